// Sums of cosines with their derivatives, the form of the theories of Moon and planets.
#pragma once

#include "vesper/astro/ephemeris.hpp"
#include "vesper/base/polynomial.hpp"
#include "vesper/base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace vesper {

/// A quantity and its derivative by time.
struct Moving {
  double value = 0.0;
  double rate = 0.0;
};

/// Terms are summed two at a time, in the vectors that every 64-bit processor has (an extension of GCC and Clang).
inline constexpr std::size_t lane_count = 2;
using TermPair __attribute__((vector_size(lane_count * sizeof(double)))) = double;

struct CosSin {
  TermPair cos;
  TermPair sin;
};

/// Within 2e-13 for angles up to 1e6 rad, without a branch: several times faster than the standard library's pair,
/// which a sum of a thousand terms feels.
inline CosSin cos_sin(const TermPair& angle_rad) {
  // Less whole turns; 2 pi in two parts, the first short enough that its multiples are exact.
  constexpr double turns_per_rad = 0.15915494309189535;
  constexpr double turn_high = 6.2831853069365025;
  constexpr double turn_low = 2.430840202602477e-10;
  constexpr double to_integer = 6755399441055744.0; // 1.5 * 2^52: adding it rounds
  // Taylor series of sin x / x and (1 - cos x) / x^2 by x^2, then the angle doubled twice. 1 - cos keeps the digits.
  constexpr double sine[] = {
      1.0, -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0, -1.0 / 39916800.0, 1.0 / 6227020800.0};
  constexpr double versine[] = {1.0 / 2.0,       -1.0 / 24.0,        1.0 / 720.0,        -1.0 / 40320.0,
                                1.0 / 3628800.0, -1.0 / 479001600.0, 1.0 / 87178291200.0};
  const TermPair turns = (angle_rad * turns_per_rad + to_integer) - to_integer;
  const TermPair x = 0.25 * ((angle_rad - turns * turn_high) - turns * turn_low); // within pi/4
  const TermPair y = x * x;
  const TermPair s = x * polynomial(sine, y);
  const TermPair v = y * polynomial(versine, y);
  const TermPair s2 = 2.0 * s * (1.0 - v); // sin and 1 - cos of 2 x
  const TermPair v2 = 2.0 * s * s;
  return {1.0 - 2.0 * s2 * s2, 2.0 * s2 * (1.0 - v2)};
}

/// Sum over the powers k of t^k times the sum of counts[k] terms from `next` on, which is left behind the last of them.
/// A term has an `amplitude` and a `Moving phase(double t)`.
/// \param least amplitudes below are left out; the terms of each power stand in falling order
template <class Term, std::size_t Powers>
Moving harmonic_sum(const Term*& next, const std::uint16_t (&counts)[Powers], double t, double least = 0.0) {
  Moving total;
  double power = 1.0;            // t^k
  double power_derivative = 0.0; // k t^(k-1)
  for (std::size_t k = 0; k < Powers; ++k) {
    const Term* const end =
        std::find_if(next, next + counts[k], [least](const Term& term) { return std::abs(term.amplitude) < least; });
    TermPair values{};
    TermPair rates{};
    for (const Term* first = next; first < end; first += lane_count) {
      TermPair amplitude{};
      TermPair phase{};
      TermPair frequency{};
      const auto here = std::min(lane_count, static_cast<std::size_t>(end - first));
      for (std::size_t i = 0; i < here; ++i) {
        const Moving at = first[i].phase(t);
        amplitude[i] = first[i].amplitude;
        phase[i] = at.value;
        frequency[i] = at.rate;
      }
      const CosSin at = cos_sin(phase);
      values += amplitude * at.cos;
      rates -= amplitude * at.sin * frequency;
    }
    next += counts[k];
    const double value = values[0] + values[1];
    const double rate = rates[0] + rates[1];
    total.value += power * value;
    total.rate += power * rate + power_derivative * value;
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
