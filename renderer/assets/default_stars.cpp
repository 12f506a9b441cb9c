#include "vesper/assets/default_stars.hpp"

#include "vesper/assets/star_glb.hpp"
#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"

namespace vesper {

extern const EmbeddedTable embedded_stars;

const StarCatalogue& default_star_catalogue() {
  static const StarCatalogue catalogue = [] {
    constexpr const char* name = "bright_stars.glb";
    const EmbeddedFile* file = embedded_stars.find(name);
    if (file == nullptr) {
      throw Error(ErrorKind::file, "is not embedded", {name, "", "Build the library again"});
    }
    return decode_star_glb(std::as_bytes(file->data), name);
  }();
  return catalogue;
}

} // namespace vesper
