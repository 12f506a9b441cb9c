#include "vesper/atmosphere/star_extinction.hpp"

#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/shader_math.hpp"

#include <algorithm>

namespace vesper {

Vec4 star_optical_depth_xyzs(const Medium& medium, Length height) {
  const double above_km = std::max(height.to(kilometre), 0.0);
  const Vec3 zenith(0.0, 0.0, 1.0);
  const AirColumns columns = columns_to_space(medium, (medium.ground_radius.to(kilometre) + above_km) * zenith, zenith);
  const double shell = f64::optical_path(1.0, above_km);
  Vec4 depth{};
  for (int channel = 0; channel < 4; ++channel) {
    const double above = optical_depth(medium, columns, star_wavelengths_nm[channel]).value;
    depth[channel] = above > 0.0 ? above / shell : 0.0; // far out the shell is 0 too
  }
  return depth;
}

} // namespace vesper
