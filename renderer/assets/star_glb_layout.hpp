// The layout of a star buffer as glTF states it, shared by writer and reader.
#pragma once

#include "vesper/assets/star_catalogue.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vesper::star_glb {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian and are copied as they are");

inline constexpr std::uint32_t magic = 0x46546C67;      // "glTF"
inline constexpr std::uint32_t json_chunk = 0x4E4F534A; // "JSON"
inline constexpr std::uint32_t bin_chunk = 0x004E4942;  // "BIN\0"
inline constexpr std::uint32_t version = 2;
inline constexpr std::size_t header_size = 12;
inline constexpr std::size_t chunk_header_size = 8;

inline constexpr int component_float = 5126;
inline constexpr int target_array_buffer = 34962;
inline constexpr int mode_points = 0;

/// One vertex attribute: its glTF name and type and its place in StarRecord.
struct Attribute {
  const char* name;
  const char* type;
  std::size_t offset;
};
inline constexpr Attribute attributes[] = {
    {"POSITION", "VEC3", offsetof(StarRecord, position)},
    {"_PROPER_MOTION", "VEC3", offsetof(StarRecord, proper_motion)},
    {"_PARALLAX", "SCALAR", offsetof(StarRecord, parallax)},
    {"_RADIAL_VELOCITY", "SCALAR", offsetof(StarRecord, radial_velocity)},
    {"_ILLUMINANCE", "SCALAR", offsetof(StarRecord, illuminance)},
    {"_COLOR", "VEC4", offsetof(StarRecord, color)},
    {"_VARIABILITY", "SCALAR", offsetof(StarRecord, variability)},
};

/// The least (or largest) value of each coordinate of the positions. Needs at least one star.
inline std::array<float, 3> position_bound(const std::vector<StarRecord>& stars, bool upper) {
  std::array<float, 3> bound = stars.front().position;
  for (const StarRecord& star : stars) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float value = star.position[axis];
      bound[axis] = upper ? std::max(bound[axis], value) : std::min(bound[axis], value);
    }
  }
  return bound;
}

} // namespace vesper::star_glb
