#include "vesper/base/embedded.hpp"

#include <algorithm>

namespace vesper {

const EmbeddedFile* EmbeddedTable::find(std::string_view name) const {
  const auto found = std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& f) { return f.name == name; });
  return found == files.end() ? nullptr : &*found;
}

} // namespace vesper
