#include "vesper/astro/precession.hpp"

#include "vesper/astro/erfa_arrays.hpp"
#include "vesper/astro/spherical.hpp"

#include <erfa.h>

#include <cmath>

namespace vesper {
namespace {

constexpr double iau_2006_years = 400.0; // from J2000

double years_since_j2000(JulianDate<TT> tt) { return tt.days_since(j2000<TT>) / days_per_julian_year; }

} // namespace

bool is_long_term(JulianDate<TT> tt) { return std::abs(years_since_j2000(tt)) > iau_2006_years; }

Precession precession(JulianDate<TT> tt) {
  Precession result;
  double rows[3][3];
  if (!is_long_term(tt)) {
    eraPmat06(tt.day, tt.fraction, rows);
    result.mean_obliquity_rad = eraObl06(tt.day, tt.fraction);
  } else {
    const double epoch = 2000.0 + years_since_j2000(tt);
    double equator_pole[3];
    double ecliptic_pole[3];
    eraLtpb(epoch, rows);
    eraLtpequ(epoch, equator_pole);
    eraLtpecl(epoch, ecliptic_pole);
    result.mean_obliquity_rad = angle_between(vector_of(equator_pole), vector_of(ecliptic_pole)).to(rad);
  }
  result.mean_equator_from_icrs = matrix_of(rows);
  // Sidereal time at a fixed Earth rotation leaves the part that belongs to TT.
  const double sidereal = eraGmst06(j2000<TT>.day, j2000<TT>.fraction, tt.day, tt.fraction);
  result.mean_equation_of_origins_rad = eraAnpm(eraEra00(j2000<TT>.day, j2000<TT>.fraction) - sidereal);
  return result;
}

} // namespace vesper
