#pragma once

#include <cstddef>

namespace vesper {

/// c[0] + c[1] x + c[2] x^2 + ..., of numbers or of vectors of them.
template <class Number, std::size_t N> [[nodiscard]] constexpr Number polynomial(const double (&c)[N], Number x) {
  Number sum = c[N - 1] + Number{};
  for (std::size_t i = N - 1; i-- > 0;) {
    sum = c[i] + x * sum;
  }
  return sum;
}

} // namespace vesper
