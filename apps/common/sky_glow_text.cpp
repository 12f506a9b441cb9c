#include "common/sky_glow_text.hpp"

#include "common/option_text.hpp"

#include "vesper/light/night_light.hpp"

#include <array>
#include <cstddef>

namespace vesper {
namespace {

constexpr double natural_v = 22.0;
constexpr std::array bortle_v{22.0, 21.9, 21.8, 21.1, 20.0, 19.2, 18.7, 18.1, 17.5};

Luminance artificial_part(double v) { return luminance_of_v_per_arcsec2(v) - luminance_of_v_per_arcsec2(natural_v); }

} // namespace

std::optional<Luminance> sky_glow_from_text(std::string_view text) {
  constexpr std::string_view magnitude = "mag";
  constexpr std::string_view bortle = "bortle";
  if (text == "off") {
    return Luminance();
  }
  if (text.starts_with(bortle)) {
    const auto number = number_within(text.substr(bortle.size()), 1, static_cast<int>(bortle_v.size()));
    return number ? std::optional(artificial_part(bortle_v.at(static_cast<std::size_t>(*number - 1)))) : std::nullopt;
  }
  if (text.ends_with(magnitude)) {
    const auto v = number_within(text.substr(0, text.size() - magnitude.size()), 10.0, natural_v);
    return v ? std::optional(artificial_part(*v)) : std::nullopt;
  }
  const auto luminance = number_within(text, 0.0, 1.0);
  return luminance ? std::optional(*luminance * candela_per_m2) : std::nullopt;
}

} // namespace vesper
