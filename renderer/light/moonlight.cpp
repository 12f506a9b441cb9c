#include "vesper/light/moonlight.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/embedded_spectrum.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/reflected_light.hpp"
#include "vesper/light/sunlight.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace vesper {

extern const EmbeddedTable embedded_light_tables;

namespace {

double checked_degrees(Angle phase_angle) {
  const double degrees = phase_angle.to(deg);
  if (!(degrees >= 0.0 && degrees <= 180.0)) {
    throw Error(ErrorKind::argument, "the Moon's phase angle of " + std::to_string(degrees) + " degrees",
                {"", "", "Give 0 to 180"});
  }
  return degrees;
}

void hold_positive(const char* what, Length distance) {
  if (!(distance > 0.0 * metre) || !std::isfinite(distance.to(metre))) {
    throw Error(ErrorKind::argument, std::string(what) + " of " + std::to_string(distance.to(kilometre)) + " km",
                {"", "", "Give a positive distance"});
  }
}

} // namespace

double moon_v_magnitude(Angle phase_angle) {
  const double degrees = checked_degrees(phase_angle);
  const double square = degrees * degrees;
  return -12.73 + 0.026 * degrees + 4.0e-9 * square * square;
}

Spectrum moon_albedo(Angle phase_angle) {
  static const Spectrum mean = embedded_spectrum(embedded_light_tables, "lunar_albedo.csv", "albedo");
  const double reddening = 0.25 - 0.42 * std::exp(-checked_degrees(phase_angle) / 42.0);
  std::vector<double> values = mean.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= std::pow(mean.wavelengths_nm()[i] / 550.0, reddening);
  }
  return {mean.wavelengths_nm(), std::move(values)};
}

Spectrum moon_irradiance(Angle phase_angle, Length from_observer, Length from_sun) {
  hold_positive("a distance of the Moon from the observer", from_observer);
  hold_positive("a distance of the Moon from the Sun", from_sun);
  const Spectrum albedo = moon_albedo(phase_angle);
  const Spectrum light = filtered(solar_irradiance_1au(), albedo);
  const double distances = (from_observer / moon_mean_distance) * (from_sun / astronomical_unit);
  const Illuminance illuminance =
      illuminance_of_v(moon_v_magnitude(phase_angle), reflected_sunlight(albedo).lux_ratio) / (distances * distances);
  const double scale = illuminance.to(lux) / integrate_xyzs(light).y;
  std::vector<double> values = light.values();
  for (double& value : values) {
    value *= scale;
  }
  return {light.wavelengths_nm(), std::move(values)};
}

} // namespace vesper
