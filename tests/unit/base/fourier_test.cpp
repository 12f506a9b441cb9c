#include "vesper/base/fourier.hpp"

#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace vesper {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> some_values(std::size_t side) {
  std::vector<Complex> values;
  for (std::size_t i = 0; i < side * side; ++i) {
    const auto x = static_cast<double>(i);
    values.emplace_back(std::sin(1.0 + x * x), std::cos(3.0 * x));
  }
  return values;
}

TEST(Fourier, IsTheSumItStandsFor) {
  constexpr std::size_t side = 8;
  const std::vector<Complex> values = some_values(side);
  std::vector<Complex> transformed = values;
  fourier_transform(transformed, side, FourierWay::forward);
  for (std::size_t v = 0; v < side; ++v) {
    for (std::size_t u = 0; u < side; ++u) {
      Complex sum = 0.0;
      for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
          sum += values[y * side + x] * std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(u * x + v * y) /
                                                            static_cast<double>(side));
        }
      }
      EXPECT_LT(std::abs(transformed[v * side + u] - sum), 1.0e-12);
    }
  }
}

TEST(Fourier, BackAfterForwardChangesNothing) {
  for (const std::size_t side : {1U, 2U, 64U}) {
    const std::vector<Complex> values = some_values(side);
    std::vector<Complex> there_and_back = values;
    fourier_transform(there_and_back, side, FourierWay::forward);
    fourier_transform(there_and_back, side, FourierWay::back);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_LT(std::abs(there_and_back[i] - values[i]), 1.0e-12);
    }
  }
}

TEST(Fourier, RefusesOtherSides) {
  std::vector<Complex> values(36);
  EXPECT_THROW(fourier_transform(values, 6, FourierWay::forward), Error);
  EXPECT_THROW(fourier_transform(values, 4, FourierWay::forward), Error);
}

} // namespace
} // namespace vesper
