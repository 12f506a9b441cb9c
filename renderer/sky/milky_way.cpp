#include "vesper/sky/milky_way.hpp"

#include <utility>

namespace vesper {

std::shared_ptr<const CubePyramid> make_milky_way(SkyMap map) {
  return std::make_shared<const CubePyramid>(map.face_size, std::move(map.texels));
}

const std::shared_ptr<const CubePyramid>& default_milky_way() {
  static const std::shared_ptr<const CubePyramid> milky_way = make_milky_way(default_sky_map());
  return milky_way;
}

} // namespace vesper
