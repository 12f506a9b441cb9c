// Grids of the Moon's elevation as the Planetary Data System holds them: an image (.IMG) with its label (.LBL).
#pragma once

#include "vesper/catalog_tools/globe_grid.hpp"
#include "vesper/catalog_tools/pds_label.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace vesper {

/// The lowest and highest place of a real Moon, with a margin: Antoniadi's floor at -9.2 km, the far side's summit at
/// +10.8 km.
inline constexpr double lowest_moon_elevation_m = -9500.0;
inline constexpr double highest_moon_elevation_m = 11000.0;

/// The label beside an image: its name with the ending .LBL or .lbl. Throws Error(file) where there is none.
[[nodiscard]] std::filesystem::path find_pds_label(const std::filesystem::path& image);

/// Reads a grid in metres above 1737.4 km from the content of the image, as the label says: 16-bit integers of either
/// byte order or 32-bit little-endian floats (PC_REAL), scaled; a whole globe in simple cylindrical projection from
/// the north down, longitude positive east. Samples of MISSING_CONSTANT, and NaN, come as NaN.
/// \param file the image's path, for messages and to hold against the name that the label gives
/// Throws Error(input) naming the label's line or the file for a label that lacks or contradicts something, describes
/// another file, kind of samples or projection, or a size that the file does not have, and for heights that are not
/// the label's MINIMUM and MAXIMUM or not the Moon's (samples in the wrong byte order).
[[nodiscard]] GlobeGrid read_elevation_grid(const PdsLabel& label, std::span<const std::byte> content,
                                            const std::filesystem::path& file);

} // namespace vesper
