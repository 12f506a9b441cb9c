// The parts of `vesper-report sky`: where it looks, what lights the sky, what is kept of unfinished work.
#include "report/crew.hpp"
#include "report/sky_light.hpp"
#include "report/sky_partial.hpp"
#include "report/sky_points.hpp"
#include "report/sky_request.hpp"

#include "support/folder_test.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

namespace vesper {
namespace {

using test::FolderTest;

CsvTable table_of(const std::string& text) {
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return {std::move(bytes), "points.csv"};
}

TEST(SkyPoints, DirectionsRunFromNorthThroughEast) {
  EXPECT_LT(glm::length(SeenPlace{0.0, 90.0}.direction() - Vec3(1.0, 0.0, 0.0)), 1e-15);
  EXPECT_LT(glm::length(SeenPlace{0.0, 0.0}.direction() - Vec3(0.0, 1.0, 0.0)), 1e-15);
  EXPECT_LT(glm::length(SeenPlace{90.0, 123.0}.direction() - Vec3(0.0, 0.0, 1.0)), 1e-15);
}

TEST(SkyPoints, ATableMayHoldASunForEachRow) {
  const auto plain = points_of_table(table_of("azimuth_deg,altitude_deg\n270,-5\n"));
  ASSERT_EQ(plain.size(), 1U);
  EXPECT_EQ(plain[0].place.azimuth_deg, 270.0);
  EXPECT_EQ(plain[0].place.altitude_deg, -5.0);
  EXPECT_FALSE(plain[0].sun);
  const auto with_sun = points_of_table(table_of("altitude_deg,azimuth_deg,sun_altitude_deg\n90,0,-12\n"));
  ASSERT_TRUE(with_sun.at(0).sun);
  EXPECT_EQ(with_sun[0].sun->altitude_deg, -12.0);
  EXPECT_EQ(with_sun[0].sun->azimuth_deg, 180.0);
}

TEST(SkyPoints, ATablesFaultsNameLineAndColumn) {
  for (const auto& [text, words] : {std::pair{"altitude_deg\n90\n", "azimuth_deg"},
                                    std::pair{"altitude_deg,azimuth_deg\n90,0\n91,0\n", "line 3, column altitude_deg"},
                                    std::pair{"altitude_deg,azimuth_deg\n", "no rows"}}) {
    try {
      static_cast<void>(points_of_table(table_of(text)));
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  }
}

TEST(SkyPoints, AFisheyeHoldsTheSkyInsideItsCircle) {
  View view; // the whole sky, south below
  view.width = view.height = 64;
  const std::vector<SkyPoint> points = points_of_view(view);
  EXPECT_NEAR(static_cast<double>(points.size()), 64.0 * 64.0 * std::numbers::pi / 4.0, 40.0);
  for (const SkyPoint& point : points) {
    EXPECT_GE(point.place.altitude_deg, 0.0);
    const double x = point.pixel[0] + 0.5 - 32.0;
    const double y = point.pixel[1] + 0.5 - 32.0;
    EXPECT_NEAR(90.0 - point.place.altitude_deg, std::hypot(x, y) * 90.0 / 32.0, 1e-9);
    // East on the left, south below.
    const Vec3 seen = point.place.direction();
    EXPECT_GT(-x * seen.x, 0.0);
    EXPECT_GT(-y * seen.y, 0.0);
  }
}

/// Noon and midnight of a summer's day at Greenwich.
SkyState sky_at(const char* time) {
  return sky_state(parse_instant(time, TimeScale::utc), {51.4769 * deg, 0.0 * deg, 47.0 * metre});
}

TEST(SkyLight, LightsStandAtTheirAirlessPlaces) {
  const SkyState sky = sky_at("2026-06-21T03:45:00Z"); // sunrise
  ASSERT_NEAR(sky.sun.altitude.to(deg), -0.5, 0.5);
  EXPECT_NEAR(latitude_of(lights_of(sky).at(0).direction).to(deg), sky.sun.altitude.to(deg), 1e-12);
}

TEST(SkyLight, ADeepSunLightsNothing) {
  const SkyState sky = sky_at("2026-01-03T00:00:00Z"); // the Sun 61 degrees below the horizon, the full Moon up
  const std::vector<SkyLight> lights = lights_of(sky);
  ASSERT_EQ(lights.size(), 1U);
  EXPECT_EQ(lights[0].name, "moon");
  EXPECT_NEAR(lights[0].angular_radius.to(arcmin), 15.5, 1.5);
  // Twilight of the Sun is seen where that of the Moon is not: both stand 11 to 16 degrees below the horizon.
  const SkyState dawn = sky_at("2026-03-21T04:45:00Z");
  ASSERT_LT(dawn.sun.altitude.to(deg), -11.0);
  ASSERT_LT(dawn.moon.place.altitude.to(deg), -11.0);
  ASSERT_GT(dawn.moon.place.altitude.to(deg), -16.0);
  const std::vector<SkyLight> twilight = lights_of(dawn);
  ASSERT_EQ(twilight.size(), 1U);
  EXPECT_EQ(twilight[0].name, "sun");
}

TEST(SkyLight, SunlightFallsWithTheSquareOfTheDistance) {
  const SkyLight near = sun_light({0.0, 0.0, 1.0}, astronomical_unit);
  const SkyLight far = sun_light({0.0, 0.0, 1.0}, 2.0 * astronomical_unit);
  EXPECT_NEAR(integrate_xyzs(near.irradiance).y, 133500.0, 500.0); // 133 to 134 klx
  EXPECT_NEAR(far.irradiance(550.0) / near.irradiance(550.0), 0.25, 1e-12);
  EXPECT_NEAR(near.angular_radius.to(arcsec), 959.63, 0.01);
  EXPECT_NEAR(far.angular_radius / near.angular_radius, 0.5, 1e-5);
}

class Partial : public FolderTest {
protected:
  [[nodiscard]] PartialResults open(const std::string& request = "a request") const {
    return {path("out.csv.partial"), request, 10, 2};
  }
};

TEST_F(Partial, KeepsWhatIsFinishedToTheLastDigit) {
  {
    PartialResults first = open();
    EXPECT_TRUE(first.finished().empty());
    first.add(7, {0.1 + 0.2, -1e-300});
    first.add(3, {1.0, 2.0});
  }
  const PartialResults second = open();
  EXPECT_EQ(second.finished().size(), 2U);
  EXPECT_EQ(second.finished().at(7), (std::vector<double>{0.1 + 0.2, -1e-300}));
}

TEST_F(Partial, ATornLastLineIsAsIfItWereNotThere) {
  for (const char* torn : {"4,0.5,0.2", "4,0.5", "4", "4,0.5,x\n", "99,1,2\n", "\n", "4,1,2,3\n"}) {
    write("out.csv.partial", std::string("a request\n3,1,2\n") + torn);
    open().add(5, {8.0, 9.0});
    EXPECT_EQ(text(path("out.csv.partial")), "a request\n3,1,2\n5,8,9\n") << torn;
  }
  write("out.csv.partial", "a req"); // cut off while it began
  EXPECT_TRUE(open().finished().empty());
  EXPECT_EQ(text(path("out.csv.partial")), "a request\n");
}

TEST_F(Partial, AnotherRequestIsRefusedAndNothingIsLost) {
  open().add(3, {1.0, 2.0});
  const std::string before = text(path("out.csv.partial"));
  EXPECT_THROW(static_cast<void>(open("another request")), Error);
  EXPECT_EQ(text(path("out.csv.partial")), before);
}

TEST(WorkAlone, EveryUnitIsDoneOnceWhateverTheThreads) {
  for (const unsigned threads : {1U, 3U, 40U}) {
    const std::vector<std::size_t> units{5, 1, 9, 4};
    std::vector<double> found;
    std::atomic<int> at_work{0};
    work_alone(
        units, threads,
        [&](std::size_t unit, unsigned for_it) {
          const int others = at_work++;
          EXPECT_LE((others + 1) * static_cast<int>(for_it), static_cast<int>(threads));
          --at_work;
          return std::vector<double>{static_cast<double>(unit)};
        },
        [&](std::size_t unit, const std::vector<double>& result) {
          EXPECT_EQ(result.at(0), static_cast<double>(unit));
          found.push_back(result[0]);
        });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, (std::vector<double>{1.0, 4.0, 5.0, 9.0}));
  }
}

/// A request's digest tells what decides its results from what does not.
TEST(SkyRequest, TheFingerprintIsThatOfTheAnswer) {
  SkyOptions options;
  options.reference = true;
  options.sun_altitude = "10";
  const auto digest = [](const SkyOptions& sky, const BudgetOptions& budget, const SceneOptions& scene) {
    return fingerprint(sky_request(sky, budget, scene, std::nullopt, false));
  };
  const SceneOptions scene = scene_from({});
  const std::string first = digest(options, {}, scene);
  BudgetOptions threads;
  threads.threads = "7";
  EXPECT_EQ(digest(options, threads, scene), first);
  SceneOptions other_time = scene; // without meaning for a Sun set by hand
  other_time.instant = parse_instant("2000-01-01", TimeScale::utc);
  EXPECT_EQ(digest(options, {}, other_time), first);

  BudgetOptions finer;
  finer.relative_error = "0.001";
  EXPECT_NE(digest(options, finer, scene), first);
  SceneOptions seeded = scene;
  seeded.seed = 1;
  EXPECT_NE(digest(options, {}, seeded), first);
  SceneOptions thicker = scene;
  thicker.medium = std::make_shared<const Medium>(clear_medium({.aerosol_optical_depth = 0.11}));
  EXPECT_NE(digest(options, {}, thicker), first);
  SkyOptions lower = options;
  lower.sun_altitude = "9";
  EXPECT_NE(digest(lower, {}, scene), first);
  SkyOptions redder = options;
  redder.wavelengths = "700";
  EXPECT_NE(digest(redder, {}, scene), first);
}

} // namespace
} // namespace vesper
