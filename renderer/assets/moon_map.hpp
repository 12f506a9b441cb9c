// The Moon's surface as a cube map: albedo and the direction that the ground faces.
//
// The file is an OpenEXR picture, six faces stacked (shaders/lib/cube_map.glsl), 32-bit channels
//   A            normal albedo
//   NX, NY, NZ   unit normal of the relief
// in the Moon's mean-Earth axes, which are the cube's too: X to selenographic longitude 0, latitude 0 (towards the
// Earth), Y to 90 degrees east, Z to the north pole. The provenance stands in text attributes. For an OpenGL
// cube texture, whose faces are laid out for left-handed axes, swap the last two faces and look up (x, y, -z).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vesper {

/// Where a map came from. Part of the file, so that a map can be traced and made again.
struct MoonMapProvenance {
  std::string albedo_file;            ///< file name without folders
  std::string albedo_sha256;          ///< of the file as read
  std::string elevation_file;         ///< file name without folders
  std::string elevation_sha256;       ///< of the file as read
  std::string label_sha256;           ///< of the elevation's label
  std::string tool;                   ///< "vesper-catalog 0.1.0"
  std::string options;                ///< the options that shape the content, as on a command line
  std::uint64_t albedo_pixels = 0;    ///< in the picture
  std::uint64_t albedo_filled = 0;    ///< pixels that were missing
  std::uint64_t elevation_pixels = 0; ///< in the grid
  std::uint64_t elevation_filled = 0; ///< pixels that were missing
  double albedo_scale = 0;            ///< albedo of a picture value of 1
};

/// What a map's reader, writer and maker hold to: sizes of a face are even, so that the borders of the near side are
/// borders of texels.
inline constexpr int least_moon_face = 16;
inline constexpr int most_moon_face = 4096;

/// The map in memory.
struct MoonMap {
  int face_size = 0; ///< texels along a face's side: even, least_moon_face to most_moon_face
  /// 4 floats a texel, in the order of cube_texel (assets/cube_texels.hpp): the normal albedo, which is the radiance
  /// factor at opposition without the surge, above 0, at most 1; and x, y, z of the relief's outward unit normal.
  std::vector<float> texels;
  MoonMapProvenance provenance;
};

/// The mean albedo of the near side as it shows on the disc, seen along the X axis from afar: sum of A cos over sum of
/// cos. With a surface that is equally bright all over the disc at full Moon it is the geometric albedo.
[[nodiscard]] double moon_disc_albedo(const MoonMap& map);

/// Replaces the file whole or not at all; the same map gives the same bytes. Throws Error(argument) for a map that
/// breaks a rule above, Error(file).
void write_moon_map(const std::filesystem::path& path, const MoonMap& map);

/// Reads what write_moon_map writes. Throws Error(file), and Error(input) naming the channel or texel at fault for
/// another picture, another shape, numbers that are not finite, and albedos and normals that break a rule above.
[[nodiscard]] MoonMap read_moon_map(const std::filesystem::path& path);
/// The same from a file in memory. \param name the file's name in messages
[[nodiscard]] MoonMap decode_moon_map(std::span<const std::byte> bytes, const std::string& name);

/// The map that is built into the library (data/moon.exr, 256 texels a face), decoded at the first call.
[[nodiscard]] const MoonMap& default_moon_map();

} // namespace vesper
