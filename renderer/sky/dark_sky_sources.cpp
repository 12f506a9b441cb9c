#include "vesper/sky/dark_sky_sources.hpp"

#include "vesper/light/night_light.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"

namespace vesper {

SpreadSource spread_airglow(const DarkSky& sky, Angle lowest) {
  static const Mat4 from_sunlight = response_matrix(solar_irradiance_1au(), airglow_spectrum());
  return {spread_light(lowest, [&](const Vec3& at) { return airglow_above(sky, at.z).y; }), from_sunlight};
}

SpreadSource spread_zodiacal_light(const DarkSky& sky, Angle lowest) {
  static const Mat4 from_sunlight = response_matrix(solar_irradiance_1au(), zodiacal_spectrum(0.5));
  return {spread_light(lowest, [&](const Vec3& at) { return zodiacal_light(sky, at).y; }), from_sunlight};
}

SpreadSource spread_starlight(const DarkSky& sky, Angle lowest) {
  static const Mat4 from_sunlight = response_matrix(solar_irradiance_1au(), faint_starlight_spectrum());
  return {spread_light(lowest, [&](const Vec3& at) { return faint_starlight(sky, at, spread_light_width).y; }),
          from_sunlight};
}

const Vec4& sky_glow_color() {
  static const Vec4 color = [] {
    const Xyzs lamps = integrate_xyzs(lamp_spectrum());
    return vector_of(lamps) / lamps.y;
  }();
  return color;
}

} // namespace vesper
