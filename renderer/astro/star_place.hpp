// Places of stars: the shared shader code (shaders/lib/star_place.glsl) in double precision, and what is read off them.
#pragma once

#include "vesper/astro/star_frame.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// A star in its catalogue, ICRS axes at the catalogue's epoch.
struct CatalogueStar {
  Vec3 position{1.0, 0.0, 0.0};      ///< unit vector
  Vec3 proper_motion_rad_year{};     ///< tangent to the sphere at `position`
  double parallax_rad = 0.0;         ///< >= 0; 0 is infinitely far
  double radial_velocity_km_s = 0.0; ///< positive receding
};

/// A star from catalogue columns.
/// \param motion_alpha proper motion in right ascension a year, multiplied by the cosine of the declination
[[nodiscard]] CatalogueStar catalogue_star(Angle right_ascension, Angle declination, Angle motion_alpha,
                                           Angle motion_delta, Angle parallax, double radial_velocity_km_s);

/// The frame in the form that the shared code takes.
/// \param epoch_jyear Julian year of the catalogue's positions
[[nodiscard]] f64::StarPlaceFrame place_frame(const StarFrame& frame, double epoch_jyear = 2000.0);

/// Proper direction to the star along ICRS axes: space motion, parallax, deflection and aberration applied. A unit
/// vector; `frame.equator_of_date_from_icrs` and `frame.horizon_from_icrs` turn it. Within 1 mas of ERFA star by star.
[[nodiscard]] Vec3 star_place_icrs(const CatalogueStar& star, const f64::StarPlaceFrame& frame);

struct Equatorial {
  Angle right_ascension; ///< 0 to 360 degrees
  Angle declination;
};
struct Horizontal {
  Angle azimuth;  ///< north through east, 0 to 360 degrees; 0 at the zenith
  Angle altitude; ///< airless
};

/// Of a vector of any length along equatorial axes.
[[nodiscard]] Equatorial equatorial_of(const Vec3& v);
/// Of a vector of any length along horizon axes (x = East, y = North, z = zenith).
[[nodiscard]] Horizontal horizontal_of(const Vec3& v);

} // namespace vesper
