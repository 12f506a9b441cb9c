// The reference transport's columns, which random paths take by the million, against the fine quadrature.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sampled_air.hpp"
#include "vesper/atmosphere/transmittance.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace vesper {
namespace {

void compare(const Medium& medium, const std::string& name) {
  const SampledAir air(medium);
  test::ErrorSum depths;
  for (const double height_km : {0.0, 0.5, 3.0, 10.0, 21.0, 40.0, 90.0}) {
    const double radius_km = air.ground_km() + height_km;
    const double horizon_deg = -(std::acos(air.ground_km() / radius_km) * rad).to(deg);
    for (const double above_deg : {0.001, 0.1, 1.0, 5.0, 20.0, 60.0, 90.0}) {
      const Vec3 direction = test::direction(0.0 * deg, (horizon_deg + above_deg) * deg);
      const AirRay ray = air.ray(radius_km, direction.z);
      ASSERT_FALSE(ray.meets_ground);
      const SampledAir::PerComponent ours = air.columns_to_space(ray, [](const auto&) { return false; });
      const AirColumns fine = columns_to_space(medium, {0.0, 0.0, radius_km}, direction);
      for (const double nm : {440.0, 550.0, 680.0}) {
        double depth = 0.0;
        for (std::size_t c = 0; c < medium.components.size(); ++c) {
          depth += medium.components[c].extinction_per_km(nm) * ours.at(c);
        }
        const double exact = optical_depth(medium, fine, nm).value;
        depths.add((depth - exact) / std::max(1.0e-5 * exact, 5.0e-7));
      }
    }
  }
  depths.hold("optical depth to space of sampled against exact air, " + name, 1.0, "of 1e-5 or 5e-7");
}

TEST(SampledAir, PublishedAirHoldsItsColumns) { compare(published_medium(), "published"); }
TEST(SampledAir, ClearAirHoldsItsColumns) { compare(clear_medium(), "clear"); }

} // namespace
} // namespace vesper
