// Places of chosen stars.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/astro/star_place.hpp"
#include "vesper/base/csv.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {

/// A star to report on.
struct RequestedStar {
  std::string id;
  CatalogueStar star;
  double epoch_jyear = 2000.0;
  std::optional<double> magnitude;
};

/// A record in double precision.
[[nodiscard]] CatalogueStar catalogue_star(const StarRecord& record);

/// The stars of a comma-separated list of "HR2491", "HD 48915", a designation as the catalogue spells it or a proper
/// name; blanks and case do not matter. Throws Error(argument) naming an unknown one.
[[nodiscard]] std::vector<RequestedStar> stars_by_id(std::string_view ids, const StarCatalogue& catalogue);

/// The stars of a table with the columns id, ra_deg, dec_deg, epoch_jyear, pm_ra_cosdec_mas_yr, pm_dec_mas_yr,
/// parallax_mas and radial_velocity_km_s, and perhaps magnitude. Blank motions, parallaxes and magnitudes are unknown;
/// a parallax below zero, which measurement errors give to far stars, is taken as 0. Throws Error(input) naming line
/// and column.
[[nodiscard]] std::vector<RequestedStar> stars_of_table(const CsvTable& table);

/// Apparent topocentric places: "id,right_ascension_deg,declination_deg,azimuth_deg,altitude_deg,magnitude", true
/// equator and equinox of date, airless altitude; an unknown magnitude is blank (null in JSON).
[[nodiscard]] std::string star_report_csv(const std::vector<RequestedStar>& stars, const StarFrame& frame);
[[nodiscard]] std::string star_report_json(const std::vector<RequestedStar>& stars, const StarFrame& frame);

} // namespace vesper
