#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/catalog_tools/bright_star_catalogue.hpp"
#include "vesper/catalog_tools/gzip.hpp"

#include "support/gzip_of.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {
namespace {

using test::gzip_of;

std::string excerpt() {
  const Bytes bytes = read_file(VESPER_TEST_DATA "/catalogue/bsc5_excerpt.dat");
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<BrightStar> read(std::string_view text) {
  return read_bright_star_catalogue(std::as_bytes(std::span(text.data(), text.size())), "bsc.dat");
}

/// The record of one star of the excerpt, 197 columns.
std::string record(unsigned hr) {
  const std::string text = excerpt();
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    if (static_cast<unsigned>(std::stoi(text.substr(at, 4))) == hr) {
      std::string line = text.substr(at, end - at);
      line.resize(197, ' ');
      return line;
    }
    at = end + 1;
  }
  ADD_FAILURE() << "HR " << hr << " is not in the excerpt";
  return "";
}

/// The record with other text from a column on, counted from 1.
std::string with(std::string line, std::size_t column, std::string_view text) {
  return line.replace(column - 1, text.size(), text);
}

const BrightStar& find(const std::vector<BrightStar>& stars, unsigned hr) {
  const auto found = std::find_if(stars.begin(), stars.end(), [&](const BrightStar& s) { return s.hr == hr; });
  EXPECT_NE(found, stars.end()) << hr;
  return *found;
}

void expect_failure(std::string_view text, const std::string& place, const std::string& part) {
  try {
    static_cast<void>(read(text));
    ADD_FAILURE() << "was accepted: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.context().file, "bsc.dat");
    EXPECT_EQ(error.context().place, place) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_FALSE(error.context().remedy.empty());
  }
}

TEST(BrightStarCatalogue, ReadsSirius) {
  const std::vector<BrightStar> stars = read(excerpt());
  EXPECT_EQ(stars.size(), 37U);
  const BrightStar& sirius = find(stars, 2491);
  EXPECT_EQ(sirius.hd, 48915U);
  EXPECT_EQ(sirius.name, "Alp CMa");
  EXPECT_TRUE(sirius.multiple);
  EXPECT_TRUE(sirius.has_position);
  EXPECT_NEAR(sirius.right_ascension_deg, 15.0 * (6 + 45 / 60.0 + 8.9 / 3600.0), 1e-12);
  EXPECT_NEAR(sirius.declination_deg, -(16 + 42 / 60.0 + 58 / 3600.0), 1e-12);
  EXPECT_EQ(sirius.v_magnitude, -1.46);
  EXPECT_EQ(sirius.b_v, 0.0);
  EXPECT_EQ(sirius.spectral_type, "A1Vm");
  EXPECT_EQ(sirius.pm_ra_arcsec_yr, -0.553);
  EXPECT_EQ(sirius.pm_dec_arcsec_yr, -1.205);
  EXPECT_EQ(sirius.parallax_arcsec, 0.375);
  EXPECT_EQ(sirius.radial_velocity_km_s, -8.0);
}

TEST(BrightStarCatalogue, MakesNames) {
  const std::vector<BrightStar> stars = read(excerpt());
  EXPECT_EQ(find(stars, 3).name, "33 Psc");
  EXPECT_EQ(find(stars, 5459).name, "Alp1 Cen");
  EXPECT_EQ(find(stars, 6056).name, "Del Oph");
  EXPECT_EQ(find(stars, 8085).name, "61 Cyg");
  EXPECT_EQ(find(stars, 1).name, "");
}

TEST(BrightStarCatalogue, KnowsWhatIsMissing) {
  const std::vector<BrightStar> stars = read(excerpt());
  EXPECT_FALSE(find(stars, 92).has_position);
  EXPECT_FALSE(find(stars, 92).v_magnitude.has_value());
  EXPECT_FALSE(find(stars, 182).has_position);
  EXPECT_FALSE(find(stars, 133).b_v.has_value());
  EXPECT_FALSE(find(stars, 133).variable);
  EXPECT_FALSE(find(stars, 133).multiple);
  EXPECT_TRUE(find(stars, 5267).multiple); // has a code, but no ADS number
  EXPECT_TRUE(find(stars, 3).variable);
  EXPECT_EQ(find(stars, 1607).b_v, 5.74);
}

TEST(BrightStarCatalogue, AcceptsWindowsLinesMissingBlanksAndNoLastLineBreak) {
  const std::string plain = record(2491) + "\n" + record(7001) + "\n";
  const std::string windows = record(2491) + "\r\n" + record(7001) + "\r\n";
  std::string trimmed = record(2491).substr(0, 107) + "\n" + record(7001) + "\n\n";
  EXPECT_EQ(read(plain).size(), 2U);
  EXPECT_EQ(read(windows).at(1).v_magnitude, 0.03);
  EXPECT_EQ(read(windows).at(0).spectral_type, "A1Vm");
  EXPECT_EQ(read(trimmed).at(0).v_magnitude, -1.46);
  EXPECT_FALSE(read(trimmed).at(0).pm_ra_arcsec_yr.has_value());
  EXPECT_EQ(read(plain.substr(0, plain.size() - 1)).size(), 2U);
  EXPECT_EQ(read(record(2491) + "        \n").size(), 1U);
}

TEST(BrightStarCatalogue, ReadsGzip) {
  const Bytes packed = gzip_of(excerpt());
  const auto stars = read_bright_star_catalogue(packed, "bsc.dat.gz");
  EXPECT_EQ(stars.size(), 37U);
  EXPECT_EQ(find(stars, 2491).v_magnitude, -1.46);
  // Members one after the other are one file (RFC 1952).
  Bytes two = gzip_of(record(2491) + "\n");
  const Bytes second = gzip_of(record(7001) + "\n");
  two.insert(two.end(), second.begin(), second.end());
  EXPECT_EQ(read_bright_star_catalogue(two, "two.gz").size(), 2U);
}

TEST(BrightStarCatalogue, BrokenGzipIsRefused) {
  const Bytes packed = gzip_of(excerpt());
  for (std::size_t size = 2; size < packed.size(); size += 7) {
    const Bytes part(packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(static_cast<void>(read_bright_star_catalogue(part, "part.gz")), Error) << size;
  }
  const auto message = [](const Bytes& bytes) -> std::string {
    try {
      static_cast<void>(read_bright_star_catalogue(bytes, "x.gz"));
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  Bytes corrupt = packed;
  corrupt[corrupt.size() / 2] ^= std::byte{0x55};
  EXPECT_NE(message(corrupt).find("corrupt"), std::string::npos) << message(corrupt);
  Bytes truncated = packed;
  truncated.resize(packed.size() - 5);
  EXPECT_NE(message(truncated).find("truncated"), std::string::npos) << message(truncated);
  Bytes longer = packed;
  longer.push_back(std::byte{'x'});
  EXPECT_NE(message(longer).find("after the end"), std::string::npos) << message(longer);
  // 64 MiB of blanks in a few kilobytes.
  EXPECT_NE(message(gzip_of(std::string(std::size_t{64} << 20, ' '))).find("unpacks to more than"), std::string::npos);
}

TEST(BrightStarCatalogue, OtherFilesAreRefused) {
  expect_failure("", "", "the file is empty");
  expect_failure("\n\r\n   \n", "", "holds no record");
  expect_failure("Some other text\nof two lines\n", "line 1, column 1", "not a star catalogue");
  expect_failure(std::string("\x7f"
                             "ELF\0\0",
                             6),
                 "line 1, column 1", "byte 0x7f is not text: not a star catalogue");
  expect_failure("{\"stars\": []}", "line 1, column 1", "not a star catalogue");
  expect_failure("1,2.5,3.5\n", "line 1, column 1", "not a star catalogue");
  expect_failure(record(2491) + "\n\tx\n", "line 2, column 1", "byte 0x09");
  expect_failure(record(2491) + "abc\n", "line 1, column 198", "has 200 columns; allowed are 197");
}

TEST(BrightStarCatalogue, TruncatedRecordsAreRefused) {
  const std::string first = record(7001) + "\n";
  const std::string sirius = record(2491);
  for (std::size_t size = 4; size < 107; ++size) {
    std::string cut = sirius.substr(0, size);
    cut.resize(cut.find_last_not_of(' ') + 1);
    expect_failure(first + cut, "line 2, column " + std::to_string(cut.size() + 1), "ends before its V magnitude");
  }
  EXPECT_EQ(read(first + sirius.substr(0, 107)).at(1).v_magnitude, -1.46);
  // The entries without a position end early by right.
  EXPECT_FALSE(read(record(92).substr(0, 60)).at(0).has_position);
}

TEST(BrightStarCatalogue, FieldsThatAreNoNumbersAreRefused) {
  const std::string s = record(2491);
  expect_failure(with(s, 103, "-1x46"), "line 1, column 103",
                 "V magnitude \"-1x46\" is not a number; allowed are -2 to 20");
  expect_failure(with(s, 103, "  inf"), "line 1, column 103", "is not a number");
  expect_failure(with(s, 103, "  nan"), "line 1, column 103", "is not a number");
  expect_failure(with(s, 103, " 1e00"), "line 1, column 103", "is not a number");
  expect_failure(with(s, 103, "1.2.3"), "line 1, column 103", "is not a number");
  expect_failure(with(s, 103, "1 2.3"), "line 1, column 103", "is not a number");
  expect_failure(with(s, 103, "    ."), "line 1, column 103", "is not a number");
  expect_failure(with(s, 110, "+-0.1"), "line 1, column 110", "colour B-V");
  expect_failure(with(s, 76, "xx"), "line 1, column 76", "right ascension, hours, \"xx\" is not a number");
  expect_failure(with(s, 76, "  "), "line 1, column 76", "is blank");
  expect_failure(with(s, 84, " "), "line 1, column 84", "sign of declination \" \"");
  expect_failure(with(s, 26, "48 915"), "line 1, column 26", "HD number \"48 915\" is not a whole number");
  expect_failure(with(s, 149, "-0.5-3"), "line 1, column 149", "proper motion in right ascension");
  expect_failure(with(s, 155, "abcdef"), "line 1, column 155", "proper motion in declination");
  expect_failure(with(s, 162, " O.37"), "line 1, column 162", "parallax");
  expect_failure(with(s, 167, "-0.x"), "line 1, column 167", "radial velocity");
  expect_failure(record(7001) + "\n" + with(s, 1, "24x1"), "line 2, column 1",
                 "HR number \"24x1\" is not a whole number");
  expect_failure(record(7001) + "\n" + with(s, 1, "    "), "line 2, column 1", "HR number is blank");
}

TEST(BrightStarCatalogue, ValuesOutOfRangeAreRefused) {
  const std::string s = record(2491);
  expect_failure(with(s, 76, "24"), "line 1, column 76", "\"24\" is out of range; allowed are 0 to 23");
  expect_failure(with(s, 78, "60"), "line 1, column 78", "\"60\" is out of range; allowed are 0 to 59");
  expect_failure(with(s, 80, "60.0"), "line 1, column 80", "right ascension, seconds, \"60.0\"");
  expect_failure(with(s, 85, "91"), "line 1, column 85", "\"91\" is out of range; allowed are 0 to 90");
  expect_failure(with(s, 85, "900001"), "line 1, column 84", "declination -90.0003 deg is out of range");
  expect_failure(with(s, 87, "60"), "line 1, column 87", "declination, arc minutes,");
  expect_failure(with(s, 89, "60"), "line 1, column 89", "declination, arc seconds,");
  expect_failure(with(s, 80, "-1.0"), "line 1, column 80", "out of range");
  expect_failure(with(s, 103, "99.99"), "line 1, column 103", "out of range");
  expect_failure(with(s, 110, "+9.99"), "line 1, column 110", "out of range");
  expect_failure(with(s, 149, "+99.99"), "line 1, column 149", "allowed are -20 to 20");
  expect_failure(with(s, 162, "+9.99"), "line 1, column 162", "allowed are -1 to 1");
  expect_failure(record(7001) + "\n" + with(s, 1, "   0"), "line 2, column 1", "allowed are 1 to 9999");
  EXPECT_EQ(read(with(s, 85, "900000")).at(0).declination_deg, -90.0);
}

TEST(BrightStarCatalogue, DuplicatedNumbersNameBothLines) {
  expect_failure(record(2491) + "\n" + record(7001) + "\n" + record(2491) + "\n", "line 3, column 1",
                 "HR 2491 occurs again, first in line 1");
}

} // namespace
} // namespace vesper
