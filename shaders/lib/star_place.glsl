// The apparent place of a star, from its catalogue entry and the state of the Earth.
//
// Algebraic throughout, so that it runs in double precision in GLSL. Against ERFA star by star it leaves out the Roemer
// delay of the proper motion (below 0.001 arcsec even for Barnard's star).

// What all stars of a frame share. C++ fills it from vesper::StarFrame.
struct StarPlaceFrame {
  PReal years;                // Julian years of TDB since the catalogue's epoch
  PVec3 observer_au;          // barycentric position of the observer
  PVec3 velocity_c;           // barycentric velocity of the observer, units of c
  PReal lorentz_inverse;      // sqrt(1 - v^2)
  PVec3 sun_to_observer;      // unit vector
  PReal solar_potential;      // 2GM/(c^2 R), R the distance of the Sun; 0 leaves deflection out
};

// Schwarzschild radius of the Sun in astronomical units (2GM/c^2/au, IAU 2009 constants).
CONSTANT Real schwarzschild_radius_sun_au = Real(1.97412574336e-8);
// One astronomical unit per Julian year, in km/s.
CONSTANT Real km_s_per_au_year = Real(4.740470464);

// Space motion and annual parallax: uniform rectilinear motion, no light-time within the catalogue's span
// (Explanatory Supplement, 3rd ed., sec. 7.2). Unit vectors and radians per year in, unit vector out.
FN PVec3 star_motion(PVec3 position, PVec3 proper_motion, PReal parallax, PReal radial_velocity, StarPlaceFrame frame) {
  PReal recession = radial_velocity * parallax / PReal(km_s_per_au_year);
  PVec3 moved = position + frame.years * (proper_motion + recession * position);
  return normalize(moved - parallax * frame.observer_au);
}

// Deflection of starlight by the Sun (Klioner 2003 eq. 70, as in ERFA's eraLd for a source at infinity); limited
// inside about 9 arcmin of the Sun's centre, where no star can be seen.
FN PVec3 star_deflection(PVec3 direction, StarPlaceFrame frame) {
  PReal along = PReal(1.0) + dot(direction, frame.sun_to_observer);
  PReal strength = frame.solar_potential / max(along, PReal(1.0e-6));
  PVec3 across = cross(direction, cross(frame.sun_to_observer, direction));
  return direction + strength * across;
}

// Stellar aberration, special-relativistic with the Sun's potential (Klioner 2003 eq. 7, as in ERFA's eraAb).
FN PVec3 star_aberration(PVec3 direction, StarPlaceFrame frame) {
  PReal along = dot(direction, frame.velocity_c);
  PReal w1 = PReal(1.0) + along / (PReal(1.0) + frame.lorentz_inverse);
  PReal w2 = frame.solar_potential;
  return normalize(direction * frame.lorentz_inverse + w1 * frame.velocity_c +
                   w2 * (frame.velocity_c - along * direction));
}

// The proper direction to a star in ICRS axes: what the frame's rotation turns to the horizon.
FN PVec3 star_place(PVec3 position, PVec3 proper_motion, PReal parallax, PReal radial_velocity, StarPlaceFrame frame) {
  PVec3 direction = star_motion(position, proper_motion, parallax, radial_velocity, frame);
  return star_aberration(star_deflection(direction, frame), frame);
}
