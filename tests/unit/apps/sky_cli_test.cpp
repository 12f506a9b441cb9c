// `vesper-report sky` and the columns of light as their users call them.
#include "support/command_line_test.hpp"

#include "vesper/assets/image_file.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/single_scattering.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace vesper {
namespace {

using nlohmann::json;
using test::CommandResult;

class SkyCli : public test::CommandLineTest {
protected:
  SkyCli() : CommandLineTest("vesper-report", "sky --reference") {}
};

class LightColumns : public test::CommandLineTest {
protected:
  LightColumns() : CommandLineTest("vesper-report") {}
};

TEST_F(SkyCli, FirstOrderIsSingleScatteringInTheDirectionsAsked) {
  write("where.csv", "altitude_deg,azimuth_deg,sun_altitude_deg,sun_azimuth_deg\n"
                     "25,200,35,180\n25,20,35,180\n90,0,-4,90\n40,90,-4,90\n");
  const CommandResult result = run("--directions where.csv --orders 1 --unit-irradiance --wavelengths 440,650 "
                                   "--sun-radius 0 --height 500 --relative-error 0.02");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, ""); // no place is needed
  const CsvTable out = table_of(result);
  ASSERT_EQ(out.row_count(), 4U);
  const Medium medium = clear_medium();
  const auto direction = [&](std::size_t row, const std::string& of) {
    const double altitude = out.number(row, out.column(of + "altitude_deg")) * std::numbers::pi / 180.0;
    const double azimuth = out.number(row, out.column(of + "azimuth_deg")) * std::numbers::pi / 180.0;
    return Vec3(std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth), std::sin(altitude));
  };
  for (std::size_t row = 0; row < 4; ++row) {
    const SkyQuery query{500.0 * metre, direction(row, "sun_"), 0.0 * deg, direction(row, "")};
    const SingleScattering exact = single_scattering(medium, query, {440.0, 650.0});
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string name = i == 0 ? "radiance_440nm_" : "radiance_650nm_";
      const double error = out.number(row, out.column(name + "error_per_sr"));
      EXPECT_NEAR(out.number(row, out.column(name + "per_sr")), exact.radiance[i], 4.5 * error) << row << name;
      EXPECT_LT(error, 0.0201 * exact.radiance[i]) << row << name;
    }
  }
}

TEST_F(SkyCli, APictureHoldsWhatTheTableTells) {
  const std::string scene = "--time 2026-06-21T12:00:00Z --latitude 50 --longitude 10 --size 4x4 --most-paths 64 ";
  const CommandResult result = run(scene + "-o sky.exr");
  ASSERT_EQ(result.status, 0) << result.err;
  const FloatImage picture = read_image(path("sky.exr"));
  ASSERT_EQ(picture.channels, (std::vector<std::string>{"X", "Y", "Z", "S"}));
  EXPECT_EQ(picture.values.at(1), 0.0F); // the corner lies outside the circle
  const CommandResult as_table = run(scene + "--picture --seed 0 --sky reference --timings");
  ASSERT_EQ(as_table.status, 0) << as_table.err;
  const CsvTable rows = table_of(as_table);
  EXPECT_EQ(rows.row_count(), 12U);
  for (std::size_t row = 0; row < rows.row_count(); ++row) {
    const auto pixel = static_cast<std::size_t>(rows.number(row, rows.column("pixel_y")) * 4.0 +
                                                rows.number(row, rows.column("pixel_x")));
    const std::array<const char*, 4> channels{"x_cd_m2", "luminance_cd_m2", "z_cd_m2", "s_cd_m2"};
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(picture.values.at(4 * pixel + i), static_cast<float>(rows.number(row, rows.column(channels.at(i)))));
    }
    EXPECT_GT(rows.number(row, rows.column("seconds")), 0.0);
  }
  EXPECT_FALSE(std::filesystem::exists(path("sky.exr.partial")));
}

class UnfinishedSky : public SkyCli {
protected:
  void SetUp() override {
    SkyCli::SetUp();
    std::string where = "altitude_deg,azimuth_deg\n";
    for (int i = 0; i < 60; ++i) {
      where += std::to_string(90 - i) + "," + std::to_string(6 * i) + "\n";
    }
    write("where.csv", where);
  }
  static constexpr const char* request = "--directions where.csv --sun-altitude 5 --most-paths 2000 "
                                         "--unit-irradiance --wavelengths 550 ";
};

TEST_F(UnfinishedSky, KilledHalfWayGoesOnToTheSameBytes) {
  const CommandResult whole = run(std::string(request) + "--threads 1");
  ASSERT_EQ(whole.status, 0) << whole.err;
  // A first process is killed as soon as it has finished some directions.
  const std::string kill =
      "'" VESPER_BIN "/vesper-report' sky --reference " + std::string(request) +
      "-o sky.csv & pid=$!; until [ \"$(wc -l 2>/dev/null <sky.csv.partial)\" -ge 5 ] || "
      "! kill -0 $pid; do sleep 0.02; done; kill -9 $pid; wait $pid; cp sky.csv.partial killed; ! [ -e sky.csv ]";
  const CommandResult resumed = run(std::string(request) + "-o sky.csv --threads 2", "{ " + kill + "; } 2>/dev/null");
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_GT(text(path("killed")).size(), 100U);
  EXPECT_EQ(text(path("sky.csv")), whole.out);
  EXPECT_FALSE(std::filesystem::exists(path("sky.csv.partial")));
#ifdef VESPER_MPIRUN
  // As root, on this host alone, however few cores it has.
  const std::string mpirun =
      "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_plm=isolated "
      "OMPI_MCA_btl_vader_single_copy_mechanism=none ASAN_OPTIONS=detect_leaks=0; '" VESPER_MPIRUN
      "' --oversubscribe -n 2 '" VESPER_BIN "/vesper-report-mpi' sky --reference ";
  const CommandResult together = run("--version", mpirun + request + "-o shared.csv");
  EXPECT_EQ(together.status, 0) << together.err;
  EXPECT_EQ(text(path("shared.csv")), whole.out);
  EXPECT_EQ(together.err, "");
  const CommandResult refused = run("--version", mpirun + request + "-o no.csv --orders 0");
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_EQ(refused.err.find("--orders: '0'"), refused.err.rfind("--orders: '0'")) << "said once: " << refused.err;
#endif
}

TEST_F(UnfinishedSky, TheResultsOfAnotherRequestAreNotTouched) {
  write("sky.csv.partial", "vesper-report sky of something else\n");
  expect_failure(1, std::string(request) + "-o sky.csv", {"sky.csv.partial", "another request", "delete"});
  EXPECT_EQ(text(path("sky.csv.partial")), "vesper-report sky of something else\n");
}

TEST_F(SkyCli, BadOptionsExitWithTwoAndWriteNothing) {
  write("where.csv", "altitude_deg,azimuth_deg\n90,0\n");
  write("suns.csv", "altitude_deg,azimuth_deg,sun_altitude_deg\n90,0,1\n");
  struct Case {
    const char* arguments;
    std::vector<std::string> words;
  };
  for (const Case& c : {
           Case{"--relative-error 0", {"--relative-error: '0'", "1e-06 to 1"}},
           Case{"--relative-error nan", {"--relative-error", "nan"}},
           Case{"--most-paths -1", {"--most-paths: '-1'", "integer from 1"}},
           Case{"--orders 0", {"--orders: '0'", "1 to 1000000"}},
           Case{"--threads 5000", {"--threads: '5000'", "0 to 1024"}},
           Case{"--sky painted", {"--sky: 'painted'", "tables, reference"}},
           Case{"--sun-altitude 91", {"--sun-altitude: '91'", "-90 to 90 degrees"}},
           Case{"--sun-altitude 1 --sun-azimuth 400", {"--sun-azimuth: '400'", "-360 to 360"}},
           Case{"--sun-altitude 1 --sun-radius 2", {"--sun-radius: '2'", "0 to 1 degrees"}},
           Case{"--moon-altitude 9 --moon-phase-angle 181", {"--moon-phase-angle: '181'", "0 to 180"}},
           Case{"--light stars", {"--light: 'stars'", "sun, moon, both"}},
           Case{"--sun-altitude 1 --light both", {"--light: 'both'", "--moon-altitude"}},
           Case{"--moon-altitude 1 --light sun", {"--light: 'sun'", "--sun-altitude"}},
           Case{"--directions suns.csv --sun-altitude 3", {"--sun-altitude: '3'", "sun_altitude_deg"}},
           Case{"--wavelengths 440,300", {"--wavelengths: '440,300'", "360 to 830 nm"}},
           Case{"--wavelengths 440,440", {"--wavelengths", "once"}},
           Case{"--sun-altitude 1 --moon-altitude 1 --unit-irradiance", {"--unit-irradiance", "--light sun"}},
           Case{"--sun-altitude 1 --unit-irradiance -o sky.exr", {"--unit-irradiance", "picture"}},
           Case{"--zenith --directions where.csv", {"--zenith, --directions FILE", "--picture"}},
           Case{"--json -o sky.exr", {"--json", "picture"}},
           Case{"--sun-altitude 20 -o sky.png", {"--output", "sky.png", "NAME.exr"}},
           Case{"--illuminance --picture", {"--illuminance", "picture"}},
           Case{"--batch where.csv", {"--batch"}},
       }) {
    const std::string output = std::string(c.arguments).find("-o ") == std::string::npos ? " -o sky.csv" : "";
    expect_failure(2, c.arguments + output, c.words);
  }
  expect_failure(1, "--directions nowhere.csv -o sky.csv", {"nowhere.csv"});
  expect_failure(1, "--directions where.csv -o no/such/folder/sky.csv", {"no/such/folder"});
}

TEST_F(LightColumns, TablesAnswerOnlyWhatTheyHold) {
  for (const char* option : {"--wavelengths 550", "--unit-irradiance", "--orders 2"}) {
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    expect_failure(2, std::string("sky --sun-altitude 10 ") + option, {name, "--reference"});
  }
}

TEST_F(LightColumns, OfTablesAndReferenceAgree) {
  const std::string scene = " --latitude 51.4769 --longitude 0 --height 47 --time 2026-06-21T12:00:00Z ";
  const auto value = [&](const std::string& arguments) {
    const CommandResult result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out);
  };
  const json tables = value("--json --columns light" + scene);
  const json reference = value("--json --sky reference --relative-error 0.01 --columns "
                               "horizontal_illuminance_lux,zenith_luminance_cd_m2,sun_direct_illuminance_lux" +
                               scene);
  for (const char* name : {"horizontal_illuminance_lux", "zenith_luminance_cd_m2", "sun_direct_illuminance_lux"}) {
    const double wanted = reference.at(name).get<double>();
    EXPECT_NEAR(tables.at(name).get<double>(), wanted, 0.05 * wanted) << name;
  }
  double lux = 0.0;
  double luminance = 0.0;
  for (const std::string source : {"sun", "moon"}) {
    lux += tables.at(source + "_direct_illuminance_lux").get<double>() +
           tables.at(source + "_diffuse_illuminance_lux").get<double>();
    luminance += tables.at(source + "_zenith_luminance_cd_m2").get<double>();
  }
  // The same zenith, looked at: light of Sun and Moon.
  const json looked = value("sky --json --illuminance" + scene).at("directions").at(0);
  EXPECT_NEAR(looked.at("luminance_cd_m2").get<double>(), luminance, 1.0e-9 * luminance);
  EXPECT_NEAR(looked.at("horizontal_illuminance_lux").get<double>(), lux, 1.0e-9 * lux);
  EXPECT_FALSE(looked.contains("paths"));
  EXPECT_FALSE(looked.contains("luminance_error_cd_m2"));

  for (const std::string source : {"airglow", "zodiacal", "starlight", "sky_glow"}) {
    lux += tables.at(source + "_illuminance_lux").get<double>();
    luminance += tables.at(source + "_zenith_luminance_cd_m2").get<double>();
  }
  EXPECT_NEAR(lux, tables.at("horizontal_illuminance_lux").get<double>(), 1.0e-9 * lux);
  EXPECT_NEAR(luminance, tables.at("zenith_luminance_cd_m2").get<double>(), 1.0e-9 * luminance);
}

TEST_F(LightColumns, TheFaintestStarIsThatOfTheZenith) {
  // A star of unknown colour and magnitude at the pole, seen from there, by night and in twilight.
  write("pole.csv",
        "id,ra_deg,dec_deg,epoch_jyear,pm_ra_cosdec_mas_yr,pm_dec_mas_yr,parallax_mas,radial_velocity_km_s\n"
        "pole,0,90,2026,,,,\n");
  double last = 10.0;
  for (const std::string time : {"2026-12-20T00:00:00Z", "2026-10-06T00:00:00Z", "2026-06-21T00:00:00Z"}) {
    const std::string scene = " --latitude 90 --longitude 0 --height 0 --time " + time;
    const json zenith = json::parse(run("--json --columns limiting_magnitude,sun_altitude_deg" + scene).out);
    const json star = json::parse(run("stars --json --visibility --catalogue pole.csv" + scene).out).at(0);
    const double limit = zenith.at("limiting_magnitude").get<double>();
    EXPECT_NEAR(star.at("limiting_magnitude").get<double>(), limit, 0.01);
    EXPECT_EQ(star.at("visibility"), "") << "without a magnitude";
    EXPECT_LT(limit, last);
    last = limit;
    // Twice the light that is needed is three quarters of a magnitude.
    const json casual = json::parse(run("--json --columns limiting_magnitude --field-factor 3.4" + scene).out);
    EXPECT_NEAR(limit - casual.at("limiting_magnitude").get<double>(), 2.5 * std::log10(2.0), 1.0e-6);
  }
}

TEST_F(LightColumns, StarsAreSeenOrHiddenByWhatHidesThem) {
  const auto why = [&](const std::string& ids, const std::string& scene) {
    const CommandResult result =
        run("stars --visibility --ids '" + ids + "' --latitude 51.4769 --longitude 0 --height 47" + " --time " + scene);
    EXPECT_EQ(result.status, 0) << result.err;
    const CsvTable table = table_of(result);
    std::vector<std::string> reasons;
    for (std::size_t i = 0; i < table.row_count(); ++i) {
      reasons.emplace_back(table.cell(i, table.column("visibility")));
    }
    return reasons;
  };
  using Reasons = std::vector<std::string>;
  // Midsummer noon; the Sun 3 degrees down; moonlight; a night without a Moon, from a city and from the country.
  EXPECT_EQ(why("Capella,Vega", "2026-06-21T12:00:00Z"), (Reasons{"in daylight", "below the horizon"}));
  EXPECT_EQ(why("Capella,Polaris", "2026-03-20T18:30:00Z"), (Reasons{"visible", "in twilight"}));
  EXPECT_EQ(why("Polaris,HR4893", "2026-01-03T00:00:00Z"), (Reasons{"visible", "in moonlight"}));
  EXPECT_EQ(why("Polaris,HR4893", "2026-12-09T00:00:00Z"), (Reasons{"visible", "visible"}));
  EXPECT_EQ(why("Polaris,HR4893", "2026-12-09T00:00:00Z --sky-glow bortle8"), (Reasons{"visible", "in sky glow"}));
  EXPECT_EQ(run("stars --ids Vega --time 2026-06-21T12:00:00Z").out.find("visibility"), std::string::npos);
}

TEST_F(LightColumns, APictureByTablesHoldsWhatTheTableTells) {
  const std::string scene = "sky --sun-altitude 3 --size 16x16 --projection perspective --altitude 20 ";
  ASSERT_EQ(run(scene + "-o sky.exr").status, 0);
  const FloatImage picture = read_image(path("sky.exr"));
  const CsvTable table = table_of(run(scene + "--picture"));
  ASSERT_EQ(table.row_count(), 256U);
  for (std::size_t i = 0; i < table.row_count(); i += 17) {
    const auto place = static_cast<std::size_t>(table.number(i, table.column("pixel_y")) * 16.0 +
                                                table.number(i, table.column("pixel_x")));
    const double luminance = table.number(i, table.column("luminance_cd_m2"));
    EXPECT_GT(luminance, 0.0);
    EXPECT_NEAR(static_cast<double>(picture.values.at(4 * place + 1)), luminance, 1.0e-6 * luminance);
  }
  EXPECT_FALSE(std::filesystem::exists(path("sky.exr.partial")));
}

TEST_F(LightColumns, AreInTheRangeOfMeasuredLight) {
  const std::string place = " --latitude 51.4769 --longitude 0 --height 47 --relative-error 0.05 --sky reference ";
  const std::string names = "sun_altitude_deg,moon_altitude_deg,horizontal_illuminance_lux,zenith_luminance_cd_m2";
  const CommandResult noon = run("--json --time 2026-06-21T12:00:00Z --columns " + names + place);
  ASSERT_EQ(noon.status, 0) << noon.err;
  const json scene = json::parse(noon.out);
  ASSERT_NEAR(scene.at("sun_altitude_deg").get<double>(), 62.0, 0.1);
  // USNO Circular 171: 104.7 klx at 62 degrees; other measurements are a factor of 1.4 off at most.
  const double noon_lux = scene.at("horizontal_illuminance_lux").get<double>();
  EXPECT_GT(noon_lux, 104700.0 / 1.4);
  EXPECT_LT(noon_lux, 104700.0 * 1.4);

  // The same instant, a full Moon 63 degrees high with the Sun far below the horizon, and a night without either.
  write("in.csv", "utc\n2026-06-21T12:00:00Z\n2026-01-03T00:00:00Z\n2026-12-09T00:00:00Z\n");
  const CommandResult batch = run("--batch in.csv --columns " + names + place);
  ASSERT_EQ(batch.status, 0) << batch.err;
  const CsvTable rows = table_of(batch);
  const std::size_t lux = rows.column("horizontal_illuminance_lux");
  const std::size_t luminance = rows.column("zenith_luminance_cd_m2");
  EXPECT_EQ(rows.number(0, lux), noon_lux);
  EXPECT_EQ(rows.number(0, luminance), scene.at("zenith_luminance_cd_m2").get<double>());
  ASSERT_NEAR(rows.number(1, rows.column("moon_altitude_deg")), 63.0, 3.0);
  // 0.29 lx for the full Moon there at its mean distance; this one is near the Earth, and not quite full.
  EXPECT_GT(rows.number(1, lux), 0.29 / 1.4);
  EXPECT_LT(rows.number(1, lux), 0.29 * 1.4);
  // A moonlit zenith has 17 to 18.5 mag/arcsec2.
  EXPECT_GT(rows.number(1, luminance), 10.8e4 * std::pow(10.0, -0.4 * 18.5));
  EXPECT_LT(rows.number(1, luminance), 10.8e4 * std::pow(10.0, -0.4 * 17.0));
  ASSERT_LT(rows.number(2, rows.column("moon_altitude_deg")), -24.0);
  // 0.6 to 2 mlx and 22 to 20.9 mag/arcsec2, here near a maximum of the Sun and with the Milky Way overhead.
  EXPECT_GT(rows.number(2, lux), 0.6e-3);
  EXPECT_LT(rows.number(2, lux), 2.0e-3);
  EXPECT_GT(rows.number(2, luminance), 10.8e4 * std::pow(10.0, -0.4 * 22.0));
  EXPECT_LT(rows.number(2, luminance), 10.8e4 * std::pow(10.0, -0.4 * 20.9));
}

TEST_F(LightColumns, AreInASceneButNotInABatchUnlessAskedFor) {
  const CommandResult scene = run("--json --time 2026-06-21T12:00:00Z");
  EXPECT_TRUE(json::parse(scene.out).contains("horizontal_illuminance_lux"));
  write("in.csv", "utc\n2026-06-21T12:00:00Z\n");
  const CommandResult batch = run("--batch in.csv --latitude 50 --longitude 0 --height 0");
  EXPECT_EQ(batch.status, 0);
  EXPECT_EQ(batch.out.find("horizontal_illuminance_lux"), std::string::npos);
  expect_failure(2, "--columns horizontal_illuminance", {"horizontal_illuminance_lux", "zenith_luminance_cd_m2"});
}

} // namespace
} // namespace vesper
