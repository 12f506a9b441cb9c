// The Moon's map as places spread evenly over the globe, to add up its light.
#pragma once

#include "vesper/assets/moon_map.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"

#include <functional>
#include <vector>

namespace vesper {

/// One place: the map between its texels, as a picture reads it.
struct MoonSample {
  f32::vec3 normal; ///< of the sphere
  f32::vec3 relief; ///< normal of the surface
  float albedo;
  float solid_angle; ///< of its share of the sphere, from the Moon's centre
};

using MoonSamples = std::vector<MoonSample>;

/// \param places on each face of the cube, at least 1. With 16384 the light of a disc is found within 0.15 % to 140
///        degrees of phase; crescents have samples of their own.
/// Throws Error(argument) unless the map has six square faces and there is a place.
[[nodiscard]] MoonSamples sample_moon(const MoonMap& map, int places = 16384);

/// Of the lune between limb and terminator alone, with the relief beyond it that the Sun lights: as fine as the texels
/// of a map of 256 a face where a crescent is thin, so that its light is found within 0.1 % to 172 degrees of phase.
/// \param map that sample_moon takes
/// \param to_observer unit vectors of the Moon's axes, at least a right angle and less than a half turn apart
[[nodiscard]] MoonSamples sample_crescent(const MoonMap& map, const Vec3& to_observer, const Vec3& to_sun);

/// The Moon's surface, for the picture and for the sum of its light.
struct MoonGlobe {
  MoonMap map;
  MoonSamples samples;
};
[[nodiscard]] MoonGlobe moon_globe(MoonMap map, int places = 16384);

/// One of the equal squares of a grid about the disc: the mean over its samples, per lux as below.
struct MoonCell {
  float sun = 0.0F; ///< luminance
  float earth = 0.0F;
};
inline constexpr int moon_cells_of_edge = 64;

/// What a disc gives an observer per lux on a plane at the Moon that faces the light.
struct MoonLightSums {
  double sun = 0.0; ///< illuminance
  double earth = 0.0;
  /// Rows upward, for pictures of few pixels. Cells beyond the limb, and without a sample, are black.
  std::vector<MoonCell> cells;
};
/// \param observer from the Moon's centre, in its radii and its axes; outside the sphere
/// \param fixed_from_disc to the Moon's axes from those of the grid: right, upward, from the observer to the centre
[[nodiscard]] MoonLightSums sum_moon_light(const MoonSamples& samples, const Vec3& observer,
                                           const f64::MoonLighting& lighting, const Mat3& fixed_from_disc);

/// The same as X, Y, Z, S in lux with shares of sunlight that differ from place to place.
/// \param eclipse_xyzs of a place on the unit sphere, in the Moon's axes
[[nodiscard]] Vec4 sum_moon_light(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting,
                                  const std::function<Vec4(const Vec3&)>& eclipse_xyzs);

/// Calls `with` for the samples that the Sun lights, with the part of MoonLightSums::sun that is theirs.
void for_sunlit(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting,
                const std::function<void(const MoonSample&, double)>& with);

/// Lighting as the GPU holds it.
[[nodiscard]] f32::MoonLighting in_single(const f64::MoonLighting& lighting);

} // namespace vesper
