// Eclipses of the Moon against figures from JPL DE431 and NASA's catalogue.
#include "support/truth.hpp"

#include "vesper/astro/lunar_eclipse.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <map>

namespace vesper {
namespace {

using test::ErrorSum;
using test::seconds_between;
using test::TruthRow;

struct ContactColumn {
  const char* name;
  LunarContact contact;
  bool penumbral;
};
constexpr std::array<ContactColumn, 6> contact_columns{{{"P1", LunarContact::p1, true},
                                                        {"U1", LunarContact::u1, false},
                                                        {"U2", LunarContact::u2, false},
                                                        {"U3", LunarContact::u3, false},
                                                        {"U4", LunarContact::u4, false},
                                                        {"P4", LunarContact::p4, true}}};

/// Contacts graze where a magnitude is close to 0 or 1: their time then follows from nothing.
bool grazing(double magnitude) { return std::abs(magnitude) <= 0.02 || std::abs(magnitude - 1.0) <= 0.02; }

TEST(LunarEclipse, MatchesTheReference) {
  const CsvTable table = test::truth_table("eclipses_lunar.csv");
  ErrorSum umbral, penumbral, umbral_chauvenet, penumbral_chauvenet, gamma, greatest, at_instant;
  std::map<std::string, ErrorSum> contacts;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    if (!row.in_table_years()) {
      continue;
    }
    SCOPED_TRACE(row.text("canon_date"));
    const LunarEclipse eclipse = lunar_eclipse_near(row.instant());
    umbral.add(eclipse.umbral_magnitude - row.number("umb_mag_danjon"));
    penumbral.add(eclipse.penumbral_magnitude - row.number("pen_mag_danjon"));
    gamma.add(eclipse.gamma - row.number("gamma"));
    greatest.add(seconds_between(eclipse.greatest, row.instant()));
    const LunarEclipse chauvenet = lunar_eclipse_near(row.instant(), ShadowModel::chauvenet);
    umbral_chauvenet.add(chauvenet.umbral_magnitude - row.number("umb_mag_chauvenet"));
    penumbral_chauvenet.add(chauvenet.penumbral_magnitude - row.number("pen_mag_chauvenet"));
    at_instant.add(lunar_eclipse_state(apparent_sun_moon(row.instant().tt)).umbral_magnitude -
                   row.number("umb_mag_danjon"));
    for (const ContactColumn& column : contact_columns) {
      const bool grazes = grazing(row.number(column.penumbral ? "pen_mag_danjon" : "umb_mag_danjon"));
      const bool expected = !row.text(column.name).empty();
      const std::optional<Instant>& found = eclipse.contact(column.contact);
      if (!grazes) {
        EXPECT_EQ(found.has_value(), expected) << column.name;
      }
      if (found && expected && !grazes) {
        contacts[column.name].add(seconds_between(*found, row.instant_in(column.name)));
      }
    }
  }
  umbral.hold("umbral magnitude, Danjon", 0.0005, "");
  penumbral.hold("penumbral magnitude, Danjon", 0.0005, "");
  umbral_chauvenet.hold("umbral magnitude, Chauvenet", 0.0005, "");
  penumbral_chauvenet.hold("penumbral magnitude, Chauvenet", 0.0005, "");
  at_instant.hold("umbral magnitude at the given instant", 0.0005, "");
  gamma.hold("gamma, distance of the shadow's axis", 0.0001, "Earth radii");
  greatest.hold("greatest eclipse", 0.5, "s");
  EXPECT_GE(umbral.count(), 100U);
  EXPECT_EQ(contacts.size(), contact_columns.size());
  for (const auto& [name, errors] : contacts) {
    errors.hold("contact " + name, 5.0, "s");
  }
}

TEST(LunarEclipse, TypesAreThoseOfTheCatalogue) {
  const CsvTable table = test::truth_table("eclipses_lunar.csv");
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    // The catalogue's shadow.
    const LunarEclipse eclipse = lunar_eclipse_near(row.instant(), ShadowModel::chauvenet);
    const char letter = row.text("canon_type").front();
    const LunarEclipseType expected = letter == 'T'   ? LunarEclipseType::total
                                      : letter == 'P' ? LunarEclipseType::partial
                                                      : LunarEclipseType::penumbral;
    const bool total_penumbral = letter == 'N' && row.number("pen_mag_chauvenet") >= 1.0;
    EXPECT_EQ(eclipse.type, total_penumbral ? LunarEclipseType::total_penumbral : expected) << row.text("canon_date");
  }
}

TEST(LunarEclipse, TheSearchFindsEachOnce) {
  const CsvTable table = test::truth_table("eclipses_lunar.csv");
  const auto start = std::chrono::steady_clock::now();
  const std::vector<LunarEclipse> found =
      lunar_eclipses(parse_instant("1950-01-01"), parse_instant("2051-01-01"), ShadowModel::chauvenet);
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  std::printf("%zu lunar eclipses from 1950 to 2050 in %.1f ms\n", found.size(), ms);
  // The table holds every second eclipse of the catalogue, the first and the last among them.
  ASSERT_EQ(found.size(), 2 * table.row_count() - 1);
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    EXPECT_LT(std::abs(seconds_between(found[2 * i].greatest, row.instant())), 60.0) << row.text("canon_date");
  }
  // Danjon's smaller shadow misses the slightest ones, and only those.
  const std::vector<LunarEclipse> danjon = lunar_eclipses(parse_instant("1950-01-01"), parse_instant("2051-01-01"));
  auto next = danjon.begin();
  for (const LunarEclipse& eclipse : found) {
    const bool same = next != danjon.end() && std::abs(seconds_between(next->greatest, eclipse.greatest)) < 1.0;
    EXPECT_TRUE(same || eclipse.penumbral_magnitude < 0.04) << to_iso8601(eclipse.greatest);
    next += same ? 1 : 0;
  }
  EXPECT_EQ(next, danjon.end());
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const bool there = std::any_of(danjon.begin(), danjon.end(), [&](const LunarEclipse& eclipse) {
      return std::abs(seconds_between(eclipse.greatest, row.instant())) < 60.0;
    });
    EXPECT_EQ(there, row.number("pen_mag_danjon") > 0.0) << row.text("canon_date");
  }
}

} // namespace
} // namespace vesper
