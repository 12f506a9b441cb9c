#include "vesper/plan/icc_profile.hpp"

#include "vesper/assets/big_endian.hpp"
#include "vesper/base/vector.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace vesper {
namespace {

/// The white of all profiles.
constexpr Vec3 d50(0.9642, 1.0, 0.8249);

/// What is seen under D50 for what is seen under `white` (Bradford: ICC.1:2010, annex E).
Mat3 d50_from(const Vec3& white) {
  const Mat3 cones(Vec3(0.8951, -0.7502, 0.0389), Vec3(0.2664, 1.7135, -0.0685), Vec3(-0.1614, 0.0367, 1.0296));
  const Vec3 gains = (cones * d50) / (cones * white);
  return glm::inverse(cones) * Mat3(gains.x, 0.0, 0.0, 0.0, gains.y, 0.0, 0.0, 0.0, gains.z) * cones;
}

Bytes localized(std::string_view text) {
  BigEndian element;
  element.text("mluc").u32(0).u32(1).u32(12).text("enUS").u32(static_cast<std::uint32_t>(2 * text.size())).u32(28);
  for (const char c : text) {
    element.u16(static_cast<unsigned char>(c));
  }
  return element.bytes();
}

Bytes xyz(const Vec3& v) { return BigEndian().text("XYZ ").u32(0).vector(v).bytes(); }

/// From code values to linear components.
Bytes curve(const Display& display) {
  constexpr unsigned power = 0;
  constexpr unsigned power_with_line = 3;
  switch (display.transfer) {
  case Transfer::gamma:
    return BigEndian().text("para").u32(0).u16(power).u16(0).fixed(display.gamma).bytes();
  case Transfer::srgb:
    return BigEndian()
        .text("para")
        .u32(0)
        .u16(power_with_line)
        .u16(0)
        .fixed(2.4)
        .fixed(1.0 / 1.055)
        .fixed(0.055 / 1.055)
        .fixed(1.0 / 12.92)
        .fixed(0.04045)
        .bytes();
  case Transfer::pq:
    break;
  }
  constexpr unsigned samples = 4096;
  const f64::DisplayModel model = display_model(display);
  BigEndian element;
  element.text("curv").u32(0).u32(samples);
  for (unsigned i = 0; i < samples; ++i) {
    element.u16(static_cast<unsigned>(std::lround(65535.0 * f64::transfer_decode(i / (samples - 1.0), model))));
  }
  return element.bytes();
}

std::string profile_name(const Display& display) {
  return fmt::format("vesper {} {}", primaries_names()[static_cast<std::size_t>(display.primaries)],
                     transfer_names()[static_cast<std::size_t>(display.transfer)]);
}

} // namespace

Bytes icc_profile(const Display& display) {
  validate(display);
  const f64::Chromaticities colors = f64::chromaticities_of(static_cast<int>(display.primaries));
  const Vec3 white = f64::xyz_of_chromaticity(colors.white);
  const Mat3 adapt = d50_from(white);
  const Mat3 xyz_from_rgb = adapt * f64::xyz_from_rgb(colors);
  BigEndian adaptation;
  adaptation.text("sf32").u32(0);
  for (int row = 0; row < 3; ++row) {
    adaptation.vector(glm::transpose(adapt)[row]);
  }
  struct Tag {
    std::string_view name;
    Bytes element; ///< empty: that of the tag before
  };
  const std::array<Tag, 11> tags{{{"desc", localized(profile_name(display))},
                                  {"cprt", localized("CC0")},
                                  {"wtpt", xyz(d50)},
                                  {"chad", adaptation.bytes()},
                                  {"lumi", xyz(white * (display.dome_gain * display.peak.to(candela_per_m2)))},
                                  {"rXYZ", xyz(xyz_from_rgb[0])},
                                  {"gXYZ", xyz(xyz_from_rgb[1])},
                                  {"bXYZ", xyz(xyz_from_rgb[2])},
                                  {"rTRC", curve(display)},
                                  {"gTRC", {}},
                                  {"bTRC", {}}}};
  constexpr std::size_t header_size = 128;
  constexpr std::size_t aligned = 4;
  BigEndian table;
  BigEndian elements;
  table.u32(static_cast<std::uint32_t>(tags.size()));
  std::size_t offset = 0;
  std::size_t size = 0;
  for (const Tag& tag : tags) {
    if (!tag.element.empty()) {
      offset = header_size + 4 + 12 * tags.size() + elements.bytes().size();
      size = tag.element.size();
      elements.all(tag.element).zeros((aligned - size % aligned) % aligned);
    }
    table.text(tag.name).u32(static_cast<std::uint32_t>(offset)).u32(static_cast<std::uint32_t>(size));
  }
  const std::size_t all = header_size + table.bytes().size() + elements.bytes().size();
  constexpr unsigned relative_colorimetric = 1;
  constexpr unsigned embedded = 1;
  BigEndian profile;
  profile.u32(static_cast<std::uint32_t>(all)).u32(0).u32(0x04300000).text("mntrRGB XYZ ");
  profile.u16(2026).u16(1).u16(1).zeros(6); // always the same date: same display, same bytes
  profile.text("acsp").u32(0).u32(embedded).zeros(16).u32(relative_colorimetric).vector(d50).zeros(48);
  return profile.all(table.bytes()).all(elements.bytes()).bytes();
}

} // namespace vesper
