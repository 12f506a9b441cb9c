// What is asked of the air: how bright it looks from a place, under a distant light.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

#include <functional>
#include <span>

namespace vesper {

/// Of the Sun on the average, and of the Moon nearly: what is solved for all places of a light is solved for this disc.
inline constexpr Angle mean_light_radius = 0.2666 * deg;

/// Multiplies values, one for each wavelength, by the share of the light that reaches a place from outside the air:
/// what another body's shadow leaves. Places are in km from the observer, along the query's axes. Called from several
/// threads.
using LightShare = std::function<void(const Vec3& place_km, std::span<double> values)>;

/// Directions are unit vectors in a frame at the observer's place whose z axis points to the zenith; rays are straight.
struct SkyQuery {
  Length height;              ///< of the observer above the ground, >= 0; any, also outside the air
  Vec3 light_direction;       ///< towards the centre of the light's disc
  Angle light_angular_radius; ///< of a uniform disc, 0 (a parallel beam) to 1 degree
  Vec3 view_direction;        ///< where light is looked for; without meaning for an irradiance
  LightShare light_share{};   ///< 1 everywhere if there is none; followed by ReferenceTransport alone
};

/// Throws Error(argument) naming the value that is out of its range.
void validate(const SkyQuery& query);

} // namespace vesper
