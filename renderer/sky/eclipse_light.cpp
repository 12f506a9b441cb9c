#include "vesper/sky/eclipse_light.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/light/response_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

/// Neckel's wavelengths, at which the share of light is found.
constexpr std::array neckel_nm{440.0, 550.0, 680.0};
constexpr std::array neckel_power{0.652, 0.503, 0.397};

double between(const std::array<double, 3>& values, double nm) {
  const std::size_t i = nm < neckel_nm[1] ? 0 : 1;
  return values[i] + (values[i + 1] - values[i]) * (nm - neckel_nm[i]) / (neckel_nm[i + 1] - neckel_nm[i]);
}

/// Over the whole range of the eye, from the shares at Neckel's wavelengths.
Spectrum spectrum_of(const std::array<double, 3>& shares) {
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (int nm = response_first_nm - 1; nm <= response_last_nm + 1; ++nm) {
    wavelengths.push_back(nm);
    values.push_back(std::clamp(between(shares, nm), 0.0, 1.0));
  }
  return {std::move(wavelengths), std::move(values)};
}

constexpr double umbral_share = 2.0e-5;
constexpr double umbral_reddening = 4.0;

} // namespace

double limb_darkening_power(double wavelength_nm) { return between(neckel_power, wavelength_nm); }

double sunlight_seen(double sun, double other, double separation, double power) {
  const double radius = other / sun; // now the Sun's is 1
  const double distance = separation / sun;
  if (distance >= 1.0 + radius) {
    return 1.0;
  }
  if (radius >= 1.0 + distance) {
    return 0.0;
  }
  // Light of the disc inside a circle about its centre.
  const auto inside = [&](double r) { return 1.0 - std::pow(std::max(0.0, (1.0 - r) * (1.0 + r)), 0.5 * power + 1.0); };
  // Circles that the other disc's edge crosses; those further inside are seen wholly or not at all.
  const double first = std::min(std::abs(distance - radius), 1.0);
  const double last = std::min(distance + radius, 1.0);
  double seen = (distance >= radius ? inside(first) : 0.0) + 1.0 - inside(last);
  static const std::vector<QuadratureNode> rule = gauss_legendre(48);
  for (const QuadratureNode& node : rule) {
    // Nodes crowd at both ends, where arcs and brightness change as square roots.
    const double r = first + (last - first) * 0.5 * (1.0 - std::cos(pi * node.place));
    const double step = (last - first) * 0.5 * pi * std::sin(pi * node.place) * node.weight;
    const double brightness = (power + 2.0) * r * std::pow(std::max(0.0, (1.0 - r) * (1.0 + r)), 0.5 * power);
    seen += step * brightness * (1.0 - f64::common_chord_half_angle(r, radius, distance) / pi);
  }
  return std::clamp(seen, 0.0, 1.0);
}

Spectrum sunlight_past_moon(const SolarEclipseState& eclipse) {
  std::array<double, 3> shares{};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = sunlight_seen(eclipse.sun_semidiameter.to(rad), eclipse.moon_semidiameter.to(rad),
                              eclipse.separation.to(rad), neckel_power[i]);
  }
  return spectrum_of(shares);
}

Spectrum sunlight_on_moon(const LunarEclipseState& eclipse) {
  if (eclipse.penumbral_magnitude <= 0.0) {
    return spectrum_of({1.0, 1.0, 1.0});
  }
  const f64::EarthShadow shadow = earth_shadow(eclipse);
  // The disc that faces the Earth: rings of equal azimuths, by Gauss's rule over the square of the radius.
  const Vec3 toward = glm::normalize(eclipse.moon_km);
  const Vec3 aside = glm::normalize(glm::cross(toward, std::abs(toward.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
  const Vec3 upward = glm::cross(aside, toward);
  const double moon_km = moon_mean_radius.to(kilometre);
  constexpr int azimuths = 32;
  static const std::vector<QuadratureNode> rings = gauss_legendre(16);
  std::array<double, 3> shares{};
  for (const QuadratureNode& ring : rings) {
    for (int k = 0; k < azimuths; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / azimuths;
      const Vec3 point =
          eclipse.moon_km + moon_km * std::sqrt(ring.place) * (std::cos(azimuth) * aside + std::sin(azimuth) * upward);
      const f64::vec3 discs = f64::earth_shadow_discs(point, shadow);
      for (std::size_t i = 0; i < shares.size(); ++i) {
        const double umbral = umbral_share * std::pow(neckel_nm[i] / neckel_nm[1], umbral_reddening);
        const double seen = sunlight_seen(discs.x, discs.y, discs.z, neckel_power[i]);
        shares[i] += ring.weight / azimuths * (umbral + (1.0 - umbral) * seen);
      }
    }
  }
  return spectrum_of(shares);
}

} // namespace vesper
