#include "support/folder_test.hpp"
#include "support/numbered_tables.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables_file.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/sha256.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <set>

namespace vesper::test {
namespace {

constexpr SkyTableSize smallest{2, 2, 2, 2};
const std::string made_from(64, 'a');

/// The bytes as a forger would leave them: altered, with a digest that fits.
void sign(Bytes& bytes) {
  const std::string digest = sha256_hex(std::span(bytes).first(bytes.size() - 64));
  std::memcpy(bytes.data() + bytes.size() - 64, digest.data(), 64);
}

void expect_refused(const Bytes& bytes, const std::string& place, const std::string& what) {
  try {
    static_cast<void>(decode_sky_tables(bytes, "here.tables", made_from));
    FAIL() << "taken, though: " << what;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_EQ(e.context().file, "here.tables");
    EXPECT_EQ(e.context().place, place) << e.what();
    EXPECT_NE(e.message().find(what), std::string::npos) << e.what();
    EXPECT_NE(e.context().remedy.find("Delete the file"), std::string::npos);
  }
}

template <class Value> Bytes with(Bytes bytes, std::size_t offset, Value value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(value));
  return bytes;
}

using SkyTablesFile = FolderTest;

TEST_F(SkyTablesFile, GivesBackEveryNumber) {
  const SkyTables tables = numbered_tables();
  const std::filesystem::path path = folder() / "sky.tables";
  write_sky_tables(path, tables, made_from);
  const SkyTables read = read_sky_tables(path, made_from);
  EXPECT_EQ(read.aerosol, tables.aerosol);
  EXPECT_EQ(read.other, tables.other);
  EXPECT_EQ(read.ground, tables.ground);
  EXPECT_EQ(read.phase, tables.phase);
  EXPECT_EQ(read.transmittance, tables.transmittance);
  EXPECT_EQ(read.light, tables.light);
  EXPECT_EQ(read.albedo, tables.albedo);
  EXPECT_EQ(read.frame.ground_km, tables.frame.ground_km);
  EXPECT_EQ(read.frame.top_km, tables.frame.top_km);
  EXPECT_EQ(read.frame.heights, tables.frame.heights);
  EXPECT_EQ(read.frame.views_below, tables.frame.views_below);
  EXPECT_EQ(read.frame.views_above, tables.frame.views_above);
  EXPECT_EQ(read.frame.lights, tables.frame.lights);
  EXPECT_EQ(read.transmittance_frame.altitudes, 4);
  EXPECT_EQ(read.transmittance_frame.heights, 2);
}

TEST_F(SkyTablesFile, NoByteMayBeMissingOrAltered) {
  const Bytes whole = encode_sky_tables(numbered_tables(), made_from);
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_THROW(static_cast<void>(decode_sky_tables(std::span(whole).first(size), "cut", made_from)), Error) << size;
  }
  for (std::size_t place = 0; place < whole.size(); place += 5) {
    Bytes altered = whole;
    altered[place] ^= std::byte{0x10};
    EXPECT_THROW(static_cast<void>(decode_sky_tables(altered, "altered", made_from)), Error) << place;
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_THROW(static_cast<void>(decode_sky_tables(longer, "longer", made_from)), Error);
}

TEST_F(SkyTablesFile, SaysWhatIsWrongAndWhere) {
  const Bytes whole = encode_sky_tables(numbered_tables(), made_from);
  expect_refused({}, "byte 0", "no file of sky tables");
  expect_refused(with(whole, 0, 'X'), "byte 0", "no file of sky tables");
  expect_refused({whole.begin(), whole.begin() + 100}, "byte 100", "ends before its tables begin");
  expect_refused(with(whole, 8, 0x04030201), "byte 8", "another byte order");
  expect_refused(with(whole, 12, 99), "byte 12", "version 99");
  expect_refused(with(whole, 80, 1), "byte 80", "sizes or numbers that no tables have");
  expect_refused(with(whole, 80, std::numeric_limits<std::int32_t>::max()), "byte 80", "sizes or numbers");
  expect_refused(with(whole, 80, 3), "byte " + std::to_string(whole.size()), "bytes where");
  expect_refused(with(whole, 200, 1.0F), "byte " + std::to_string(whole.size() - 64), "altered");
  Bytes infinite = with(whole, 148, std::numeric_limits<float>::infinity());
  sign(infinite);
  expect_refused(infinite, "byte 148", "numbers that no tables have");
  Bytes not_a_number = with(whole, whole.size() - 64 - 4, std::numeric_limits<float>::quiet_NaN());
  sign(not_a_number);
  expect_refused(not_a_number, "byte " + std::to_string(whole.size() - 64 - std::size_t{16} * 16),
                 "numbers that no tables have");
  Bytes of_others = with(whole, 16, 'b');
  sign(of_others);
  expect_refused(of_others, "byte 16", "another medium");
}

TEST(SkyTablesFingerprint, TellsMediaApartByWhateverLightMeets) {
  const Medium clear = clear_medium();
  std::set<std::string> seen{sky_tables_fingerprint(clear)};
  EXPECT_EQ(*seen.begin(), sky_tables_fingerprint(clear_medium())) << "the same medium";
  EXPECT_EQ(seen.begin()->size(), 64U);
  const auto expect_new = [&](const std::string& what, const Medium& medium, const SkyTableSize& size = {}) {
    EXPECT_TRUE(seen.insert(sky_tables_fingerprint(medium, size)).second) << what;
  };
  const auto changed = [&](auto change) {
    Medium medium = clear;
    change(medium);
    return medium;
  };
  const auto scaled = [](const WavelengthLaw& law, double factor) {
    return WavelengthLaw([law, factor](double nm) { return factor * law(nm); });
  };
  expect_new("another medium", published_medium());
  expect_new("size", clear, smallest);
  expect_new("ground", changed([](Medium& m) { m.ground_radius = m.ground_radius + 1.0 * metre; }));
  expect_new("top", changed([](Medium& m) { m.top_radius = m.top_radius + 1.0 * metre; }));
  expect_new("albedo", changed([&](Medium& m) { m.ground_albedo = scaled(m.ground_albedo, 1.00001); }));
  expect_new("wavelengths", changed([](Medium& m) { m.wavelengths_nm.pop_back(); }));
  expect_new("components", changed([](Medium& m) { m.components.pop_back(); }));
  for (std::size_t c = 0; c < clear.components.size(); ++c) {
    const std::string name = clear.components[c].name;
    const auto part = [&](auto change) { return changed([&](Medium& m) { change(m.components[c]); }); };
    const auto bump =
        HeightProfile::table({0.0, 1.0, 1.02, 1.04, 100.0}, {1.0, 1.0, 1.01, 1.0, 0.0}, HeightProfile::Between::linear);
    expect_new(name + "'s scattering", part([&](MediumComponent& m) {
                 m.scattering_per_km = [law = m.scattering_per_km](double nm) { return law(nm) + 1.0e-9; };
               }));
    expect_new(name + "'s absorption", part([&](MediumComponent& m) {
                 m.absorption_per_km = [law = m.absorption_per_km](double nm) { return law(nm) + 1.0e-9; };
               }));
    expect_new(name + "'s phase", part([](MediumComponent& m) {
                 m.phase.kind = m.phase.kind == PhaseKind::schlick ? PhaseKind::rayleigh : PhaseKind::schlick;
               }));
    expect_new(name + "'s phase's parameter",
               part([](MediumComponent& m) { m.phase.parameter = constant_law(0.123); }));
    expect_new(name + "'s profile", part([&](MediumComponent& m) { m.profile = bump; }));
    expect_new(name + "'s profile's scale",
               part([](MediumComponent& m) { m.profile = HeightProfile::exponential(8.0001); }));
  }
  EXPECT_THROW(static_cast<void>(sky_tables_fingerprint(changed([](Medium& m) { m.top_radius = m.ground_radius; }))),
               Error);
}

} // namespace
} // namespace vesper::test
