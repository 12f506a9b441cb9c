// Elevation grids: samples to heights, and grids that are not what their labels say.
#include "support/expect_error.hpp"
#include "support/folder_test.hpp"
#include "support/moon_inputs.hpp"

#include "vesper/catalog_tools/elevation_grid.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <span>
#include <string>

namespace vesper {
namespace {

using test::elevation_label;
using test::elevation_samples;
using test::with;

GlobeGrid read(const std::string& label, const std::string& samples, const std::string& file = "in/A.IMG") {
  return read_elevation_grid(PdsLabel(label, "A.LBL"), std::as_bytes(std::span(samples)), file);
}

/// 36 lines of hills, lowest -1800 m, highest 1800 m or so.
GlobeGrid hills() {
  return test::globe_grid(36, 0.0, [](const Vec3& d) { return 1800.0 * d.x + 300.0 * d.y * d.z; });
}

TEST(ElevationGrid, ReadsBothByteOrders) {
  GlobeGrid expected = hills();
  expected.values[5] = std::numeric_limits<float>::quiet_NaN();
  for (const bool big : {false, true}) {
    const GlobeGrid grid =
        read(elevation_label("A.IMG", 36, big ? "MSB_INTEGER" : "LSB_INTEGER"), elevation_samples(expected, big));
    ASSERT_EQ(grid.values.size(), expected.values.size());
    EXPECT_EQ(grid.width, 72);
    EXPECT_EQ(grid.west_edge_deg, 0.0);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      if (i == 5) {
        EXPECT_TRUE(std::isnan(grid.values[i]));
      } else {
        EXPECT_NEAR(grid.values[i], expected.values[i], 0.2501);
      }
    }
  }
}

TEST(ElevationGrid, ReadsFloatsInKilometres) {
  std::string label = with(elevation_label("A.IMG", 36, "PC_REAL"), "SAMPLE_BITS = 16", "SAMPLE_BITS = 32");
  label = with(with(with(label, "METER", "KILOMETER"), "= 0.5", "= 1"), "1737400.", "1737.4");
  label = with(label, "MISSING_CONSTANT = -32768", "MISSING_CONSTANT = -1e10\nMAXIMUM = 1.8\n");
  GlobeGrid grid = hills();
  std::string samples;
  for (float height : grid.values) {
    height /= 1000.0F;
    samples.append(reinterpret_cast<const char*>(&height), sizeof(height));
  }
  const float missing = -1e10F;
  std::memcpy(samples.data(), &missing, sizeof(missing));
  test::expect_error(ErrorKind::input, {"the largest of its samples", "says 1.8"},
                     [&] { return read(label, samples); });
  label = with(label, "MAXIMUM = 1.8\n", "");
  const GlobeGrid back = read(label, samples);
  EXPECT_TRUE(std::isnan(back.values[0]));
  EXPECT_NEAR(back.values[100], grid.values[100], 0.001);
}

TEST(ElevationGrid, PutsHeightsOnTheSphereOf1737Point4Kilometres) {
  const std::string samples = elevation_samples(hills());
  const GlobeGrid usual = read(elevation_label("A.IMG", 36), samples);
  const GlobeGrid without = read(with(elevation_label("A.IMG", 36), "    OFFSET = 1737400.\r\n", ""), samples);
  EXPECT_EQ(without.values, usual.values);
  const std::string other = with(elevation_label("A.IMG", 36), "1737.4 <km>", "1738.0 <km>");
  EXPECT_FLOAT_EQ(read(with(other, "1737400.", "1738000."), samples).values[7], usual.values[7] + 600.0F);
}

TEST(ElevationGrid, RefusesWhatTheFileIsNot) {
  const std::string samples = elevation_samples(hills());
  const auto expect = [&](const std::string& label, const std::vector<std::string>& words, const std::string& content) {
    test::expect_error(ErrorKind::input, words, [&] { return read(label, content); });
  };
  const std::string label = elevation_label("A.IMG", 36);
  expect(label, {"in/A.IMG", "the file has 5183 bytes", "it should have 5184"}, samples.substr(1));
  expect(label, {"in/A.IMG", "every sample is missing"},
         elevation_samples(test::globe_grid(36, 0, [](const Vec3&) { return std::nan(""); })));
  expect(elevation_label("B.IMG", 36), {"A.LBL: line 4", "^IMAGE is \"B.IMG\"", "\"A.IMG\""}, samples);
  expect(with(label, "^IMAGE", "^TABLE"), {"A.LBL", "^IMAGE is missing"}, samples);
  // Real heights in the other byte order are no heights.
  expect(elevation_label("A.IMG", 36, "MSB_INTEGER"),
         {"in/A.IMG", "heights run from", "with their bytes swapped they would be", "Set SAMPLE_TYPE in A.LBL to LSB"},
         samples);
  expect(with(label, "= 0.5", "= 50"), {"heights run from", "-9500 to 11000 m", "Fetch"}, samples);
  // Missing ones that the label calls something else: the third of the second line.
  std::string undeclared = samples;
  undeclared.replace(std::size_t{2} * (72 + 2), 2, std::string("\x01\x80"));
  expect(label, {"in/A.IMG: line 2, sample 3", "-16383.5", "MISSING_CONSTANT", "A.LBL"}, undeclared);
  expect(with(label, "    UNIT", "    MINIMUM = -3000\r\n    UNIT"),
         {"in/A.IMG", "the least of its samples is -3", "A.LBL says -3000"}, samples);
  // A label that is off by one is as it was published.
  EXPECT_NO_THROW(read(with(label, "    UNIT", "    MINIMUM = -3594\r\n    MAXIMUM = 3592\r\n    UNIT"), samples));
}

TEST(ElevationGrid, NamesTheLineOfALabelThatDoesNotFit) {
  const std::string samples = elevation_samples(hills());
  const std::string label = elevation_label("A.IMG", 36);
  const auto expect = [&](const std::string& from, const std::string& to, const std::vector<std::string>& words) {
    test::expect_error(ErrorKind::input, words, [&] { return read(with(label, from, to), samples); });
  };
  expect("LINES = 36", "LINES = 37", {"A.LBL: line 8", "LINES is \"37\"; allowed is 36 by MAP_RESOLUTION"});
  expect("LINE_SAMPLES = 72", "LINE_SAMPLES = 36", {"line 9", "allowed is 72 by MAP_RESOLUTION"});
  expect("LSB_INTEGER", "LSB_UNSIGNED_INTEGER", {"line 10", "allowed is LSB_INTEGER, MSB_INTEGER or PC_REAL"});
  expect("SAMPLE_BITS = 16", "SAMPLE_BITS = 32", {"line 11", "16 with LSB_INTEGER"});
  expect("METER", "FEET", {"UNIT is \"FEET\"", "METER or KILOMETER"});
  expect("= 0.5", "= 0", {"SCALING_FACTOR", "above 0"});
  expect("1737400.", "6371000.", {"OFFSET", "1737.4 km"});
  expect("SIMPLE CYLINDRICAL", "POLAR STEREOGRAPHIC", {"MAP_PROJECTION_TYPE", "SIMPLE CYLINDRICAL"});
  expect("0.2 <pix/deg>", "0.2 <deg/pix>", {"MAP_RESOLUTION", "<pix/deg>"});
  expect("1737.4 <km>", "6371.0 <km>", {"A_AXIS_RADIUS", "1737.4"});
  expect("\"EAST\"", "\"WEST\"", {"POSITIVE_LONGITUDE_DIRECTION", "EAST"});
  expect("MAXIMUM_LATITUDE = 90", "MAXIMUM_LATITUDE = 60", {"MAXIMUM_LATITUDE", "whole globe"});
  expect("EASTERNMOST_LONGITUDE = 360", "EASTERNMOST_LONGITUDE = 180", {"EASTERNMOST_LONGITUDE", "whole globe"});
  expect("    LINES = 36\r\n", "", {"A.LBL", "LINES is missing from the object IMAGE"});
}

class PdsLabelFile : public test::FolderTest {};

TEST_F(PdsLabelFile, IsFoundBesideTheImage) {
  write("A.IMG", "x");
  test::expect_error(ErrorKind::file, {"A.IMG", "has no label (.LBL) beside it", "--label"},
                     [&] { return find_pds_label(path("A.IMG")); });
  write("A.lbl", "x");
  EXPECT_EQ(find_pds_label(path("A.IMG")), path("A.lbl"));
  write("A.LBL", "x");
  EXPECT_EQ(find_pds_label(path("A.IMG")), path("A.LBL"));
}

} // namespace
} // namespace vesper
