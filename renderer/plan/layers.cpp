#include "vesper/plan/layers.hpp"

#include <algorithm>
#include <array>

namespace vesper {
namespace {

constexpr std::array<std::string_view, layer_count> names_of_layers{"stars", "planets", "ground"};

} // namespace

std::span<const std::string_view> layer_names() { return names_of_layers; }

std::optional<Layer> layer_from_name(std::string_view name) {
  const auto* found = std::find(names_of_layers.begin(), names_of_layers.end(), name);
  if (found == names_of_layers.end()) {
    return std::nullopt;
  }
  return static_cast<Layer>(found - names_of_layers.begin());
}

} // namespace vesper
