// Scintillation against the theory it is drawn from, and against what observers report.
#include "vesper/base/shader_math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace vesper {
namespace {

constexpr double eye_pupil_m = 0.007;
constexpr double degree = std::numbers::pi / 180.0;

struct Statistics {
  double mean[4]{};
  double deviation[4]{};
  double correlation_xz = 0.0;
};

/// Over many stars and instants.
Statistics statistics(double altitude_deg, double exposure_s, unsigned seed = 1) {
  constexpr int stars = 400;
  constexpr int instants = 150;
  double sum[4]{};
  double square[4]{};
  double cross = 0.0;
  for (unsigned star = 1; star <= stars; ++star) {
    for (int i = 0; i < instants; ++i) {
      const double seconds = 8.4e8 + 0.37 * i;
      const glm::dvec4 light = f64::scintillation(f64::hash_pair(star, seed), seconds, std::sin(altitude_deg * degree),
                                                  exposure_s, eye_pupil_m);
      for (int c = 0; c < 4; ++c) {
        sum[c] += light[c];
        square[c] += light[c] * light[c];
      }
      cross += light.x * light.z;
    }
  }
  constexpr double count = stars * instants;
  Statistics result;
  for (int c = 0; c < 4; ++c) {
    result.mean[c] = sum[c] / count;
    result.deviation[c] = std::sqrt(square[c] / count - result.mean[c] * result.mean[c]);
  }
  result.correlation_xz =
      (cross / count - result.mean[0] * result.mean[2]) / (result.deviation[0] * result.deviation[2]);
  return result;
}

TEST(Scintillation, ConservesTheMeanLight) {
  for (const double altitude : {90.0, 45.0, 20.0, 10.0, 5.0, 1.0}) {
    const Statistics s = statistics(altitude, 0.0);
    for (int c = 0; c < 4; ++c) {
      EXPECT_NEAR(s.mean[c], 1.0, 0.015) << altitude << " " << c;
    }
  }
}

TEST(Scintillation, HasTheVarianceOfTheTheory) {
  std::printf("altitude  sigma_I drawn  theory   drawn over 0.1 s\n");
  for (const double altitude : {90.0, 60.0, 45.0, 30.0, 20.0, 10.0, 3.0}) {
    const Statistics s = statistics(altitude, 0.0);
    const double sec_z = f64::scintillation_secant(std::sin(altitude * degree));
    const double theory = std::sqrt(f64::scintillation_index(f64::rytov_variance(555.0e-9, sec_z, eye_pupil_m)));
    std::printf("%8.0f  %13.3f  %6.3f   %16.3f\n", altitude, s.deviation[1], theory,
                statistics(altitude, 0.1).deviation[1]);
    EXPECT_NEAR(s.deviation[1] / theory, 1.0, 0.06) << altitude;
  }
}

TEST(Scintillation, AtTheZenithLiesInTheRangeObserversGive) {
  // For a pupil of 7 mm: 0.2 to 0.4 at an instant, less after the eye's integration (Dravins et al. 1997).
  const double instant = statistics(90.0, 0.0).deviation[1];
  EXPECT_GT(instant, 0.2);
  EXPECT_LT(instant, 0.4);
  EXPECT_LT(statistics(90.0, 0.1).deviation[1], 0.5 * instant);
}

TEST(Scintillation, FollowsTheSmallApertureLawsWhileWeak) {
  // sec(z)^(11/6) and wavelength^(-7/6); the eye's pupil takes off a little, more where the Fresnel zone is small.
  const double zenith = f64::rytov_variance(555.0e-9, 1.0, 0.0);
  EXPECT_NEAR(f64::rytov_variance(555.0e-9, 2.0, 0.0) / zenith, std::pow(2.0, 11.0 / 6.0), 1.0e-9);
  EXPECT_NEAR(f64::rytov_variance(277.5e-9, 1.0, 0.0) / zenith, std::pow(2.0, 7.0 / 6.0), 1.0e-9);
  const double eye = f64::rytov_variance(555.0e-9, 1.0, eye_pupil_m);
  EXPECT_GT(eye / zenith, 0.95);
  EXPECT_LT(eye / zenith, 1.0);
  // Weak turbulence: index equals Rytov variance.
  EXPECT_NEAR(f64::scintillation_index(1.0e-3) / 1.0e-3, 1.0, 2.0e-3);
}

TEST(Scintillation, SaturatesTowardsTheHorizon) {
  double largest = 0.0;
  for (int tenth = 0; tenth <= 900; ++tenth) {
    const double sec_z = f64::scintillation_secant(std::sin(0.1 * tenth * degree));
    const double index = f64::scintillation_index(f64::rytov_variance(555.0e-9, sec_z, eye_pupil_m));
    EXPECT_TRUE(std::isfinite(index));
    largest = std::max(largest, index);
  }
  // Unbounded, the law would reach 0.14 * 40^(11/6) = 130 at the horizon.
  EXPECT_LT(largest, 2.0);
  EXPECT_GT(largest, 0.8);
}

TEST(Scintillation, ColoursPartNearTheHorizon) {
  const double high = statistics(80.0, 0.0).correlation_xz;
  const double middle = statistics(30.0, 0.0).correlation_xz;
  const double low = statistics(10.0, 0.0).correlation_xz;
  std::printf("correlation of X and Z: %.3f at 80, %.3f at 30, %.3f at 10 degrees\n", high, middle, low);
  EXPECT_GT(high, 0.95);
  EXPECT_LT(middle, high);
  EXPECT_LT(low, 0.5);
}

TEST(Scintillation, LongExposuresAverageItAway) {
  double last = 1.0e9;
  for (const double exposure : {0.0, 0.01, 0.1, 1.0, 30.0}) {
    const double deviation = statistics(60.0, exposure).deviation[1];
    EXPECT_LT(deviation, last);
    last = deviation;
  }
  EXPECT_LT(last, 0.01);
}

TEST(Scintillation, IsSmoothInTimeAndAltitude) {
  const unsigned key = f64::hash_pair(2491U, 0U);
  const double seconds = 8.4e8;
  const glm::dvec4 at = f64::scintillation(key, seconds, 0.3, 0.0, eye_pupil_m);
  EXPECT_NEAR(f64::scintillation(key, seconds + 1.0e-6, 0.3, 0.0, eye_pupil_m).y / at.y, 1.0, 2.0e-3);
  EXPECT_NEAR(f64::scintillation(key, seconds, 0.3 + 1.0e-6, 0.0, eye_pupil_m).y / at.y, 1.0, 1.0e-4);
  // Through the horizon and without end.
  for (const double sine : {-1.0, -1.0e-9, 0.0, 1.0e-9, 1.0}) {
    const glm::dvec4 light = f64::scintillation(key, seconds, sine, 0.0, eye_pupil_m);
    for (int c = 0; c < 4; ++c) {
      EXPECT_TRUE(std::isfinite(light[c]) && light[c] > 0.0);
    }
  }
}

TEST(Scintillation, DistantDatesKeepTheirPhases) {
  // 10 000 years on the clock still resolves 60 microseconds: a tenth of a millisecond moves the light as little as
  // it does today.
  const unsigned key = f64::hash_pair(7001U, 0U);
  const auto worst_step = [&](double seconds) {
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      const double a = f64::scintillation(key, seconds + i, 0.5, 0.0, eye_pupil_m).y;
      const double b = f64::scintillation(key, seconds + i + 1.0e-4, 0.5, 0.0, eye_pupil_m).y;
      worst = std::max(worst, std::abs(b / a - 1.0));
    }
    return worst;
  };
  EXPECT_LT(worst_step(3.15e11), 2.0 * worst_step(8.4e8));
}

TEST(MuellerScintillation, OnlyDimsAndGrowsTowardsTheHorizon) {
  double zenith = 0.0;
  double horizon = 0.0;
  for (unsigned frame = 0; frame < 2000; ++frame) {
    const glm::dvec4 high = f64::mueller_scintillation(77U, frame, 1.0);
    const glm::dvec4 low = f64::mueller_scintillation(77U, frame, 40.0);
    for (int c = 0; c < 4; ++c) {
      EXPECT_GE(low[c], 0.0);
      EXPECT_LE(high[c], 1.0);
    }
    zenith += 1.0 - high.y;
    horizon += 1.0 - low.y;
  }
  EXPECT_GT(horizon, 10.0 * zenith);
}

} // namespace
} // namespace vesper
