// vesper-report eclipses as its users call it.
#include "support/command_line_test.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace vesper {
namespace {

using nlohmann::json;
using test::CommandResult;

class EclipseCli : public test::CommandLineTest {
protected:
  EclipseCli() : CommandLineTest("vesper-report", "eclipses") {}
};

constexpr const char* burgos = " --latitude 42.3439 --longitude -3.6969 --height 860";

TEST_F(EclipseCli, LunarOnesOfAYear) {
  const CommandResult result = run(std::string("--from 2026 --to 2026 --kind lunar") + burgos);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(result.out.starts_with("greatest,type,gamma,umbral_magnitude,penumbral_magnitude,P1,U1,U2,U3,U4,P4,"
                                     "moon_altitude_deg,moon_magnitude,moon_danjon\n"))
      << result.out;
  const CsvTable out = table_of(result);
  ASSERT_EQ(out.row_count(), 2U);
  EXPECT_EQ(out.cell(0, 1), "total");
  EXPECT_TRUE(out.cell(0, 0).starts_with("2026-03-03T11:33:")) << out.cell(0, 0);
  EXPECT_EQ(out.cell(1, 1), "partial");
  EXPECT_EQ(out.cell(1, out.column("U2")), "");
  EXPECT_TRUE(out.cell(1, out.column("U4")).ends_with("Z"));
  EXPECT_NEAR(out.number(1, out.column("umbral_magnitude")), 0.930, 0.002);
  EXPECT_GT(out.number(1, out.column("moon_altitude_deg")), 0.0);
  EXPECT_NEAR(out.number(0, out.column("moon_magnitude")), -2.2, 1.0);
  EXPECT_GT(out.number(0, out.column("moon_danjon")), 2.0); // it only just goes in
  EXPECT_EQ(out.cell(1, out.column("moon_danjon")), "");
  const CsvTable dark = table_of(run(std::string("--from 2026 --to 2026 --kind lunar --danjon 0") + burgos));
  EXPECT_GT(dark.number(0, dark.column("moon_magnitude")), out.number(0, out.column("moon_magnitude")) + 1.0);
  const CommandResult chauvenet = run(std::string("--from 2026 --to 2026 --kind lunar --shadow chauvenet") + burgos);
  const CsvTable wider = table_of(chauvenet);
  EXPECT_NEAR(wider.number(1, wider.column("umbral_magnitude")), 0.935, 0.002);
}

TEST_F(EclipseCli, SolarOnesWithThePlacesOwnTimes) {
  const CommandResult result = run(std::string("--from 2026-08-12 --to 2026-08-12 --kind solar --json") + burgos);
  ASSERT_EQ(result.status, 0) << result.err;
  const json rows = json::parse(result.out);
  ASSERT_EQ(rows.size(), 1U);
  const json& row = rows.at(0);
  EXPECT_EQ(row.at("type"), "total");
  EXPECT_EQ(row.at("local_type"), "total");
  EXPECT_EQ(row.at("C2").get<std::string>().substr(0, 18), "2026-08-12T18:28:2");
  EXPECT_NEAR(row.at("sun_altitude_deg").get<double>(), 8.18, 0.01);
  EXPECT_EQ(row.at("obscuration"), 1.0);
  // It is no eclipse where the Sun is down.
  const json south =
      json::parse(run("--from 2026-08-12 --to 2026-08-12 --kind solar --json --latitude -40 --longitude 175").out);
  EXPECT_EQ(south.at(0).at("local_type"), "none");
  EXPECT_TRUE(south.at(0).at("max").is_null());
}

TEST_F(EclipseCli, TheSlightestOnesCount) {
  // 1935 had five, the most that a year can have; that of 5 January, of magnitude 0.001, hardly touched the Earth. The
  // century had 228 (Espenak and Meeus 2006, Five Millennium Canon of Solar Eclipses).
  const CsvTable out = table_of(run(std::string("--from 1901 --to 2000 --kind solar") + burgos));
  EXPECT_EQ(out.row_count(), 228U);
  std::string in_1935;
  for (std::size_t row = 0; row < out.row_count(); ++row) {
    if (out.cell(row, 0).starts_with("1935")) {
      in_1935.append(out.cell(row, 0).substr(5, 5)).append(" ");
    }
  }
  EXPECT_EQ(in_1935, "01-05 02-03 06-30 07-30 12-25 ");
}

TEST_F(EclipseCli, SpansIncludeTheirLastYearAndMayBeEmpty) {
  const CommandResult years = run(std::string("--from 2026 --to 2030 --kind solar") + burgos);
  ASSERT_EQ(years.status, 0) << years.err;
  EXPECT_NE(years.err.find("UT1"), std::string::npos) << years.err;
  const CsvTable out = table_of(years);
  ASSERT_EQ(out.row_count(), 12U);
  EXPECT_TRUE(out.cell(11, 0).starts_with("2030-11-25")) << out.cell(11, 0);
  EXPECT_TRUE(out.cell(11, 0).ends_with(" UT1"));
  const CommandResult none = run(std::string("--from 2026-04-01 --to 2026-04-30 --kind solar") + burgos);
  EXPECT_EQ(none.status, 0);
  EXPECT_EQ(table_of(none).row_count(), 0U);
  EXPECT_EQ(json::parse(run(std::string("--from 2026-04-01 --to 2026-04-30 --kind lunar --json") + burgos).out),
            json::array());
}

TEST_F(EclipseCli, SpansAreOfTheCalendarAsked) {
  // The eclipse of 21 August 1560, Julian, which turned the young Tycho Brahe to astronomy: 31 August, Gregorian.
  const std::string day = std::string("--from 1560-08-21 --to 1560-08-21 --kind solar --quiet") + burgos;
  EXPECT_EQ(table_of(run(day)).row_count(), 0U);
  const CommandResult julian = run(day + " --calendar julian");
  ASSERT_EQ(julian.status, 0) << julian.err;
  const CsvTable out = table_of(julian);
  ASSERT_EQ(out.row_count(), 1U);
  EXPECT_TRUE(out.cell(0, 0).starts_with("1560-08-31")) << out.cell(0, 0);
  // In TT a day begins a minute earlier than in UTC.
  const std::string hour = std::string("--from 2026-08-12T17:46:30 --to 2026-08-13 --kind solar --quiet") + burgos;
  EXPECT_EQ(table_of(run(hour)).row_count(), 0U);
  EXPECT_EQ(table_of(run(hour + " --time-scale tt")).row_count(), 1U);
}

TEST_F(EclipseCli, TheValleysOfTheLimbShortenTotality) {
  const std::string asked = std::string("--from 2026-08-12 --to 2026-08-12 --kind solar --quiet") + burgos;
  const CsvTable mean = table_of(run(asked));
  const CsvTable valleys = table_of(run(asked + " --lunar-radius valleys"));
  const std::size_t c1 = mean.column("C1");
  const std::size_t c2 = mean.column("C2");
  EXPECT_EQ(mean.cell(0, c1), valleys.cell(0, c1));
  const auto seconds = [&](const CsvTable& t) { return std::stod(std::string(t.cell(0, c2).substr(17, 6))); };
  ASSERT_EQ(mean.cell(0, c2).substr(0, 17), valleys.cell(0, c2).substr(0, 17));
  const double begins_later_s = seconds(valleys) - seconds(mean);
  EXPECT_GT(begins_later_s, 0.5);
  EXPECT_LT(begins_later_s, 4.0);
}

TEST_F(EclipseCli, FaultsNameTheOptionAndWriteNothing) {
  struct Case {
    const char* arguments;
    const char* expected;
  };
  for (const Case& c : {
           Case{"--from 2026 --to 2030", "--kind is missing"},
           Case{"--from 2026 --kind lunar", "--to is missing"},
           Case{"--to 2026 --kind lunar", "--from is missing"},
           Case{"--from 2026 --to 2030 --kind moon", "--kind: 'moon' is not allowed; allowed: lunar, solar"},
           Case{"--from 2026 --to 2030 --kind solar --lunar-radius x", "--lunar-radius: 'x' is not allowed"},
           Case{"--from 2026 --to 2030 --kind lunar --shadow x", "--shadow: 'x' is not allowed"},
           Case{"--from 20260 --to 2030 --kind lunar", "--from: '20260' is not allowed"},
           Case{"--from 2026-02-30 --to 2030 --kind lunar", "--from: '2026-02-30' is not allowed"},
           Case{"--from 2026 --to 2025 --kind lunar", "--to: '2025' is not allowed"},
           Case{"--from=-4713 --to 2025 --kind lunar", "years -4712 to 9999"},
           Case{"--from 2026 --to 2030 --kind lunar --batch x.csv", "takes no --batch"},
       }) {
    const CommandResult result = run(std::string(c.arguments) + burgos + " -o " + path("out.csv"));
    EXPECT_EQ(result.status, 2) << c.arguments << result.err;
    EXPECT_NE(result.err.find(c.expected), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(path("out.csv"))) << c.arguments;
  }
}

TEST_F(EclipseCli, WritesToAFile) {
  const std::string options = std::string("--from 2026 --to 2026 --kind lunar") + burgos;
  const CommandResult result = run(options + " -o " + path("out.csv"));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(text("out.csv"), run(options).out);
}

} // namespace
} // namespace vesper
