// Places of chosen stars, and whether they are seen.
#pragma once

#include "report/scene_air.hpp"

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/astro/star_place.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/sky/sky_state.hpp"
#include "vesper/sky/star_visibility.hpp"

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
  Vec4 light = vector_of(star_color(0.7)); ///< X, Y, Z, S above the air for 1 lux; B-V = 0.7 where it is not known
  double lux_ratio = star_lux_ratio(0.7);  ///< as in photometry.hpp
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

/// Apparent and topocentric: true equator and equinox of date, airless.
struct ReportedPlace {
  Equatorial equatorial;
  Horizontal horizontal;
};
[[nodiscard]] std::vector<ReportedPlace> reported_places(const std::vector<RequestedStar>& stars,
                                                         const StarFrame& frame);

/// What an eye sees of each, by the tables of the sky; of a star without a magnitude only the limit has a meaning.
/// Takes some tens of milliseconds and the tables.
[[nodiscard]] std::vector<StarSight> star_sights(const std::vector<RequestedStar>& stars,
                                                 const std::vector<ReportedPlace>& places, const SkyState& sky,
                                                 const SceneAir& air);

/// "id,right_ascension_deg,declination_deg,azimuth_deg,altitude_deg,magnitude"; an unknown magnitude is blank (null in
/// JSON).
/// \param sights one a star, for the columns "limiting_magnitude,visibility" after these; none without them
[[nodiscard]] std::string star_report_csv(const std::vector<RequestedStar>& stars,
                                          const std::vector<ReportedPlace>& places,
                                          const std::vector<StarSight>& sights = {});
[[nodiscard]] std::string star_report_json(const std::vector<RequestedStar>& stars,
                                           const std::vector<ReportedPlace>& places,
                                           const std::vector<StarSight>& sights = {});

} // namespace vesper
