// The sums that stand for integrals over the spectrum.
#include "vesper/base/error.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace vesper {
namespace {

/// The integral that the weights replace, on its own grid: the quantity is linear between the wavelengths and constant
/// beyond them.
Xyzs integral(const Spectrum& light, const std::vector<double>& nm, const std::vector<double>& values) {
  std::vector<double> grid;
  std::vector<double> product;
  for (int at = 360; at <= 830; ++at) {
    const double inside = std::clamp<double>(at, nm.front(), nm.back());
    grid.push_back(at);
    product.push_back(light(at) * (nm.size() == 1 ? values.front() : Spectrum(nm, values)(inside)));
  }
  return integrate_xyzs({std::move(grid), std::move(product)});
}

void expect_same(const Xyzs& a, const Xyzs& b) {
  const double scale = 1.0e-13 * (std::abs(b.x) + std::abs(b.y) + std::abs(b.z) + std::abs(b.s));
  EXPECT_NEAR(a.x, b.x, scale);
  EXPECT_NEAR(a.y, b.y, scale);
  EXPECT_NEAR(a.z, b.z, scale);
  EXPECT_NEAR(a.s, b.s, scale);
}

TEST(SpectralWeights, AreExactForWhatIsLinearBetweenTheWavelengths) {
  const std::vector<std::vector<double>> grids{
      {360.0, 370.0, 400.0, 450.0, 600.0, 830.0},
      {440.0, 550.0, 680.0},         // constant beyond
      {380.5, 411.37, 500.0, 777.7}, // not on the grid
      {200.0, 300.0, 555.0, 900.0},  // from outside
      {500.0, 500.2, 500.4, 501.0},  // finer than the grid
      {100.0, 200.0},                // all on one side
      {900.0, 1000.0},
  };
  for (const Spectrum& light :
       {solar_irradiance_1au(), planck_spectrum(3000.0), Spectrum({500, 501, 700}, {0, 1, 2})}) {
    for (const std::vector<double>& nm : grids) {
      const SpectralWeights weights = spectral_weights(light, nm);
      for (std::size_t seed = 1; seed < 4; ++seed) {
        std::vector<double> values;
        for (std::size_t i = 0; i < nm.size(); ++i) {
          values.push_back(std::sin(static_cast<double>(seed * (3 * i + 1))));
        }
        expect_same(weights(values), integral(light, nm, values));
      }
    }
  }
}

TEST(SpectralWeights, OfAConstantAreTheLightItself) {
  const Xyzs sun = integrate_xyzs(solar_irradiance_1au());
  expect_same(spectral_weights(solar_irradiance_1au(), {550.0})({1.0}), sun);
  expect_same(spectral_weights(solar_irradiance_1au(), {10.0})({1.0}), sun);
  expect_same(spectral_weights(solar_irradiance_1au(), {440.0, 550.0, 680.0})({1.0, 1.0, 1.0}), sun);
}

TEST(SpectralWeights, AreZeroInTheDark) {
  const Xyzs dark = spectral_weights(Spectrum({400, 700}, {0, 0}), {440.0, 550.0})({1.0, 2.0});
  expect_same(dark, {});
  const Xyzs infrared = spectral_weights(Spectrum({900, 1000}, {1, 1}), {440.0, 550.0})({1.0, 2.0});
  expect_same(infrared, {});
}

TEST(SpectralWeights, RefuseWhatIsNoSetOfWavelengths) {
  const Spectrum& sun = solar_irradiance_1au();
  EXPECT_THROW(static_cast<void>(spectral_weights(sun, {})), Error);
  EXPECT_THROW(static_cast<void>(spectral_weights(sun, {550.0, 440.0})), Error);
  EXPECT_THROW(static_cast<void>(spectral_weights(sun, {550.0, 550.0})), Error);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(spectral_weights(sun, {nan})), Error);
  EXPECT_THROW(static_cast<void>(spectral_weights(sun, {440.0, nan, 550.0})), Error);
  EXPECT_THROW(static_cast<void>(spectral_weights(sun, {440.0, infinity})), Error);
  EXPECT_THROW(static_cast<void>(spectral_weights(sun, {440.0, 550.0})({1.0})), Error);
}

} // namespace
} // namespace vesper
