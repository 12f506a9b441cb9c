// From catalogue entries to a star buffer, with an account of what happened on the way.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/catalog_tools/bright_star_catalogue.hpp"

#include <cstddef>
#include <limits>
#include <map>
#include <span>

namespace vesper {

struct StarProductOptions {
  /// The faintest V magnitude that is kept.
  double limit_magnitude = std::numeric_limits<double>::infinity();
};

/// What became of the entries.
struct StarProductReport {
  std::size_t read = 0;
  std::size_t kept = 0;
  std::size_t dropped_without_position = 0;
  std::size_t dropped_without_magnitude = 0;
  std::size_t dropped_by_limit = 0;
  // Of the kept stars:
  std::size_t inferred_colors = 0; ///< B-V taken from the spectral type
  std::size_t assumed_colors = 0;  ///< neither B-V nor a known spectral type: B-V = 0.65
  std::size_t without_proper_motion = 0;
  std::size_t without_parallax = 0;
  std::size_t negative_parallaxes = 0; ///< taken as unknown
  std::size_t without_radial_velocity = 0;
  std::size_t multiple = 0;
  std::size_t variable = 0; ///< the catalogue gives no amplitude: their variability is 0 in the product
  std::map<int, std::size_t> count_by_magnitude; ///< key m: m - 0.5 <= V < m + 0.5
  double illuminance_before_lux = 0;             ///< kept stars in double precision
  double illuminance_after_lux = 0;              ///< the floats of the product, added in double precision
};

struct StarProduct {
  StarCatalogue catalogue;
  StarProductReport report;
};

/// Makes the star buffer: entries with a position and a magnitude up to the limit, sorted by magnitude, then HR number.
/// Illuminance and colour follow from V and B-V (light/photometry.hpp, light/star_color.hpp); negative parallaxes are
/// taken as unknown. Fills epoch, counts and illuminance of the provenance; the caller knows the rest.
/// Throws Error(input) when no star is left, Error(argument) for a limit that is not a number.
[[nodiscard]] StarProduct make_star_product(std::span<const BrightStar> entries, const StarProductOptions& options);

/// Catalogue title and terms that belong into the provenance.
inline constexpr const char* bright_star_source =
    "Bright Star Catalogue, 5th revised edition (Hoffleit and Warren 1991)";
inline constexpr const char* bright_star_licence = "public domain";

} // namespace vesper
