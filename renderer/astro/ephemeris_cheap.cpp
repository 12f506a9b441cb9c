#include "vesper/astro/ephemeris_cheap.hpp"

#include "vesper/astro/erfa_arrays.hpp"
#include "vesper/astro/rotation.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/astro/star_frame.hpp"

#include <erfa.h>

#include <cmath>
#include <complex>

namespace vesper {
namespace {

/// Mean ecliptic and equinox of date, au.
struct SunAndMoon {
  Vec3 sun;
  Vec3 moon;
};

Vec3 sun_geocentric(double t) {
  const double m = 6.24 + 628.302 * t;
  const double longitude =
      4.895048 + 628.331951 * t + (0.033417 - 0.000084 * t) * std::sin(m) + 0.000351 * std::sin(2.0 * m);
  const double distance = 1.000140 - (0.016708 - 0.000042 * t) * std::cos(m) - 0.000141 * std::cos(2.0 * m);
  return distance * unit_vector(longitude, 0.0);
}

Vec3 moon_geocentric(double t) {
  // Products of the four arguments' cos + i sin give the cosines and sines of their sums.
  const auto unit = [t](double at_j2000, double rate) { return std::polar(1.0, at_j2000 + rate * t); };
  using Unit = std::complex<double>;
  const Unit anomaly = unit(2.3554, 8328.6911); // m'
  const Unit sun = unit(6.2300, 628.3019);      // m
  const Unit node = unit(1.6280, 8433.4663);    // f
  const Unit elongation = unit(5.1985, 7771.3772);
  const Unit twice = elongation * elongation; // 2d
  const Unit evection = twice * std::conj(anomaly);
  const Unit onward = twice * anomaly;
  const Unit annual = twice * std::conj(sun);

  const double longitude = 3.8104 + 8399.7091 * t + 0.1098 * anomaly.imag() + 0.0222 * evection.imag() +
                           0.0115 * twice.imag() + 0.0037 * (anomaly * anomaly).imag() - 0.0032 * sun.imag() -
                           0.0020 * (node * node).imag() + 0.0010 * (evection * std::conj(anomaly)).imag() +
                           0.0010 * (evection * std::conj(sun)).imag() + 0.0009 * onward.imag() +
                           0.0008 * annual.imag() + 0.0007 * (anomaly * std::conj(sun)).imag() -
                           0.0006 * elongation.imag() - 0.0005 * (sun * anomaly).imag();
  const double latitude = 0.0895 * node.imag() + 0.0049 * (anomaly * node).imag() +
                          0.0048 * (anomaly * std::conj(node)).imag() + 0.0030 * (twice * std::conj(node)).imag() +
                          0.0010 * (evection * node).imag() + 0.0008 * (evection * std::conj(node)).imag() +
                          0.0006 * (twice * node).imag();
  const double parallax = 0.016593 + 0.000904 * anomaly.real() + 0.000166 * evection.real() + 0.000137 * twice.real() +
                          0.000049 * (anomaly * anomaly).real() + 0.000015 * onward.real() + 0.000009 * annual.real();
  constexpr double earth_radii_per_au = 23455.0;
  return 1.0 / (earth_radii_per_au * parallax) * unit_vector(longitude, latitude);
}

/// Obliquity 0.409093 - 0.000227 t (Jensen et al. 2001), then precession backwards.
SunAndMoon sun_and_moon_icrs(JulianDate<TDB> tdb) {
  const double t = centuries_since_j2000(tdb);
  const double obliquity = 0.409093 - 0.000227 * t;
  const Mat3 icrs_from_ecliptic = glm::transpose(cheap_equator_of_date_from_icrs(t)) * turn_x(obliquity);
  return {icrs_from_ecliptic * sun_geocentric(t), icrs_from_ecliptic * moon_geocentric(t)};
}

} // namespace

SunEarthMoon sun_earth_moon_cheap(JulianDate<TDB> tdb) {
  // The Moon's acceleration changes over days: half an hour on each side leaves 1e-7 of its velocity.
  constexpr double step_days = 0.02;
  const SunAndMoon now = sun_and_moon_icrs(tdb);
  const SunAndMoon before = sun_and_moon_icrs(tdb.plus_days(-step_days));
  const SunAndMoon after = sun_and_moon_icrs(tdb.plus_days(step_days));
  SunEarthMoon bodies;
  bodies.earth = {-now.sun, (before.sun - after.sun) / (2.0 * step_days)};
  bodies.moon = {now.moon, (after.moon - before.moon) / (2.0 * step_days)};
  return bodies;
}

StateVector planet_heliocentric_cheap(Planet planet, JulianDate<TDB> tdb) {
  constexpr int erfa_numbers[planet_count] = {1, 2, 4, 5, 6, 7, 8};
  double pv[2][3];
  eraPlan94(tdb.day, tdb.fraction, erfa_numbers[static_cast<int>(planet)], pv);
  return {vector_of(pv[0]), vector_of(pv[1])};
}

} // namespace vesper
