// The light that the eye adapts to, from noon to the dark night.
#include "vesper/sky/scene_white.hpp"

#include "support/truth.hpp"

#include "vesper/base/shader_math.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/sky/moon_illumination.hpp"
#include "vesper/sky/sky_light.hpp"

#include <array>
#include <cstdio>
#include <limits>

namespace vesper {
namespace {

const Observer la_palma{28.76 * deg, -17.88 * deg, 0.0 * metre};
const Vec2 white_of_displays(0.3127, 0.3290);

Vec2 xy_of(const Vec3& xyz) { return Vec2(xyz) / (xyz.x + xyz.y + xyz.z); }
Vec2 xy_of(const Spectrum& light) { return xy_of(Vec3(vector_of(integrate_xyzs(light)))); }

SkyState sky_at(const char* utc, double later_s = 0.0, const Observer& observer = la_palma) {
  return sky_state(later(parse_instant(utc), later_s), observer);
}

/// log10 of the Sun's lux on level ground: Janiczek and DeYoung 1987 (USNO Circular 171), as in Vallado's Fundamentals
/// of Astrodynamics, table 5-1. Below -12 degrees it has the night sky's own light in it.
double published_lux(double altitude_deg) {
  struct Piece {
    double from_deg;
    std::array<double, 4> terms;
  };
  constexpr std::array<Piece, 5> pieces{{{20.0, {3.74, 3.97, -4.07, 1.47}},
                                         {5.0, {3.05, 13.28, -45.98, 64.33}},
                                         {-0.8, {2.88, 22.26, -207.64, 1034.30}},
                                         {-5.0, {2.88, 21.81, -258.11, -858.36}},
                                         {-12.0, {2.70, 12.17, -431.69, -1899.83}}}};
  const double x = altitude_deg / 90.0;
  for (const Piece& piece : pieces) {
    if (altitude_deg >= piece.from_deg) {
      const auto& t = piece.terms;
      return std::pow(10.0, t[0] + x * (t[1] + x * (t[2] + x * t[3])));
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(SceneWhite, CountsLightsByWhatTheyGiveTheGround) {
  constexpr double sun_lux = 133.3e3; // above the air
  test::ErrorSum error;
  double last = 0.0;
  for (double altitude = -12.0; altitude <= 90.0; altitude += 0.5) {
    const double share = share_on_level_ground(altitude * deg);
    error.add(std::log2(share * sun_lux / published_lux(altitude)));
    EXPECT_GT(share, last);
    last = share;
  }
  EXPECT_LT(last, 1.0);
  error.hold("illuminance of level ground by altitude, -12 to 90 degrees, against published fits", std::log2(1.8),
             "octaves");
}

TEST(SceneWhite, IsThatOfSunMoonOrTheDisplay) {
  const SkyState noon = sky_at("2026-08-14T13:10:00Z");
  const Vec3 by_day = adapting_light(noon);
  EXPECT_NEAR(by_day.y, 1.2e5, 0.2e5);
  EXPECT_LT(glm::distance(xy_of(by_day), xy_of(sunlight_of(noon))), 1.0e-5);
  const SkyState full_moon = sky_at("2026-08-28T01:30:00Z");
  EXPECT_LT(glm::distance(xy_of(adapting_light(full_moon)), xy_of(moonlight_of(full_moon))), 1.0e-3);
  const Vec3 dark = adapting_light(sky_at("2026-08-15T01:00:00Z"));
  EXPECT_LT(glm::distance(xy_of(dark), white_of_displays), 1.0e-6);
  EXPECT_NEAR(dark.y, 1.0e-3, 1.0e-6);
}

/// Chromaticities from one instant to another, a minute apart.
std::vector<Vec2> whites(const char* utc, int minutes) {
  std::vector<Vec2> all;
  for (int minute = 0; minute <= minutes; ++minute) {
    all.push_back(xy_of(adapting_light(sky_at(utc, 60.0 * minute))));
  }
  return all;
}

TEST(SceneWhite, GoesSmoothlyFromTheSunsToTheMoonsAndToTheNights) {
  // The eye follows a new white within a minute (half at once, the rest by halves in 20 s: Rinner and Gegenfurtner
  // 2000, Vision Research 40, 1813), in which this one must not go more than a tenth of the way from the Sun's to the
  // Moon's.
  const SkyState full_moon = sky_at("2026-08-28T01:30:00Z");
  const double sun_to_moon = glm::distance(xy_of(sunlight_of(full_moon)), xy_of(moonlight_of(full_moon)));
  // Three hours from before sunset: with a half Moon up, with a full Moon that rises meanwhile, and without one.
  for (const char* from : {"2026-08-20T19:20:00Z", "2026-08-28T19:20:00Z", "2026-08-13T19:20:00Z"}) {
    const std::vector<Vec2> white = whites(from, 180);
    double fastest = 0.0;
    for (std::size_t i = 1; i < white.size(); ++i) {
      fastest = std::max(fastest, glm::distance(white[i], white[i - 1]));
    }
    const double all = glm::distance(white.front(), white.back());
    std::printf("%s: x, y from %.4f, %.4f to %.4f, %.4f in three hours, at most %.4f a minute\n", from, white.front().x,
                white.front().y, white.back().x, white.back().y, fastest);
    EXPECT_GT(all, 0.005) << from;
    EXPECT_LT(fastest, 0.1 * sun_to_moon) << from;
  }
}

TEST(SceneWhite, KeepsTheColourOfEclipses) {
  const Observer mangalore{12.87 * deg, 74.88 * deg, 0.0 * metre};
  const SkyState total = sky_at("2011-06-15T20:12:37Z", 0.0, mangalore);
  const Vec2 copper = xy_of(moonlight_of(total));
  EXPECT_GT(copper.x, 0.45);
  EXPECT_LT(glm::distance(xy_of(adapting_light(total)), white_of_displays), 0.002) << "the night is dark";
  // While a part of the Moon is lit, white lies between the night's and the full Moon's.
  const Vec2 moon = xy_of(moon_illumination(total).sunlit_moon);
  for (const double minutes : {-100.0, -80.0, -60.0, 60.0, 80.0, 100.0}) {
    const Vec2 white = xy_of(adapting_light(sky_at("2011-06-15T20:12:37Z", 60.0 * minutes, mangalore)));
    const Vec2 way = moon - white_of_displays;
    const double share = glm::dot(white - white_of_displays, way) / glm::dot(way, way);
    EXPECT_LT(glm::distance(white, white_of_displays + share * way), 1.0e-4);
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.001);
  }
}

TEST(SceneWhite, IsFoundForANewMoonAndInATotalEclipseOfTheSun) {
  const Observer burgos{42.34 * deg, -3.70 * deg, 900.0 * metre};
  for (const SkyState& sky : {sky_at("2026-08-12T17:37:00Z"), sky_at("2026-08-12T18:29:30Z", 0.0, burgos)}) {
    const Vec3 light = adapting_light(sky);
    EXPECT_GT(light.y, 1.0e3);
    EXPECT_LT(glm::distance(xy_of(light), xy_of(sun_light({0.0, 0.0, 1.0}, sky.sun.distance).irradiance)), 1.0e-4);
  }
}

} // namespace
} // namespace vesper
