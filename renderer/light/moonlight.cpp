#include "vesper/light/moonlight.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/checked_geometry.hpp"
#include "vesper/light/embedded_spectrum.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/sunlight.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace vesper {

extern const EmbeddedTable embedded_light_tables;

double moon_v_magnitude(Angle phase_angle) {
  return -12.73 - 2.5 * std::log10(f64::lunar_phase(checked_phase_degrees("the Moon's", phase_angle)));
}

Spectrum moon_albedo(Angle phase_angle) {
  static const Spectrum mean = embedded_spectrum(embedded_light_tables, "lunar_albedo.csv", "albedo");
  const double reddening = 0.20 - 0.15 * std::exp(-checked_phase_degrees("the Moon's", phase_angle) / 42.0);
  std::vector<double> values = mean.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= std::pow(mean.wavelengths_nm()[i] / 550.0, reddening);
  }
  return {mean.wavelengths_nm(), std::move(values)};
}

Spectrum moon_irradiance(Angle phase_angle, Length from_observer, Length from_sun) {
  hold_positive_distance("a distance of the Moon from the observer", from_observer);
  hold_positive_distance("a distance of the Moon from the Sun", from_sun);
  const Spectrum light = filtered(solar_irradiance_1au(), moon_albedo(phase_angle));
  const double distances = (from_observer / moon_mean_distance) * (from_sun / astronomical_unit);
  const double brighter_mag = v_magnitude(light) - moon_v_magnitude(phase_angle);
  return scaled(light, std::pow(10.0, 0.4 * brighter_mag) / (distances * distances));
}

} // namespace vesper
