#include "vesper/gpu/resting_points.hpp"

namespace vesper::gpu {

StarRecord resting_star(const Vec3& direction, const Vec4& light) {
  StarRecord record{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double exact = direction[static_cast<int>(i)];
    record.position.at(i) = static_cast<float>(exact);
    record.proper_motion.at(i) = static_cast<float>(exact - static_cast<double>(record.position.at(i)));
  }
  record.illuminance = static_cast<float>(light.y);
  for (std::size_t i = 0; i < 4 && light.y > 0.0; ++i) {
    record.color.at(i) = static_cast<float>(light[static_cast<int>(i)] / light.y);
  }
  return record;
}

SkyState resting(const SkyState& sky) {
  SkyState still = sky;
  still.stars = StarFrame();
  still.stars.sun_to_observer = Vec3(1.0, 0.0, 0.0);
  still.stars.years_since_j2000 = 1.0;
  return still;
}

} // namespace vesper::gpu
