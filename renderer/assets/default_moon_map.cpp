#include "vesper/assets/moon_map.hpp"
#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"

namespace vesper {

extern const EmbeddedTable embedded_moon;

const MoonMap& default_moon_map() {
  static const MoonMap map = [] {
    constexpr const char* name = "moon.exr";
    const EmbeddedFile* file = embedded_moon.find(name);
    if (file == nullptr) {
      throw Error(ErrorKind::file, "is not embedded", {name, "", "Build the library again"});
    }
    return decode_moon_map(std::as_bytes(file->data), name);
  }();
  return map;
}

} // namespace vesper
