// Pictures of the whole Moon as maps of albedo.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/catalog_tools/globe_grid.hpp"

#include <filesystem>
#include <string_view>

namespace vesper {

/// How a picture's numbers stand for albedo.
enum class AlbedoEncoding {
  automatic, ///< sRGB where the file holds whole numbers, linear where it holds floating-point ones
  srgb,      ///< through the transfer function of IEC 61966-2-1
  linear,    ///< in proportion
};

/// automatic, srgb or linear. Throws Error(argument) for another name.
[[nodiscard]] AlbedoEncoding parse_albedo_encoding(std::string_view name);

struct AlbedoPictureOptions {
  Angle centre_longitude; ///< selenographic longitude at the picture's centre, positive east
  AlbedoEncoding encoding = AlbedoEncoding::automatic;
};

/// Reads a picture of any format that OpenImageIO knows, equirectangular, north up, east to the right, twice as wide as
/// high. Of colour channels their luminance (ITU-R BT.709) counts; pixels that are not above 0, not finite or not
/// opaque are missing. The albedo is to a scale.
/// Throws Error(file), and Error(input) for what is no picture or has another shape.
[[nodiscard]] GlobeGrid read_albedo_picture(const std::filesystem::path& path, const AlbedoPictureOptions& options);

} // namespace vesper
