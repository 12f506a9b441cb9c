#include "vesper/light/reflected_light.hpp"

#include "vesper/light/photometry.hpp"
#include "vesper/light/star_color.hpp"

namespace vesper {
namespace {

constexpr double sun_b_v = 0.65;

}

ReflectedLight reflected_sunlight(const Spectrum& albedo) {
  const Spectrum sun = planck_spectrum(star_temperature_k(sun_b_v));
  std::vector<double> values = sun.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= albedo(sun.wavelengths_nm()[i]);
  }
  const Spectrum reflected(sun.wavelengths_nm(), std::move(values));
  const double a0 = lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  const double ratio = lux_per_v_flux(reflected) / a0;
  const Xyzs light = integrate_xyzs(reflected);
  return {{light.x / light.y, 1.0, light.z / light.y, light.s / light.y}, ratio};
}

} // namespace vesper
