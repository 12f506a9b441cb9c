// Numbers that a 16-bit float (IEEE 754 binary16) holds.
#pragma once

#include <algorithm>
#include <cmath>

namespace vesper {

/// The nearest one, ties to even: within 2^-11 (0.0489 %) of the number, or within 2^-25 below 2^-14.
/// \param value within +-65504
[[nodiscard]] inline float nearest_half(double value) {
  int exponent = 0;
  static_cast<void>(std::frexp(value, &exponent));
  const int last_bit = std::max(exponent - 11, -24);
  return static_cast<float>(std::ldexp(std::nearbyint(std::ldexp(value, -last_bit)), last_bit));
}

[[nodiscard]] inline bool is_half(float value) {
  return std::abs(value) <= 65504.0F && nearest_half(static_cast<double>(value)) == value;
}

} // namespace vesper
