#include "vesper/plan/chromatic_adaptation.hpp"

#include "vesper/base/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace vesper {

double degree_of_adaptation(Luminance field) { return 1.0 - std::exp(-(field.to(candela_per_m2) + 42.0) / 92.0) / 3.6; }

Mat3 chromatic_adaptation(const Vec3& from_white, const Vec3& to_white, double degree) {
  const Mat3 cat16 =
      glm::transpose(Mat3(0.401288, 0.650173, -0.051461, -0.250268, 1.204414, 0.045854, -0.002079, 0.048952, 0.953127));
  const Vec3 gain = degree * (cat16 * to_white) / (cat16 * from_white) + (1.0 - degree);
  return glm::inverse(cat16) * Mat3(gain.x, 0.0, 0.0, 0.0, gain.y, 0.0, 0.0, 0.0, gain.z) * cat16;
}

ColorAdaptation adapted_to_light(const Vec3& light, const Vec3& display_white) {
  for (int i = 0; i < 3; ++i) {
    if (!(light[i] > 0.0 && std::isfinite(light[i]))) {
      throw Error(ErrorKind::argument,
                  fmt::format("light of X, Y, Z = {}, {}, {} lux has no white to adapt to", light.x, light.y, light.z),
                  {"", "", "Give what adapting_light() finds, or none"});
    }
  }
  constexpr double field_of_white = 0.2;
  const Luminance field = field_of_white * light.y / std::numbers::pi * candela_per_m2;
  Mat3 shown = chromatic_adaptation(light / light.y, display_white, degree_of_adaptation(field));
  for (int column = 0; column < 3; ++column) {
    shown[column].y = column == 1 ? 1.0 : 0.0;
  }
  return {shown, glm::inverse(shown) * f64::night_hue};
}

} // namespace vesper
