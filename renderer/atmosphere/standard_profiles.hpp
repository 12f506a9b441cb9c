// The standard atmosphere's molecules and ozone by height, and how ozone absorbs.
#pragma once

#include "vesper/atmosphere/height_profile.hpp"
#include "vesper/atmosphere/medium.hpp"

namespace vesper {

/// Density of the US Standard Atmosphere 1976 over that of sea level, every km to 120 km, logarithmic between.
[[nodiscard]] HeightProfile standard_air_profile();

/// Ozone of the US Standard Atmosphere 1976 (NOAA-S/T 76-1562, mid-latitude model, 348 Dobson units), 1e17 molecules
/// per m3, to 74 km, linear between.
[[nodiscard]] HeightProfile standard_ozone_profile();

/// Absorption where an ozone profile is 1, so that its zenith column holds this many Dobson units: cross-section at
/// 233 K (data/ozone_absorption_233k.csv), 360 to 830 nm.
/// \param column_km of the profile, positive (zenith_column_km)
[[nodiscard]] WavelengthLaw ozone_absorption_per_km(double dobson, double column_km);

} // namespace vesper
