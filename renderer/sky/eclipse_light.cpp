#include "vesper/sky/eclipse_light.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/sunlight.hpp"

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

/// Calls `visit(point_km, weight)` for points of the Moon's face, seen from the Earth; weights sum to 1.
template <class Visit> void for_points_of_moon(const Vec3& moon_km, Visit&& visit) {
  const Vec3 toward = glm::normalize(-moon_km);
  const Vec3 aside = glm::normalize(glm::cross(toward, std::abs(toward.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
  const Vec3 upward = glm::cross(toward, aside);
  constexpr int azimuths = 32;
  // Gauss's rule over the square of the radius.
  static const std::vector<QuadratureNode> rings = gauss_legendre(16);
  for (const QuadratureNode& ring : rings) {
    for (int k = 0; k < azimuths; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / azimuths;
      const Vec3 normal = std::sqrt(ring.place) * (std::cos(azimuth) * aside + std::sin(azimuth) * upward) +
                          std::sqrt(1.0 - ring.place) * toward;
      visit(moon_km + moon_mean_radius.to(kilometre) * normal, ring.weight / azimuths);
    }
  }
}

/// The wavelengths of the published colour map, in order.
constexpr std::array published_nm{450.0, 507.0, 555.0, 600.0};

Spectrum published_sunlight_on_moon(const LunarEclipseState& eclipse) {
  const f64::EarthShadow shadow = earth_shadow(eclipse);
  Vec4 shares{};
  for_points_of_moon(eclipse.moon_km, [&](const Vec3& point, double weight) {
    const Vec2 place = f64::earth_shadow_place(point, shadow);
    shares += weight * f64::lunar_eclipse_colors(f64::lunar_eclipse_phase(place, shadow));
  });
  return {{response_first_nm - 1.0, published_nm[0], published_nm[1], published_nm[2], published_nm[3],
           response_last_nm + 1.0},
          {shares.z, shares.z, shares.w, shares.y, shares.x, shares.x}};
}

EclipseSpectra spectra_of(const LunarEclipseState& eclipse, const EclipseAir& air) {
  return eclipse_spectra(air.light ? *air.light : default_earth_shadow_light(),
                         glm::dot(eclipse.moon_km, eclipse.axis) * kilometre, eclipse.sun_distance, air.danjon);
}

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

Spectrum sunlight_on_moon(const LunarEclipseState& eclipse, const EclipseAir& air, Tier tier) {
  if (eclipse.penumbral_magnitude <= 0.0) {
    return spectrum_of({1.0, 1.0, 1.0});
  }
  if (tier == Tier::cheap) {
    return published_sunlight_on_moon(eclipse);
  }
  const EclipseSpectra spectra = spectra_of(eclipse, air);
  const f64::EarthShadow shadow = earth_shadow(eclipse);
  std::vector<double> shares(spectra.wavelengths_nm.size(), 0.0);
  for_points_of_moon(eclipse.moon_km, [&](const Vec3& point, double weight) {
    spectra.add(f64::earth_shadow_place(point, shadow), shadow, weight, shares);
  });
  return spectra.spectrum(shares);
}

LunarEclipseTable lunar_eclipse_table(const LunarEclipseState& eclipse, const Spectrum& moonlight,
                                      const EclipseAir& air, Tier tier) {
  if (eclipse.penumbral_magnitude > 0.0 && tier != Tier::cheap) {
    return lunar_eclipse_table(spectra_of(eclipse, air), moonlight);
  }
  LunarEclipseTable table;
  table.frame.kind = eclipse.penumbral_magnitude > 0.0 ? f64::lunar_eclipse_published : f64::lunar_eclipse_none;
  return table;
}

double dimming_v_mag(const Spectrum& share) {
  return -2.5 * std::log10(integrate_v_band(filtered(solar_irradiance_1au(), share)) /
                           integrate_v_band(solar_irradiance_1au()));
}

double seen_danjon(double dimming_mag) { return std::clamp(0.8 * (15.0 - dimming_mag), least_danjon, most_danjon); }

} // namespace vesper
