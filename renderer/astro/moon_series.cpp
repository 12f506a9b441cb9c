#include "vesper/astro/ephemeris_series.hpp"

#include "vesper/astro/harmonic_sum.hpp"
#include "vesper/astro/rotation.hpp"
#include "vesper/base/units.hpp"

#include <cmath>
#include <cstdint>

namespace vesper {
namespace {

/// A polynomial of degree 4 with its derivative.
Moving moving_polynomial(const double (&c)[5], double t) {
  return {polynomial(c, t), polynomial({c[1], 2.0 * c[2], 3.0 * c[3], 4.0 * c[4]}, t)};
}

struct LunarTerm {
  double amplitude;
  double coefficients[5]; ///< of the phase, rad, by powers of Julian centuries
  [[nodiscard]] Moving phase(double t) const { return moving_polynomial(coefficients, t); }
};

#include "elp_mpp02_terms.inl"

/// The Moon's mean longitude in the ecliptic of date from the mean equinox of J2000 carried along, rad, with the
/// constants fitted to DE405 (Chapront and Francou 2003).
constexpr double mean_longitude[5] = {3.8103440908308803, 8399.68473007193, -3.318952042550094e-5,
                                      3.1102494491060616e-8, -2.0328237648922845e-10};

/// From the ecliptic of date to that of J2000, both counted from the departure point of longitudes (Laskar 1986, with
/// the constants of ELP/MPP02). P and Q are sine of half the inclination times sine and cosine of the node.
Mat3 j2000_from_ecliptic_of_date(double t) {
  const double p = polynomial({0.0, 0.10180391e-4, 0.47020439e-6, -0.5417367e-9, -0.2507948e-11, 0.463486e-14}, t);
  const double q = polynomial({0.0, -0.113469002e-3, 0.12372674e-6, 0.12654170e-8, -0.1371808e-11, -0.320334e-14}, t);
  const double c = std::sqrt(1.0 - p * p - q * q);
  return {1.0 - 2.0 * p * p, 2.0 * p * q,       -2.0 * p * c, //
          2.0 * p * q,       1.0 - 2.0 * q * q, 2.0 * q * c,  //
          2.0 * p * c,       -2.0 * q * c,      1.0 - 2.0 * (p * p + q * q)};
}

/// From the inertial mean ecliptic and equinox of J2000 in DE405: obliquity 84381.40928" and 0.05294" between the
/// equinox and the origin of ICRS right ascensions (Chapront, Chapront-Touze and Francou 2002, A&A 387, 700).
/// A fit of the whole theory to DE405 gives the same within 0.002".
const Mat3& icrs_from_j2000() {
  static const Mat3 matrix = [] {
    const double obliquity = (84381.40928 * arcsec).to(rad);
    const double origin = (-0.05294 * arcsec).to(rad);
    return turn_z(origin) * turn_x(obliquity);
  }();
  return matrix;
}

} // namespace

StateVector moon_geocentric_series(JulianDate<TDB> tdb) {
  const double t = centuries_since_j2000(tdb);
  const LunarTerm* term = moon_terms;
  const Moving in_longitude = harmonic_sum(term, moon_term_counts[0], t);
  const Moving in_latitude = harmonic_sum(term, moon_term_counts[1], t);
  const Moving in_distance = harmonic_sum(term, moon_term_counts[2], t);

  constexpr double rad_per_arcsec = arcsec.to(rad);
  constexpr double au_per_km = kilometre / astronomical_unit;
  const Moving mean = moving_polynomial(mean_longitude, t);
  const auto scaled = [](const Moving& m, double unit) {
    return Moving{m.value * unit, m.rate * unit / days_per_julian_century};
  };
  Moving longitude = scaled(in_longitude, rad_per_arcsec);
  longitude.value += mean.value;
  longitude.rate += mean.rate / days_per_julian_century;
  // The ecliptic itself turns by 6e-9 rad a day: nothing beside the Moon's 0.2.
  return icrs_from_j2000() *
         (j2000_from_ecliptic_of_date(t) *
          cartesian_of(longitude, scaled(in_latitude, rad_per_arcsec), scaled(in_distance, au_per_km)));
}

} // namespace vesper
