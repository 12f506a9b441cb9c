#include "common/scene_options.hpp"

#include "common/program.hpp"
#include "common/scene_option_table.hpp"

#include "support/folder_test.hpp"

#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vesper {
namespace {

/// The test's folder also stands in for the user's settings.
class SceneOptionsTest : public test::FolderTest {
protected:
  void SetUp() override {
    FolderTest::SetUp();
    std::filesystem::create_directories(folder() / "vesper");
    ::setenv("XDG_CONFIG_HOME", folder().c_str(), 1);
  }

  static SceneOptions resolve(std::vector<std::string> arguments) {
    CLI::App app("test", "test");
    prepare_program(app);
    const SceneOptionSet options(app);
    std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
    app.parse(std::move(arguments));
    return options.resolve(Assumptions::silent);
  }

  static std::string error_of(const std::vector<std::string>& arguments) {
    try {
      (void)resolve(arguments);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::argument);
      return e.what();
    }
    return "";
  }
};

TEST_F(SceneOptionsTest, DefaultsAreTheWholeSkyOverGreenwichNow) {
  const SceneOptions scene = resolve({});
  EXPECT_NEAR(scene.observer.latitude.to(deg), 51.4769, 1e-12);
  EXPECT_NEAR(scene.observer.height.to(metre), 47.0, 1e-9);
  EXPECT_EQ(scene.view.projection, Projection::fisheye);
  EXPECT_NEAR(scene.view.azimuth.to(deg), 180.0, 1e-12);
  EXPECT_NEAR(scene.view.altitude.to(deg), 90.0, 1e-12);
  EXPECT_NEAR(scene.view.fov.to(deg), 180.0, 1e-12);
  EXPECT_EQ(scene.view.width, 1024);
  EXPECT_EQ(scene.view.height, 1024);
  EXPECT_EQ(scene.layers, all_layers());
  EXPECT_EQ(scene.tier, Tier::standard);
  EXPECT_FALSE(scene.latitude_given);
}

TEST_F(SceneOptionsTest, CommandLineBeatsSceneFileBeatsSettings) {
  write("vesper/settings.toml", "latitude = 1\nlongitude = 2.5\nheight = 3\nseed = 4\n");
  const std::string scene_file =
      write("scene.toml", "longitude = 20\nheight = 30.5\ntime = 2026-08-12T22:00:00Z\nlayers = [\"stars\"]\n");
  const SceneOptions scene = resolve({"--height", "300", "--scene", scene_file});
  EXPECT_NEAR(scene.observer.latitude.to(deg), 1.0, 1e-12);
  EXPECT_NEAR(scene.observer.longitude.to(deg), 20.0, 1e-12);
  EXPECT_NEAR(scene.observer.height.to(metre), 300.0, 1e-12);
  EXPECT_EQ(scene.seed, 4U);
  EXPECT_EQ(to_iso8601(scene.instant), "2026-08-12T22:00:00.000Z");
  EXPECT_TRUE(has(scene.layers, Layer::stars));
  EXPECT_FALSE(has(scene.layers, Layer::ground));
}

TEST_F(SceneOptionsTest, TheLastOfRepeatedOptionsWins) {
  EXPECT_NEAR(resolve({"--latitude", "10", "--latitude", "-20"}).observer.latitude.to(deg), -20.0, 1e-12);
}

TEST_F(SceneOptionsTest, DependentDefaultsFollowTheProjection) {
  EXPECT_NEAR(resolve({"--projection", "perspective"}).view.fov.to(deg), 60.0, 1e-12);
  EXPECT_EQ(resolve({"--projection", "cubemap"}).view.height, 6 * 1024);
  EXPECT_EQ(resolve({"--projection", "cubemap", "--size", "256x256"}).view.height, 1536);
  EXPECT_EQ(resolve({"--projection", "cubemap", "--size", "256x1536"}).view.width, 256);
}

TEST_F(SceneOptionsTest, RangesAreHeldAndNamed) {
  struct Case {
    std::vector<std::string> arguments;
    const char* in_message;
  };
  const std::vector<Case> cases{
      {{"--latitude", "90.1"}, "--latitude: '90.1' is not allowed; allowed: -90 to 90"},
      {{"--latitude", "north"}, "--latitude: 'north'"},
      {{"--latitude", "nan"}, "--latitude: 'nan'"},
      {{"--latitude", ""}, "--latitude: ''"},
      {{"--longitude", "-181"}, "-180 to 360"},
      {{"--height", "1e9"}, "-500 to 100000000"},
      {{"--pressure", "1101"}, "0 to 1100 hPa"},
      {{"--pressure", "-1"}, "0 to 1100 hPa"},
      {{"--temperature", "60.5"}, "-90 to 60 degrees Celsius"},
      {{"--temperature", "warm"}, "-90 to 60 degrees Celsius"},
      {{"--azimuth", "361"}, "-360 to 360"},
      {{"--altitude", "91"}, "-90 to 90"},
      {{"--projection", "mercator"}, "perspective, fisheye, stereographic, equirectangular, cubemap"},
      {{"--fov", "170", "--projection", "perspective"}, "0 < fov < 170"},
      {{"--fov", "0"}, "0 < fov <= 360"},
      {{"--fov", "361"}, "0 < fov <= 360"},
      {{"--fov", "350", "--projection", "stereographic"}, "0 < fov < 350"},
      {{"--size", "0x10"}, "1 to 16384"},
      {{"--size", "16385x10"}, "1 to 16384"},
      {{"--size", "100"}, "WIDTHxHEIGHT"},
      {{"--size", "100x100x100"}, "WIDTHxHEIGHT"},
      {{"--size", "100x200", "--projection", "cubemap"}, "Wx6W"},
      {{"--tier", "best"}, "cheap, default, reference"},
      {{"--medium", "mars"}, "--medium: 'mars' is not allowed; allowed: clear, published or a file"},
      {{"--medium", ""}, "clear, published or a file"},
      {{"--solar-flux", "59"}, "60 to 400 solar flux units"},
      {{"--sky-glow", "1.5"}, "bortle1 to bortle9"},
      {{"--sky-glow", "-0.1"}, "0 to 1 (cd/m2)"},
      {{"--sky-glow", "22.1mag"}, "10mag to 22mag"},
      {{"--sky-glow", "bortle10"}, "bortle1 to bortle9"},
      {{"--sky-glow", "mag"}, "10mag to 22mag"},
      {{"--sky-glow-azimuth", "361"}, "-360 to 360 degrees"},
      {{"--sky-glow-distance", "0.5"}, "1 to 300 km"},
      {{"--layers", "stars,moonbase"}, "stars, planets, milky-way, moon, sun, sky, airglow"},
      {{"--layers", "stars,"}, "stars, planets, milky-way, moon, sun, sky, airglow"},
      {{"--seed", "-1"}, "0 to 18446744073709551615"},
      {{"--time-scale", "gps"}, "utc, ut1, tt"},
      {{"--time", "2026-02-30"}, "month 2 has no day 30"},
  };
  for (const Case& c : cases) {
    EXPECT_NE(error_of(c.arguments).find(c.in_message), std::string::npos)
        << c.arguments[0] << " " << c.arguments[1] << ": " << error_of(c.arguments);
  }
}

TEST_F(SceneOptionsTest, TheAirIsTheStandardAtmospheresUnlessGiven) {
  // US Standard Atmosphere 1976 at 2 km: 795.01 hPa, 275.154 K.
  const std::vector<std::string> place{"--latitude", "28", "--longitude", "-17", "--height", "2000"};
  const Refraction standard = sky_state_of(resolve(place)).refraction;
  EXPECT_EQ(standard.model, RefractionModel::traced);
  EXPECT_NEAR(standard.conditions.pressure_hpa, 795.01, 0.1);
  EXPECT_NEAR(standard.conditions.temperature_c, 2.004, 0.01);
  EXPECT_EQ(standard.conditions.height.to(metre), 2000.0);
  const Refraction given =
      sky_state_of(resolve({"--pressure", "780.5", "--temperature", "-7", "--tier", "cheap"})).refraction;
  EXPECT_EQ(given.model, RefractionModel::published);
  EXPECT_EQ(given.conditions.pressure_hpa, 780.5);
  EXPECT_EQ(given.conditions.temperature_c, -7.0);
}

TEST_F(SceneOptionsTest, TheEclipsedMoonIsLitThroughTheSceneAir) {
  const std::vector<std::string> total{"--time", "2010-12-21T08:17:00Z"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), total.begin(), total.end());
    return sky_state_of(resolve(more)).eclipse_air;
  };
  EXPECT_EQ(with({}).danjon, 2.5);
  EXPECT_EQ(with({"--danjon", "0.5"}).danjon, 0.5);
  EXPECT_FALSE(with({}).light); // the built-in map's
  const SceneOptions other = resolve({"--medium", "published", "--time", "2010-12-21T08:17:00Z"});
  const EclipseAir air = sky_state_of(other).eclipse_air;
  ASSERT_TRUE(air.light);
  EXPECT_EQ(air.light, sky_state_of(other).eclipse_air.light) << "made once for a medium";
  EXPECT_FALSE(sky_state_of(resolve({"--medium", "published", "--time", "2010-12-14"})).eclipse_air.light);
}

TEST_F(SceneOptionsTest, TheMediumIsClearAirUnlessGiven) {
  const SceneOptions scene = resolve({});
  EXPECT_EQ(scene.medium_name, "clear");
  ASSERT_TRUE(scene.medium);
  EXPECT_EQ(scene.medium->components.size(), 4U);
  EXPECT_EQ(resolve({"--medium", "published"}).medium->components.size(), 3U);
}

TEST_F(SceneOptionsTest, AMediumsFileLiesBesideTheSceneFile) {
  write("hazy.toml", "base = \"clear\"\nground_albedo = 0.75\n");
  std::filesystem::create_directories(folder() / "scenes");
  write("scenes/hazier.toml", "base = \"clear\"\nground_albedo = 0.5\n");
  const std::string scene_file = write("scenes/scene.toml", "medium = \"hazier.toml\"\n");
  const SceneOptions scene = resolve({"--scene", scene_file});
  EXPECT_EQ(scene.medium->ground_albedo(550.0), 0.5);
  EXPECT_EQ(scene.medium_name, path("scenes/hazier.toml"));
  EXPECT_EQ(resolve({"--scene", scene_file, "--medium", path("hazy.toml")}).medium->ground_albedo(550.0), 0.75);
  EXPECT_EQ(
      resolve({"--scene", write("scenes/other.toml", "medium = \"../hazy.toml\"\n")}).medium->ground_albedo(550.0),
      0.75);
}

TEST_F(SceneOptionsTest, FaultsOfAMediumsFileAreNoFaultsOfTheOption) {
  const auto kind_of = [](const std::vector<std::string>& arguments) {
    try {
      (void)resolve(arguments);
    } catch (const Error& e) {
      return e.kind();
    }
    return ErrorKind::gpu;
  };
  EXPECT_EQ(kind_of({"--medium", path("none.toml")}), ErrorKind::file);
  EXPECT_EQ(kind_of({"--medium", write("bad.toml", "base = \"clear\"\nozone = 300\n")}), ErrorKind::input);
  // What the command line overrides is not looked at.
  EXPECT_NO_THROW((void)resolve({"--scene", write("s.toml", "medium = \"bad.toml\"\n"), "--medium", "clear"}));
}

TEST_F(SceneOptionsTest, FaultsInFilesNameFileAndLine) {
  const auto error_in = [&](const std::string& text) { return error_of({"--scene", write("s.toml", text)}); };
  EXPECT_NE(error_in("seed = 1\nlatitud = 5\n").find("s.toml: line 2, column 1: key 'latitud' is unknown"),
            std::string::npos);
  EXPECT_NE(error_in("latitude = \"5\"\n").find("line 1"), std::string::npos);
  EXPECT_NE(error_in("latitude = \"5\"\n").find("It takes a number"), std::string::npos);
  EXPECT_NE(error_in("projection = 5\n").find("It takes a string"), std::string::npos);
  EXPECT_NE(error_in("seed = 1.5\n").find("It takes an integer"), std::string::npos);
  EXPECT_NE(error_in("layers = [1]\n").find("It takes a string or an array of strings"), std::string::npos);
  EXPECT_NE(error_in("\n\nlatitude = 91\n").find("line 3"), std::string::npos);
  EXPECT_NE(error_in("latitude = 91\n").find("key 'latitude': '91' is not allowed"), std::string::npos);
  EXPECT_NE(error_in("latitude == 5\n").find("line 1"), std::string::npos);
  EXPECT_NE(error_in("[view]\nfov = 5\n").find("key 'view' is unknown"), std::string::npos);
  EXPECT_NE(error_of({"--scene", "/no/such/scene.toml"}).find("/no/such/scene.toml: cannot be opened"),
            std::string::npos);
}

TEST_F(SceneOptionsTest, SkyGlowIsGivenAsPeopleGiveIt) {
  const auto glow = [](const char* text) {
    return resolve({"--sky-glow", text}).dark_sky.glow.zenith.to(candela_per_m2);
  };
  EXPECT_EQ(resolve({}).dark_sky.glow.zenith, Luminance());
  EXPECT_EQ(glow("off"), 0.0);
  EXPECT_EQ(glow("0.002"), 0.002);
  // 10.8e4 * 10^(-0.4 m) cd/m2, less that of a natural night.
  EXPECT_NEAR(glow("20mag"), 10.8e4 * (std::pow(10.0, -8.0) - std::pow(10.0, -8.8)), 1.0e-5);
  EXPECT_EQ(glow("22mag"), 0.0);
  EXPECT_EQ(glow("bortle1"), 0.0);
  EXPECT_EQ(glow("bortle5"), glow("20mag"));
  EXPECT_GT(glow("bortle9"), glow("bortle8"));
}

TEST_F(SceneOptionsTest, EveryOptionCanStandInASceneFile) {
  std::string text;
  for (const SceneOptionDescription& option : scene_option_table()) {
    text += std::string(option.name) + " = " +
            (option.name == "projection"     ? "\"stereographic\""
             : option.name == "size"         ? "\"640x480\""
             : option.name == "tier"         ? "\"cheap\""
             : option.name == "layers"       ? "\"ground\""
             : option.name == "time"         ? "2026-08-12"
             : option.name == "time-scale"   ? "\"tt\""
             : option.name == "calendar"     ? "\"gregorian\""
             : option.name == "medium"       ? "\"published\""
             : option.name == "sky"          ? "\"tables\""
             : option.name == "solar-flux"   ? "107"
             : option.name == "danjon"       ? "3"
             : option.name == "field-factor" ? "2"
             : option.name == "sky-glow"     ? "0.007"
                                             : "7") +
            "\n";
  }
  const SceneOptions scene = resolve({"--scene", write("all.toml", text)});
  EXPECT_EQ(scene.view.projection, Projection::stereographic);
  EXPECT_EQ(scene.view.width, 640);
  EXPECT_EQ(scene.tier, Tier::cheap);
  EXPECT_EQ(scene.seed, 7U);
  EXPECT_EQ(scene.medium_name, "published");
  EXPECT_EQ(scene.dark_sky.solar_flux_sfu, 107.0);
  EXPECT_EQ(scene.dark_sky.glow.zenith, 0.007 * candela_per_m2);
  EXPECT_EQ(scene.dark_sky.glow.azimuth, 7.0 * deg);
  EXPECT_EQ(scene.dark_sky.glow.distance, 7.0 * kilometre);
  EXPECT_EQ(scene.instant.tt.days_since({2461264.5, 0.0}), 0.0);
}

} // namespace
} // namespace vesper
