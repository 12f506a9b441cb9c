// vesper-report events as its users call it.
#include "support/command_line_test.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace vesper {
namespace {

using nlohmann::json;
using test::CommandResult;

class EventCli : public test::CommandLineTest {
protected:
  EventCli() : CommandLineTest("vesper-report", "events") {}
};

constexpr const char* madrid = " --latitude 40.4 --longitude -3.7 ";
constexpr const char* tromso = " --latitude 69.65 --longitude 18.96 ";

TEST_F(EventCli, ADayInOrder) {
  const CommandResult result = run(std::string("--time 2026-08-12T22:00:00Z") + madrid);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const CsvTable day = table_of(result);
  EXPECT_EQ(day.header(),
            (std::vector<std::string_view>{"date", "body", "event", "time", "azimuth_deg", "altitude_deg"}));
  const std::vector<std::pair<std::string_view, std::string_view>> expected{
      {"sun", "astronomical dawn"}, {"sun", "nautical dawn"}, {"moon", "rise"},
      {"sun", "civil dawn"},        {"sun", "rise"},          {"moon", "transit"},
      {"sun", "transit"},           {"sun", "set"},           {"moon", "set"},
      {"sun", "civil dusk"},        {"sun", "nautical dusk"}, {"sun", "astronomical dusk"}};
  ASSERT_EQ(day.row_count(), expected.size());
  std::string before;
  for (std::size_t i = 0; i < day.row_count(); ++i) {
    EXPECT_EQ(day.cell(i, 0), "2026-08-12");
    EXPECT_EQ(day.cell(i, 1), expected[i].first);
    EXPECT_EQ(day.cell(i, 2), expected[i].second);
    const std::string time(day.cell(i, 3));
    EXPECT_LT(before, time);
    EXPECT_EQ(time.size(), std::string("2026-08-12T22:00:00.000Z").size());
    before = time;
  }
  EXPECT_NEAR(day.number(4, 5), -50.0 / 60.0, 1e-9);
  EXPECT_NEAR(day.number(6, 4), 180.0, 1e-9);
}

TEST_F(EventCli, PolarDaysAndNightsAreSaidPlainly) {
  const CsvTable summer = table_of(run(std::string("--bodies sun --days 2 --time 2026-06-21") + tromso));
  ASSERT_EQ(summer.row_count(), 4U);
  for (const std::size_t row : {0U, 2U}) {
    EXPECT_EQ(summer.cell(row, 2), "does not set");
    EXPECT_EQ(summer.cell(row, 3), "");
    EXPECT_GT(summer.number(row, 5), 2.0); // the midnight Sun: 69.65 + 23.44 - 90 = 3.09
    EXPECT_LT(summer.number(row, 5), 3.2);
    EXPECT_EQ(summer.cell(row + 1, 2), "transit");
  }
  EXPECT_EQ(summer.cell(2, 0), "2026-06-22");
  const json winter = json::parse(run(std::string("--json --bodies sun --time 2026-12-21") + tromso).out);
  EXPECT_EQ(winter.at(0).at("event"), "does not rise");
  EXPECT_TRUE(winter.at(0).at("time").is_null());
  EXPECT_NEAR(winter.at(0).at("altitude_deg").get<double>(), 90.0 - 69.65 - 23.44, 0.02);
  EXPECT_EQ(winter.at(1).at("event"), "astronomical dawn");
}

TEST_F(EventCli, TwilightsThatDoNotComeAreSaidPlainly) {
  struct Case {
    const char* options;
    const char* said; ///< the last of what holds all day, "" for nothing
  };
  // The Sun's extremes are those of 90 less latitude, plus and minus 23.44.
  for (const Case& c :
       {Case{"--latitude 40 --time 2026-06-21", ""}, Case{"--latitude 50 --time 2026-06-21", "does not sink below -18"},
        Case{"--latitude 60 --time 2026-06-21", "does not sink below -12"},
        Case{"--latitude 64 --time 2026-06-21", "does not sink below -6"},
        Case{"--latitude 70 --time 2026-06-21", "does not set"},
        Case{"--latitude 70 --time 2026-12-21", "does not rise"},
        Case{"--latitude 80 --time 2026-12-21", "does not climb above -12"},
        Case{"--latitude 89 --time 2026-12-21", "does not climb above -18"}}) {
    const CsvTable day = table_of(run(std::string("--bodies sun --longitude 0 --height 0 ") + c.options));
    std::string said;
    for (std::size_t i = 0; i < day.row_count() && day.cell(i, 3).empty(); ++i) {
      said = day.cell(i, 2);
    }
    EXPECT_EQ(said, c.said) << c.options;
  }
}

TEST_F(EventCli, PlanetsAndStarsAndLowerTransits) {
  const CommandResult result =
      run(std::string("--bodies Venus,HR2491,polaris --lower-transits --time 2026-03-01") + madrid);
  ASSERT_EQ(result.status, 0) << result.err;
  const CsvTable day = table_of(result);
  EXPECT_EQ(day.cell(0, 1), "polaris");
  EXPECT_EQ(day.cell(0, 2), "does not set");
  std::size_t lower = 0;
  for (std::size_t i = 0; i < day.row_count(); ++i) {
    lower += day.cell(i, 2) == "lower transit" ? 1U : 0U;
  }
  EXPECT_EQ(lower, 3U);
  EXPECT_EQ(day.row_count(), 3U + 3U + 2U + 2U + 1U); // transits twice, two bodies that rise and set, one that does not
}

TEST_F(EventCli, TracedRefractionAndHeightMoveTheSunset) {
  const auto sunset = [&](const std::string& options) {
    const json day = json::parse(run("--json --bodies sun --time 2026-08-12" + std::string(madrid) + options).out);
    for (const json& row : day) {
      if (row.at("event") == "set") {
        return row;
      }
    }
    return json();
  };
  const json almanac = sunset("--height 3000");
  EXPECT_NEAR(almanac.at("altitude_deg").get<double>(), -50.0 / 60.0, 1e-9);
  EXPECT_EQ(almanac.at("time").get<std::string>().substr(0, 19),
            sunset("--height 0").at("time").get<std::string>().substr(0, 19));
  const json low = sunset("--refraction model --height 0");
  EXPECT_NEAR(low.at("altitude_deg").get<double>(), -49.0 / 60.0, 1.5 / 60.0);
  const json high = sunset("--refraction model --height 3000");
  EXPECT_LT(high.at("altitude_deg").get<double>(),
            low.at("altitude_deg").get<double>() - 1.5); // the dip is 1.6 degrees
  EXPECT_GT(high.at("time").get<std::string>(), low.at("time").get<std::string>());
  // Cold dense air bends more; without air the limb sets where it is.
  EXPECT_LT(sunset("--refraction model --height 0 --temperature -30").at("altitude_deg").get<double>(),
            low.at("altitude_deg").get<double>() - 0.05);
  EXPECT_NEAR(sunset("--refraction model --height 0 --pressure 0").at("altitude_deg").get<double>(), -15.8 / 60.0,
              0.1 / 60.0); // the Sun's semidiameter in August
  EXPECT_LT(sunset("--horizon 5").at("time").get<std::string>(), low.at("time").get<std::string>());
  EXPECT_NEAR(sunset("--horizon 5").at("altitude_deg").get<double>(), 5.0 - 50.0 / 60.0, 1e-9);
}

TEST_F(EventCli, DatesWithoutLeapSecondsAreSaidToBeUt1) {
  const CommandResult old = run(std::string("--bodies sun --time 1066-10-14") + madrid);
  EXPECT_EQ(old.status, 0);
  EXPECT_NE(old.err.find("UT1"), std::string::npos);
  EXPECT_NE(old.out.find(" UT1,"), std::string::npos);
  const CommandResult border = run(std::string("--bodies sun --time 2026-12-31 --days 2") + madrid);
  EXPECT_NE(border.out.find("2026-12-31,sun,rise,2026-12-31T07:"), std::string::npos) << border.out;
  EXPECT_NE(border.out.find("2027-01-01,sun,rise,2027-01-01T07:"), std::string::npos) << border.out;
  EXPECT_NE(border.err.find("UT1"), std::string::npos) << border.err;
}

TEST_F(EventCli, BadOptionsNameOptionValueAndRangeAndWriteNothing) {
  struct Case {
    const char* arguments;
    const char* option;
    const char* value;
    const char* range;
  };
  const std::string out = path("out.csv");
  for (const Case& c : {
           Case{"--days 0", "--days", "'0'", "1 to 36525"},
           Case{"--days 36526", "--days", "'36526'", "1 to 36525"},
           Case{"--days 1.5", "--days", "'1.5'", "1 to 36525"},
           Case{"--days ''", "--days", "''", "1 to 36525"},
           Case{"--days 3 --time 9999-12-31", "--days", "'3'", "1 to 1"},
           Case{"--bodies vulcan", "--bodies", "'vulcan'", "sun, moon, mercury"},
           Case{"--bodies sun,", "--bodies", "''", "sun, moon, mercury"},
           Case{"--bodies moon,moon", "--bodies", "'moon,moon'", "each body once"},
           Case{"--bodies HR99999", "--bodies", "'HR99999'", "HR or HD number"},
           Case{"--refraction none", "--refraction", "'none'", "almanac, model"},
           Case{"--horizon 81", "--horizon", "'81'", "-10 to 80"},
           Case{"--horizon nan", "--horizon", "'nan'", "-10 to 80"},
           Case{"--horizon high", "--horizon", "'high'", "-10 to 80"},
           Case{"--latitude 91", "--latitude", "'91'", "-90 to 90"},
           Case{"--time 2026-13-01", "--time", "'2026-13-01'", "1 to 12"},
           Case{"--columns sun_azimuth_deg", "events", "--columns", "takes no"},
           Case{"--batch x.csv", "events", "--batch", "takes no"},
           Case{"--ids HR2491", "--ids", "", ""},
       }) {
    const CommandResult result = run(c.arguments + std::string(" -o ") + out);
    EXPECT_EQ(result.status, 2) << c.arguments << "\n" << result.err;
    EXPECT_EQ(result.out, "");
    for (const char* expected : {c.option, c.value, c.range}) {
      EXPECT_NE(result.err.find(expected), std::string::npos) << expected << "\n" << result.err;
    }
    EXPECT_FALSE(std::filesystem::exists(out)) << c.arguments;
  }
  EXPECT_EQ(run("--time 2026-01-01 -o /no/such/folder/out.csv").status, 1);
  EXPECT_EQ(run("--time 2026-01-01 -o " + out).status, 0);
  EXPECT_TRUE(std::filesystem::exists(out));
}

} // namespace
} // namespace vesper
