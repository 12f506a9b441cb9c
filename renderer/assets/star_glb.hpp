// Star catalogues as binary glTF 2.0 (.glb), which any glTF viewer opens as a cloud of points.
//
// One mesh of points. One interleaved buffer view of StarRecords (stride 56 bytes) with the attributes
//   POSITION          VEC3    ICRS unit vector at the catalogue's epoch
//   _PROPER_MOTION    VEC3    rad/year, tangent to the sphere
//   _PARALLAX         SCALAR  rad, 0 where unknown
//   _RADIAL_VELOCITY  SCALAR  km/s, receding positive, 0 where unknown
//   _ILLUMINANCE      SCALAR  lux above the atmosphere
//   _COLOR            VEC4    X, Y, Z, S for Y = 1 lux
//   _VARIABILITY      SCALAR  peak-to-peak amplitude in V magnitudes, 0 where none or unknown
// The mesh's `extras` hold the parallel arrays hr, hd, name and magnitude; the asset's `extras` the provenance and the
// units. Stars are sorted by magnitude.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/base/files.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace vesper {

/// The bytes of the file. The same catalogue gives the same bytes. Throws Error(argument) for a catalogue that breaks a
/// rule of check_star_catalogue.
[[nodiscard]] Bytes encode_star_glb(const StarCatalogue& catalogue);

/// Reads what encode_star_glb writes. `name` is the file's name in messages. Throws Error(input), with the byte, the
/// member, the accessor or the star at fault, for anything else: a wrong magic number, version, length or chunk, broken
/// JSON, accessors of another type, stride, count or place than above, and stars that break a rule of
/// check_star_catalogue. Memory in use stays in proportion to the size of the file whatever counts it claims.
[[nodiscard]] StarCatalogue decode_star_glb(std::span<const std::byte> bytes, const std::string& name);

/// encode_star_glb to a file that is replaced whole or not at all, and back. Throw Error(file) as well.
void write_star_glb(const std::filesystem::path& path, const StarCatalogue& catalogue);
[[nodiscard]] StarCatalogue read_star_glb(const std::filesystem::path& path);

} // namespace vesper
