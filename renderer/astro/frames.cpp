#include "vesper/astro/frames.hpp"

#include "vesper/astro/erfa_arrays.hpp"
#include "vesper/astro/precession.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/astro/star_frame.hpp"

#include <erfa.h>

#include <numbers>

namespace vesper {
namespace {

/// The ecliptic of date with its longitudes counted from the true equinox, where it crosses the true equator.
Mat3 true_ecliptic_from_icrs(const EarthState& earth) {
  const Vec3 ecliptic_pole = glm::transpose(mean_ecliptic_from_icrs(earth.instant.tt))[2];
  const Vec3 celestial_pole = glm::transpose(earth.equator_of_date_from_icrs)[2];
  const Vec3 equinox = glm::normalize(glm::cross(celestial_pole, ecliptic_pole));
  return glm::transpose(Mat3(equinox, glm::cross(ecliptic_pole, equinox), ecliptic_pole));
}

Mat3 make_galactic_from_icrs() {
  // Longitude and latitude of each ICRS axis give the columns.
  constexpr double quarter_turn = 0.5 * std::numbers::pi;
  const double axes[3][2] = {{0.0, 0.0}, {quarter_turn, 0.0}, {0.0, quarter_turn}};
  Mat3 galactic;
  for (int i = 0; i < 3; ++i) {
    double longitude = 0.0;
    double latitude = 0.0;
    eraIcrs2g(axes[i][0], axes[i][1], &longitude, &latitude);
    galactic[i] = unit_vector(longitude, latitude);
  }
  return galactic;
}

} // namespace

Mat3 mean_ecliptic_from_icrs(JulianDate<TT> tt) {
  double rows[3][3];
  if (is_long_term(tt)) {
    eraLtecm(eraEpj(tt.day, tt.fraction), rows);
  } else {
    eraEcm06(tt.day, tt.fraction, rows);
  }
  return matrix_of(rows);
}

Mat3 galactic_from_icrs() {
  static const Mat3 galactic = make_galactic_from_icrs();
  return galactic;
}

Mat3 frame_from_icrs(CelestialFrame frame, const EarthState& earth) {
  const JulianDate<TT>& tt = earth.instant.tt;
  switch (frame) {
  case CelestialFrame::mean_of_date:
    return precession(tt).mean_equator_from_icrs;
  case CelestialFrame::true_of_date:
    return earth.equator_of_date_from_icrs;
  case CelestialFrame::ecliptic_of_date:
    return true_ecliptic_from_icrs(earth);
  case CelestialFrame::ecliptic_j2000:
    return mean_ecliptic_from_icrs(j2000<TT>);
  case CelestialFrame::galactic:
    return galactic_from_icrs();
  case CelestialFrame::horizon:
    return horizon_from_equator(earth.observer.latitude, earth.local_sidereal_time_rad) *
           earth.equator_of_date_from_icrs;
  case CelestialFrame::icrs:
    break;
  }
  return Mat3(1.0);
}

Mat3 frame_rotation(CelestialFrame from, CelestialFrame to, const EarthState& earth) {
  return frame_from_icrs(to, earth) * glm::transpose(frame_from_icrs(from, earth));
}

} // namespace vesper
