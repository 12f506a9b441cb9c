#include "vesper/sky/eclipse_light.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/base/sine.hpp"
#include "vesper/light/corona.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/seen_rings.hpp"
#include "vesper/light/solar_disc.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

/// Of a face equally bright all over, as the Earth's centre sees it.
std::vector<MoonPlace> even_face(const Vec3& moon_km) {
  const Vec3 toward = glm::normalize(-moon_km);
  const Vec3 aside = glm::normalize(glm::cross(toward, std::abs(toward.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
  const Vec3 upward = glm::cross(toward, aside);
  constexpr int azimuths = 32;
  // Gauss's rule over the square of the radius.
  static const std::vector<QuadratureNode> rings = gauss_legendre(16);
  std::vector<MoonPlace> face;
  face.reserve(rings.size() * azimuths);
  for (const QuadratureNode& ring : rings) {
    for (int k = 0; k < azimuths; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / azimuths;
      const Vec3 normal = std::sqrt(ring.place) * (std::cos(azimuth) * aside + std::sin(azimuth) * upward) +
                          std::sqrt(1.0 - ring.place) * toward;
      face.push_back({normal, ring.weight / azimuths});
    }
  }
  return face;
}

/// Calls `visit(place behind the Earth, share)` for places of the Moon.
template <class Visit>
void for_places(std::span<const MoonPlace> face, const LunarEclipseState& eclipse, const f64::EarthShadow& shadow,
                Visit&& visit) {
  for (const MoonPlace& place : face) {
    const Vec3 point_km = eclipse.moon_km + moon_mean_radius.to(kilometre) * place.normal;
    visit(f64::earth_shadow_place(point_km, shadow), place.share);
  }
}

/// The wavelengths of the published colour map, in order.
constexpr std::array published_nm{450.0, 507.0, 555.0, 600.0};

Spectrum published_sunlight_on_moon(const LunarEclipseState& eclipse, std::span<const MoonPlace> face) {
  const f64::EarthShadow shadow = earth_shadow(eclipse);
  Vec4 shares{};
  for_places(face, eclipse, shadow, [&](const Vec2& place, double share) {
    shares += share * f64::lunar_eclipse_colors(f64::lunar_eclipse_phase(place, shadow));
  });
  return {{response_first_nm - 1.0, published_nm[0], published_nm[1], published_nm[2], published_nm[3],
           response_last_nm + 1.0},
          {shares.z, shares.z, shares.w, shares.y, shares.x, shares.x}};
}

EclipseSpectra spectra_of(const LunarEclipseState& eclipse, const EclipseAir& air) {
  return eclipse_spectra(air.light ? *air.light : default_earth_shadow_light(),
                         glm::dot(eclipse.moon_km, eclipse.axis) * kilometre, eclipse.sun_distance, air.danjon);
}

/// Light of a disc of brightness mu^power within a share r of its radius, over all of it.
double within(double r, double power) {
  return 1.0 - std::pow(std::max(0.0, (1.0 - r) * (1.0 + r)), 0.5 * power + 1.0);
}

} // namespace

LimbSeries sunlight_seen(double sun, double other, double separation, const LimbPowers& powers) {
  const SeenRings rings = rings_past_disc(other / sun, separation / sun, 0.0, 1.0);
  LimbSeries seen{};
  for (std::size_t k = 0; k < limb_terms; ++k) {
    seen.at(k) = within(rings.inside_until, powers[k]) + 1.0 - within(rings.outside_from, powers[k]);
  }
  for (const SeenRings::Node& node : rings.crossed) {
    const double mu = sine_of(node.radius);
    const double step = std::pow(mu, powers.step);
    double brightness = std::pow(mu, powers.lowest);
    for (std::size_t k = 0; k < limb_terms; ++k) {
      seen.at(k) += node.weight * (powers[k] + 2.0) * node.radius * brightness;
      brightness *= step;
    }
  }
  return seen;
}

Spectrum sunlight_past_moon(const SolarEclipseState& eclipse, LimbDarkening law) {
  const double sun = eclipse.sun_semidiameter.to(rad);
  const double moon = eclipse.moon_semidiameter.to(rad);
  const double separation = eclipse.separation.to(rad);
  const LimbPowers powers = limb_powers(law);
  const LimbSeries seen = sunlight_seen(sun, moon, separation, powers);
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

Spectrum sunlight_on_moon(const LunarEclipseState& eclipse, const EclipseAir& air, Tier tier) {
  return sunlight_on_moon(eclipse, even_face(eclipse.moon_km), air, tier);
}

Spectrum sunlight_on_moon(const LunarEclipseState& eclipse, std::span<const MoonPlace> face, const EclipseAir& air,
                          Tier tier) {
  if (eclipse.penumbral_magnitude <= 0.0) {
    return {{response_first_nm - 1.0, response_last_nm + 1.0}, {1.0, 1.0}};
  }
  if (tier == Tier::cheap) {
    return published_sunlight_on_moon(eclipse, face);
  }
  const EclipseSpectra spectra = spectra_of(eclipse, air);
  const f64::EarthShadow shadow = earth_shadow(eclipse);
  std::vector<double> shares(spectra.wavelengths_nm.size(), 0.0);
  for_places(face, eclipse, shadow,
             [&](const Vec2& place, double share) { spectra.add(place, shadow, share, shares); });
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
