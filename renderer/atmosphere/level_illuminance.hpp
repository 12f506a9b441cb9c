// Light on a level surface that looks up, from the tables of the sky.
#pragma once

#include "vesper/atmosphere/sky_tables.hpp"

namespace vesper {

/// Illuminance by the light itself, in X, Y, Z and S, lux above 1 lux of sunlight outside the air: of what stands above
/// the horizon of a uniform disc, through the air.
/// \param height above the ground, >= 0; any, also outside the air
/// \param light_altitude of the disc's centre, airless, -90 to 90 degrees
/// \param light_radius 0 to 1 degree
/// Throws Error(argument) for values out of these ranges.
[[nodiscard]] Xyzs direct_illuminance(const SkyTables& tables, Length height, Angle light_altitude, Angle light_radius);

/// The same by the light that the air scatters: the integral of the sky's luminance over the hemisphere, good to 1e-3
/// of what the tables hold for aerosol with an asymmetry of 0.9 at the most. Takes a quarter of a millisecond.
[[nodiscard]] Xyzs diffuse_illuminance(const SkyTables& tables, Length height, Angle light_altitude);

} // namespace vesper
