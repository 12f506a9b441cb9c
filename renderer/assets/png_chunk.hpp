// What the picture library cannot write into a PNG.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace vesper {

/// Puts a chunk behind a PNG's header, before all other chunks (PNG, third edition, 5.3).
/// \param png the whole file
/// \param type four letters
void insert_png_chunk(std::vector<unsigned char>& png, std::string_view type, std::span<const std::byte> data);

} // namespace vesper
