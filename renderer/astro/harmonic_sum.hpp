// Sums of cosines with their derivatives, the form of the theories of Moon and planets.
#pragma once

#include "vesper/astro/ephemeris.hpp"
#include "vesper/base/vector.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace vesper {

/// A quantity and its derivative by time.
struct Moving {
  double value = 0.0;
  double rate = 0.0;
};

/// Sum over the powers k of t^k times the sum of counts[k] terms from `next` on, which is left behind the last of them.
/// A term has an `amplitude` and a `Moving phase(double t)`.
/// \param least amplitudes below are left out; the terms of each power stand in falling order
template <class Term, std::size_t Powers>
Moving harmonic_sum(const Term*& next, const std::uint16_t (&counts)[Powers], double t, double least = 0.0) {
  Moving total;
  double power = 1.0;           // t^k
  double power_derivative = 0.0; // k t^(k-1)
  for (std::size_t k = 0; k < Powers; ++k) {
    Moving sum;
    for (const Term& term : std::span(next, counts[k])) {
      if (std::abs(term.amplitude) < least) {
        break;
      }
      const Moving phase = term.phase(t);
      sum.value += term.amplitude * std::cos(phase.value);
      sum.rate -= term.amplitude * std::sin(phase.value) * phase.rate;
    }
    next += counts[k];
    total.value += power * sum.value;
    total.rate += power * sum.rate + power_derivative * sum.value;
    power_derivative = static_cast<double>(k + 1) * power;
    power *= t;
  }
  return total;
}

/// Position and velocity of spherical coordinates: longitude, latitude, distance.
inline StateVector cartesian_of(const Moving& longitude, const Moving& latitude, const Moving& distance) {
  const double cl = std::cos(longitude.value);
  const double sl = std::sin(longitude.value);
  const double cb = std::cos(latitude.value);
  const double sb = std::sin(latitude.value);
  const Vec3 direction(cb * cl, cb * sl, sb);
  const Vec3 east(-cb * sl, cb * cl, 0.0);
  const Vec3 north(-sb * cl, -sb * sl, cb);
  return {distance.value * direction,
          distance.rate * direction + distance.value * (longitude.rate * east + latitude.rate * north)};
}

inline StateVector operator*(const Mat3& turn, const StateVector& state) {
  return {turn * state.position_au, turn * state.velocity_au_d};
}

} // namespace vesper
