// What is lost where a few wavelengths stand for the spectrum, and where one light's tables serve another: against the
// light field at all of the medium's wavelengths.
#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/spectral_rule.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/media.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace vesper {
namespace {

/// The sky of a medium as spectra: all of its wavelengths, from several heights.
struct SkySpectra {
  struct Entry {
    double light_deg;
    std::vector<double> radiance;
  };
  std::vector<double> wavelengths_nm;
  std::vector<Entry> entries;
};

SkySpectra sky_spectra(const Medium& medium) {
  SkySpectra result{medium.wavelengths_nm, {}};
  const SampledAir air(medium);
  const SpectralAir optics(medium, medium.wavelengths_nm);
  const LightField field(air, optics, {16, 12, 6, 10, 5, 0.25, 0.5, 0.02, 8});
  for (const double light : {60.0, 30.0, 10.0, 3.0, 0.0, -2.0, -4.0, -6.0, -9.0, -12.0}) {
    for (const double height : {0.0, 2.4, 11.0}) {
      for (const double altitude : {90.0, 30.0, 8.0, 1.0}) {
        for (const double azimuth : {0.0, 90.0, 180.0}) {
          const SkyQuery query{height * kilometre, test::direction(0.0 * deg, light * deg), 0.2666 * deg,
                               test::direction(azimuth * deg, altitude * deg)};
          result.entries.push_back({light, field.radiance(query)});
        }
      }
    }
  }
  return result;
}

struct RuleSpan {
  const char* name;
  double lowest_deg;
  double highest_deg;
  double limit; ///< of the RMS, %
};

/// Holds the RMS of X, Y, Z and S over the sky; `what(radiance)` gives the right ones and those under test.
using Pair = std::pair<Xyzs, Xyzs>;
void compare_rule(const SkySpectra& sky, const std::string& name, const std::vector<RuleSpan>& spans,
                  const std::function<Pair(const std::vector<double>&)>& what) {
  for (const RuleSpan& span : spans) {
    std::array<test::ErrorSum, 4> sums;
    for (const SkySpectra::Entry& entry : sky.entries) {
      if (entry.light_deg >= span.lowest_deg && entry.light_deg <= span.highest_deg) {
        const auto [exact, found] = what(entry.radiance);
        sums[0].add(100.0 * (found.x / exact.x - 1.0));
        sums[1].add(100.0 * (found.y / exact.y - 1.0));
        sums[2].add(100.0 * (found.z / exact.z - 1.0));
        sums[3].add(100.0 * (found.s / exact.s - 1.0));
      }
    }
    test::ErrorSum rms;
    for (const test::ErrorSum& sum : sums) {
      rms.add(sum.rms());
    }
    rms.hold(name + ", " + span.name + ": RMS over the sky of X, Y, Z, S", span.limit, "%");
  }
}

void eight_wavelengths(const Medium& medium, const SkySpectra& sky, const std::string& name) {
  const SpectralRule rule = spectral_rule(medium, solar_irradiance_1au(), 8);
  ASSERT_EQ(rule.wavelengths_nm.size(), 8U);
  const SpectralWeights exact = spectral_weights(solar_irradiance_1au(), sky.wavelengths_nm);
  std::vector<std::size_t> places;
  for (const double nm : rule.wavelengths_nm) {
    const auto found = std::lower_bound(sky.wavelengths_nm.begin(), sky.wavelengths_nm.end(), nm);
    ASSERT_TRUE(found != sky.wavelengths_nm.end() && *found == nm);
    places.push_back(static_cast<std::size_t>(found - sky.wavelengths_nm.begin()));
  }
  compare_rule(sky, name + ", eight wavelengths",
               {{"light above 0 degrees", 0.0, 90.0, 0.2},
                {"0 to -6 degrees", -6.0, -0.1, 1.0},
                {"-6 to -12 degrees", -12.0, -6.1, 1.0}},
               [&](const std::vector<double>& radiance) {
                 std::vector<double> few(places.size());
                 std::transform(places.begin(), places.end(), few.begin(),
                                [&](std::size_t place) { return radiance[place]; });
                 return Pair{exact(radiance), rule.weights(few)};
               });
}

TEST(SpectralRule, ClearAirAndItsMoonlightThroughTheMatrix) {
  const Medium medium = clear_medium();
  const SkySpectra sky = sky_spectra(medium);
  eight_wavelengths(medium, sky, "clear");

  const SpectralWeights sun = spectral_weights(solar_irradiance_1au(), sky.wavelengths_nm);
  const double sun_lux = integrate_xyzs(solar_irradiance_1au()).y;
  for (const double phase : {2.0, 90.0, 140.0}) {
    const Spectrum moon = moon_irradiance(phase * deg, moon_mean_distance, 149597870.7 * kilometre);
    const SpectralWeights exact = spectral_weights(moon, sky.wavelengths_nm);
    const Mat4 matrix = response_matrix(solar_irradiance_1au(), moon);
    const double moon_lux = integrate_xyzs(moon).y;
    compare_rule(sky, "Moon of phase angle " + std::to_string(static_cast<int>(phase)) + " through the Sun's light",
                 {{"above 0 degrees", 0.0, 90.0, 0.5}, {"0 to -12 degrees", -12.0, -0.1, 0.5}},
                 [&](const std::vector<double>& radiance) {
                   const Xyzs s = sun(radiance);
                   const Vec4 m = matrix * Vec4(s.x, s.y, s.z, s.s) * (moon_lux / sun_lux);
                   return Pair{exact(radiance), Xyzs{m.x, m.y, m.z, m.w}};
                 });
  }
}

TEST(SpectralRule, DenseAerosol) {
  ClearAir haze;
  haze.aerosol_optical_depth = 1.0;
  const Medium medium = clear_medium(haze);
  eight_wavelengths(medium, sky_spectra(medium), "aerosol of depth 1");
}

TEST(SpectralRule, KeepsTheWavelengthsOfAMediumThatHasFew) {
  const SpectralRule rule = spectral_rule(published_medium(), solar_irradiance_1au(), 3);
  EXPECT_EQ(rule.wavelengths_nm, published_medium().wavelengths_nm);
  EXPECT_EQ(rule.weights.y, spectral_weights(solar_irradiance_1au(), rule.wavelengths_nm).y);
}

TEST(SpectralRule, HasNoNegativeWeightsInAnyAir) {
  Medium odd = published_medium();
  odd.wavelengths_nm = {440.0, 480.0, 520.0, 560.0, 600.0, 640.0, 680.0};
  for (const Medium& medium :
       {clear_medium(), test::scaled(clear_medium(), 0.0), test::scaled(clear_medium(), 100.0), odd}) {
    for (const std::size_t most : {1U, 2U, 5U, 12U}) {
      const SpectralRule rule = spectral_rule(medium, solar_irradiance_1au(), most);
      EXPECT_EQ(rule.wavelengths_nm.size(), std::min<std::size_t>(most, medium.wavelengths_nm.size()));
      EXPECT_TRUE(std::is_sorted(rule.wavelengths_nm.begin(), rule.wavelengths_nm.end()));
      for (const auto* weights : {&rule.weights.x, &rule.weights.y, &rule.weights.z, &rule.weights.s}) {
        EXPECT_EQ(weights->size(), rule.wavelengths_nm.size());
        EXPECT_TRUE(std::all_of(weights->begin(), weights->end(), [](double w) { return w >= 0.0; }));
      }
    }
  }
  EXPECT_THROW((void)spectral_rule(clear_medium(), solar_irradiance_1au(), 0), Error);
}

} // namespace
} // namespace vesper
