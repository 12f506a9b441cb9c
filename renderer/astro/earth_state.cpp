#include "vesper/astro/earth_state.hpp"

#include "vesper/base/error.hpp"

#include <erfa.h>

#include <array>

namespace vesper {
namespace {

using Rows = double[3][3];

/// ERFA's matrices are arrays of rows.
Mat3 matrix_of(const Rows& rows) {
  Mat3 m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m[column][row] = rows[row][column];
    }
  }
  return m;
}

Vec3 vector_of(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

} // namespace

EarthState earth_state(const Instant& instant, const Observer& observer, Tier tier) {
  EarthState state;
  state.instant = instant;
  state.observer = observer;
  const JulianDate<TT>& tt = instant.tt;

  state.tier = tier;
  state.tdb = tdb_from_tt(tt);
  state.bodies = sun_earth_moon(state.tdb, tier);

  Rows of_date;
  eraPnm06a(tt.day, tt.fraction, of_date);
  state.equator_of_date_from_icrs = matrix_of(of_date);
  const double sidereal = eraGst06(instant.ut1.day, instant.ut1.fraction, tt.day, tt.fraction, of_date);
  state.local_sidereal_time_rad = eraAnp(sidereal + observer.longitude.to(rad));

  double diurnal[2][3];
  eraPvtob(observer.longitude.to(rad), observer.latitude.to(rad), observer.height.to(metre), 0.0, 0.0, 0.0, sidereal,
           diurnal);
  constexpr double au_m = astronomical_unit.to(metre);
  constexpr double seconds_per_day = 86400.0;
  const Mat3 icrs_from_equator_of_date = glm::transpose(state.equator_of_date_from_icrs);
  state.earth_to_observer_au = icrs_from_equator_of_date * (vector_of(diurnal[0]) / au_m);
  state.observer_velocity_au_d = icrs_from_equator_of_date * (vector_of(diurnal[1]) * (seconds_per_day / au_m));
  return state;
}

double greenwich_apparent_sidereal_time_rad(const Instant& instant) {
  return eraGst06a(instant.ut1.day, instant.ut1.fraction, instant.tt.day, instant.tt.fraction);
}

} // namespace vesper
