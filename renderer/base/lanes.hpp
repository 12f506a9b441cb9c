// Four floats in one register: light at four wavelengths, as GLSL's vec4 holds it.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>

namespace vesper {

/// Operators act on each of the four. Compilers seldom find them in a struct of four floats; a vector type says so.
struct Lanes {
  using Floats = float __attribute__((vector_size(16)));
  using Integers = int __attribute__((vector_size(16)));
  static constexpr std::size_t size = 4;

  Floats values{};

  Lanes() = default;
  explicit Lanes(float all) : values{all, all, all, all} {}
  explicit Lanes(Floats own) : values(own) {}
  [[nodiscard]] float operator[](std::size_t i) const { return values[i]; }

  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.values + b.values); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.values - b.values); }
  friend Lanes operator-(Lanes a) { return Lanes(-a.values); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.values * b.values); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.values / b.values); }
  friend Lanes operator+(float a, Lanes b) { return Lanes(a + b.values); }
  friend Lanes operator-(float a, Lanes b) { return Lanes(a - b.values); }
  friend Lanes operator-(Lanes a, float b) { return Lanes(a.values - b); }
  friend Lanes operator*(float a, Lanes b) { return Lanes(a * b.values); }
  friend Lanes operator*(Lanes a, float b) { return Lanes(a.values * b); }
  Lanes& operator+=(Lanes b) {
    values += b.values;
    return *this;
  }
  Lanes& operator*=(Lanes b) {
    values *= b.values;
    return *this;
  }
};

inline Lanes max(Lanes a, Lanes b) { return Lanes(a.values > b.values ? a.values : b.values); }
inline Lanes min(Lanes a, Lanes b) { return Lanes(a.values < b.values ? a.values : b.values); }

/// 2^x within 3e-6 of itself, for x below 128; below -126 as there.
inline Lanes exp2(Lanes x) {
  const Lanes::Floats bounded = max(x, Lanes(-126.0F)).values;
  // Truncation rounds down what is positive.
  const Lanes::Integers whole = __builtin_convertvector(bounded + 127.0F, Lanes::Integers);
  const Lanes::Floats t = bounded - (__builtin_convertvector(whole, Lanes::Floats) - 127.0F);
  const Lanes::Floats mantissa =
      1.0F + t * (0.69315286F + t * (0.24014077F + t * (0.055886440F + t * (0.0089304169F + t * 0.0018894827F))));
  return Lanes(mantissa * std::bit_cast<Lanes::Floats>(whole << 23));
}

inline Lanes log2(Lanes x) {
  return Lanes(Lanes::Floats{std::log2(x[0]), std::log2(x[1]), std::log2(x[2]), std::log2(x[3])});
}

} // namespace vesper
