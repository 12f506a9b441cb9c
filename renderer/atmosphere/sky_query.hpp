// What is asked of the air: how bright it looks from a place, under a distant light.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Of the Sun on the average, and of the Moon nearly: what is solved for all places of a light is solved for this disc.
inline constexpr Angle mean_light_radius = 0.2666 * deg;

/// Directions are unit vectors in a frame at the observer's place whose z axis points to the zenith; rays are straight.
struct SkyQuery {
  Length height;              ///< of the observer above the ground, >= 0; any, also outside the air
  Vec3 light_direction;       ///< towards the centre of the light's disc
  Angle light_angular_radius; ///< of a uniform disc, 0 (a parallel beam) to 1 degree
  Vec3 view_direction;        ///< where light is looked for; without meaning for an irradiance
};

/// Throws Error(argument) naming the value that is out of its range.
void validate(const SkyQuery& query);

} // namespace vesper
