// The layers a frame is composed of.
#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace vesper {

enum class Layer : std::size_t {
  stars,     ///< point sources of the catalogue
  planets,   ///< Mercury to Neptune, as point sources
  milky_way, ///< the light of stars too faint to be drawn as points
  moon,      ///< its disc, which hides what is behind it
  sun,       ///< its disc and, where nothing outshines it, the corona; the Moon hides them
  sky,       ///< light scattered in the air, from the Sun and the Moon
  airglow,
  zodiacal, ///< zodiacal light and gegenschein
  sky_glow, ///< artificial light in the air
  ground,   ///< the opaque Earth below the horizon; with the sky's layer, lit
};
inline constexpr std::size_t layer_count = 10;

using LayerSet = std::bitset<layer_count>;

/// Names in the order of the enumeration, as `--layers` takes them.
[[nodiscard]] std::span<const std::string_view> layer_names();
[[nodiscard]] std::optional<Layer> layer_from_name(std::string_view name);

[[nodiscard]] inline LayerSet all_layers() { return LayerSet().set(); }
[[nodiscard]] inline bool has(const LayerSet& set, Layer layer) { return set.test(static_cast<std::size_t>(layer)); }

} // namespace vesper
