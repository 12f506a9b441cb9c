// vesper-catalog panorama as a person uses it.
#include "support/command_line_test.hpp"
#include "support/fits_file.hpp"
#include "support/sky_picture.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/default_stars.hpp"
#include "vesper/assets/image_file.hpp"
#include "vesper/assets/sky_map.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/units.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

namespace vesper {
namespace {

using test::card;
using test::CommandResult;
using test::FitsContent;
using test::SkyHeader;

class PanoramaCli : public test::CommandLineTest {
protected:
  PanoramaCli() : CommandLineTest("vesper-catalog", "panorama") {}

  /// info and check, without the command of the others.
  [[nodiscard]] CommandResult inspect(const std::string& arguments) const { return run_with("", arguments); }

  static FitsContent sky(const std::string& more = card("BUNIT", "cd/m2")) {
    FitsContent content{
        72, 36, 1, FLOAT_IMG, 0, false, SkyHeader{"CAR", "GLON", "GLAT", 72, 36, 5.0, 0.0, 0.0, more}.cards(), {}};
    content.values.assign(72UL * 36UL, 0.25F);
    return content;
  }
  void write_fits(const std::string& name, const FitsContent& content) const { test::write_fits(path(name), content); }
};

TEST_F(PanoramaCli, AConstantSkyInCandelas) {
  write_fits("in.fits", sky());
  const CommandResult made = run("in.fits -o out.exr --face 32 --json");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto report = nlohmann::json::parse(made.out);
  EXPECT_EQ(report["coordinates"], "GLON-CAR, galactic");
  EXPECT_NEAR(report["budget"]["out"]["light"][0].get<double>(), 0.25 * 4.0 * std::numbers::pi, 1e-4);
  EXPECT_NEAR(report["fields"]["Sagittarius"]["xyzs_cd_m2"][1].get<double>(), 0.25, 1e-6);
  EXPECT_NEAR(report["fields"]["north galactic pole"]["mag_arcsec2"].get<double>(), 14.09, 0.01);
  const SkyMap map = read_sky_map(path("out.exr"));
  EXPECT_EQ(map.face_size, 32);
  EXPECT_EQ(map.provenance.source_files, "in.fits");
  EXPECT_EQ(map.provenance.source_sha256, report["source_sha256"]);
  for (std::size_t i = 1; i < map.texels.size(); i += 4) {
    ASSERT_NEAR(map.texels[i], 0.25F, 1e-6F);
  }
}

TEST_F(PanoramaCli, MapsAreInspected) {
  write_fits("in.fits", sky());
  ASSERT_EQ(run("in.fits -o out.exr --face 16 --credit ours").status, 0);
  const auto info = nlohmann::json::parse(inspect("info out.exr --json").out);
  EXPECT_EQ(info["face_size"], 16);
  EXPECT_EQ(info["credit"], "ours");
  EXPECT_EQ(info["calibrated"], true);
  EXPECT_NEAR(info["mean_luminance_cd_m2"].get<double>(), 0.25, 1e-3);
  EXPECT_NEAR(info["budget"]["out"]["area_deg2"].get<double>(), 41252.96, 0.01);
  EXPECT_NE(inspect("check out.exr").out.find("valid, a map of the sky, 6 faces of 16 x 16"), std::string::npos);
  SkyMap map = read_sky_map(path("out.exr"));
  map.texels[5] *= 2.0F;
  write_sky_map(path("changed.exr"), map);
  const CommandResult changed = inspect("check changed.exr --json");
  EXPECT_EQ(changed.status, 1);
  EXPECT_EQ(nlohmann::json::parse(changed.out)["valid"], false);
  EXPECT_NE(changed.err.find("changed.exr: budget, out_xyzs_lux: holds"), std::string::npos) << changed.err;
  map.provenance.budget = "{}";
  map.texels[1] = -1.0F;
  write_sky_map(path("bare.exr"), map);
  EXPECT_NE(inspect("check bare.exr").out.find(", 1 texels below zero"), std::string::npos);
  write("cut.exr", text("out.exr").substr(0, text("out.exr").size() / 2));
  EXPECT_EQ(inspect("check cut.exr").status, 1);
}

TEST_F(PanoramaCli, SameInputSameBytes) {
  write_fits("in.fits", sky());
  ASSERT_EQ(run("in.fits -o a.exr --face 16").status, 0);
  ASSERT_EQ(run("./in.fits --face=16 --output b.exr").status, 0);
  EXPECT_TRUE(text("a.exr") == text("b.exr"));
}

TEST_F(PanoramaCli, FaultyInputLeavesTheOldOutput) {
  write("out.exr", "an earlier file");
  write("text.fits", "no FITS");
  expect_failure(1, "text.fits -o out.exr", {"text.fits", "byte 0", "not a FITS file"});
  write("text.txt", "no picture");
  expect_failure(1, "text.txt -o out.exr", {"text.txt", "cannot be read"});
  write_fits("unit.fits", sky(""));
  expect_failure(1, "unit.fits -o out.exr",
                 {"unit.fits: HDU 1, BUNIT: the unit of the values is missing", "--calibrate"});
  write_fits("counts.fits", sky(card("BUNIT", "counts/s")));
  expect_failure(1, "counts.fits -o out.exr", {"HDU 1, BUNIT", "\"counts/s\""});
  FitsContent blank = sky();
  blank.values.assign(blank.values.size(), std::numeric_limits<float>::quiet_NaN());
  write_fits("blank.fits", blank);
  expect_failure(1, "blank.fits -o out.exr", {"blank.fits: HDU 1, BLANK", "all are blank"});
  FitsContent swapped = sky();
  std::swap(swapped.width, swapped.height);
  write_fits("swapped.fits", swapped);
  expect_failure(1, "swapped.fits -o out.exr", {"swapped.fits: HDU 1, NAXIS1", "axes are swapped"});
  FitsContent unknown = sky();
  unknown.cards = card("CTYPE1", "GLON-QQQ") + card("CTYPE2", "GLAT-QQQ");
  write_fits("unknown.fits", unknown);
  expect_failure(1, "unknown.fits -o out.exr", {"unknown.fits: HDU 1, CTYPE1", "GLON-QQQ", "Known are"});
  unknown.cards.clear();
  write_fits("no_wcs.fits", unknown);
  expect_failure(1, "no_wcs.fits -o out.exr", {"no_wcs.fits: HDU 1, CTYPE1", "no celestial coordinates", "--frame"});
  write_fits("few_stars.fits", sky(""));
  expect_failure(1, "few_stars.fits -o out.exr --calibrate stars", {"few_stars.fits", "0 stars", "--zero-point"});
  EXPECT_TRUE(text("out.exr") == "an earlier file");
}

TEST_F(PanoramaCli, AStarBufferOfAnotherEpochIsRefused) {
  StarCatalogue stars = default_star_catalogue();
  stars.provenance.epoch_jyear = 1800.0;
  write_star_glb(path("old.glb"), stars);
  write_fits("in.fits", sky());
  expect_failure(1, "in.fits -o out.exr --remove-stars old.glb", {"old.glb: epoch_jyear", "J1800", "J2000", "--epoch"});
  expect_failure(1, "in.fits -o out.exr --remove-stars none.glb", {"none.glb"});
  EXPECT_EQ(run("in.fits -o out.exr --face 16 --remove-stars old.glb --epoch 1810").status, 0);
}

TEST_F(PanoramaCli, HolesAndMissingPolesAreFilledAndReported) {
  FitsContent content = sky();
  for (int i = 0; i < 72; ++i) {
    content.values[static_cast<std::size_t>(i)] = -1.0F; // around the southern pole
  }
  write_fits("in.fits", content);
  const CommandResult made = run("in.fits -o out.exr --face 64 --missing -1 --json");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto report = nlohmann::json::parse(made.out);
  // A cap of 5 degrees: 2 pi (1 - cos 5 deg) = 78.5 square degrees, less what 72 great circles cut off a circle.
  EXPECT_NEAR(report["budget"]["filled"]["area_deg2"].get<double>(), 78.5, 0.3);
  EXPECT_EQ(report["holes_filled"], 1);
  EXPECT_NEAR(report["fields"]["south galactic pole"]["xyzs_cd_m2"][1].get<double>(), 0.25, 1e-5);
}

TEST_F(PanoramaCli, AWholeSkyPictureWithoutCoordinates) {
  // Right ascension 90 at the left, falling to the right; a white spot at right ascension 30, declination 45.
  std::vector<std::uint8_t> pixels(360UL * 180UL * 4UL, 0);
  const std::size_t spot = 4 * (45UL * 360UL + 60UL);
  std::fill_n(pixels.begin() + spot, 3, std::uint8_t{255});
  write_png(path("sky.png"), 360, 180, pixels, {});
  expect_failure(1, "none.png -o out.exr --frame icrs --zero-point 20", {"none.png"});
  expect_failure(2, "sky.png -o out.exr --zero-point 20", {"--frame is missing", "--origin"});
  expect_failure(2, "sky.png -o out.exr --frame earth --zero-point 20", {"--frame"});
  expect_failure(1, "sky.png -o out.exr --frame icrs", {"BUNIT", "--calibrate anchors"});
  ASSERT_EQ(run("sky.png -o out.exr --frame icrs --origin -90 --zero-point 20 --face 64").status, 0);
  const SkyMap map = read_sky_map(path("out.exr"));
  std::size_t brightest = 0;
  for (std::size_t i = 0; i < map.texels.size() / 4; ++i) {
    brightest = map.texels[4 * i + 1] > map.texels[4 * brightest + 1] ? i : brightest;
  }
  const double ra = (29.5 * deg).to(rad);
  const double dec = (44.5 * deg).to(rad);
  const Vec3 expected(std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec));
  EXPECT_LT(distance(cube_texel(64, brightest).direction, expected), 0.025);
}

TEST_F(PanoramaCli, WrongOptionsExitWith2) {
  write_fits("in.fits", sky());
  expect_failure(2, "", {"input"});
  expect_failure(2, "in.fits", {"--output is missing"});
  expect_failure(2, "in.fits -o in.fits", {"names the input itself"});
  expect_failure(2, "in.fits -o out.exr --face 3", {"--face"});
  expect_failure(2, "in.fits -o out.exr --transform 1,2", {"--transform", "mono"});
  expect_failure(2, "in.fits -o out.exr --origin 5", {"--frame"});
  expect_failure(2, "in.fits -o out.exr --zero-point 20 --calibrate stars", {"exclude"});
  expect_failure(1, "in.fits -o no/such/out.exr", {"no/such/out.exr: cannot be created"});
}

TEST_F(PanoramaCli, AnInterruptLeavesTheOldOutputAndNoOther) {
  FitsContent large{3600,
                    1800,
                    1,
                    FLOAT_IMG,
                    0,
                    false,
                    SkyHeader{"AIT", "GLON", "GLAT", 3600, 1800, 0.1, 0.0, 0.0, card("BUNIT", "cd/m2")}.cards(),
                    std::vector<float>(3600UL * 1800UL, 1.0F)};
  write_fits("in.fits", large);
  write("out.exr", "an earlier file");
  // The shell that becomes the program tells its own number to one that waits until the program catches interrupts.
  const CommandResult stopped = run("in.fits -o out.exr --face 1024",
                                    "me=$(exec sh -c 'echo $PPID'); "
                                    "caught() { sed -n 's/^SigCgt:.*\\(.\\)$/\\1/p' /proc/$me/status; }; "
                                    "{ until [ $((0x$(caught) & 2)) != 0 ]; do sleep 0.01; done; kill -INT $me; } & :");
  EXPECT_NE(stopped.err.find("interrupted"), std::string::npos) << stopped.err;
  EXPECT_EQ(stopped.status, 1);
  EXPECT_TRUE(text("out.exr") == "an earlier file");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder())) {
    ++files;
  }
  EXPECT_EQ(files, 2U) << stopped.err;
}

TEST_F(PanoramaCli, NothingHalfWrittenWhenTheDiskIsFull) {
  write_fits("in.fits", sky());
  write("out.exr", "an earlier file");
  expect_failure(1, "in.fits -o out.exr --face 64", {"out.exr"}, "ulimit -f 1");
  EXPECT_TRUE(text("out.exr") == "an earlier file");
}

} // namespace
} // namespace vesper
