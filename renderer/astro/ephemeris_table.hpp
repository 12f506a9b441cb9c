// The embedded table of the solar system from JPL DE405, December 1959 to January 2060.
#pragma once

#include "vesper/astro/ephemeris.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace vesper {

/// Nutation of the IAU 2000A theory adjusted to the IAU 2006 precession.
struct Nutation {
  double longitude_rad = 0.0;   ///< to be added to the mean ecliptic longitude of date
  double obliquity_rad = 0.0;   ///< true less mean
  double cio_locator_rad = 0.0; ///< s + XY/2, which places the origin of the Earth rotation angle
};

/// The Euler angles of DE405's principal axes of inertia of the Moon with respect to the equator of the ICRS: the
/// Moon's axes from ICRS ones by R_z(psi) R_x(theta) R_z(phi), R turning the frame. The mean-Earth axes of maps
/// differ by constant turns of about an arcminute.
struct LunarAngles {
  double phi_rad = 0.0;   ///< from the ICRS x axis to the ascending node of the Moon's equator
  double theta_rad = 0.0; ///< inclination of the Moon's equator to the ICRS equator
  double psi_rad = 0.0;   ///< from the node to the prime meridian; whole turns left out
};

/// Chebyshev polynomials with integer coefficients, made by data/make_ephemeris.py.
///
/// The file, little endian: a head {char magic[8] "VESPEPH1", f64 first Julian date, f64 days, u32 series, u32 bytes of
/// the file}; for each series a row {char name[16], f64 quantum, u32 place of its first byte, u32 segments, u32 orders,
/// u32 orders of 32 bits}; then the segments, which share the span evenly. A segment holds its orders from the highest
/// to the lowest, each as three components: 16-bit integers, the lowest orders 32-bit ones. The value is the quantum
/// (km or rad) times the integer.
///
/// Worst errors against DE405 and ERFA stand in data/README.md: Moon 2 m, Sun and Earth 0.3 km, planets 0.001" as seen
/// from the Earth, nutation 0.00002", the Moon's axes 0.05". DE405 itself, seen from the Earth, is within 0.02" (Sun,
/// Moon, inner planets), 0.2" (Jupiter, Saturn), 0.5" (Uranus) and 1.5" (Neptune) of DE431; its axes are the ICRS's
/// within 0.001".
///
/// Evaluation changes nothing and allocates nothing: any number of threads may share a table. Each function gives
/// nothing outside the span and for dates that are not numbers.
class EphemerisTable {
public:
  /// Reads the directory; the bytes must outlive the table. Throws Error(input) naming what does not fit.
  explicit EphemerisTable(std::span<const unsigned char> bytes);

  /// The table built into the library.
  [[nodiscard]] static const EphemerisTable& embedded();

  [[nodiscard]] JulianDate<TDB> begin() const { return {first_jd_, 0.0}; }
  [[nodiscard]] JulianDate<TDB> end() const { return {first_jd_ + days_, 0.0}; }
  /// Whether a date lies in the span, its ends included.
  [[nodiscard]] bool covers(JulianDate<TDB> tdb) const { return contains(tdb.day, tdb.fraction); }

  [[nodiscard]] std::optional<SunEarthMoon> sun_earth_moon(JulianDate<TDB> tdb) const;
  /// From the Sun; the barycentre of the planet and its moons.
  [[nodiscard]] std::optional<StateVector> planet_heliocentric(Planet planet, JulianDate<TDB> tdb) const;
  [[nodiscard]] std::optional<Nutation> nutation(JulianDate<TT> tt) const;
  [[nodiscard]] std::optional<LunarAngles> lunar_angles(JulianDate<TDB> tdb) const;

private:
  enum Body { moon, earth_moon, sun, first_planet, moon_axes = first_planet + planet_count, earth_nutation, bodies };

  struct Series {
    const unsigned char* segments = nullptr;
    std::uint32_t segment_bytes = 0;
    std::uint32_t last_segment = 0;
    int narrow_orders = 0;
    int wide_orders = 0;
    double segment_days = 0.0;
    double quantum = 0.0;
  };
  struct Value {
    Vec3 value{};
    Vec3 per_day{};
  };

  [[nodiscard]] bool contains(double day, double fraction) const {
    const double days = (day - first_jd_) + fraction;
    return days >= 0.0 && days <= days_;
  }
  [[nodiscard]] Value evaluate(Body body, double day, double fraction) const;
  [[nodiscard]] StateVector state(Body body, JulianDate<TDB> tdb) const;

  double first_jd_ = 0.0;
  double days_ = 0.0;
  std::array<Series, bodies> series_{};
};

} // namespace vesper
