// From maps in longitude and latitude to the Moon's cube map, with an account of what happened on the way.
#pragma once

#include "vesper/assets/moon_map.hpp"
#include "vesper/base/units.hpp"
#include "vesper/catalog_tools/globe_grid.hpp"

#include <cstddef>
#include <functional>

namespace vesper {

/// The sphere that the elevation stands on (the reference of LOLA's grids).
inline constexpr Length moon_reference_radius = 1737.4 * kilometre;

/// Mean albedo of the near side as it shows on the disc: the Moon of V = -12.73 at 384400 km, of 1737.4 km radius, lit
/// by a Sun of V = -26.75.
inline constexpr double moon_product_disc_albedo = 0.1207;

struct MoonProductOptions {
  int face_size = 256; ///< texels along a side of the cube's faces: even, least_moon_face to most_moon_face
  /// Called from several threads with how many of moon_product_work(face_size) units of work were done.
  std::function<void(std::size_t units)> progress = [](std::size_t) {};
};
[[nodiscard]] std::size_t moon_product_work(int face_size);

struct MoonProductReport {
  FillReport albedo_fill;
  FillReport elevation_fill;
  double albedo_scale = 0; ///< albedo of a picture value of 1
  double least_albedo = 0; ///< of the map's texels
  double most_albedo = 0;
  double lowest_m = 0; ///< of the elevation grid, above moon_reference_radius
  double highest_m = 0;
  Angle mean_slope; ///< root mean square over the area, at the map's resolution
};

struct MoonProduct {
  MoonMap map;
  MoonProductReport report;
};

/// Makes the cube map. Missing pixels are filled from those around them.
///
/// A texel's albedo is the mean of the picture over the texel's area, times one number by which moon_disc_albedo of
/// the map becomes moon_product_disc_albedo. Its normal is that of the surface r = R + h: n along e - grad h / r with
/// the mean gradient over the texel, from the heights at its corners, each a mean over an area of a texel's size. The
/// gradient is taken on the cube's faces, so that no direction is special but the sampling of the grids near the
/// poles. To keep files small, albedos are rounded to 12 bits (0.0122 % at most) and the components of normals to 1/128
/// of a texel's width or less (2^-14 at 256 texels a face).
///
/// \param albedo      linear, to a scale; NaN where missing
/// \param elevation_m metres above moon_reference_radius; NaN where missing
/// Fills counts and scale of the provenance; the caller knows the rest. Throws Error(argument) for a face size out of
/// range, Error(input) when more than half of the globe is missing in either, or an albedo comes out above 1.
[[nodiscard]] MoonProduct make_moon_product(GlobeGrid albedo, GlobeGrid elevation_m, const MoonProductOptions& options);

} // namespace vesper
