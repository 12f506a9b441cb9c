// Names that people know for stars and groups of stars.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace vesper {

/// A group of stars that is recognised at a glance, by Harvard Revised numbers.
struct SkyFigure {
  std::string_view name;
  std::span<const std::uint16_t> stars;
};
[[nodiscard]] std::span<const SkyFigure> sky_figures();

struct NamedStar {
  std::uint16_t hr;
  std::string_view name;
};
/// Proper names (IAU Catalog of Star Names) of bright stars.
[[nodiscard]] std::span<const NamedStar> named_stars();

/// The proper name of a star, or "".
[[nodiscard]] std::string_view proper_name(std::uint32_t hr);

} // namespace vesper
