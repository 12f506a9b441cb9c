#include "vesper/light/photometry.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/star_color.hpp"

#include <cmath>

namespace vesper {

double lux_per_v_flux(const Spectrum& spectrum) {
  const double v_flux = integrate_v_band(spectrum);
  if (!(v_flux > 0.0)) {
    throw Error(ErrorKind::argument, "the spectrum has no light in the V band",
                {"", "", "Give values between 470 and 700 nm"});
  }
  return integrate_xyzs(spectrum).y / v_flux;
}

Illuminance illuminance_of_v(double v_magnitude, double lux_ratio) {
  return std::pow(10.0, -0.4 * v_magnitude) * lux_ratio * v0_a0_illuminance;
}

double v_of_illuminance(Illuminance illuminance, double lux_ratio) {
  return -2.5 * std::log10(illuminance / (lux_ratio * v0_a0_illuminance));
}

double v_magnitude(const Spectrum& irradiance) {
  static const double a0 = lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  return v_of_illuminance(a0 * integrate_v_band(irradiance) * lux, 1.0);
}

} // namespace vesper
