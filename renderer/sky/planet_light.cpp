#include "vesper/sky/planet_light.hpp"

#include "vesper/light/photometry.hpp"

#include <array>

namespace vesper {
namespace {

using Albedos = std::array<double, 5>; ///< in U, B, V, R, I

constexpr std::array<Albedos, planet_count> albedos{{
    {0.087, 0.105, 0.142, 0.158, 0.180},
    {0.348, 0.658, 0.689, 0.658, 0.591},
    {0.060, 0.088, 0.170, 0.250, 0.285},
    {0.358, 0.443, 0.538, 0.513, 0.321},
    {0.203, 0.339, 0.499, 0.568, 0.423},
    {0.502, 0.561, 0.488, 0.264, 0.089},
    {0.578, 0.562, 0.442, 0.226, 0.076},
}};

std::array<ReflectedLight, planet_count> make_table() {
  std::array<ReflectedLight, planet_count> table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    table.at(i) =
        reflected_sunlight(Spectrum({360.0, 436.0, 549.0, 700.0, 900.0}, {albedos.at(i).begin(), albedos.at(i).end()}));
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
