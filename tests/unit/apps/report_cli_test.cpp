// vesper-report as its users call it.
#include "support/command_line_test.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace vesper {
namespace {

using nlohmann::json;
using test::CommandResult;

class ReportCli : public test::CommandLineTest {
protected:
  ReportCli() : CommandLineTest("vesper-report") {}
};

constexpr const char* place = " --latitude 50 --longitude 10 --height 100 ";

TEST_F(ReportCli, ASceneAsJson) {
  const CommandResult result = run(std::string("--json --time 2026-08-12T22:00:00Z") + place);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json scene = json::parse(result.out);
  EXPECT_EQ(scene.at("time"), "2026-08-12T22:00:00.000Z");
  EXPECT_EQ(scene.at("latitude_deg"), 50.0);
  // A new Moon: the total solar eclipse was at 17:46 that day.
  EXPECT_LT(scene.at("moon_illuminated_fraction").get<double>(), 0.005);
  EXPECT_NEAR(scene.at("sun_distance_au").get<double>(), 1.0134, 0.001);
  EXPECT_LT(scene.at("sun_altitude_deg").get<double>(), -10.0);
}

TEST_F(ReportCli, TheMoonsGlobeIsReported) {
  // A row of the reference table (tests/data/astro/moon_topo.csv).
  const CommandResult result =
      run("--json --time 1985-05-08T00:50:24Z --latitude 47.0974 --longitude 127.1032 --height 3312 "
          "--columns moon_axis_deg,moon_libration_longitude_deg,moon_libration_latitude_deg,moon_bright_limb_deg");
  ASSERT_EQ(result.status, 0) << result.err;
  const json scene = json::parse(result.out);
  EXPECT_NEAR(scene.at("moon_axis_deg").get<double>(), 358.4800, 0.01);
  EXPECT_NEAR(scene.at("moon_libration_longitude_deg").get<double>(), 5.4727, 0.01);
  EXPECT_NEAR(scene.at("moon_libration_latitude_deg").get<double>(), 5.3072, 0.01);
  EXPECT_NEAR(scene.at("moon_bright_limb_deg").get<double>(), 94.0680, 0.02);
}

TEST_F(ReportCli, ASceneInWordsNamesWhatIsUp) {
  const CommandResult result = run(std::string("--time 2026-01-15T22:00:00Z") + place);
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* expected :
       {"night", "Sirius", "Capella", "Betelgeuse", "Orion", "Cassiopeia", "Jupiter", "Uranus"}) {
    EXPECT_NE(result.out.find(expected), std::string::npos) << expected << "\n" << result.out;
  }
  for (const char* unexpected : {"Antares", "Scorpius", "the Southern Cross", "Vega", "Saturn"}) {
    EXPECT_EQ(result.out.find(unexpected), std::string::npos) << unexpected << "\n" << result.out;
  }
}

TEST_F(ReportCli, AssumedPlaceIsSaidOnceOnStandardError) {
  const CommandResult said = run("--json --time 2026-08-12");
  EXPECT_EQ(said.status, 0);
  const std::size_t first = said.err.find("Greenwich");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(said.err.find("Greenwich", first + 1), std::string::npos);
  EXPECT_EQ(run("--json --time 2026-08-12 --quiet").err, "");
}

TEST_F(ReportCli, HelpAndVersionSucceed) {
  for (const char* arguments : {"--help", "--version", "stars --help"}) {
    const CommandResult result = run(arguments);
    EXPECT_EQ(result.status, 0) << arguments;
    EXPECT_NE(result.out, "") << arguments;
  }
}

TEST_F(ReportCli, BadOptionsExitWithTwoAndWriteNothing) {
  const std::string out = path("out.csv");
  const std::string output = " -o " + out;
  const std::string in = write("in.csv", "utc,latitude_deg,longitude_deg,height_m\n2026-08-12,1,2,3\n");
  for (const std::string& arguments :
       {std::string("--latitude 95"), std::string("--time 2026-02-30"), std::string("--nonsense"),
        std::string("--time"), std::string("--columns moon_colour --json"), std::string("stars"),
        std::string("stars --ids HR99999"), std::string("stars --ids Nosuchstar"), std::string("stars --ids HR2491,"),
        std::string("stars --ids Vega --batch " + in), "--json --batch " + in,
        "--columns sun_azimuth_deg,sun_azimuth_deg --batch " + in, std::string("--scene /no/such/file.toml"),
        std::string("unknown-subcommand"), std::string("--output= --json")}) {
    const CommandResult result = run(arguments + output);
    EXPECT_EQ(result.status, 2) << arguments << "\n" << result.err;
    EXPECT_NE(result.err, "") << arguments;
    EXPECT_FALSE(std::filesystem::exists(out)) << arguments;
  }
}

TEST_F(ReportCli, BatchPassesOtherColumnsThroughAndKeepsOrder) {
  const std::string in = write("in.csv", "name,height_m,longitude_deg,latitude_deg,utc\r\n"
                                         "\"a, b\",0,10,50,2026-08-12T22:00:00Z\r\n"
                                         "c,100,-70.5,-33,2030-01-01T00:00:00Z\r\n");
  const CommandResult result =
      run("--batch " + in + " -o " + path("out.csv") + " --columns moon_altitude_deg,sun_altitude_deg");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("1 stamps lie outside the leap seconds known (1972 to 2026), the first in line 3"),
            std::string::npos)
      << result.err;
  const CsvTable out = table("out.csv");
  EXPECT_EQ(out.header(), (std::vector<std::string_view>{"name", "height_m", "longitude_deg", "latitude_deg", "utc",
                                                         "moon_altitude_deg", "sun_altitude_deg"}));
  EXPECT_EQ(out.cell(0, 0), "a, b");
  EXPECT_EQ(out.cell(1, 2), "-70.5");
  const json scene = json::parse(run("--json --time 2026-08-12T22:00:00Z --latitude 50 --longitude 10 --height 0").out);
  EXPECT_EQ(out.number(0, out.column("sun_altitude_deg")), scene.at("sun_altitude_deg").get<double>());
}

TEST_F(ReportCli, BatchTakesJulianDates) {
  const std::string in = write("in.csv", "jd_tt,jd_ut1,latitude_deg,longitude_deg,height_m\n"
                                         "2461265.416666666666,2461265.415865741,50,10,0\n");
  const CommandResult result = run("--batch " + in + " --columns sun_azimuth_deg");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("jd_tt,jd_ut1,latitude_deg,longitude_deg,height_m,sun_azimuth_deg\n"), std::string::npos);
}

TEST_F(ReportCli, BatchTakesTheHeightsThatTheOptionTakes) {
  const std::string at =
      "--columns sun_azimuth_deg,sun_altitude_deg --time 2026-08-12T22:00:00Z --latitude 50 --longitude 10";
  const std::string in = write("in.csv", "utc,height_m\n2026-08-12T22:00:00Z,100000000\n");
  const CsvTable rows = table_of(run(at + " --batch " + in));
  const json scene =
      json::parse(run("--json --time 2026-08-12T22:00:00Z --latitude 50 --longitude 10 --height 1e8").out);
  EXPECT_EQ(rows.number(0, rows.column("sun_altitude_deg")), scene.at("sun_altitude_deg").get<double>());
}

TEST_F(ReportCli, BatchSaysWhatItsFarthestDateStrains) {
  const std::string in = write("in.csv", "jd_tt,jd_ut1,latitude_deg,longitude_deg,height_m\n2451545,2451545,1,2,3\n"
                                         "10000,9999,1,2,3\n2400000,2400000,1,2,3\n");
  const CommandResult far = run("--batch " + in);
  ASSERT_EQ(far.status, 0) << far.err;
  EXPECT_NE(far.err.find("line 3, the farthest date: The Earth's rotation is known"), std::string::npos) << far.err;
  EXPECT_NE(far.err.find("line 3, the farthest date: The theories of Moon"), std::string::npos) << far.err;
  write("in.csv", "jd_tt,jd_ut1,latitude_deg,longitude_deg,height_m\n2451545,2451545,1,2,3\n");
  EXPECT_EQ(run("--batch " + in).err, "");
}

TEST_F(ReportCli, BatchFaultsNameLineAndColumnAndWriteNothing) {
  struct Case {
    const char* text;
    const char* expected;
  };
  for (const Case& c : {
           Case{"", "the table is empty"},
           Case{"utc,latitude_deg,longitude_deg\n2026-08-12,1,2\n", "there is no column 'height_m'"},
           Case{"jd_tt,latitude_deg,longitude_deg,height_m\n2451545,1,2,3\n", "there is no column 'jd_ut1'"},
           Case{"utc,latitude_deg,longitude_deg,height_m\n2026-08-12,1,2,3\n2026-08-12,91,2,3\n",
                "line 3, column latitude_deg: '91' is not in -90 to 90"},
           Case{"utc,latitude_deg,longitude_deg,height_m\n2026-08-12,1,,3\n", "line 2, column longitude_deg"},
           Case{"utc,latitude_deg,longitude_deg,height_m\n2026-08-32,1,2,3\n", "line 2, column utc"},
           Case{"utc,latitude_deg,longitude_deg,height_m\n2026-08-12,1,2,1e9\n", "line 2, column height_m"},
           Case{"utc,latitude_deg,longitude_deg,height_m\n2026-08-12,1,2\n", "line 2: 3 fields"},
           Case{"jd_tt,jd_ut1,latitude_deg,longitude_deg,height_m\n2451545,2441545,1,2,3\n", "line 2, column jd_ut1"},
           Case{"utc,latitude_deg,longitude_deg,height_m,sun_azimuth_deg\n2026-08-12,1,2,3,4\n",
                "in.csv: line 1: column 'sun_azimuth_deg' stands in the input already"},
       }) {
    const std::string in = write("in.csv", c.text);
    const CommandResult result = run("--batch " + in + " -o " + path("out.csv"));
    EXPECT_EQ(result.status, 1) << c.text << result.err;
    EXPECT_NE(result.err.find(c.expected), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(path("out.csv"))) << c.text;
  }
  const std::string late = write("in.csv", "utc,latitude_deg,longitude_deg,height_m\n9999-12-31,1,2,3\n");
  const CommandResult julian = run("--calendar julian --batch " + late);
  EXPECT_EQ(julian.status, 1) << julian.err;
  EXPECT_NE(julian.err.find("line 2, column utc: '9999-12-31' is not a time: dates end"), std::string::npos)
      << julian.err;
  EXPECT_EQ(run("--batch /no/such/file.csv").status, 1);
  const std::string good = write("in.csv", "utc,latitude_deg,longitude_deg,height_m\n2026-08-12,1,2,3\n");
  EXPECT_EQ(run("--batch " + good + " -o /no/such/folder/out.csv").status, 1);
  EXPECT_EQ(run("--batch " + good + " -o /dev/full").status, 1);
}

TEST_F(ReportCli, PlanetColumnsAreThereForTheAsking) {
  const std::string in = write("in.csv", "utc,latitude_deg,longitude_deg,height_m\n 2025-02-16T00:00:00Z ,0,0,0\n");
  const CsvTable all = table_of(run("--columns default,planets --batch " + in));
  constexpr std::size_t planet_columns = 77; // 11 of each of 7
  EXPECT_EQ(all.header().size(), table_of(run("--batch " + in)).header().size() + planet_columns);
  const CsvTable venus =
      table_of(run("--columns venus_magnitude,venus_diameter_arcsec,sun_altitude_deg --batch " + in));
  EXPECT_EQ(venus.header().at(4), "venus_magnitude");
  // Greatest brilliancy of February 2025: -4.9 mag, 40" across (almanacs).
  EXPECT_NEAR(venus.number(0, 4), -4.87, 0.05);
  EXPECT_NEAR(venus.number(0, 5), 39.0, 2.0);
  EXPECT_EQ(run("--columns default,venus_magnitude,default --batch " + in).status, 2);
  EXPECT_EQ(run("--columns pluto_magnitude --batch " + in).status, 2);
}

TEST_F(ReportCli, ZenithExtinctionIsThatOfTheMediumAboveTheObserver) {
  const auto extinction = [&](const std::string& options) {
    const CommandResult result =
        run("--json --columns zenith_extinction_v_mag --time 2026-01-15T22:00:00Z --latitude 28 --longitude -17 " +
            options);
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out).at("zenith_extinction_v_mag").get<double>();
  };
  // What observers find at clear sites.
  const double sea_level = extinction("--height 0");
  EXPECT_GT(sea_level, 0.20);
  EXPECT_LT(sea_level, 0.30);
  const double mountain = extinction("--height 2400");
  EXPECT_GT(mountain, 0.13);
  EXPECT_LT(mountain, 0.18);
  // An optical depth of 1 that is grey is 1.086 magnitudes.
  write("grey.toml", "base = \"clear\"\n[[component]]\nname = \"fog\"\nscattering = \"10 /km\"\n"
                     "profile = { kind = \"exponential\", scale = \"100 m\" }\n"
                     "phase = { kind = \"henyey-greenstein\", asymmetry = 0.8 }\n");
  EXPECT_NEAR(extinction("--height 0 --medium grey.toml") - sea_level, 1.0857, 1.0e-4);
  // Heights of a table.
  write("in.csv", "utc,latitude_deg,longitude_deg,height_m\n2026-01-15T22:00:00Z,28,-17,0\n"
                  "2026-01-15T22:00:00Z,28,-17,2400\n");
  ASSERT_EQ(run("--batch in.csv -o out.csv --columns zenith_extinction_v_mag").status, 0);
  const CsvTable rows = table("out.csv");
  const std::size_t column = rows.column("zenith_extinction_v_mag");
  EXPECT_EQ(rows.number(0, column), sea_level);
  EXPECT_EQ(rows.number(1, column), mountain);
}

TEST_F(ReportCli, TheMediumsFaultsAreToldApart) {
  expect_failure(2, "--medium mars", {"--medium", "'mars'", "clear, published"});
  expect_failure(1, "--medium none.toml", {"none.toml"});
  write("air.toml", "base = \"clear\"\naerosol_optical_dept = 0.1\n");
  expect_failure(1, "--medium air.toml",
                 {"air.toml: line 2, key 'aerosol_optical_dept'", "Did you mean 'aerosol_optical_depth'?"});
}

TEST_F(ReportCli, StarsById) {
  const CommandResult result =
      run(std::string("stars --ids 'HR2491,hd 172167,polaris' --time 2026-01-15T22:00:00Z") + place);
  ASSERT_EQ(result.status, 0) << result.err;
  const CsvTable out = table_of(result);
  ASSERT_EQ(out.row_count(), 3U);
  EXPECT_EQ(out.cell(1, 0), "hd 172167");
  EXPECT_NEAR(out.number(0, out.column("magnitude")), -1.46, 0.01);
  EXPECT_NEAR(out.number(1, out.column("magnitude")), 0.03, 0.02); // Vega
  EXPECT_NEAR(out.number(2, out.column("altitude_deg")), 50.0, 1.0);
  EXPECT_NEAR(out.number(2, out.column("declination_deg")), 89.37, 0.02);
  const CommandResult as_json = run(std::string("stars --json --ids HR2491 --time 2026-01-15T22:00:00Z") + place);
  EXPECT_EQ(json::parse(as_json.out).at(0).at("altitude_deg").get<double>(), out.number(0, out.column("altitude_deg")));
}

TEST_F(ReportCli, StarsOfATable) {
  const std::string header = "id,ra_deg,dec_deg,epoch_jyear,pm_ra_cosdec_mas_yr,pm_dec_mas_yr,parallax_mas,"
                             "radial_velocity_km_s\n";
  const std::string options = " --time 2026-01-15T22:00:00Z" + std::string(place);
  const CommandResult good =
      run("stars --catalogue " +
          write("s.csv", header + "Sirius,101.28854105,-16.71314306,1991.25,-546.01,-1223.08,379.21,\n") + options);
  ASSERT_EQ(good.status, 0) << good.err;
  write("out.csv", good.out);
  const CommandResult same = run("stars --ids Sirius" + options);
  write("same.csv", same.out);
  // The catalogue's own entry is a rounded one: within an arcsecond.
  for (const char* column : {"right_ascension_deg", "declination_deg", "azimuth_deg", "altitude_deg"}) {
    EXPECT_NEAR(table("out.csv").number(0, table("out.csv").column(column)),
                table("same.csv").number(0, table("same.csv").column(column)), 1.5 / 3600.0)
        << column;
  }
  const CommandResult bad = run("stars --catalogue " + write("s.csv", header + "x,10,95,2000,,,,\n") + options);
  EXPECT_EQ(bad.status, 1);
  EXPECT_NE(bad.err.find("line 2, column dec_deg: '95' is not in -90 to 90"), std::string::npos) << bad.err;
  const CommandResult wild = run("stars --catalogue " + write("s.csv", header + "x,10,5,2000,1e300,,,\n") + options);
  EXPECT_EQ(wild.status, 1);
  EXPECT_NE(wild.err.find("column pm_ra_cosdec_mas_yr: '1e300' is not in"), std::string::npos) << wild.err;
}

} // namespace
} // namespace vesper
