#include "vesper/plan/layers.hpp"

#include <algorithm>
#include <array>

namespace vesper {
namespace {

constexpr std::array<std::string_view, layer_count> names{"stars", "planets", "milky-way", "moon",     "sun",
                                                          "sky",   "airglow", "zodiacal",  "sky-glow", "ground"};

} // namespace

std::span<const std::string_view> layer_names() { return names; }

std::optional<Layer> layer_from_name(std::string_view name) {
  const auto* found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    return std::nullopt;
  }
  return static_cast<Layer>(found - names.begin());
}

} // namespace vesper
