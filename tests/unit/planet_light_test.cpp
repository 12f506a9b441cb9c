// The colours of the planets, and the calming of a disc's scintillation.
#include "vesper/base/error.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/planet_light.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vesper {
namespace {

double redness(Planet planet) {
  const Chromaticity c = chromaticity(planet_light(planet).color);
  return c.x;
}

TEST(PlanetLight, AWhiteBodyShinesAsTheSun) {
  const ReflectedLight white = reflected_sunlight({{300.0, 900.0}, {0.5, 0.5}});
  const Xyzs sun = integrate_xyzs(solar_irradiance_1au());
  EXPECT_NEAR(white.color.x, sun.x / sun.y, 1e-12);
  EXPECT_NEAR(white.color.z, sun.z / sun.y, 1e-12);
  EXPECT_NEAR(white.color.s, sun.s / sun.y, 1e-12);
  EXPECT_NEAR(white.lux_ratio, star_lux_ratio(0.65), 0.01);
  EXPECT_THROW(static_cast<void>(reflected_sunlight({{300.0, 900.0}, {0.0, 0.0}})), Error);
}

TEST(PlanetLight, ColoursAreInTheOrderThatTheEyeSees) {
  // Mars reddest, Saturn yellower than Jupiter, Venus nearly the Sun's white, Neptune bluest.
  EXPECT_GT(redness(Planet::mars), redness(Planet::saturn));
  EXPECT_GT(redness(Planet::saturn), redness(Planet::jupiter));
  EXPECT_GT(redness(Planet::jupiter), redness(Planet::venus));
  EXPECT_GT(redness(Planet::venus), redness(Planet::uranus));
  EXPECT_GT(redness(Planet::uranus), redness(Planet::neptune));
  EXPECT_NEAR(redness(Planet::venus), chromaticity(star_color(0.65)).x, 0.01);
  for (int i = 0; i < planet_count; ++i) {
    const ReflectedLight& light = planet_light(static_cast<Planet>(i));
    EXPECT_EQ(light.color.y, 1.0);
    EXPECT_TRUE(light.lux_ratio > 0.95 && light.lux_ratio < 1.08) << light.lux_ratio;
  }
}

TEST(PlanetLight, VenusAtItsBrightestCastsShadows) {
  // V = -4.9: about a five-hundredth of the full Moon's 0.31 lux at most.
  const double venus = planet_illuminance(Planet::venus, -4.9).to(lux);
  EXPECT_NEAR(venus, 2.54e-6 * std::pow(10.0, 0.4 * 4.9) * 1.02, 0.03 * venus);
  EXPECT_EQ(planet_illuminance(Planet::venus, std::numeric_limits<double>::infinity()).to(lux), 0.0);
}

TEST(DiscScintillation, APointKeepsItsPupilAndAWideDiscIsCalm) {
  EXPECT_EQ(f64::disc_pupil(0.007, 0.0, 0.5), 0.007);
  const auto sigma = [](double diameter_rad, double sin_altitude) {
    const double pupil = f64::disc_pupil(0.007, diameter_rad, sin_altitude);
    return std::sqrt(
        f64::scintillation_index(f64::rytov_variance(555.0e-9, f64::scintillation_secant(sin_altitude), pupil)));
  };
  const double star = sigma(0.0, 1.0);
  EXPECT_LT(sigma((10.0 * arcsec).to(rad), 1.0), 0.15 * star);
  EXPECT_GT(sigma((10.0 * arcsec).to(rad), 1.0), 0.02 * star);
  EXPECT_LT(sigma((40.0 * arcsec).to(rad), 1.0), 0.03 * star);
  EXPECT_GT(sigma((0.1 * arcsec).to(rad), 1.0), 0.95 * star);
  // Lower down it twinkles more, though its patch of air widens.
  EXPECT_GT(sigma((10.0 * arcsec).to(rad), 0.2), sigma((10.0 * arcsec).to(rad), 1.0));
  EXPECT_TRUE(std::isfinite(sigma((60.0 * arcsec).to(rad), 0.0)));
}

} // namespace
} // namespace vesper
