// The noise before rounding, by statistics: what the GPU does as C++ in single precision.
#include "vesper/base/shader_math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

namespace vesper {
namespace {

constexpr std::size_t columns = 1024;
constexpr std::size_t rows = 256;
constexpr float steps = 255.0F;

using Picture = std::vector<int>;

/// Codes of the sky from the zenith down to the horizon some 40 minutes after sunset, on a dim display: 8 to 44 steps.
/// One axis runs along the gradient.
float twilight(std::size_t along, std::size_t length) {
  const float t = static_cast<float>(along) / static_cast<float>(length - 1);
  return f32::srgb_encode(0.0024F * std::exp(2.45F * t * t));
}

using Noisy = std::function<float(float code, std::size_t column, std::size_t row)>;

Picture rounded(const Noisy& noisy, bool down_the_columns) {
  Picture picture(columns * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const float code = down_the_columns ? twilight(row, rows) : twilight(column, columns);
      picture[row * columns + column] = static_cast<int>(std::lround(steps * noisy(code, column, row)));
    }
  }
  return picture;
}

Noisy ours(unsigned seed) {
  return [seed](float code, std::size_t column, std::size_t row) {
    return f32::dithered(f32::vec3(code), static_cast<unsigned>(column), static_cast<unsigned>(row), seed, steps).y;
  };
}

/// White noise of the same distribution.
Noisy white(unsigned seed) {
  return [random = std::mt19937(seed),
          uniform = std::uniform_real_distribution<float>(-0.5F, 0.5F)](float code, std::size_t, std::size_t) mutable {
    return code + (uniform(random) + uniform(random)) / steps;
  };
}

/// Lengths of the runs of equal values along rows or columns: the longest and the mean.
struct Runs {
  double longest = 0.0;
  double mean = 0.0;
};

Runs runs(const Picture& picture, bool along_rows) {
  const std::size_t lines = along_rows ? rows : columns;
  const std::size_t length = along_rows ? columns : rows;
  std::size_t longest = 0;
  std::size_t count = 0;
  for (std::size_t line = 0; line < lines; ++line) {
    const auto at = [&](std::size_t i) { return picture[along_rows ? line * columns + i : i * columns + line]; };
    std::size_t run = 0;
    for (std::size_t i = 0; i < length; ++i) {
      run = i > 0 && at(i) == at(i - 1) ? run + 1 : 1;
      count += run == 1 ? 1 : 0;
      longest = std::max(longest, run);
    }
  }
  return {static_cast<double>(longest), static_cast<double>(picture.size()) / static_cast<double>(count)};
}

TEST(Dither, LeavesNoLongerRunsThanWhiteNoise) {
  constexpr unsigned pictures = 8;
  for (const bool gradient_down : {false, true}) {
    for (const bool along_rows : {true, false}) {
      Runs own;
      Runs of_white;
      for (unsigned seed = 0; seed < pictures; ++seed) {
        const auto add = [&](Runs& sum, const Noisy& noisy) {
          const Runs one = runs(rounded(noisy, gradient_down), along_rows);
          sum.longest = std::max(sum.longest, one.longest);
          sum.mean += one.mean / pictures;
        };
        add(own, ours(seed));
        add(of_white, white(seed + 1));
      }
      std::printf("runs along %s, gradient along %s: longest %.0f of white noise %.0f, mean %.3f of %.3f pixels\n",
                  along_rows ? "rows" : "columns", gradient_down ? "columns" : "rows", own.longest, of_white.longest,
                  own.mean, of_white.mean);
      EXPECT_LE(own.longest, of_white.longest);
      EXPECT_LT(own.mean, of_white.mean);
    }
  }
}

TEST(Dither, KeepsTheMeanAtEveryLevel) {
  // Also beside black and white, where noise is narrower, and for each channel and seed.
  double worst = 0.0;
  constexpr unsigned side = 256;
  for (const float level : {0.0F, 0.02F, 0.3F, 0.5F, 1.2F, 20.75F, 254.4F, 254.9F, 255.0F}) {
    for (const unsigned seed : {0U, 7U}) {
      std::array<double, 3> sum{};
      for (unsigned row = 0; row < side; ++row) {
        for (unsigned column = 0; column < side; ++column) {
          const f32::vec3 codes = f32::dithered(f32::vec3(level / steps), column, row, seed, steps);
          for (int channel = 0; channel < 3; ++channel) {
            sum.at(static_cast<std::size_t>(channel)) += std::round(static_cast<double>(steps * codes[channel]));
          }
        }
      }
      for (const double s : sum) {
        const double error = s / (side * side) - static_cast<double>(level);
        if (level == 0.0F || level == steps) {
          EXPECT_EQ(error, 0.0) << level;
        }
        worst = std::max(worst, std::abs(error));
      }
    }
  }
  std::printf("means of %u pixels off by %.4f steps at worst\n", side * side, worst);
  // The variance of a code is at most a quarter: 4 standard errors of white noise.
  EXPECT_LT(worst, 4.0 * 0.5 / side);
}

/// Sum of squares of the noise's means over squares of `side` pixels, over what white noise would have.
double coarse_noise(unsigned side) {
  constexpr unsigned squares = 64;
  double sum = 0.0;
  for (unsigned i = 0; i < squares * squares; ++i) {
    double mean = 0.0;
    for (unsigned j = 0; j < side * side; ++j) {
      const f32::vec3 codes =
          f32::dithered(f32::vec3(0.5F), i % squares * side + j % side, i / squares * side + j / side, 3, steps);
      mean += static_cast<double>((codes.x - 0.5F) * steps) / (side * side);
    }
    sum += mean * mean * side * side;
  }
  constexpr double variance = 1.0 / 6.0; // of a triangle over -1 to 1
  return sum / (squares * squares) / variance;
}

TEST(Dither, IsWeakAtLowFrequencies) {
  const double of_one = coarse_noise(1);
  const double of_eight = coarse_noise(8);
  std::printf("noise power in squares of 1 and 8 pixels: %.3f and %.3f of white noise\n", of_one, of_eight);
  EXPECT_NEAR(of_one, 1.0, 0.05);
  EXPECT_LT(of_eight, 0.35);
}

TEST(Dither, ChannelsAndFramesMakeUpForEachOther) {
  // Correlations of the noise of two channels and of two frames on end: not above those of independent noise.
  double channels = 0.0;
  double frames = 0.0;
  constexpr unsigned side = 200;
  for (unsigned i = 0; i < side * side; ++i) {
    const f32::vec3 a = f32::dithered(f32::vec3(0.5F), i % side, i / side, 1, steps) - f32::vec3(0.5F);
    const f32::vec3 b = f32::dithered(f32::vec3(0.5F), i % side, i / side, 2, steps) - f32::vec3(0.5F);
    channels += static_cast<double>(a.x * a.y * steps * steps) / (side * side) * 6.0;
    frames += static_cast<double>(a.x * b.x * steps * steps) / (side * side) * 6.0;
  }
  std::printf("correlation of channels %.3f, of frames %.3f\n", channels, frames);
  EXPECT_LT(channels, 0.0);
  EXPECT_LT(frames, 0.0);
}

} // namespace
} // namespace vesper
