#include "vesper/plan/planned_disc.hpp"

#include <array>

namespace vesper {

std::shared_ptr<const MoonGlobe> default_moon_globe() {
  static const std::shared_ptr<const MoonGlobe> globe = [] {
    MoonMap map;
    map.face_size = 64;
    static const std::array<Mat3, 6> faces{
        Mat3({0, 0, 1}, {0, -1, 0}, {1, 0, 0}),  Mat3({0, 0, -1}, {0, -1, 0}, {-1, 0, 0}),
        Mat3({1, 0, 0}, {0, 0, -1}, {0, 1, 0}),  Mat3({1, 0, 0}, {0, 0, 1}, {0, -1, 0}),
        Mat3({-1, 0, 0}, {0, -1, 0}, {0, 0, 1}), Mat3({1, 0, 0}, {0, -1, 0}, {0, 0, -1})};
    for (const Mat3& face : faces) {
      for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 64; ++column) {
          const Vec3 n =
              glm::normalize(face * Vec3((2.0 * column + 1.0) / 64 - 1.0, (2.0 * row + 1.0) / 64 - 1.0, 1.0));
          map.texels.insert(map.texels.end(), {0.12F, float(n.x), float(n.y), float(n.z)});
        }
      }
    }
    return make_moon_globe(map);
  }();
  return globe;
}

} // namespace vesper
