// Phase functions against what defines them: unity over the sphere and the published mean cosines.
#include "vesper/base/shader_math.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace vesper {
namespace {

using Phase = std::function<double(double cos_angle)>;

struct Moments {
  double total;
  double mean_cosine;
};

/// Simpson's rule in the logarithm of the distance from the end where the peak is, so that the peak is resolved.
Moments moments(const Phase& phase) {
  Moments sum{0.0, 0.0};
  for (const double side : {-1.0, 1.0}) {
    constexpr int steps = 4000;
    const double first = std::log(1.0e-12);
    const double step = -first / steps;
    for (int i = 0; i <= steps; ++i) {
      const double distance = std::exp(first + i * step);
      const double weight = (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * step / 3.0;
      const double cos_angle = side * (1.0 - distance);
      const double share = 2.0 * std::numbers::pi * weight * distance * phase(cos_angle);
      sum.total += share;
      sum.mean_cosine += share * cos_angle;
    }
  }
  return sum;
}

TEST(Phase, IntegratesToOneWithThePublishedMeanCosine) {
  test::ErrorSum unity;
  test::ErrorSum henyey_greenstein;
  test::ErrorSum cornette_shanks;
  test::ErrorSum schlick;
  for (int i = -99; i <= 99; ++i) {
    const double g = 0.01 * i;
    const Moments hg = moments([g](double c) { return f64::henyey_greenstein_phase(c, g); });
    const Moments cs = moments([g](double c) { return f64::cornette_shanks_phase(c, g); });
    const Moments s = moments([g](double c) { return f64::schlick_phase(c, g); });
    unity.add(hg.total - 1.0);
    unity.add(cs.total - 1.0);
    unity.add(s.total - 1.0);
    henyey_greenstein.add(hg.mean_cosine - g);
    cornette_shanks.add(cs.mean_cosine - 3.0 * g * (4.0 + g * g) / (5.0 * (2.0 + g * g)));
    if (std::abs(g) > 0.1 && std::abs(g) <= 0.9) {
      const double k = 1.55 * g - 0.55 * g * g * g;
      schlick.add(s.mean_cosine - (1.0 / k - (1.0 - k * k) / (2.0 * k * k) * std::log((1.0 + k) / (1.0 - k))));
      EXPECT_GT(s.mean_cosine * g, 0.0);
    }
  }
  for (const double depolarization : {0.0, 0.0279, 0.1, 6.0 / 7.0}) {
    const Moments r = moments([=](double c) { return f64::rayleigh_phase(c, depolarization); });
    unity.add(r.total - 1.0);
    henyey_greenstein.add(r.mean_cosine);
  }
  unity.hold("phase functions over the sphere", 1.0e-6, "");
  henyey_greenstein.hold("mean cosine of Henyey-Greenstein and Rayleigh", 1.0e-6, "");
  cornette_shanks.hold("mean cosine of Cornette-Shanks", 1.0e-6, "");
  schlick.hold("mean cosine of Schlick", 1.0e-6, "");
}

TEST(Phase, RayleighAtARightAngleDependsOnDepolarization) {
  // Light scattered at a right angle over that scattered forward: (1 + rho) / 2.
  for (const double rho : {0.0, 0.0279, 0.2}) {
    EXPECT_NEAR(f64::rayleigh_phase(0.0, rho) / f64::rayleigh_phase(1.0, rho), 0.5 * (1.0 + rho), 1.0e-12);
  }
}

TEST(Phase, SinglePrecisionAgreesAlsoInThePeak) {
  test::ErrorSum relative;
  for (int i = -99; i <= 99; ++i) {
    const auto g = static_cast<float>(0.01 * i);
    for (int j = -1000; j <= 1000; ++j) {
      const auto c = static_cast<float>(0.001 * j);
      const auto add = [&](float ours, double reference) {
        relative.add((static_cast<double>(ours) - reference) / reference);
      };
      const auto c64 = static_cast<double>(c);
      const auto g64 = static_cast<double>(g);
      add(f32::rayleigh_phase(c, 0.0625F), f64::rayleigh_phase(c64, 0.0625));
      add(f32::henyey_greenstein_phase(c, g), f64::henyey_greenstein_phase(c64, g64));
      add(f32::cornette_shanks_phase(c, g), f64::cornette_shanks_phase(c64, g64));
      add(f32::schlick_phase(c, g), f64::schlick_phase(c64, g64));
    }
  }
  relative.hold("phase functions in single precision, relative", 5.0e-5, "");
}

} // namespace
} // namespace vesper
