// FITS files as they come: number formats, blanks, compression, axes, and what is wrong with them.
#include "support/fits_file.hpp"
#include "support/folder_test.hpp"
#include "support/gzip_of.hpp"
#include "support/sky_picture.hpp"

#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/fits_picture.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace vesper {
namespace {

using test::card;
using test::FitsContent;
using test::SkyHeader;

constexpr int width = 36;
constexpr int height = 18;

class FitsPictures : public test::FolderTest {
protected:
  static FitsContent ramp() {
    FitsContent content{width,
                        height,
                        1,
                        FLOAT_IMG,
                        0,
                        false,
                        SkyHeader{"CAR", "GLON", "GLAT", width, height, 10.0, 0.0, 0.0, ""}.cards(),
                        {}};
    for (int i = 0; i < width * height; ++i) {
      content.values.push_back(static_cast<float>(i % 200));
    }
    return content;
  }
  [[nodiscard]] std::vector<float> read(const std::string& name) const {
    FitsPicture picture({path(name)}, 0, {});
    std::vector<float> values(static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()));
    picture.read(0, 0, values);
    return values;
  }
  void write(const std::string& name, const FitsContent& content) const { test::write_fits(path(name), content); }

  /// The error that `work` ends in names file, place and all `words`.
  template <class Work>
  void expect_error(const Work& work, const std::string& file, const std::string& place,
                    const std::vector<std::string>& words) const {
    try {
      work();
      FAIL() << "no error, expected one with " << words.front();
    } catch (const Error& error) {
      EXPECT_NE(error.context().file.find(file), std::string::npos) << error.what();
      EXPECT_NE(error.context().place.find(place), std::string::npos) << error.what();
      EXPECT_FALSE(error.context().remedy.empty()) << error.what();
      for (const std::string& word : words) {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
      }
    }
  }
  void expect_file_error(const std::string& name, const std::string& place,
                         const std::vector<std::string>& words) const {
    expect_error([&] { FitsPicture({path(name)}, 0, {}); }, name, place, words);
  }
  void expect_wcs_error(const std::string& cards, const std::string& place,
                        const std::vector<std::string>& words) const {
    expect_error([&] { PictureWcs(cards, "made.fits", "HDU 1"); }, "made.fits", place, words);
  }
};

TEST_F(FitsPictures, NumbersAreScaledAndBlanksAreMissing) {
  FitsContent content = ramp();
  content.bits = SHORT_IMG;
  content.values[5] = -32768.0F;
  content.cards += card("BSCALE", 0.5) + card("BZERO", 100.0) + "BLANK   =               -32768" + std::string(50, ' ');
  write("short.fits", content);
  const std::vector<float> values = read("short.fits");
  EXPECT_TRUE(std::isnan(values[5]));
  EXPECT_FLOAT_EQ(values[0], 100.0F);
  EXPECT_FLOAT_EQ(values[7], 103.5F);
}

TEST_F(FitsPictures, CompressionsGiveTheSameNumbers) {
  FitsContent content = ramp();
  content.values[5] = std::numeric_limits<float>::quiet_NaN();
  write("plain.fits", content);
  const std::vector<float> plain = read("plain.fits");
  EXPECT_TRUE(std::isnan(plain[5]));
  write_file_atomically(path("whole.fits.gz"), test::gzip_of(text("plain.fits")));
  content.compression = GZIP_1;
  write("tiles.fits", content);
  content.values[5] = 5.0F;
  content.bits = LONG_IMG;
  content.compression = RICE_1;
  write("rice.fits", content);
  const std::vector<float> gzip = read("whole.fits.gz");
  const std::vector<float> tiles = read("tiles.fits");
  const std::vector<float> rice = read("rice.fits");
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (i == 5) {
      EXPECT_TRUE(std::isnan(gzip[i]) && std::isnan(tiles[i]));
    } else {
      EXPECT_EQ(plain[i], gzip[i]);
      EXPECT_EQ(plain[i], tiles[i]);
      EXPECT_EQ(plain[i], rice[i]);
    }
  }
}

TEST_F(FitsPictures, ChannelsOnAThirdAxisOrInSeveralFiles) {
  FitsContent content = ramp();
  write("one.fits", content);
  content.planes = 3;
  content.in_extension = true;
  const std::vector<float> plane = content.values;
  for (const float offset : {1000.0F, 2000.0F}) {
    for (const float value : plane) {
      content.values.push_back(value + offset);
    }
  }
  write("cube.fits", content);
  FitsPicture cube({path("cube.fits")}, 0, {});
  EXPECT_EQ(cube.channels(), 3);
  EXPECT_EQ(cube.place(), "HDU 2");
  FitsPicture turned({path("cube.fits")}, 2, {3, 2, 1});
  FitsPicture files({path("one.fits"), path("one.fits"), path("one.fits")}, 0, {});
  std::vector<float> row(width);
  cube.read(2, 4, row);
  EXPECT_FLOAT_EQ(row[3], 2000.0F + static_cast<float>((4 * width + 3) % 200));
  turned.read(2, 4, row);
  EXPECT_FLOAT_EQ(row[3], static_cast<float>((4 * width + 3) % 200));
  files.read(1, 4, row);
  EXPECT_FLOAT_EQ(row[3], static_cast<float>((4 * width + 3) % 200));
  expect_error([&] { FitsPicture({path("cube.fits")}, 0, {4}); }, "cube.fits", "NAXIS3", {"no plane 4"});
  expect_error([&] { FitsPicture({path("cube.fits")}, 0, {1, 2}); }, "cube.fits", "NAXIS3", {"2 channels"});
  expect_error([&] { FitsPicture({path("cube.fits")}, 5, {}); }, "cube.fits", "HDU", {"no HDU 5", "has 2"});
}

TEST_F(FitsPictures, BrokenFilesAreNamed) {
  FolderTest::write("text.fits", "Not a FITS file at all\n");
  expect_file_error("text.fits", "byte 0", {"not a FITS file"});
  expect_file_error("none.fits", "", {"cannot be opened"});
  write("whole.fits", ramp());
  const std::string bytes = text("whole.fits");
  // The header takes a block of 2880 bytes, the data 2592 of the next.
  FolderTest::write("cut.fits", bytes.substr(0, 2880 + 2000));
  expect_file_error("cut.fits", "HDU 1, NAXIS", {"cut short", "2592", "4880"});
  FolderTest::write("header.fits", bytes.substr(0, 1000));
  expect_file_error("header.fits", "HDU 1", {"header"});
  const Bytes packed = test::gzip_of(bytes);
  write_file_atomically(path("cut.fits.gz"), std::span(packed).first(packed.size() / 2));
  expect_file_error("cut.fits.gz", "byte", {"truncated"});
  FitsContent rice = ramp();
  rice.bits = LONG_IMG;
  rice.compression = RICE_1;
  write("rice.fits", rice);
  const std::string compressed = text("rice.fits");
  FolderTest::write("cut_rice.fits", compressed.substr(0, compressed.size() - 2880));
  expect_file_error("cut_rice.fits", "HDU 2", {"cut short"});
  FitsContent empty = ramp();
  write("one.fits", empty);
  empty.width = 18;
  empty.height = 36;
  write("other.fits", empty);
  expect_error(
      [&] {
        FitsPicture({path("one.fits"), path("other.fits"), path("one.fits")}, 0, {});
      },
      "other.fits", "NAXIS1", {"18 x 36", "36 x 18"});
}

TEST_F(FitsPictures, HeadersThatMakeNoSenseAreNamed) {
  const SkyHeader good{"CAR", "GLON", "GLAT", width, height, 10.0, 0.0, 0.0, ""};
  expect_wcs_error("", "HDU 1", {"coordinates", "--frame"});
  expect_wcs_error(card("CTYPE1", "LINEAR") + card("CTYPE2", "LINEAR"), "CTYPE1", {"no celestial coordinates"});
  expect_wcs_error(card("CTYPE1", "GLON-XYZ") + card("CTYPE2", "GLAT-XYZ"), "CTYPE1", {"GLON-XYZ", "CAR", "HPX"});
  expect_wcs_error(card("CTYPE1", "GLON-CAR") + card("CTYPE2", "DEC--CAR"), "HDU 1", {"no sense"});
  expect_wcs_error(card("CTYPE1", "LINEAR") + card("CTYPE2", "GLON-CAR") + card("CTYPE3", "GLAT-CAR"), "CTYPE3",
                   {"swapped", "axes 1 and 2"});
  expect_wcs_error(good.cards() + card("CUNIT1", "furlong"), "CUNIT", {"no sense"});
  expect_wcs_error(good.cards() + card("CD1_1", 0.0) + card("CD2_2", 0.0), "CD", {"no sense"});
  expect_wcs_error(good.cards() + card("RADESYS", "FK4") + card("EQUINOX", 1900.0) + card("CTYPE1", "RA---CAR") +
                       card("CTYPE2", "DEC--CAR"),
                   "RADESYS", {"not known", "FK4"});
  expect_wcs_error(good.cards() + fmt::format("{:<80}", "CRPIX1  = nonsense"), "HDU 1", {"no valid value"});
  expect_error([&] { good.wcs().require_on_sphere(height, width * 4); }, "made.fits", "NAXIS1", {"swapped"});
  good.wcs().require_on_sphere(width, height);
}

TEST_F(FitsPictures, MatrixFormsAndDefaultsMeanTheSame) {
  const std::string types =
      card("CTYPE1", "GLON-AIT") + card("CTYPE2", "GLAT-AIT") + card("CRPIX1", 18.5) + card("CRPIX2", 9.5);
  const std::string cdelt = types + card("CDELT1", -9.0) + card("CDELT2", 9.0);
  const std::string pc = cdelt + card("PC1_1", 1.0) + card("PC2_2", 1.0) + card("CRVAL1", 0.0) + card("CRVAL2", 0.0) +
                         card("LONPOLE", 0.0) + card("CUNIT1", "deg") + card("CUNIT2", "deg");
  const std::string cd = types + card("CD1_1", -9.0) + card("CD2_2", 9.0);
  // Latitude on the first axis, longitude on the second.
  const std::string turned = card("CTYPE1", "GLAT-AIT") + card("CTYPE2", "GLON-AIT") + card("CRPIX1", 9.5) +
                             card("CRPIX2", 18.5) + card("CDELT1", 9.0) + card("CDELT2", -9.0);
  PictureWcs first(cdelt, "a", "HDU 1");
  for (const std::string& cards : {pc, cd}) {
    PictureWcs other(cards, "b", "HDU 1");
    EXPECT_LT(distance(first.direction({7.3, 11.1}), other.direction({7.3, 11.1})), 1e-12);
  }
  EXPECT_LT(distance(first.direction({7.3, 11.1}), PictureWcs(turned, "c", "HDU 1").direction({11.1, 7.3})), 1e-12);
  const Vec3 direction = first.direction({7.3, 11.1});
  const auto place = first.place(direction);
  ASSERT_TRUE(place.has_value());
  EXPECT_NEAR(place->x, 7.3, 1e-9);
  EXPECT_NEAR(place->y, 11.1, 1e-9);
}

TEST_F(FitsPictures, RemarksOfTheHeader) {
  FitsContent content = ramp();
  content.cards += card("SATURATE", 4.9e4) + card("BUNIT", "cd/m2") + card("DATE-OBS", "2008-07-01T12:00:00");
  write("remarks.fits", content);
  const FitsRemarks remarks = FitsPicture({path("remarks.fits")}, 0, {}).remarks();
  EXPECT_EQ(remarks.saturation, 4.9e4);
  EXPECT_EQ(remarks.unit, "cd/m2");
  EXPECT_NEAR(remarks.epoch_jyear.value(), 2008.5, 0.01);
}

} // namespace
} // namespace vesper
