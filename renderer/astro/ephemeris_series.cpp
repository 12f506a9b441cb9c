#include "vesper/astro/ephemeris_series.hpp"

#include "vesper/astro/harmonic_sum.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace vesper {
namespace {

constexpr double days_per_millennium = 10.0 * days_per_julian_century;

struct PlanetaryTerm {
  double amplitude;
  double phase_rad;
  double frequency; ///< rad per Julian millennium
  [[nodiscard]] Moving phase(double t) const { return {phase_rad + frequency * t, frequency}; }
};

#include "vsop87_terms.inl"

constexpr std::size_t theory_count = std::size(planet_term_counts);
constexpr std::size_t earth_theory = 2;

/// Where each planet's terms begin.
constexpr std::array<std::size_t, theory_count + 1> first_terms = [] {
  std::array<std::size_t, theory_count + 1> first{};
  for (std::size_t i = 0; i < theory_count; ++i) {
    first[i + 1] = first[i];
    for (const auto& coordinate : planet_term_counts[i]) {
      for (const std::uint16_t count : coordinate) {
        first[i + 1] += count;
      }
    }
  }
  return first;
}();
static_assert(first_terms.back() == std::size(planet_terms));

constexpr std::size_t theory_of(Planet planet) {
  const auto i = static_cast<std::size_t>(planet);
  return i < earth_theory ? i : i + 1;
}

/// From the ecliptic and equinox J2000 of VSOP87: its rotation to the FK5 (Bretagnon and Francou 1988), then
/// 0.0123" about y and 0.0197" about z, which leave no mean rotation between the Earth's places of the whole theory and
/// those of DE405 (ICRS) from 1960 to 2059.
constexpr Mat3 icrs_from_vsop87(1.0, -0.000000384458, -0.000000059632,          //
                                0.000000376453, 0.917482137087, 0.397776982902, //
                                -0.000000098217, -0.397776982902, 0.917482137087);

StateVector heliocentric(std::size_t theory, JulianDate<TDB> tdb, double least_amplitude = 0.0) {
  const double t = tdb.days_since(j2000<TDB>) / days_per_millennium;
  const PlanetaryTerm* term = planet_terms + first_terms[theory];
  const auto& counts = planet_term_counts[theory];
  const Moving longitude = harmonic_sum(term, counts[0], t, least_amplitude);
  const Moving latitude = harmonic_sum(term, counts[1], t, least_amplitude);
  const Moving distance = harmonic_sum(term, counts[2], t, least_amplitude);
  StateVector state = icrs_from_vsop87 * cartesian_of(longitude, latitude, distance);
  state.velocity_au_d /= days_per_millennium;
  return state;
}

/// From the barycentre of the solar system, by the pull of the giant planets; the rest moves it by 4e-6 au. Their
/// places to 1e-3 do.
StateVector sun_barycentric(JulianDate<TDB> tdb) {
  struct Giant {
    Planet planet;
    double sun_to_planet; ///< ratio of masses, with the moons (IAU 2009 system of constants)
  };
  constexpr Giant giants[] = {{Planet::jupiter, 1047.3486},
                              {Planet::saturn, 3497.9018},
                              {Planet::uranus, 22902.98},
                              {Planet::neptune, 19412.26}};
  constexpr double least_amplitude = 1e-4;
  StateVector sun;
  double mass = 1.0;
  for (const Giant& giant : giants) {
    const StateVector state = heliocentric(theory_of(giant.planet), tdb, least_amplitude);
    sun.position_au -= state.position_au / giant.sun_to_planet;
    sun.velocity_au_d -= state.velocity_au_d / giant.sun_to_planet;
    mass += 1.0 / giant.sun_to_planet;
  }
  return {sun.position_au / mass, sun.velocity_au_d / mass};
}

} // namespace

StateVector planet_heliocentric_series(Planet planet, JulianDate<TDB> tdb) {
  return heliocentric(theory_of(planet), tdb);
}

SunEarthMoon sun_earth_moon_series(JulianDate<TDB> tdb) {
  SunEarthMoon bodies;
  bodies.sun = sun_barycentric(tdb);
  const StateVector from_sun = heliocentric(earth_theory, tdb);
  bodies.earth = {bodies.sun.position_au + from_sun.position_au, bodies.sun.velocity_au_d + from_sun.velocity_au_d};
  bodies.moon = moon_geocentric_series(tdb);
  return bodies;
}

} // namespace vesper
