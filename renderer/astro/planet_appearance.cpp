#include "vesper/astro/planet_appearance.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/base/polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vesper {
namespace {

struct Radius {
  double mean_km, equatorial_km;
};
/// In the order of Planet.
constexpr std::array<Radius, planet_count> radii{{{2439.4, 2440.53},
                                                  {6051.8, 6051.8},
                                                  {3389.50, 3396.19},
                                                  {69911.0, 71492.0},
                                                  {58232.0, 60268.0},
                                                  {25362.0, 25559.0},
                                                  {24622.0, 24764.0}}};

/// As an angle, of a sphere.
Angle diameter_of(double radius_km, double distance_au) {
  return 2.0 * std::asin(std::min((radius_km * kilometre).to(astronomical_unit) / distance_au, 1.0)) * rad;
}

double sin_of_latitude(const Vec3& pole, const Vec3& to_planet) {
  // The observer stands the other way.
  return -glm::dot(pole, to_planet) / glm::length(to_planet);
}

Vec3 pole_at(double ra_deg, double dec_deg) { return unit_vector((ra_deg * deg).to(rad), (dec_deg * deg).to(rad)); }

// All of them are magnitudes at 1 au from Sun and observer.

double mercury_magnitude(double phase) { // eq. 2
  return polynomial({-0.613, 6.3280e-2, -1.6336e-3, 3.3644e-5, -3.4265e-7, 1.6893e-9, -3.0334e-12}, phase);
}

double venus_magnitude(double phase) { // eq. 3 and 4
  return phase <= 163.7 ? polynomial({-4.384, -1.044e-3, 3.687e-4, -2.814e-6, 8.938e-9}, phase)
                        : polynomial({236.05828, -2.81914, 8.39034e-3}, phase);
}

double mars_magnitude(double phase) { // eq. 6
  return polynomial({-1.601, 2.267e-2, -1.302e-4}, std::min(phase, 50.0));
}

double jupiter_magnitude(double phase) { // eq. 8
  return polynomial({-9.395, -3.7e-4, 6.16e-4}, std::min(phase, 12.0));
}

/// Globe and rings, eq. 10: the rings' opening is the geometric mean of the latitudes of observer and Sun, 0 when these
/// see different sides.
double saturn_magnitude(double phase, const Vec3& from_observer, const Vec3& from_sun, double centuries) {
  const Vec3 pole = pole_at(40.589 - 0.036 * centuries, 83.537 - 0.004 * centuries);
  const double product = std::asin(sin_of_latitude(pole, from_observer)) * std::asin(sin_of_latitude(pole, from_sun));
  const double opening = std::sin(std::sqrt(std::max(product, 0.0)));
  const double p = std::min(phase, 6.5);
  return -8.914 - 1.825 * opening + 0.026 * p - 0.378 * opening * std::exp(-2.25 * p);
}

/// Eq. 14 and 15: it brightens as a pole turns to us; latitudes are planetographic.
double uranus_magnitude(double phase, const Vec3& from_observer, const Vec3& from_sun) {
  static const Vec3 pole = pole_at(257.311, -15.175);
  const auto latitude_deg = [](double sine) {
    constexpr double flattening = 0.0229;
    const double tangent = sine / std::sqrt(std::max(1.0 - sine * sine, 0.0));
    return (std::atan(std::abs(tangent) / ((1.0 - flattening) * (1.0 - flattening))) * rad).to(deg);
  };
  const double latitude =
      0.5 * (latitude_deg(sin_of_latitude(pole, from_observer)) + latitude_deg(sin_of_latitude(pole, from_sun)));
  return polynomial({-7.110, 6.587e-3, 1.045e-4}, std::min(phase, 3.1)) - 8.4e-4 * latitude;
}

double neptune_magnitude(double centuries) { // eq. 16
  const double year = 2000.0 + 100.0 * centuries;
  return std::clamp(-6.89 - 0.0054 * (year - 1980.0), -7.00, -6.89);
}

} // namespace

double illuminated_fraction(Angle phase_angle) {
  const double half = std::cos(0.5 * phase_angle.to(rad));
  return half * half;
}

PlanetAppearance planet_appearance(Planet planet, const Vec3& from_observer_au, const Vec3& from_sun_au,
                                   JulianDate<TDB> tdb) {
  const double observer_au = glm::length(from_observer_au);
  const double sun_au = glm::length(from_sun_au);
  PlanetAppearance appearance;
  appearance.phase_angle = angle_between(from_observer_au, from_sun_au);
  appearance.illuminated_fraction = illuminated_fraction(appearance.phase_angle);
  const Radius& radius = radii.at(static_cast<std::size_t>(planet));
  appearance.diameter = diameter_of(radius.mean_km, observer_au);
  appearance.equatorial_diameter = diameter_of(radius.equatorial_km, observer_au);

  const double phase = appearance.phase_angle.to(deg);
  const double centuries = centuries_since_j2000(tdb);
  const double at_unit_distance = [&] {
    switch (planet) {
    case Planet::mercury:
      return mercury_magnitude(phase);
    case Planet::venus:
      return venus_magnitude(phase);
    case Planet::mars:
      return mars_magnitude(phase);
    case Planet::jupiter:
      return jupiter_magnitude(phase);
    case Planet::saturn:
      return saturn_magnitude(phase, from_observer_au, from_sun_au, centuries);
    case Planet::uranus:
      return uranus_magnitude(phase, from_observer_au, from_sun_au);
    case Planet::neptune:
      break;
    }
    return neptune_magnitude(centuries);
  }();
  appearance.magnitude = at_unit_distance + 5.0 * std::log10(sun_au * observer_au);
  return appearance;
}

} // namespace vesper
