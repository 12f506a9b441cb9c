// Sky tables for tests of what is done with them.
#pragma once

#include "vesper/atmosphere/sky_tables.hpp"

namespace vesper::test {

/// Small tables whose texels are all different.
inline SkyTables numbered_tables() {
  SkyTables tables;
  tables.frame = {6371.0F, 6471.0F, 2, 2, 3, 2};
  tables.transmittance_frame = {4, 2};
  tables.light = {1.0F, 1.0F, 0.9F, 2.5F};
  tables.albedo = {0.3F, 0.3F, 0.2F, 0.3F};
  float number = -20.0F;
  const auto fill = [&](std::vector<f32::vec4>& texels, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i, number += 0.125F) {
      texels.emplace_back(number, number + 0.01F, number + 0.02F, number + 0.03F);
    }
  };
  constexpr auto scattering = std::size_t{2} * 5 * 2 * f32::sky_azimuths;
  fill(tables.aerosol, scattering);
  fill(tables.other, scattering);
  fill(tables.ground, 2);
  fill(tables.phase, 5);
  fill(tables.transmittance, 16);
  return tables;
}

} // namespace vesper::test
