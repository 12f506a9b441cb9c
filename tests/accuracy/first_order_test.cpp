// The reference transport's first order against the quadrature of single scattering.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/atmosphere/single_scattering.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace vesper {
namespace {

struct Comparison {
  test::ErrorSum over_allowed;  ///< difference over the larger of 3 standard errors and 2e-4
  test::ErrorSum over_standard; ///< over the standard error, where that is what decides
  std::size_t unsettled = 0;    ///< answers that are no more than a guess, by their own account
};

void add(Comparison& sum, const Estimate& paths, double exact) {
  if (exact == 0.0) {
    EXPECT_EQ(paths.mean, 0.0);
    return;
  }
  constexpr double settled = 0.05;
  constexpr double allowed = 2.0e-4;
  if (!(paths.mean > 0.0 && paths.standard_error <= settled * paths.mean)) {
    ++sum.unsettled;
    return;
  }
  const double difference = paths.mean - exact;
  sum.over_allowed.add(difference / std::max(3.0 * paths.standard_error, allowed * exact));
  if (paths.standard_error > allowed * exact) {
    sum.over_standard.add(difference / paths.standard_error);
  }
}

void compare_first_order(const Medium& air, const std::string& name) {
  const std::vector<double> wavelengths_nm{440.0, 550.0, 680.0};
  const ReferenceTransport transport(air, wavelengths_nm);
  PathBudget budget;
  budget.relative_error = 2.0e-3;
  budget.most_paths = 1U << 15U;
  budget.orders = 1;
  Comparison sum;
  for (const double height_km : {0.0, 10.0, 1000.0}) {
    const double limb_deg = -(std::acos(air.ground_radius / (air.ground_radius + height_km * kilometre)) * rad).to(deg);
    for (const double altitude_deg : {90.0, 0.0, limb_deg + 0.01, limb_deg - 3.0, -90.0}) {
      for (const double sun_deg : {60.0, 20.0, 2.0, -6.0}) {
        const SkyQuery query{height_km * kilometre, test::direction(40.0 * deg, sun_deg * deg), 0.0 * deg,
                             test::direction(0.0 * deg, altitude_deg * deg)};
        SCOPED_TRACE(::testing::Message()
                     << name << ", " << height_km << " km, view " << altitude_deg << ", Sun " << sun_deg << " degrees");
        const SingleScattering exact = single_scattering(air, query, wavelengths_nm);
        ++budget.stream;
        const TransportResult paths = transport.radiance(query, {}, budget);
        for (std::size_t k = 0; k < wavelengths_nm.size(); ++k) {
          add(sum, paths.spectrum[k], exact.radiance[k]);
        }
      }
    }
  }
  sum.over_allowed.hold("first order of paths against quadrature, " + name, 1.0, "of 3 standard errors or 2e-4");
  sum.over_standard.print(("first order of paths against quadrature, " + name).c_str(), "standard errors");
  // Standard errors are neither too small nor too large.
  EXPECT_GT(sum.over_standard.rms(), 0.7);
  EXPECT_LT(sum.over_standard.rms(), 1.3);
  // Just above the limb of an Earth in twilight, where the once scattered light is below 1e-7 of day's and all but
  // nothing of what is seen.
  EXPECT_LE(sum.unsettled, 3U);
}

TEST(FirstOrder, OfPublishedAirAgreesWithQuadrature) { compare_first_order(published_medium(), "published"); }
TEST(FirstOrder, OfClearAirAgreesWithQuadrature) { compare_first_order(clear_medium(), "clear"); }

} // namespace
} // namespace vesper
