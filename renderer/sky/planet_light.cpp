#include "vesper/sky/planet_light.hpp"

#include "vesper/light/photometry.hpp"

#include <array>
#include <vector>

namespace vesper {
namespace {

using Albedos = std::array<double, 7>; ///< in U, B, V, R_c, R, I_c and I

constexpr std::array<Albedos, planet_count> albedos{{
    {0.087, 0.105, 0.142, 0.158, 0.172, 0.180, 0.208},
    {0.348, 0.658, 0.689, 0.658, 0.708, 0.640, 0.584},
    {0.060, 0.088, 0.170, 0.250, 0.288, 0.285, 0.330},
    {0.358, 0.443, 0.538, 0.513, 0.495, 0.389, 0.321},
    {0.203, 0.339, 0.499, 0.646, 0.568, 0.543, 0.423},
    {0.502, 0.561, 0.488, 0.264, 0.202, 0.089, 0.079},
    {0.578, 0.562, 0.442, 0.226, 0.181, 0.072, 0.067},
}};

std::array<ReflectedLight, planet_count> make_table() {
  // Effective wavelengths of U, B, V, R_c, R, I_c and I, nm.
  const std::vector<double> bands{360.0, 436.0, 549.0, 641.0, 700.0, 798.0, 900.0};
  std::array<ReflectedLight, planet_count> table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    table.at(i) = reflected_sunlight({bands, {albedos.at(i).begin(), albedos.at(i).end()}});
  }
  return table;
}

} // namespace

const ReflectedLight& planet_light(Planet planet) {
  static const std::array<ReflectedLight, planet_count> table = make_table();
  return table.at(static_cast<std::size_t>(planet));
}

Illuminance planet_illuminance(Planet planet, double magnitude) {
  return illuminance_of_v(magnitude, planet_light(planet).lux_ratio);
}

} // namespace vesper
