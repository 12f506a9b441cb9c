#include "vesper/sky/eclipse_light.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/light/corona.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/seen_rings.hpp"
#include "vesper/light/solar_disc.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

/// At which the share of light that is left of the Moon's is found.
constexpr std::array shadow_nm{440.0, 550.0, 680.0};

double between(const std::array<double, 3>& values, double nm) {
  const std::size_t i = nm < shadow_nm[1] ? 0 : 1;
  return values[i] + (values[i + 1] - values[i]) * (nm - shadow_nm[i]) / (shadow_nm[i + 1] - shadow_nm[i]);
}

/// Over the whole range of the eye, from the shares at those wavelengths.
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

/// Light of a disc of brightness mu^power within a share r of its radius, over all of it.
double within(double r, double power) {
  return 1.0 - std::pow(std::max(0.0, (1.0 - r) * (1.0 + r)), 0.5 * power + 1.0);
}

/// Shares of the light of six discs, of brightness mu^powers[k], that pass another disc.
LimbSeries sunlight_seen(const SeenRings& rings, const LimbPowers& powers) {
  LimbSeries seen{};
  for (std::size_t k = 0; k < limb_terms; ++k) {
    seen.at(k) = within(rings.inside_until, powers[k]) + 1.0 - within(rings.outside_from, powers[k]);
  }
  for (const SeenRings::Node& node : rings.crossed) {
    const double mu = std::sqrt(std::max(0.0, (1.0 - node.radius) * (1.0 + node.radius)));
    const double step = std::pow(mu, powers.step);
    double brightness = std::pow(mu, powers.lowest);
    for (std::size_t k = 0; k < limb_terms; ++k) {
      seen.at(k) += node.weight * (powers[k] + 2.0) * node.radius * brightness;
      brightness *= step;
    }
  }
  return seen;
}

} // namespace

double sunlight_seen(double sun, double other, double separation, double power) {
  const SeenRings rings = rings_past_disc(other / sun, separation / sun, 0.0, 1.0);
  double seen = within(rings.inside_until, power) + 1.0 - within(rings.outside_from, power);
  for (const SeenRings::Node& node : rings.crossed) {
    const double mu_square = std::max(0.0, (1.0 - node.radius) * (1.0 + node.radius));
    seen += node.weight * (power + 2.0) * node.radius * std::pow(mu_square, 0.5 * power);
  }
  return std::clamp(seen, 0.0, 1.0);
}

Spectrum sunlight_past_moon(const SolarEclipseState& eclipse, LimbDarkening law) {
  const double sun = eclipse.sun_semidiameter.to(rad);
  const double moon = eclipse.moon_semidiameter.to(rad);
  const double separation = eclipse.separation.to(rad);
  const LimbPowers powers = limb_powers(law);
  const LimbSeries seen = sunlight_seen(rings_past_disc(moon / sun, separation / sun, 0.0, 1.0), powers);
  const CoronaLight corona = corona_seen(sun, moon, separation);
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (int nm = response_first_nm - 1; nm <= response_last_nm + 1; ++nm) {
    const LimbSeries series = limb_series(nm, law);
    double disc = 0.0;
    for (std::size_t k = 0; k < limb_terms; ++k) {
      disc += series.at(k) * powers.disc_mean(k) * seen.at(k);
    }
    wavelengths.push_back(nm);
    values.push_back(std::clamp(disc, 0.0, 1.0) + corona.electrons + corona.dust * dust_reddening(nm));
  }
  return {std::move(wavelengths), std::move(values)};
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
        const double umbral = umbral_share * std::pow(shadow_nm[i] / shadow_nm[1], umbral_reddening);
        const double seen = sunlight_seen(discs.x, discs.y, discs.z, limb_darkening_power(shadow_nm[i]));
        shares[i] += ring.weight / azimuths * (umbral + (1.0 - umbral) * seen);
      }
    }
  }
  return spectrum_of(shares);
}

} // namespace vesper
