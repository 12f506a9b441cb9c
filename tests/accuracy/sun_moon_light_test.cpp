// The light of Sun and Moon above the atmosphere against figures from outside (tests/data/README.md).
#include "vesper/base/shader_math.hpp"
#include "vesper/light/earthshine.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

namespace vesper {
namespace {

constexpr Length moon_distance = 384400.0 * kilometre;

Spectrum full_moon() { return moon_irradiance(0.0 * deg, moon_distance, astronomical_unit); }

/// Bessell 1990 (PASP 102, 1181), table 2: the B band.
double through_b_band(const Spectrum& light) {
  const std::vector<double> response{0.000, 0.030, 0.134, 0.567, 0.920, 0.978, 1.000, 0.978, 0.935, 0.853, 0.740,
                                     0.640, 0.536, 0.424, 0.325, 0.235, 0.150, 0.095, 0.043, 0.009, 0.000};
  std::vector<double> nm;
  for (std::size_t i = 0; i < response.size(); ++i) {
    nm.push_back(360.0 + 10.0 * static_cast<double>(i));
  }
  const Spectrum band(nm, response);
  double sum = 0.0;
  for (int at = 360; at <= 560; ++at) {
    sum += light(at) * band(at);
  }
  return sum;
}

double b_over_v(const Spectrum& light) { return through_b_band(light) / integrate_v_band(light); }

/// The V magnitude of a spectrum, from the flux that a star of V = 0 has through the band: 3.631e-11 W/(m2 nm)
/// (Bessell, Castelli and Plez 1998, A&A 333, 231, table A2). Another zero point than the library's, which is in lux.
double v_magnitude_1998(const Spectrum& light) {
  const double band = integrate_v_band({{300.0, 900.0}, {1.0, 1.0}});
  return -2.5 * std::log10(integrate_v_band(light) / band / 3.631e-11);
}

TEST(Sunlight, GivesTheSolarIlluminance) {
  const double klx = 1.0e-3 * integrate_xyzs(solar_irradiance_1au()).y;
  std::printf("Sun above the atmosphere: %.2f klx (133.3 .. 133.8)\n", klx);
  test::ErrorSum error;
  error.add(klx - 133.55);
  error.hold("Sun above the atmosphere against 133.3 to 133.8 klx", 0.25, "klx");
}

TEST(Sunlight, HasTheColourOfThePublishedIntegral) {
  // Linear sRGB of the Sun above the atmosphere, W/m2 weighted by the matching functions: the notes on Atmosphere Plus.
  const Xyzs sun = integrate_xyzs(solar_irradiance_1au());
  const double x = sun.x / photopic_efficacy_lm_w;
  const double y = sun.y / photopic_efficacy_lm_w;
  const double z = sun.z / photopic_efficacy_lm_w;
  test::ErrorSum error;
  // IEC 61966-2-1.
  error.add(100.0 * ((3.2406 * x - 1.5372 * y - 0.4986 * z) / 213.866 - 1.0));
  error.add(100.0 * ((-0.9689 * x + 1.8758 * y + 0.0415 * z) / 190.346 - 1.0));
  error.add(100.0 * ((0.0557 * x - 0.2040 * y + 1.0570 * z) / 183.806 - 1.0));
  error.hold("linear sRGB of the Sun against a published integral", 1.0, "%");
}

TEST(Sunlight, HasTheMagnitudeOfTheSun) {
  // -26.76 (Torres 2010, AJ 140, 1158; Willmer 2018, ApJS 236, 47).
  test::ErrorSum error;
  error.add(v_magnitude_1998(solar_irradiance_1au()) + 26.76);
  error.hold("V of the Sun against -26.76", 0.03, "mag");
}

TEST(Sunlight, HoldsAsMuchAsABlackBodyOfItsTemperature) {
  // 5772 K and 695 700 km (IAU 2015 resolution B3). Lines take from the blue, the continuum gives back in the red: the
  // visible as a whole holds a little more.
  double sun = 0.0;
  double black_body = 0.0;
  const double solid_angle = std::numbers::pi * std::pow(695700.0 * kilometre / astronomical_unit, 2.0);
  for (int nm = 360; nm < 830; ++nm) {
    sun += 0.5 * (solar_irradiance_1au()(nm) + solar_irradiance_1au()(nm + 1));
    black_body += solid_angle * planck_w_m2_sr_nm(nm + 0.5, 5772.0);
  }
  std::printf("360 to 830 nm: %.1f W/m2, black body of 5772 K %.1f W/m2\n", sun, black_body);
  EXPECT_NEAR(sun / black_body, 1.0, 0.04);
}

Spectrum moon_at(double phase_deg) { return moon_irradiance(phase_deg * deg, moon_distance, astronomical_unit); }

/// Krisciunas and Schaefer 1991, eq. 9.
double published_v(double phase_deg) { return -12.73 + 0.026 * phase_deg + 4.0e-9 * std::pow(phase_deg, 4); }

TEST(Moonlight, FollowsThePublishedPhaseLaw) {
  test::ErrorSum measured;
  test::ErrorSum crescent;
  for (double phase = 7.0; phase <= 150.0; phase += 0.5) {
    (phase <= 120.0 ? measured : crescent).add(v_magnitude_1998(moon_at(phase)) - published_v(phase));
  }
  measured.hold("V of the Moon against Krisciunas and Schaefer 1991, 7 to 120 degrees, zero point of 1998", 0.05,
                "mag");
  crescent.hold("V of the Moon against Krisciunas and Schaefer 1991, 120 to 150 degrees", 0.2, "mag");
}

TEST(Moonlight, FallsBeyondThePublishedLawAsTheTable) {
  // Allen 1973, sec. 66: 7.5 mag fainter than full at 160 degrees.
  test::ErrorSum error;
  error.add(moon_v_magnitude(160.0 * deg) + 12.73 - 7.5);
  error.hold("V of the Moon at 160 degrees of phase against Allen 1973", 0.4, "mag");
}

TEST(Moonlight, HasTheOppositionSurge) {
  const auto surge = [](double phase) { return published_v(phase) - moon_v_magnitude(phase * deg); };
  std::printf("surge: %.3f mag at 0, %.3f at 1.5, %.3f at 4, %.3f at 7 degrees\n", surge(0.0), surge(1.5), surge(4.0),
              surge(7.0));
  test::ErrorSum size;
  size.add(surge(0.0) - surge(7.0) - 0.275);
  size.hold("opposition surge of the full Moon against 0.2 to 0.35 mag", 0.075, "mag");
  // Buratti, Hillier and Wang 1996: more than 40 % from 4 degrees to 0.
  const double gain = integrate_v_band(moon_at(0.0)) / integrate_v_band(moon_at(4.0));
  test::ErrorSum clementine;
  clementine.add(100.0 * (gain - 1.40));
  clementine.hold("the Moon's gain from 4 degrees to 0 against Clementine's 40 %", 3.0, "% of the light at 4 degrees");
}

TEST(Moonlight, IsThatOfTheFullMoon) {
  const double full = integrate_xyzs(full_moon()).y / std::pow(10.0, 0.4 * f64::lunar_surge_mag(0.0));
  std::printf("full Moon without surge %.4f lx\n", full);
  test::ErrorSum illuminance;
  illuminance.add(100.0 * (full / 0.31 - 1.0));
  illuminance.hold("full Moon without surge above the atmosphere against 0.31 lx", 6.0, "%");
}

/// B-V with that of the Sun 0.65.
double b_v_of(const Spectrum& light) {
  return 0.65 - 2.5 * std::log10(b_over_v(light) / b_over_v(solar_irradiance_1au()));
}

TEST(Moonlight, IsRedderThanTheSunAsMeasured) {
  // 0.92 (Harris 1961, in Allen 1973); 0.94 over all phases (Gallouet 1963).
  std::printf("B-V of the Moon: %.3f full, %.3f at 45 degrees, %.3f at the quarters\n", b_v_of(moon_at(0.0)),
              b_v_of(moon_at(45.0)), b_v_of(moon_at(90.0)));
  test::ErrorSum error;
  error.add(b_v_of(moon_at(0.0)) - 0.92);
  error.add(b_v_of(moon_at(5.0)) - 0.92);
  error.add(b_v_of(moon_at(60.0)) - 0.93);
  error.add(b_v_of(moon_at(90.0)) - 0.94);
  error.hold("B-V of the Moon against photometry", 0.03, "mag");
}

TEST(Earthlight, HasTheMagnitudeAndColourOfTheEarth) {
  const auto earthlight = [](double phase) { return earth_irradiance(phase * deg, moon_distance, astronomical_unit); };
  // Mallama and Hilton 2018, eq. 5: V = 5 log10(r d) - 3.99 - 1.060e-3 a + 2.054e-4 a^2.
  test::ErrorSum magnitude;
  for (const double phase : {0.0, 30.0, 90.0, 150.0}) {
    const double theirs =
        5.0 * std::log10(moon_distance / astronomical_unit) - 3.99 - 1.060e-3 * phase + 2.054e-4 * phase * phase;
    magnitude.add(v_magnitude_1998(earthlight(phase)) - theirs);
  }
  magnitude.hold("V of the Earth from the Moon against Mallama and Hilton 2018", 0.05, "mag");
  std::printf("full Earth: %.2f lx, %.4g of sunlight\n", integrate_xyzs(earthlight(0.0)).y,
              integrate_v_band(earthlight(0.0)) / integrate_v_band(solar_irradiance_1au()));
  test::ErrorSum share;
  share.add(100.0 * (integrate_v_band(earthlight(0.0)) / integrate_v_band(solar_irradiance_1au()) / 1.19e-4 - 1.0));
  share.hold("light of the full Earth on the Moon against 1.19e-4 of sunlight", 1.0, "%");
  // Thejll et al. 2014: earthlight 0.44 +- 0.02, the dark side 0.150 bluer than the bright one beside it.
  test::ErrorSum colour;
  colour.add(b_v_of(earthlight(60.0)) - 0.44);
  colour.hold("B-V of earthlight against Thejll et al. 2014", 0.03, "mag");
  const double dark = b_v_of(filtered(earthlight(60.0), moon_albedo(1.0 * deg)));
  std::printf("B-V: earthlight %.3f, dark side %.3f, bright side %.3f\n", b_v_of(earthlight(60.0)), dark,
              b_v_of(moon_at(120.0)));
  test::ErrorSum difference;
  difference.add(b_v_of(moon_at(120.0)) - dark - 0.15);
  difference.hold("B-V of the bright less that of the dark side against Thejll et al. 2014", 0.1, "mag");
}

/// Albedo of the disc without libration, mean of the waxing and the waning Moon: Kieffer and Stone 2005, eq. 10.
Spectrum rolo_albedo(double phase_deg) {
  const std::string path = std::string(VESPER_TEST_DATA) + "/light/rolo_reflectance.csv";
  const CsvTable table(read_file(path), path);
  const double phase = (phase_deg * deg).to(rad);
  std::vector<double> nm;
  std::vector<double> albedo;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto number = [&](const char* column) { return table.number(row, table.column(column)); };
    nm.push_back(number("wavelength_nm"));
    albedo.push_back(std::exp(number("a0") + phase * (number("a1") + phase * (number("a2") + phase * number("a3"))) +
                              number("d1") * std::exp(-phase_deg / 4.06054) +
                              number("d2") * std::exp(-phase_deg / 12.8802) +
                              number("d3") * std::cos((phase_deg + 30.5858) / 16.7498)));
  }
  return {std::move(nm), std::move(albedo)};
}

TEST(Moonlight, HasTheColourOfTheLunarIrradianceModel) {
  // Photometry through wide bands finds the full Moon redder (B-V 0.92) than this model does (0.84), and B-V is held to
  // it above: what the model has more lies in the violet, where its bands of 405, 412 and 414 nm differ by 9 %.
  test::ErrorSum bands;
  test::ErrorSum violet;
  test::ErrorSum x;
  test::ErrorSum y;
  test::ErrorSum lux_per_v;
  for (const double phase : {2.0, 7.0, 20.0, 45.0, 90.0, 110.0}) {
    const Spectrum rolo = rolo_albedo(phase);
    const Spectrum albedo = moon_albedo(phase * deg);
    const Spectrum theirs = filtered(solar_irradiance_1au(), rolo);
    const Spectrum ours = moon_irradiance(phase * deg, moon_distance, astronomical_unit);
    const double scale = integrate_v_band(filtered(solar_irradiance_1au(), albedo)) / integrate_v_band(theirs);
    for (std::size_t i = 0; i < rolo.values().size(); ++i) {
      const double nm = rolo.wavelengths_nm()[i];
      if (nm >= 400.0 && nm <= 830.0) {
        (nm < 420.0 ? violet : bands).add(100.0 * (albedo(nm) / (scale * rolo.values()[i]) - 1.0));
      }
    }
    x.add(chromaticity(integrate_xyzs(ours)).x - chromaticity(integrate_xyzs(theirs)).x);
    y.add(chromaticity(integrate_xyzs(ours)).y - chromaticity(integrate_xyzs(theirs)).y);
    lux_per_v.add(100.0 * (lux_per_v_flux(ours) / lux_per_v_flux(theirs) - 1.0));
  }
  bands.hold("lunar albedo against Kieffer and Stone 2005, 441 to 775 nm, 2 to 110 degrees of phase, equal in V", 10.0,
             "%");
  violet.hold("lunar albedo against Kieffer and Stone 2005, 405 to 414 nm, 2 to 110 degrees of phase, equal in V", 15.0,
              "%");
  x.hold("CIE x of moonlight against Kieffer and Stone 2005", 0.006, "");
  y.hold("CIE y of moonlight against Kieffer and Stone 2005", 0.006, "");
  lux_per_v.hold("lux per V of moonlight against Kieffer and Stone 2005", 0.5, "%");
}

TEST(Moonlight, BrightnessFollowsTheLunarIrradianceModel) {
  // Velikodsky et al. 2011 find that model's albedo 13 % low, Krisciunas and Schaefer's law is good to some 20 %.
  constexpr double moon_solid_angle = 6.4177e-5;
  for (const double phase : {7.0, 20.0, 45.0, 90.0}) {
    const double model =
        integrate_v_band(filtered(solar_irradiance_1au(), rolo_albedo(phase))) * moon_solid_angle / std::numbers::pi;
    const double ours = integrate_v_band(moon_irradiance(phase * deg, moon_distance, astronomical_unit));
    const double difference = -2.5 * std::log10(ours / model);
    std::printf("phase angle %2.0f: %+.3f mag against Kieffer and Stone 2005\n", phase, difference);
    EXPECT_LT(std::abs(difference), 0.3) << phase;
  }
}

} // namespace
} // namespace vesper
