#include "vesper/astro/nutation_series.hpp"

#include "vesper/astro/harmonic_sum.hpp"
#include "vesper/base/units.hpp"

#include <erfa.h>

#include <algorithm>
#include <iterator>

namespace vesper {
namespace {

struct NutationTerm {
  double phase[5]; ///< rad, by powers of Julian centuries
  double longitude_sin, longitude_t_sin, longitude_cos;
  double obliquity_cos, obliquity_t_cos, obliquity_sin;
};

#include "nutation_terms.inl"

} // namespace

Nutation nutation_series(JulianDate<TT> tt) {
  const double t = centuries_since_j2000(tt);
  TermPair longitude{};
  TermPair obliquity{};
  constexpr std::size_t count = std::size(nutation_terms);
  for (std::size_t first = 0; first < count; first += lane_count) {
    TermPair phase{};
    TermPair longitude_sin{};
    TermPair longitude_cos{};
    TermPair obliquity_sin{};
    TermPair obliquity_cos{};
    const std::size_t here = std::min(lane_count, count - first);
    for (std::size_t i = 0; i < here; ++i) {
      const NutationTerm& term = nutation_terms[first + i];
      phase[i] = polynomial(term.phase, t);
      longitude_sin[i] = term.longitude_sin + t * term.longitude_t_sin;
      longitude_cos[i] = term.longitude_cos;
      obliquity_sin[i] = term.obliquity_sin;
      obliquity_cos[i] = term.obliquity_cos + t * term.obliquity_t_cos;
    }
    const CosSin at = cos_sin(phase);
    longitude += longitude_sin * at.sin + longitude_cos * at.cos;
    obliquity += obliquity_sin * at.sin + obliquity_cos * at.cos;
  }
  // The changing oblateness of the Earth (-2.7774e-6 a century) and the obliquity of IAU 2006.
  const double oblateness = -2.7774e-6 * t;
  constexpr double rad_per_arcsec = arcsec.to(rad);
  Nutation nutation;
  nutation.longitude_rad = (longitude[0] + longitude[1]) * rad_per_arcsec * (1.0 + 0.4697e-6 + oblateness);
  nutation.obliquity_rad = (obliquity[0] + obliquity[1]) * rad_per_arcsec * (1.0 + oblateness);
  nutation.cio_locator_rad = eraS06(tt.day, tt.fraction, 0.0, 0.0); // without X and Y it is the series of s + XY/2
  return nutation;
}

} // namespace vesper
