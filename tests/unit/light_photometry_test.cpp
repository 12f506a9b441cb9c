#include "vesper/base/error.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectrum.hpp"
#include "vesper/light/star_color.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace vesper {
namespace {

TEST(Spectrum, IsLinearBetweenSamplesAndZeroOutside) {
  const Spectrum spectrum({400, 500, 700}, {1, 3, 5});
  EXPECT_DOUBLE_EQ(spectrum(400), 1);
  EXPECT_DOUBLE_EQ(spectrum(450), 2);
  EXPECT_DOUBLE_EQ(spectrum(500), 3);
  EXPECT_DOUBLE_EQ(spectrum(600), 4);
  EXPECT_DOUBLE_EQ(spectrum(700), 5);
  EXPECT_EQ(spectrum(399.999), 0);
  EXPECT_EQ(spectrum(700.001), 0);
  EXPECT_EQ(spectrum(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Spectrum, RefusesBrokenTables) {
  EXPECT_THROW(Spectrum({400}, {1}), Error);
  EXPECT_THROW(Spectrum({400, 500}, {1}), Error);
  EXPECT_THROW(Spectrum({400, 400}, {1, 1}), Error);
  EXPECT_THROW(Spectrum({500, 400}, {1, 1}), Error);
  EXPECT_THROW(static_cast<void>(planck_spectrum(0.0)), Error);
  EXPECT_THROW(static_cast<void>(planck_spectrum(std::numeric_limits<double>::infinity())), Error);
}

// Stefan-Boltzmann and Wien are independent of the formula's coefficients as written.
TEST(Planck, IntegratesToStefanBoltzmannAndPeaksWhereWienSays) {
  const double temperature = 5772.0;
  double radiance = 0.0;
  double peak_nm = 0.0;
  double peak = 0.0;
  for (double nm = 100.5; nm < 100000.0; nm += 1.0) {
    const double value = planck_w_m2_sr_nm(nm, temperature);
    radiance += value;
    if (value > peak) {
      peak = value;
      peak_nm = nm;
    }
  }
  const double expected = 5.670374419e-8 * std::pow(temperature, 4) / 3.14159265358979;
  EXPECT_NEAR(radiance / expected, 1.0, 1e-5);
  EXPECT_NEAR(peak_nm, 2.897771955e6 / temperature, 1.0);
}

TEST(ResponseFunctions, HaveTheirMaximaWhereTheCieHasThem) {
  EXPECT_DOUBLE_EQ(cie_y_bar()(555), 1.0);
  EXPECT_NEAR(cie_scotopic()(507), 1.0, 0.015); // the 10 nm table misses the maximum of 1 at 507 nm
  EXPECT_DOUBLE_EQ(v_band()(530), 1.0);
  EXPECT_EQ(v_band()(470), 0.0);
  EXPECT_EQ(v_band()(700), 0.0);
}

// An equal-energy spectrum lies at the white point E by the definition of the CIE 1931 system.
TEST(ResponseFunctions, EqualEnergyIsWhite) {
  const Chromaticity white = chromaticity(integrate_xyzs(Spectrum({300, 900}, {1, 1})));
  EXPECT_NEAR(white.x, 1.0 / 3.0, 1e-4);
  EXPECT_NEAR(white.y, 1.0 / 3.0, 1e-4);
}

// Light of 555 nm: 683 lm/W; its S is V'(555) of 1700 lm/W.
TEST(ResponseFunctions, UseTheEfficaciesOfTheirStandards) {
  const Spectrum line({554, 555, 556}, {0, 1, 0}); // 1 W/m2
  const Xyzs light = integrate_xyzs(line);
  EXPECT_NEAR(light.y, 683.0, 0.01);
  EXPECT_NEAR(light.s, 1700.0 * 0.4049, 1.0);
}

TEST(Photometry, MagnitudesAndLuxAreInverse) {
  for (const double v : {-26.75, -1.46, 0.0, 6.5, 30.0}) {
    for (const double ratio : {0.99, 1.0, 1.3}) {
      EXPECT_NEAR(v_of_illuminance(illuminance_of_v(v, ratio), ratio), v, 1e-12);
    }
  }
  EXPECT_DOUBLE_EQ(illuminance_of_v(0.0, 1.0).to(lux), 2.54e-6);
  EXPECT_NEAR(illuminance_of_v(5.0, 1.0).to(lux), 2.54e-8, 1e-20);
  EXPECT_EQ(v_of_illuminance(0.0 * lux, 1.0), std::numeric_limits<double>::infinity());
  EXPECT_THROW(static_cast<void>(lux_per_v_flux(Spectrum({800, 900}, {1, 1}))), Error);
}

TEST(StarColor, StatesItsTemperatures) {
  EXPECT_NEAR(star_temperature_k(min_star_b_v), 21707, 1);
  EXPECT_NEAR(star_temperature_k(max_star_b_v), 1386, 1);
}

TEST(StarColor, TableAgreesWithDirectIntegration) {
  const double a0 = lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  double worst = 0.0;
  for (double b_v = -0.397; b_v < 6.0; b_v += 0.0731) {
    const Spectrum spectrum = planck_spectrum(star_temperature_k(b_v));
    const Xyzs direct = integrate_xyzs(spectrum);
    const Xyzs table = star_color(b_v);
    EXPECT_EQ(table.y, 1.0);
    worst = std::max({worst, std::abs(table.x * direct.y / direct.x - 1), std::abs(table.z * direct.y / direct.z - 1),
                      std::abs(table.s * direct.y / direct.s - 1),
                      std::abs(star_lux_ratio(b_v) / (lux_per_v_flux(spectrum) / a0) - 1)});
  }
  std::printf("star colour table: worst relative error %.1e\n", worst);
  EXPECT_LT(worst, 1e-4);
}

} // namespace
} // namespace vesper
