// What picture files say of the display, read byte by byte and through the picture library.
#include "vesper/assets/image_file.hpp"
#include "vesper/plan/display_files.hpp"
#include "vesper/plan/icc_profile.hpp"

#include "support/folder_test.hpp"
#include "support/truth.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <map>
#include <string>
#include <vector>
#include <zlib.h>

namespace vesper {
namespace {

using test::FolderTest;

/// Big-endian numbers of a file.
class Reader {
public:
  explicit Reader(Bytes bytes) : bytes_(std::move(bytes)) {}
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::uint32_t number(std::size_t offset, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      value = value << 8U | std::to_integer<std::uint32_t>(bytes_.at(offset + i));
    }
    return value;
  }
  [[nodiscard]] double fixed(std::size_t offset) const {
    return static_cast<std::int32_t>(number(offset, 4)) / 65536.0;
  }
  [[nodiscard]] Vec3 vector(std::size_t offset) const { return {fixed(offset), fixed(offset + 4), fixed(offset + 8)}; }
  [[nodiscard]] std::string text(std::size_t offset, std::size_t count) const {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
      text += std::to_integer<char>(bytes_.at(offset + i));
    }
    return text;
  }
  [[nodiscard]] Bytes part(std::size_t offset, std::size_t count) const {
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(offset);
    return {first, first + static_cast<std::ptrdiff_t>(count)};
  }

private:
  Bytes bytes_;
};

/// The chunks of a PNG in their order; checks each one's sum.
std::vector<std::pair<std::string, Bytes>> png_chunks(const Bytes& file) {
  const Reader png(file);
  std::vector<std::pair<std::string, Bytes>> chunks;
  for (std::size_t at = 8; at < png.size();) {
    const std::size_t size = png.number(at, 4);
    const Bytes checked = png.part(at + 4, 4 + size);
    EXPECT_EQ(png.number(at + 8 + size, 4),
              ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size())));
    chunks.emplace_back(png.text(at + 4, 4), png.part(at + 8, size));
    at += 12 + size;
  }
  return chunks;
}

const Bytes* find(const std::vector<std::pair<std::string, Bytes>>& chunks, const std::string& type) {
  const auto found = std::find_if(chunks.begin(), chunks.end(), [&](const auto& chunk) { return chunk.first == type; });
  return found == chunks.end() ? nullptr : &found->second;
}

Bytes inflated(const Bytes& chunk, std::size_t offset, std::size_t size) {
  Bytes plain(size);
  uLongf length = size;
  EXPECT_EQ(::uncompress(reinterpret_cast<Bytef*>(plain.data()), &length,
                         reinterpret_cast<const Bytef*>(chunk.data() + offset), chunk.size() - offset),
            Z_OK);
  EXPECT_EQ(length, size);
  return plain;
}

/// Offsets of the elements of a profile; checks its frame.
std::map<std::string, std::size_t> elements_of(const Reader& profile) {
  EXPECT_EQ(profile.number(0, 4), profile.size());
  EXPECT_EQ(profile.text(12, 12), "mntrRGB XYZ ");
  EXPECT_EQ(profile.text(36, 4), "acsp");
  std::map<std::string, std::size_t> offsets;
  for (std::size_t i = 0; i < profile.number(128, 4); ++i) {
    const std::size_t at = 132 + 12 * i;
    const std::size_t offset = profile.number(at + 4, 4);
    EXPECT_EQ(offset % 4, 0U);
    EXPECT_LE(offset + profile.number(at + 8, 4), profile.size());
    offsets[profile.text(at, 4)] = offset;
  }
  return offsets;
}

class DisplayFiles : public FolderTest {};

TEST_F(DisplayFiles, ProfilesHoldThePublishedColoursUnderD50) {
  // sRGB as the ICC publishes it (sRGB v4 appearance, "sRGB2014.icc": colorants of D50), within its rounding.
  const Reader srgb(icc_profile(Display()));
  const auto elements = elements_of(srgb);
  EXPECT_LT(glm::distance(srgb.vector(elements.at("rXYZ") + 8), Vec3(0.4361, 0.2225, 0.0139)), 3.0e-4);
  EXPECT_LT(glm::distance(srgb.vector(elements.at("gXYZ") + 8), Vec3(0.3851, 0.7169, 0.0971)), 3.0e-4);
  EXPECT_LT(glm::distance(srgb.vector(elements.at("bXYZ") + 8), Vec3(0.1431, 0.0606, 0.7141)), 3.0e-4);
  for (const Primaries primaries : {Primaries::srgb, Primaries::display_p3, Primaries::rec2020}) {
    Display display;
    display.primaries = primaries;
    display.transfer = Transfer::gamma;
    const Reader profile(icc_profile(display));
    const auto offsets = elements_of(profile);
    const Vec3 white = profile.vector(offsets.at("rXYZ") + 8) + profile.vector(offsets.at("gXYZ") + 8) +
                       profile.vector(offsets.at("bXYZ") + 8);
    EXPECT_LT(glm::distance(white, Vec3(0.9642, 1.0, 0.8249)), 1.0e-4) << "the white is that of the profile's space";
    EXPECT_LT(glm::distance(profile.vector(offsets.at("wtpt") + 8), Vec3(0.9642, 1.0, 0.8249)), 1.0e-4);
    // The adaptation undone gives the display's own red.
    const std::size_t chad = offsets.at("chad") + 8;
    const Mat3 adapt = glm::transpose(Mat3(profile.vector(chad), profile.vector(chad + 12), profile.vector(chad + 24)));
    const Vec3 red = glm::inverse(adapt) * profile.vector(offsets.at("rXYZ") + 8);
    const Vec2 xy = Vec2(red) / (red.x + red.y + red.z);
    EXPECT_LT(glm::distance(xy, Vec2(f64::chromaticities_of(static_cast<int>(primaries)).red)), 2.0e-4);
    EXPECT_NEAR(profile.vector(offsets.at("lumi") + 8).y, 200.0, 1.0e-4);
    EXPECT_EQ(profile.text(offsets.at("rTRC"), 4), "para");
    EXPECT_NEAR(profile.fixed(offsets.at("rTRC") + 12), 2.2, 1.0e-4);
    EXPECT_EQ(offsets.at("rTRC"), offsets.at("bTRC"));
  }
}

TEST_F(DisplayFiles, TheCurveOfAProfileIsItsTransfer) {
  // ICC.1:2010 table 65, function 3.
  const Reader srgb(icc_profile(Display()));
  const std::size_t at = elements_of(srgb).at("rTRC");
  ASSERT_EQ(srgb.number(at + 8, 2), 3U);
  std::array<double, 5> p{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.at(i) = srgb.fixed(at + 12 + 4 * i);
  }
  test::ErrorSum errors;
  for (int code = 0; code <= 255; ++code) {
    const double x = code / 255.0;
    errors.add((x >= p[4] ? std::pow(p[1] * x + p[2], p[0]) : p[3] * x) - f64::srgb_decode(x));
  }
  errors.hold("sRGB's curve in the profile", 5.0e-5, "of white");
  Display display;
  display.transfer = Transfer::pq;
  display.peak = 1000.0 * candela_per_m2;
  display.black = Luminance();
  const Reader pq(icc_profile(display));
  const std::size_t table = elements_of(pq).at("gTRC");
  ASSERT_EQ(pq.text(table, 4), "curv");
  ASSERT_EQ(pq.number(table + 8, 4), 4096U);
  const auto entry = static_cast<std::size_t>(std::lround(f64::pq_encode(500.0) * 4095.0));
  EXPECT_NEAR(pq.number(table + 12 + 2 * entry, 2) / 65535.0, 0.5, 2.0e-3);
  EXPECT_EQ(pq.number(table + 12 + 2 * 4095, 2), 65535U);
}

/// Numbers that need all 16 bits.
std::vector<std::uint16_t> deep_pixels() {
  std::vector<std::uint16_t> rgba;
  for (unsigned i = 0; i < 12; ++i) {
    rgba.insert(rgba.end(), {static_cast<std::uint16_t>(i * 5003), static_cast<std::uint16_t>(65535 - i * 401),
                             static_cast<std::uint16_t>(i), 65535});
  }
  return rgba;
}

TEST_F(DisplayFiles, ADeepPictureComesBackWithAllItsBits) {
  const std::vector<std::uint16_t> rgba = deep_pixels();
  Display display;
  display.primaries = Primaries::display_p3;
  write_png(path("deep.png"), 4, 3, rgba, {}, color_tags(display));
  const FloatImage image = read_image(path("deep.png"));
  ASSERT_EQ(image.values.size(), 36U);
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_EQ(std::lround(image.values[i] * 65535.0F), rgba[i / 3 * 4 + i % 3]);
  }
  const auto chunks = png_chunks(read_file(path("deep.png")));
  EXPECT_EQ(chunks.front().first, "IHDR");
  EXPECT_EQ(Reader(chunks.front().second).number(8, 1), 16U);
  const Bytes* profile = find(chunks, "iCCP");
  ASSERT_NE(profile, nullptr);
  const std::size_t name =
      static_cast<std::size_t>(std::find(profile->begin(), profile->end(), std::byte{0}) - profile->begin());
  const Bytes expected = icc_profile(display);
  EXPECT_EQ(inflated(*profile, name + 2, expected.size()), expected);
  EXPECT_EQ(find(chunks, "sRGB"), nullptr);
  ASSERT_NE(find(chunks, "cICP"), nullptr);
  EXPECT_EQ(Reader(*find(chunks, "cICP")).number(0, 4), 0x0C0D0001U); // P3 with D65, sRGB's curve, RGB, full range
  write_png(path("again.png"), 4, 3, rgba, {}, color_tags(display));
  EXPECT_EQ(read_file(path("again.png")), read_file(path("deep.png")));
}

TEST_F(DisplayFiles, SrgbNeedsNoProfile) {
  const std::vector<std::uint8_t> rgba(4 * 6, 77);
  write_png(path("plain.png"), 3, 2, rgba, {}, color_tags(Display()));
  const auto chunks = png_chunks(read_file(path("plain.png")));
  EXPECT_EQ(Reader(chunks.front().second).number(8, 1), 8U);
  EXPECT_NE(find(chunks, "sRGB"), nullptr);
  EXPECT_EQ(find(chunks, "iCCP"), nullptr);
  EXPECT_EQ(find(chunks, "cICP"), nullptr);
}

TEST_F(DisplayFiles, PqSaysItsCodePointsAndTheDisplaysVolume) {
  Display display;
  display.primaries = Primaries::rec2020;
  display.transfer = Transfer::pq;
  display.peak = 1000.0 * candela_per_m2;
  display.black = 0.005 * candela_per_m2;
  write_png(path("pq.png"), 4, 3, deep_pixels(), {}, color_tags(display));
  const auto chunks = png_chunks(read_file(path("pq.png")));
  ASSERT_NE(find(chunks, "cICP"), nullptr);
  EXPECT_EQ(Reader(*find(chunks, "cICP")).number(0, 4), 0x09100001U); // ITU-R BT.2100 PQ: 9, 16, 0, 1
  ASSERT_NE(find(chunks, "mDCV"), nullptr);
  const Reader volume(*find(chunks, "mDCV"));
  ASSERT_EQ(volume.size(), 24U);
  EXPECT_EQ(volume.number(0, 2), 35400U); // red's x of 0.708 by 0.00002
  EXPECT_EQ(volume.number(14, 2), 16450U);
  EXPECT_EQ(volume.number(16, 4), 10000000U); // 1000 cd/m2 by 0.0001
  EXPECT_EQ(volume.number(20, 4), 50U);
  for (const char* before : {"cICP", "mDCV", "iCCP"}) {
    const auto at = [&](const std::string& type) {
      return std::find_if(chunks.begin(), chunks.end(), [&](const auto& chunk) { return chunk.first == type; });
    };
    EXPECT_LT(at(before) - chunks.begin(), at("IDAT") - chunks.begin()) << before;
  }
  EXPECT_EQ(read_image(path("pq.png")).width, 4);
}

TEST_F(DisplayFiles, AnExrOfDisplayValuesIsLinearAndSaysItsColours) {
  Display display;
  display.primaries = Primaries::display_p3;
  const std::vector<std::uint16_t> rgba = deep_pixels();
  write_rgb_exr(path("display.exr"), 4, 3, display_signals(rgba, display), linear_colors(display), {});
  const FloatImage image = read_image(path("display.exr"));
  EXPECT_TRUE(image.floating);
  ASSERT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B"}));
  for (std::size_t i = 0; i < 36; ++i) {
    const double code = rgba[i / 3 * 4 + i % 3] / 65535.0;
    EXPECT_NEAR(image.values[i], f64::srgb_decode(code), 1.0e-7);
  }
  // OpenEXR: name, type, size, numbers with the lowest byte first.
  const Bytes bytes = read_file(path("display.exr"));
  const auto floats_of = [&](const std::string& attribute, std::size_t count) {
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t at = text.find(attribute);
    EXPECT_NE(at, std::string::npos) << attribute;
    std::vector<float> values(count);
    std::memcpy(values.data(), bytes.data() + at + attribute.size() + 4, 4 * count);
    return values;
  };
  using namespace std::string_literals;
  const std::vector<float> xy = floats_of("chromaticities\0chromaticities\0"s, 8);
  EXPECT_EQ(xy, (std::vector<float>{0.680F, 0.320F, 0.265F, 0.690F, 0.150F, 0.060F, 0.3127F, 0.3290F}));
  EXPECT_EQ(floats_of("whiteLuminance\0float\0"s, 1).front(), 200.0F);
}

} // namespace
} // namespace vesper
