#pragma once

#include <cstddef>

namespace vesper {

/// c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t N> [[nodiscard]] constexpr double polynomial(const double (&c)[N], double x) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) {
    sum = c[i] + x * sum;
  }
  return sum;
}

} // namespace vesper
