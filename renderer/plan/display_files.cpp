#include "vesper/plan/display_files.hpp"

#include "vesper/assets/big_endian.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/icc_profile.hpp"

#include <array>
#include <cmath>

namespace vesper {
namespace {

f64::Chromaticities chromaticities(const Display& display) {
  return f64::chromaticities_of(static_cast<int>(display.primaries));
}

} // namespace

ColorTags color_tags(const Display& display) {
  validate(display);
  ColorTags tags;
  if (display.primaries == Primaries::srgb && display.transfer == Transfer::srgb) {
    return tags;
  }
  tags.icc_profile = icc_profile(display);
  // ITU-T H.273: colour primaries, transfer characteristics, no matrix, full range.
  constexpr std::array<unsigned, 3> primaries{1, 12, 9};
  constexpr unsigned srgb_points = 13;
  constexpr unsigned pq_points = 16;
  if (display.transfer != Transfer::gamma) {
    tags.chunks.emplace_back("cICP", BigEndian()
                                         .u8(primaries.at(static_cast<std::size_t>(display.primaries)))
                                         .u8(display.transfer == Transfer::pq ? pq_points : srgb_points)
                                         .u8(0)
                                         .u8(1)
                                         .bytes());
  }
  if (display.transfer == Transfer::pq) {
    const f64::Chromaticities colors = chromaticities(display);
    BigEndian volume;
    for (const Vec2& xy : {colors.red, colors.green, colors.blue, colors.white}) {
      for (const double number : {xy.x, xy.y}) {
        volume.u16(static_cast<unsigned>(std::lround(number / 0.00002)));
      }
    }
    for (const Luminance luminance : {display.peak, display.black}) {
      volume.u32(static_cast<std::uint32_t>(std::lround(display.dome_gain * luminance.to(candela_per_m2) / 0.0001)));
    }
    tags.chunks.emplace_back("mDCV", volume.bytes());
  }
  return tags;
}

LinearColors linear_colors(const Display& display) {
  const f64::Chromaticities colors = chromaticities(display);
  LinearColors result;
  std::size_t i = 0;
  for (const Vec2& xy : {colors.red, colors.green, colors.blue, colors.white}) {
    result.chromaticities.at(i++) = static_cast<float>(xy.x);
    result.chromaticities.at(i++) = static_cast<float>(xy.y);
  }
  result.white_cd_m2 = static_cast<float>(display.dome_gain * display.peak.to(candela_per_m2));
  return result;
}

std::vector<float> display_signals(std::span<const std::uint16_t> rgba, const Display& display) {
  const f64::DisplayModel model = display_model(display);
  std::vector<float> signals;
  signals.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    if (i % 4 != 3) {
      signals.push_back(static_cast<float>(f64::transfer_decode(rgba[i] / 65535.0, model)));
    }
  }
  return signals;
}

} // namespace vesper
