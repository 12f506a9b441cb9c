#include "vesper/astro/precession.hpp"

#include <erfa.h>

#include <cmath>

namespace vesper {
namespace {

constexpr JulianDate<TT> j2000{2451545.0, 0.0};
constexpr double days_per_year = 365.25;
constexpr double iau_2006_years = 400.0; // from J2000

/// ERFA's matrices are arrays of rows.
Mat3 matrix_of(const double (&rows)[3][3]) {
  Mat3 m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m[column][row] = rows[row][column];
    }
  }
  return m;
}

double angle_between(const double (&a)[3], const double (&b)[3]) {
  const Vec3 u(a[0], a[1], a[2]);
  const Vec3 v(b[0], b[1], b[2]);
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

double years_since_j2000(JulianDate<TT> tt) { return tt.days_since(j2000) / days_per_year; }

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
    result.mean_obliquity_rad = angle_between(equator_pole, ecliptic_pole);
  }
  result.mean_equator_from_icrs = matrix_of(rows);
  // Sidereal time at a fixed Earth rotation leaves the part that belongs to TT.
  const double sidereal = eraGmst06(j2000.day, j2000.fraction, tt.day, tt.fraction);
  result.mean_equation_of_origins_rad = eraAnpm(eraEra00(j2000.day, j2000.fraction) - sidereal);
  return result;
}

} // namespace vesper
