// Where a product is to be written.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace vesper {

/// That --output may be written, before any work is done. Throws Error(argument) where it is missing without --dry-run,
/// names an input or ends in another way than products of its kind, and as require_writable does.
/// \param ending  ".exr" and the like; a name without any is taken as it is
/// \param inputs  paths that must stay as they are
void require_product_path(const std::string& output, std::string_view ending, bool dry_run,
                          std::span<const std::string> inputs);

} // namespace vesper
