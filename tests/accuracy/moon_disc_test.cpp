// The Moon's disc: its luminance added up by other means against the light that the sky is lit by, and its figures.
#include "vesper/astro/constants.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/moon_disc.hpp"
#include "vesper/sky/sky_light.hpp"

#include "support/moon_relief.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

const Observer mangalore{12.87 * deg, 74.88 * deg, 22.0 * metre};

SkyState sky_on(double days_after_new_year) {
  return sky_state(later(parse_instant("2026-01-01T00:00:00Z"), 86400.0 * days_after_new_year), mangalore);
}

/// Instants through a year, with every phase and libration.
std::vector<SkyState> skies(int count) {
  std::vector<SkyState> states;
  states.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    states.push_back(sky_on(365.25 * (i + 0.37) / count));
  }
  return states;
}

/// Luminance times solid angle over all view rays that meet the sphere: no map, no samples, no cubes. Rays stand on
/// rings of equal solid angle about the disc's centre.
template <class Surface> Vec4 added_up(const MoonDisc& disc, const Surface& surface, int rings) {
  const double sine = moon_mean_radius / disc.distance;
  const double one_less_cosine = sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)));
  const double distance = disc.distance / moon_mean_radius;
  const Vec3 forward = disc.moon_fixed_from_horizon * disc.direction;
  const Vec3 right = glm::normalize(glm::cross(forward, std::abs(forward.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
  const Vec3 up = glm::cross(right, forward);
  Vec4 sum(0.0);
  for (int i = 0; i < rings; ++i) {
    const double less = one_less_cosine * (i + 0.5) / rings;
    const double s = std::sqrt(less * (2.0 - less));
    for (int k = 0; k < rings; ++k) {
      const double turn = 2.0 * pi * (k + 0.5) / rings;
      const Vec3 ray = (1.0 - less) * forward + s * (std::cos(turn) * right + std::sin(turn) * up);
      const double across = distance * s;
      const double to_surface = distance * (1.0 - less) - std::sqrt(std::max(0.0, 1.0 - across * across));
      const Vec3 place = glm::normalize(to_surface * ray - distance * forward);
      const test::SurfacePlace at = surface(place);
      sum += f64::moon_luminance(at.albedo, place, at.normal, -ray, disc.lighting, Vec4(1.0));
    }
  }
  return 2.0 * pi * one_less_cosine / (rings * rings) * sum;
}

/// The same with the light of one of the two only.
MoonDisc lit_by_one(MoonDisc disc, bool sun) {
  (sun ? disc.lighting.earthlit : disc.lighting.sunlit) = Vec4(0.0);
  return disc;
}

template <class Surface> void compare(const Surface& surface, const std::string& what) {
  const MoonGlobe globe = moon_globe(test::map_of(surface, 192));
  test::ErrorSum bright;
  test::ErrorSum thin;
  for (const SkyState& sky : skies(43)) {
    const MoonDisc disc = moon_disc(sky, globe);
    if (sky.lunar_eclipse.penumbral_magnitude > 0.0) {
      continue;
    }
    const double phase = sky.moon.phase_angle.to(deg);
    const Vec4 light = added_up(disc, surface, phase < 150.0 ? 300 : 1000);
    for (const double ratio : {light.x / disc.illuminance.x, light.y / disc.illuminance.y, light.z / disc.illuminance.z,
                               light.w / disc.illuminance.s}) {
      (phase < 172.0 ? bright : thin).add(100.0 * (ratio - 1.0));
    }
  }
  bright.hold(what + ": luminance over the disc against the Moon's irradiance, to 172 degrees of phase", 0.5, "%");
  thin.hold(what + ": luminance over the disc against the Moon's irradiance, thinner crescents", 1.0, "%");
}

TEST(MoonDisc, AddsUpToTheLightOfTheMoon) { compare(test::waved_surface, "a Moon with relief"); }
TEST(MoonDisc, AddsUpToTheLightOfAnEvenMoon) { compare(test::even_surface, "an even Moon"); }

TEST(MoonDisc, AddsUpToTheLightOfTheEclipsedMoon) {
  // Each place with its own share of the sunlight against the mean over the disc that lights the air.
  const MoonGlobe globe = moon_globe(default_moon_map());
  test::ErrorSum y;
  test::ErrorSum others;
  for (const char* middle : {"2010-12-21T08:17:00Z", "2011-06-15T20:12:37Z", "2012-06-04T11:03:00Z"}) {
    for (int quarters = -12; quarters <= 12; ++quarters) {
      const SkyState sky = sky_state(later(parse_instant(middle), 900.0 * quarters), mangalore);
      const MoonDisc disc = moon_disc(sky, globe);
      const LunarEclipseState& eclipse = sky.lunar_eclipse;
      const LunarEclipseTable table = lunar_eclipse_table(eclipse, moon_illumination(sky).sunlit_moon);
      const f64::EarthShadow shadow = earth_shadow(eclipse, sky.moon.moon_fixed_from_icrs);
      const Vec3 moon_km = sky.moon.moon_fixed_from_icrs * eclipse.moon_km;
      const Vec4 drawn = sum_moon_light(
          globe.samples, disc.distance / moon_mean_radius * disc.to_observer, disc.lighting, [&](const Vec3& normal) {
            return f64::lunar_eclipse_shares(moon_km + moon_mean_radius.to(kilometre) * normal, shadow, table.frame,
                                             table.sampler());
          });
      y.add(100.0 * (drawn.y / disc.illuminance.y - 1.0));
      for (const double ratio :
           {drawn.x / disc.illuminance.x, drawn.z / disc.illuminance.z, drawn.w / disc.illuminance.s}) {
        others.add(100.0 * (ratio - 1.0));
      }
    }
  }
  y.hold("luminance over the eclipsed disc against the irradiance", 0.5, "%");
  others.hold("X, Z and S of it", 0.7, "%");
}

double gain(const f64::LunarLaw& drawn, const f64::LunarLaw& law) {
  return (drawn.seeliger + drawn.lambert) / (law.seeliger + law.lambert);
}

TEST(MoonDisc, OfTheBuiltInMapIsSampledFinelyEnough) {
  // Its light against that of many more places; and its laws against those for an even sphere.
  const MoonGlobe globe = moon_globe(default_moon_map());
  const MoonSamples many = sample_moon(default_moon_map(), 600000);
  test::ErrorSum sampling;
  test::ErrorSum crescents;
  test::ErrorSum sun;
  test::ErrorSum earth;
  for (const SkyState& sky : skies(47)) {
    const MoonDisc disc = moon_disc(sky, globe);
    const MoonIllumination moon = moon_illumination(sky);
    const f64::MoonLighting& lighting = disc.lighting;
    const MoonLightSums sums =
        sum_moon_light(many, disc.distance / moon_mean_radius * disc.to_observer, lighting, disc.fixed_from_disc);
    if (sky.moon.phase_angle < 172.0 * deg) {
      (sky.moon.phase_angle < 125.0 * deg ? sampling : crescents)
          .add(100.0 * (sums.sun * lighting.sunlit.y / integrate_xyzs(moon.sunlit_moon).y - 1.0));
    }
    sampling.add(100.0 * (sums.earth * lighting.earthlit.y / integrate_xyzs(moon.earthlit_moon).y - 1.0));
    if (sky.moon.phase_angle < 150.0 * deg) {
      sun.add(100.0 * (gain(lighting.sun_law, lunar_law(sky.moon.phase_angle)) - 1.0));
    }
    earth.add(100.0 * (gain(lighting.earth_law, lunar_law(moon.earthlight_phase)) - 1.0));
  }
  sampling.hold("light of the built-in map from the places added up, to 125 degrees of phase", 0.2, "%");
  crescents.hold("light of the built-in map from the places added up, 125 to 172 degrees of phase", 0.3, "%");
  sun.hold("light of the built-in map by the Sun against the phase law, to 150 degrees of phase, scaled away", 20.0,
           "%");
  earth.hold("light of the built-in map by the Earth against that of an even sphere, scaled away", 5.0, "%");
}

TEST(MoonDisc, LitArcsEndWhereTheSunSets) {
  // Against steps along lines; near the horns a line may cut what is dark between them, which then lies inside the arc.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  test::ErrorSum error;
  int lit_lines = 0;
  for (int i = 0; i < 4000; ++i) {
    const double elongation = 0.25 * pi * (1.0 + unit(random)); // of the Sun behind the disc
    const double turned = pi * unit(random);
    const Vec3 to_sun(std::sin(elongation) * std::cos(turned), std::sin(elongation) * std::sin(turned),
                      std::cos(elongation));
    const double reach = 0.05 * (1.0 + unit(random));
    const Vec2 from(1.2 * unit(random), 1.2 * unit(random));
    const Vec2 line(0.4 * unit(random), 0.4 * unit(random));
    constexpr int steps = 4000;
    double first = 2.0;
    double last = -2.0;
    for (int k = 0; k < steps; ++k) {
      const double t = (k + 0.5) / steps;
      const Vec2 place = from + t * line;
      const double square = glm::dot(place, place);
      if (square < 1.0 && glm::dot(to_sun, Vec3(place, -std::sqrt(1.0 - square))) > -reach) {
        first = std::min(first, t);
        last = t;
      }
    }
    const f64::DiscArc arc = f64::disc_lit_arc(from, line, to_sun, reach);
    if (last < first) {
      error.add(steps * arc.radius * (std::sin(arc.end) - std::sin(arc.start)));
      continue;
    }
    ++lit_lines;
    error.add(steps * (arc.middle + arc.radius * std::sin(arc.start) - first));
    error.add(steps * (arc.middle + arc.radius * std::sin(arc.end) - last));
  }
  EXPECT_GT(lit_lines, 800);
  error.hold("ends of what a line shows of a crescent", 1.0, "steps of 1/4000 of the line");
}

TEST(MoonDisc, GivesTheSkyTheSameLight) {
  const MoonGlobe globe = moon_globe(test::map_of(test::waved_surface, 32));
  test::ErrorSum error;
  for (const SkyState& sky : skies(40)) {
    const MoonDisc disc = moon_disc(sky, globe);
    for (const SkyLight& light : lights_of(sky)) {
      if (light.name == "moon" && sky.moon.phase_angle < 170.0 * deg) {
        error.add(100.0 * (integrate_xyzs(light.irradiance).y / disc.illuminance.y - 1.0));
        EXPECT_EQ(light.direction, disc.direction);
        EXPECT_NEAR(light.angular_radius.to(arcsec), disc.angular_radius.to(arcsec), 1.0e-9);
      }
    }
  }
  error.hold("the Moon's light on the air against that of its disc", 1.0e-9, "%");
}

TEST(MoonDisc, EvenSurfaceNeedsNoGain) {
  // The law's own gain is exact for a smooth sphere of one albedo far away and a Sun without a disc.
  const MoonGlobe globe = moon_globe(test::map_of(test::even_surface, 32));
  test::ErrorSum error;
  for (const SkyState& sky : skies(60)) {
    const double phase = sky.moon.phase_angle.to(deg);
    if (phase < 120.0) {
      const MoonDisc disc = moon_disc(sky, globe);
      const f64::LunarLaw law = lunar_law(sky.moon.phase_angle);
      // The albedo of the map is 0.12, the Moon's in lux 0.119: 133.3 klx of sunlight against 0.31 of moonlight.
      error.add(100.0 * (gain(disc.lighting.sun_law, law) * 0.12 / 0.1190 - 1.0));
    }
  }
  error.hold("the law's gain over a smooth sphere", 2.5, "%");
}

TEST(MoonDisc, LibrationPointLiesUnderTheObserver) {
  test::ErrorSum centre;
  test::ErrorSum pole;
  const MoonGlobe globe = moon_globe(test::map_of(test::even_surface, 16), 100);
  for (const SkyState& sky : skies(30)) {
    const MoonDisc disc = moon_disc(sky, globe);
    const Vec3 under = disc.moon_fixed_from_horizon * -disc.direction;
    centre.add(
        test::separation(under, test::direction(sky.moon.libration.longitude, sky.moon.libration.latitude)).to(arcsec));
    EXPECT_NEAR(glm::determinant(disc.moon_fixed_from_horizon), 1.0, 1.0e-12);
    // The pole's position angle against the zenith: what the state says of the axis and the parallactic angle.
    const Vec3 north = glm::transpose(disc.moon_fixed_from_horizon)[2];
    const Angle from_zenith = position_angle(disc.direction, glm::normalize(disc.direction + 1.0e-3 * north));
    pole.add(test::angle_difference(from_zenith, sky.moon.axis - sky.moon.parallactic).to(deg));
  }
  centre.hold("point under the observer against the libration", 1.0e-6, "arcsec");
  pole.hold("position angle of the drawn axis against the zenith", 0.01, "degrees");
}

TEST(MoonDisc, FullMoonHasTheLuminanceAndLuxOfTheAnchors) {
  // 2026-01-03, 10:03 UTC; no eclipse. Anchors: 5000 cd/m2 and 0.31 lx without the surge, at the mean distances.
  const SkyState sky = sky_state(parse_instant("2026-01-03T10:30:00Z"), mangalore);
  const MoonDisc disc = moon_disc(sky, moon_globe(test::map_of(test::waved_surface, 64)));
  const double phase = sky.moon.phase_angle.to(deg);
  const double surge = std::pow(10.0, 0.4 * f64::lunar_surge_mag(phase));
  const double course = std::pow(10.0, 0.4 * 0.026 * phase);
  const double sun = std::pow(moon_illumination(sky).sun_distance / astronomical_unit, 2);
  const double luminance = disc.mean_luminance.to(candela_per_m2) / surge * course * sun;
  const double near = std::pow(disc.distance / (384400.0 * kilometre), 2);
  std::printf("phase %.2f degrees: %.0f cd/m2, %.3f lx, V = %.2f, with the surge of %.2f mag\n", phase,
              disc.mean_luminance.to(candela_per_m2), disc.illuminance.y, disc.v_magnitude, 2.5 * std::log10(surge));
  test::ErrorSum error;
  error.add(100.0 * (luminance / 5000.0 - 1.0));
  error.hold("mean luminance of the full Moon's disc without surge against 5000 cd/m2", 10.0, "%");
  test::ErrorSum lux_error;
  lux_error.add(100.0 * (disc.illuminance.y / surge * course * sun * near / 0.31 - 1.0));
  lux_error.hold("illuminance of the full Moon without surge against 0.31 lx", 6.0, "%");
}

/// B over V of X, Y, Z: bluer light has more Z for its Y.
double blueness(const Vec4& light) { return light.z / light.y; }

TEST(Earthshine, DarkSideOfAThinCrescent) {
  const MoonGlobe globe = moon_globe(test::map_of(test::waved_surface, 64));
  test::ErrorSum brightness;
  int crescents = 0;
  double brightest = 99.0;
  double faintest = 0.0;
  for (const SkyState& sky : skies(400)) {
    const double phase = sky.moon.phase_angle.to(deg);
    if (phase < 135.0 || phase > 170.0) {
      continue;
    }
    ++crescents;
    const MoonDisc disc = moon_disc(sky, globe);
    // The mean of the disc without the Sun. 108e3 cd/m2 is one of V = 0 in a square second of arc.
    const double solid_angle_sr = pi * std::pow(std::sin(disc.angular_radius.to(rad)), 2);
    const Vec4 dark = added_up(lit_by_one(disc, false), test::even_surface, 40) / solid_angle_sr;
    const double magnitude = -2.5 * std::log10(dark.y / 10.8e4);
    brightest = std::min(brightest, magnitude);
    faintest = std::max(faintest, magnitude);
    brightness.add(magnitude - 12.75);
    EXPECT_GT(blueness(disc.lighting.earthlit), 1.08 * blueness(disc.lighting.sunlit)) << phase;
  }
  EXPECT_GT(crescents, 20);
  std::printf("dark side: %.2f to %.2f mag in a square second of arc\n", brightest, faintest);
  brightness.hold("dark side at a thin crescent against 12 to 13.5 mag/arcsec2", 0.75, "mag");
}

} // namespace
} // namespace vesper
