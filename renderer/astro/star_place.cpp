#include "vesper/astro/star_place.hpp"

#include "vesper/astro/spherical.hpp"

#include <cmath>

namespace vesper {
CatalogueStar catalogue_star(Angle right_ascension, Angle declination, Angle motion_alpha, Angle motion_delta,
                             Angle parallax, double radial_velocity_km_s) {
  const double sa = std::sin(right_ascension.to(rad));
  const double ca = std::cos(right_ascension.to(rad));
  const double sd = std::sin(declination.to(rad));
  const double cd = std::cos(declination.to(rad));
  const Vec3 east(-sa, ca, 0.0);
  const Vec3 north(-sd * ca, -sd * sa, cd);
  return {Vec3(cd * ca, cd * sa, sd), motion_alpha.to(rad) * east + motion_delta.to(rad) * north, parallax.to(rad),
          radial_velocity_km_s};
}

f64::StarPlaceFrame place_frame(const StarFrame& frame, double epoch_jyear) {
  f64::StarPlaceFrame place;
  place.years = frame.years_since_j2000 + (2000.0 - epoch_jyear);
  place.observer_au = frame.observer_barycentric_au;
  place.velocity_c = frame.observer_velocity_c;
  place.lorentz_inverse = frame.lorentz_inverse;
  place.sun_to_observer = frame.sun_to_observer;
  place.solar_potential =
      frame.solar_deflection ? double(f64::schwarzschild_radius_sun_au) / frame.sun_distance_au : 0.0;
  return place;
}

Vec3 star_place_icrs(const CatalogueStar& star, const f64::StarPlaceFrame& frame) {
  return f64::star_place(star.position, star.proper_motion_rad_year, star.parallax_rad, star.radial_velocity_km_s,
                         frame);
}

Equatorial equatorial_of(const Vec3& v) { return {whole_turn_atan2(v.y, v.x), latitude_of(v)}; }

Horizontal horizontal_of(const Vec3& v) { return {whole_turn_atan2(v.x, v.y), latitude_of(v)}; }

} // namespace vesper
