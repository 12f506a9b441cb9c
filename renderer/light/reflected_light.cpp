#include "vesper/light/reflected_light.hpp"

#include "vesper/light/photometry.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"

namespace vesper {

ReflectedLight reflected_sunlight(const Spectrum& albedo) {
  const Spectrum reflected = filtered(solar_irradiance_1au(), albedo);
  const double a0 = lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  const double ratio = lux_per_v_flux(reflected) / a0;
  const Xyzs light = integrate_xyzs(reflected);
  return {{light.x / light.y, 1.0, light.z / light.y, light.s / light.y}, ratio};
}

} // namespace vesper
