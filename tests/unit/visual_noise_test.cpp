// The grain of the dark: its statistics must not depend on the picture, the order of frames or the place.
#include "vesper/base/shader_math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace vesper::test {
namespace {

/// A picture of some degrees across, looking along x, in `side` x `side` pixels.
std::vector<double> grain_picture(int side, double degrees, double seconds, unsigned int seed) {
  const double scale = degrees / side;
  std::vector<double> picture;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5 - 0.5 * side) * scale * f64::pi / 180.0;
      const double y = (row + 0.5 - 0.5 * side) * scale * f64::pi / 180.0;
      const f64::vec3 direction = glm::normalize(f64::vec3(1.0, x, y));
      picture.push_back(f64::visual_noise(direction, column, row, scale, seconds, seed));
    }
  }
  return picture;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

double covariance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum / static_cast<double>(a.size());
}

/// Variance of the means over squares of `squares` x `squares` to a picture.
double variance_of_patches(const std::vector<double>& picture, int side, int squares) {
  const int patch = side / squares;
  double sum = 0.0;
  for (int i = 0; i < squares * squares; ++i) {
    double mean = 0.0;
    for (int y = 0; y < patch; ++y) {
      for (int x = 0; x < patch; ++x) {
        mean += picture[static_cast<std::size_t>((i / squares * patch + y) * side + i % squares * patch + x)];
      }
    }
    mean /= patch * patch;
    sum += mean * mean;
  }
  return sum / (squares * squares);
}

TEST(VisualNoise, HasMeanNoneAndVarianceOne) {
  const std::vector<double> picture = grain_picture(512, 40.0, 3.21, 7);
  // 40 000 grains.
  std::printf("grain: mean %.4f, variance %.4f\n", mean_of(picture), covariance(picture, picture));
  EXPECT_NEAR(mean_of(picture), 0.0, 0.03);
  EXPECT_NEAR(covariance(picture, picture), 1.0, 0.03);
}

TEST(VisualNoise, LooksTheSameInPixelsOfAnySize) {
  // Means over 1.25 degrees, from pixels of 0.04, 0.16 and 0.31 degrees.
  const double fine = variance_of_patches(grain_picture(1024, 40.0, 3.21, 7), 1024, 32);
  const double middle = variance_of_patches(grain_picture(256, 40.0, 3.21, 7), 256, 32);
  const double coarse = variance_of_patches(grain_picture(128, 40.0, 3.21, 7), 128, 32);
  std::printf("grain: standard deviation of means over 1.25 degrees: %.4f, %.4f, %.4f\n", std::sqrt(fine),
              std::sqrt(middle), std::sqrt(coarse));
  // The sampling error of a standard deviation from 1024 patches is 2.2 %.
  EXPECT_NEAR(std::sqrt(middle / fine), 1.0, 0.1);
  EXPECT_NEAR(std::sqrt(coarse / fine), 1.0, 0.1);
}

TEST(VisualNoise, IsAFunctionOfTimeAndSeed) {
  const std::vector<double> picture = grain_picture(256, 20.0, 3.21, 7);
  EXPECT_EQ(picture, grain_picture(256, 20.0, 3.21, 7));
  EXPECT_GT(covariance(picture, grain_picture(256, 20.0, 3.211, 7)), 0.98); // a hundredth of a grain's time
  EXPECT_NEAR(covariance(picture, grain_picture(256, 20.0, 3.51, 7)), 0.0, 0.05);
  EXPECT_NEAR(covariance(picture, grain_picture(256, 20.0, 3.21, 8)), 0.0, 0.05);
  for (const double seconds : {0.0, -5.0, 1.0e7}) {
    EXPECT_NEAR(covariance(grain_picture(128, 20.0, seconds, 7), grain_picture(128, 20.0, seconds, 7)), 1.0, 0.1);
  }
}

TEST(VisualNoise, ChangesSteadilyInTime) {
  double largest = 0.0;
  const f64::vec3 direction = glm::normalize(f64::vec3(0.3, -0.5, 0.7));
  for (int i = 0; i < 1000; ++i) {
    const double a = f64::visual_noise(direction, 0, 0, 0.05, 0.001 * i, 3);
    const double b = f64::visual_noise(direction, 0, 0, 0.05, 0.001 * (i + 1), 3);
    largest = std::max(largest, std::abs(a - b));
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(largest, 0.1); // of a variation of 1 in 0.1 s, looked at each 0.001 s
}

} // namespace
} // namespace vesper::test
