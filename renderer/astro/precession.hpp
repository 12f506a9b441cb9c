// Precession over all the years that times may have.
#pragma once

#include "vesper/astro/time.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// The mean equator and equinox of a date, and what ties the Earth's rotation to them.
struct Precession {
  Mat3 mean_equator_from_icrs{1.0}; ///< frame bias and precession
  double mean_obliquity_rad = 0.0;
  /// Earth rotation angle less mean sidereal time at Greenwich.
  double mean_equation_of_origins_rad = 0.0;
};

/// IAU 2006 (eraPmat06, eraObl06) from 1600 to 2400, outside the long-term precession of Vondrak, Capitaine and Wallace
/// 2011 (A&A 534, A22; eraLtpb), which is made for 200 000 years: IAU 2006 is a polynomial and leaves it by 17" in
/// -3000, 70" in -4712 and 4' in 9999. They differ by 0.008" where they join. The equation of origins is that of IAU
/// 2006 everywhere (eraGmst06), within 37" of the long-term precession at -4712 and 240" at 9999: seconds of time where
/// Delta-T is uncertain by many minutes.
[[nodiscard]] Precession precession(JulianDate<TT> tt);

/// Whether precession() takes the long-term model, outside 1600 to 2400.
[[nodiscard]] bool is_long_term(JulianDate<TT> tt);

} // namespace vesper
