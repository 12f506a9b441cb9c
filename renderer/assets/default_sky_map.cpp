#include "vesper/assets/sky_map.hpp"
#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"

namespace vesper {

extern const EmbeddedTable embedded_milky_way;

const SkyMap& default_sky_map() {
  static const SkyMap map = [] {
    constexpr const char* name = "milky_way.exr";
    const EmbeddedFile* file = embedded_milky_way.find(name);
    if (file == nullptr) {
      throw Error(ErrorKind::file, "is not embedded", {name, "", "Build the library again"});
    }
    return decode_sky_map(std::as_bytes(file->data), name);
  }();
  return map;
}

} // namespace vesper
