#include "vesper/base/fourier.hpp"

#include "vesper/base/error.hpp"

#include <bit>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vesper {
namespace {

using Complex = std::complex<double>;

/// std::complex guards its product against infinities, at several times the cost.
Complex product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Of one row: values `stride` apart, whose order is first turned into that of the reversed bits of their places.
void transform_row(Complex* row, std::size_t side, std::size_t stride, const std::vector<Complex>& turns) {
  for (std::size_t i = 1, j = 0; i < side; ++i) {
    std::size_t bit = side >> 1U;
    for (; (j & bit) != 0; bit >>= 1U) {
      j ^= bit;
    }
    j ^= bit;
    if (i < j) {
      std::swap(row[i * stride], row[j * stride]);
    }
  }
  for (std::size_t half = 1; half < side; half *= 2) {
    const std::size_t turn = side / (2 * half);
    for (std::size_t begin = 0; begin < side; begin += 2 * half) {
      for (std::size_t k = 0; k < half; ++k) {
        Complex& low = row[(begin + k) * stride];
        Complex& high = row[(begin + k + half) * stride];
        const Complex turned = product(high, turns[k * turn]);
        high = low - turned;
        low += turned;
      }
    }
  }
}

} // namespace

void fourier_transform(std::span<Complex> square, std::size_t side, FourierWay way) {
  if (!std::has_single_bit(side) || square.size() != side * side) {
    throw Error(ErrorKind::argument,
                "a Fourier transform of " + std::to_string(square.size()) + " values with a side of " +
                    std::to_string(side),
                {"", "", "Give a side that is a power of 2 and its square of values"});
  }
  std::vector<Complex> turns;
  const double sign = way == FourierWay::forward ? -1.0 : 1.0;
  for (std::size_t k = 0; k < side / 2; ++k) {
    turns.push_back(
        std::polar(1.0, sign * 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(side)));
  }
  for (std::size_t i = 0; i < side; ++i) {
    transform_row(&square[i * side], side, 1, turns);
  }
  for (std::size_t i = 0; i < side; ++i) {
    transform_row(&square[i], side, side, turns);
  }
  if (way == FourierWay::back) {
    for (Complex& value : square) {
      value /= static_cast<double>(square.size());
    }
  }
}

} // namespace vesper
