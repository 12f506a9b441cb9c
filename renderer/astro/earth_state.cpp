#include "vesper/astro/earth_state.hpp"

#include "vesper/astro/ephemeris_table.hpp"
#include "vesper/astro/erfa_arrays.hpp"
#include "vesper/astro/nutation_series.hpp"
#include "vesper/astro/precession.hpp"

#include <erfa.h>

#include <cmath>

namespace vesper {
namespace {

using Rows = double[3][3];

/// The Earth's axes in space at one instant.
struct Orientation {
  Mat3 of_date{1.0};                ///< true equator and equinox of date from ICRS
  double equation_of_origins = 0.0; ///< Earth rotation angle less apparent sidereal time, rad
};

Nutation nutation_at(JulianDate<TT> tt) {
  const auto tabulated = EphemerisTable::embedded().nutation(tt);
  return tabulated ? *tabulated : nutation_series(tt);
}

Orientation long_term_orientation(JulianDate<TT> tt, const Nutation& nutation) {
  const Precession mean = precession(tt);
  Rows nutated;
  eraNumat(mean.mean_obliquity_rad, nutation.longitude_rad, nutation.obliquity_rad, nutated);
  const double equation_of_equinoxes =
      nutation.longitude_rad * std::cos(mean.mean_obliquity_rad) + eraEect00(tt.day, tt.fraction);
  return {matrix_of(nutated) * mean.mean_equator_from_icrs, mean.mean_equation_of_origins_rad - equation_of_equinoxes};
}

/// What eraPnm06a and eraGst06 compute, given the nutation (Wallace and Capitaine 2006, A&A 459, 981); in far years
/// after the long-term precession.
Orientation orientation(JulianDate<TT> tt) {
  const Nutation nutation = nutation_at(tt);
  if (is_long_term(tt)) {
    return long_term_orientation(tt, nutation);
  }
  double gamma_bar = 0.0;
  double phi_bar = 0.0;
  double psi_bar = 0.0;
  double epsilon = 0.0;
  eraPfw06(tt.day, tt.fraction, &gamma_bar, &phi_bar, &psi_bar, &epsilon);
  Rows of_date;
  eraFw2m(gamma_bar, phi_bar, psi_bar + nutation.longitude_rad, epsilon + nutation.obliquity_rad, of_date);
  double x = 0.0;
  double y = 0.0;
  eraBpn2xy(of_date, &x, &y);
  return {matrix_of(of_date), eraEors(of_date, nutation.cio_locator_rad - 0.5 * x * y)};
}

double apparent_sidereal_time_rad(JulianDate<UT1> ut1, double equation_of_origins) {
  return eraAnp(eraEra00(ut1.day, ut1.fraction) - equation_of_origins);
}

} // namespace

EarthState earth_state(const Instant& instant, const Observer& observer, Tier tier) {
  require_supported(instant.tt);
  EarthState state;
  state.instant = instant;
  state.observer = observer;
  state.tier = tier;
  state.tdb = tdb_from_tt(instant.tt);
  state.bodies = sun_earth_moon(state.tdb, tier);

  const Orientation axes = orientation(instant.tt);
  state.equator_of_date_from_icrs = axes.of_date;
  const double sidereal = apparent_sidereal_time_rad(instant.ut1, axes.equation_of_origins);
  state.local_sidereal_time_rad = eraAnp(sidereal + observer.longitude.to(rad));

  double diurnal[2][3];
  eraPvtob(observer.longitude.to(rad), observer.latitude.to(rad), observer.height.to(metre), 0.0, 0.0, 0.0, sidereal,
           diurnal);
  constexpr double au_m = astronomical_unit.to(metre);
  const Mat3 icrs_from_equator_of_date = glm::transpose(state.equator_of_date_from_icrs);
  state.earth_to_observer_au = icrs_from_equator_of_date * (vector_of(diurnal[0]) / au_m);
  state.observer_velocity_au_d = icrs_from_equator_of_date * (vector_of(diurnal[1]) * (seconds_per_day / au_m));
  return state;
}

double greenwich_apparent_sidereal_time_rad(const Instant& instant) {
  return apparent_sidereal_time_rad(instant.ut1, orientation(instant.tt).equation_of_origins);
}

} // namespace vesper
