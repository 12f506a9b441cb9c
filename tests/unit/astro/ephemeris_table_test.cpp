// The embedded table as a file: what it covers, and that damage is refused.
#include "vesper/astro/ephemeris_table.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

namespace vesper {
namespace {

std::vector<unsigned char> file_bytes() {
  const Bytes bytes = read_file(VESPER_SOURCE_DIR "/data/ephemeris_1960_2059.bin");
  std::vector<unsigned char> result(bytes.size());
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

void expect_refused(const std::vector<unsigned char>& bytes, const std::string& word) {
  try {
    const EphemerisTable table(bytes);
    FAIL() << "accepted; expected a word on \"" << word << '"';
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(EphemerisTable, CoversTheYearsItIsNamedAfterAndFitsItsBudget) {
  const EphemerisTable& table = EphemerisTable::embedded();
  EXPECT_TRUE(table.covers({2436934.5, 0.0})); // 1960-01-01
  EXPECT_TRUE(table.covers({2473459.5, 0.0})); // 2060-01-01
  EXPECT_LT(file_bytes().size(), 1900000U);
}

TEST(EphemerisTable, EndsSharply) {
  const EphemerisTable& table = EphemerisTable::embedded();
  constexpr double microsecond = 1e-6 / 86400.0;
  EXPECT_TRUE(table.covers(table.begin()));
  EXPECT_TRUE(table.covers(table.end()));
  EXPECT_TRUE(table.sun_earth_moon(table.end()).has_value());
  EXPECT_FALSE(table.covers(table.begin().plus_days(-microsecond)));
  EXPECT_FALSE(table.covers(table.end().plus_days(microsecond)));
  EXPECT_FALSE(table.sun_earth_moon(table.end().plus_days(1.0)).has_value());
  EXPECT_FALSE(table.planet_heliocentric(Planet::venus, table.begin().plus_days(-1.0)).has_value());
  EXPECT_FALSE(table.lunar_angles(table.end().plus_days(1.0)).has_value());
  EXPECT_FALSE(table.nutation({table.end().day, 1.0}).has_value());
}

TEST(EphemerisTable, GivesNothingForDatesThatAreNoNumbers) {
  const EphemerisTable& table = EphemerisTable::embedded();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity, 1e300, -1e300}) {
    EXPECT_FALSE(table.covers({bad, 0.0}));
    EXPECT_FALSE(table.covers({2451545.0, bad}));
    EXPECT_FALSE(table.sun_earth_moon({2451545.0, bad}).has_value());
  }
}

TEST(EphemerisTable, DoesNotMindHowADateIsSplit) {
  const EphemerisTable& table = EphemerisTable::embedded();
  const Vec3 moon = table.sun_earth_moon({2451545.0, 0.25})->moon.position_au;
  for (const JulianDate<TDB> tdb : {JulianDate<TDB>{0.25, 2451545.0}, {2451545.25, 0.0}, {2400000.5, 51544.75}}) {
    EXPECT_LT(glm::length(table.sun_earth_moon(tdb)->moon.position_au - moon), 1e-15);
  }
}

TEST(EphemerisTable, RefusesDamage) {
  const std::vector<unsigned char> sound = file_bytes();
  EXPECT_NO_THROW(EphemerisTable{sound});
  expect_refused({}, "directory");
  expect_refused({sound.begin(), sound.end() - 1}, "bytes instead of");
  const auto damaged = [&](std::size_t place, unsigned char value) {
    std::vector<unsigned char> bytes = sound;
    bytes[place] = value;
    return bytes;
  };
  expect_refused(damaged(0, 'W'), "VESPEPH1");
  expect_refused(damaged(23, 0xff), "span");
  expect_refused(damaged(24, 11), "series");
  // The first row: name, quantum, place, segments, orders, wide orders.
  expect_refused(damaged(32, 'M'), "Moon");
  expect_refused(damaged(32 + 23, 0xbf), "quantum");
  expect_refused(damaged(32 + 24, 1), "bytes at byte");
  expect_refused(damaged(32 + 30, 1), "bytes at byte");
  expect_refused(damaged(32 + 32, 255), "orders");
  expect_refused(damaged(32 + 36, 0), "wide");
}

} // namespace
} // namespace vesper
