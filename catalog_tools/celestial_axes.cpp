#include "vesper/catalog_tools/celestial_axes.hpp"

#include "vesper/base/units.hpp"

#include <cmath>
#include <erfa.h>
#include <fmt/format.h>
#include <numbers>

namespace vesper {
namespace {

constexpr double j2000 = 2451545.0;
constexpr double days_per_julian_century = 36525.0;
constexpr double quarter_turn = 0.5 * std::numbers::pi;

/// ERFA's matrices lie row by row.
Mat3 from_rows(const double (&rows)[3][3]) {
  return {
      {rows[0][0], rows[1][0], rows[2][0]}, {rows[0][1], rows[1][1], rows[2][1]}, {rows[0][2], rows[1][2], rows[2][2]}};
}

Vec3 unit_vector(double longitude_deg, double latitude_deg) {
  const double longitude = (longitude_deg * deg).to(rad);
  const double latitude = (latitude_deg * deg).to(rad);
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

Mat3 icrs_from_galactic() {
  Mat3 axes;
  for (int i = 0; i < 3; ++i) {
    double ra = 0.0;
    double dec = 0.0;
    eraG2icrs(i == 1 ? quarter_turn : 0.0, i == 2 ? quarter_turn : 0.0, &ra, &dec);
    axes[i] = Vec3(std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec));
  }
  return axes;
}

/// The poles of de Vaucouleurs et al. 1976: north at l = 47.37, b = 6.32; longitude 0 at l = 137.37, b = 0.
Mat3 galactic_from_supergalactic() {
  const Vec3 north = unit_vector(47.37, 6.32);
  const Vec3 zero = unit_vector(137.37, 0.0);
  return {zero, cross(north, zero), north};
}

Mat3 icrs_from_fk5(double equinox) {
  double fk5_to_hipparcos[3][3];
  double spin[3];
  eraFk5hip(fk5_to_hipparcos, spin);
  double precession[3][3];
  eraPmat76(j2000, (equinox - 2000.0) * days_per_julian_century / 100.0, precession);
  return from_rows(fk5_to_hipparcos) * transpose(from_rows(precession));
}

/// The rotation of positions from B1950 to J2000 (Murray 1989, A&A 218, 325, section 4), for the
/// epoch 1950; the E-terms of aberration, at most 0.34", are left in.
Mat3 fk5_from_fk4() {
  const double rows[3][3] = {{0.9999256794956877, -0.0111814832204662, -0.0048590038153592},
                             {0.0111814832391717, 0.9999374848933135, -0.0000271625947142},
                             {0.0048590037723143, -0.0000271702937440, 0.9999881946023742}};
  return from_rows(rows);
}

Mat3 icrs_from_ecliptic(double equinox) {
  double rotation[3][3];
  eraEcm06(j2000, (equinox - 2000.0) * days_per_julian_century / 100.0, rotation);
  return transpose(from_rows(rotation));
}

} // namespace

std::optional<CelestialAxes> celestial_axes(const std::string& longitude_type, const std::string& radesys,
                                            std::optional<double> equinox) {
  if (longitude_type == "GLON") {
    return CelestialAxes{icrs_from_galactic(), "galactic"};
  }
  if (longitude_type == "SLON") {
    return CelestialAxes{icrs_from_galactic() * galactic_from_supergalactic(), "supergalactic"};
  }
  const bool old = equinox && *equinox < 1984.0;
  if (longitude_type == "ELON") {
    if (old) {
      return std::nullopt; // FK4's ecliptic
    }
    return CelestialAxes{icrs_from_ecliptic(equinox.value_or(2000.0)),
                         fmt::format("ecliptic, equinox J{}", equinox.value_or(2000.0))};
  }
  if (longitude_type != "RA") {
    return std::nullopt;
  }
  const std::string system = !radesys.empty() ? radesys : !equinox ? "ICRS" : old ? "FK4" : "FK5";
  if (system == "ICRS") {
    return CelestialAxes{Mat3(1.0), "ICRS"};
  }
  if (system == "FK5") {
    return CelestialAxes{icrs_from_fk5(equinox.value_or(2000.0)),
                         fmt::format("FK5, equinox J{}", equinox.value_or(2000.0))};
  }
  if ((system == "FK4" || system == "FK4-NO-E") && equinox.value_or(1950.0) == 1950.0) {
    return CelestialAxes{icrs_from_fk5(2000.0) * fk5_from_fk4(), "FK4, equinox B1950"};
  }
  return std::nullopt;
}

} // namespace vesper
