// The light of the whole sky beyond the air as a cube map: the Milky Way.
//
// The file is an OpenEXR picture, six faces stacked (shaders/lib/cube_map.glsl), 32-bit channels X, Y, Z, S in cd/m2
// (CIE 1931 and the scotopic luminance), in ICRS axes, which are the cube's too: X to right ascension 0, declination 0,
// Y to right ascension 90 degrees, Z to the north pole. The provenance stands in text attributes. An OpenGL cube
// texture is laid out for left-handed axes: opengl_cube_direction in cube_map.glsl.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vesper {

/// Where a map came from. Part of the file, so that a map can be traced and made again.
struct SkyMapProvenance {
  std::string source_files;  ///< file names without folders
  std::string source_sha256; ///< of the files as read, in their order
  std::string coordinates;   ///< projection and axes of the source: "GLON-CAR, galactic"
  std::string tool;          ///< "vesper-catalog 0.1.0"
  std::string options;       ///< the options that shape the content, as on a command line
  std::string calibration;   ///< from the source's numbers to cd/m2, and how that was found; may begin "uncalibrated"
  std::string credit;        ///< whose picture it is and under which licence, as the maker of the map states it
  std::string budget;        ///< the light that went in, was removed, filled in and came out, as JSON
};

/// What a map's reader, writer and maker hold to.
inline constexpr int least_sky_face = 16;
inline constexpr int most_sky_face = 8192;

/// The map in memory.
struct SkyMap {
  int face_size = 0; ///< texels along a face's side, least_sky_face to most_sky_face
  /// 4 floats a texel, in the order of cube_texel (assets/cube_texels.hpp): X, Y, Z, S in cd/m2, finite.
  std::vector<float> texels;
  SkyMapProvenance provenance;
};

/// X, Y, Z and S of all of it together on a surface that faces each part of the sky, lux: the sum of luminance times
/// solid angle.
[[nodiscard]] std::array<double, 4> sky_illuminance(const SkyMap& map);

/// Replaces the file whole or not at all; the same map gives the same bytes. Throws Error(argument) for a size out of
/// range, Error(file).
///
/// \param fill_rows is called for consecutive rows of texels, first_row to 6 face_size, and fills the span with X, Y,
/// Z, S
void write_sky_map(const std::filesystem::path& path, int face_size, const SkyMapProvenance& provenance,
                   const std::function<void(int first_row, std::span<float> xyzs)>& fill_rows);
void write_sky_map(const std::filesystem::path& path, const SkyMap& map);

/// Reads what write_sky_map writes. Throws Error(file), and Error(input) naming what is at fault for another picture,
/// another shape, and numbers that are not finite.
[[nodiscard]] SkyMap read_sky_map(const std::filesystem::path& path);
/// The same from a file in memory. \param name the file's name in messages
[[nodiscard]] SkyMap decode_sky_map(std::span<const std::byte> bytes, const std::string& name);

/// The map that is built into the library (data/milky_way.exr, 256 texels a face), decoded at the first call. It is
/// uncalibrated: the galactic poles and two fields of the Milky Way have their published brightness, the rest follows a
/// picture that was made to look at.
[[nodiscard]] const SkyMap& default_sky_map();

} // namespace vesper
