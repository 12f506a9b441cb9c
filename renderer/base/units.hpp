// Quantities with their unit in the type, for public borders. Kernels work on plain radians and name their units.
#pragma once

#include <compare>
#include <numbers>

namespace vesper {

/// A number with a physical dimension, held in the unit that is named in the aliases below.
/// Written `3.0 * deg`, read back `angle.to(arcmin)`.
template <class Dimension> class Quantity {
public:
  constexpr Quantity() = default;
  /// The value in another unit of the same dimension.
  [[nodiscard]] constexpr double to(Quantity unit) const { return value_ / unit.value_; }

  friend constexpr Quantity operator*(double factor, Quantity q) { return Quantity(factor * q.value_); }
  friend constexpr Quantity operator*(Quantity q, double factor) { return Quantity(factor * q.value_); }
  friend constexpr Quantity operator/(Quantity q, double divisor) { return Quantity(q.value_ / divisor); }
  friend constexpr double operator/(Quantity a, Quantity b) { return a.value_ / b.value_; }
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.value_ + b.value_); }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.value_ - b.value_); }
  friend constexpr Quantity operator-(Quantity a) { return Quantity(-a.value_); }
  friend constexpr auto operator<=>(Quantity, Quantity) = default; // NOLINT(modernize-use-nullptr)

  /// The unit that a dimension is held in. Every other unit is a multiple of it.
  static constexpr Quantity base_unit() { return Quantity(1.0); }

private:
  constexpr explicit Quantity(double value) : value_(value) {}
  double value_ = 0.0;
};

using Angle = Quantity<struct AngleDimension>;             ///< held in radians
using Length = Quantity<struct LengthDimension>;           ///< held in metres
using Luminance = Quantity<struct LuminanceDimension>;     ///< held in cd/m2
using Illuminance = Quantity<struct IlluminanceDimension>; ///< held in lux

inline constexpr Angle rad = Angle::base_unit();
inline constexpr Angle deg = std::numbers::pi / 180.0 * rad;
inline constexpr Angle arcmin = deg / 60.0;
inline constexpr Angle arcsec = deg / 3600.0;
inline constexpr Angle milliarcsec = arcsec / 1000.0;

inline constexpr Length metre = Length::base_unit();
inline constexpr Length kilometre = 1000.0 * metre;
/// IAU 2012 resolution B2.
inline constexpr Length astronomical_unit = 149597870700.0 * metre;

inline constexpr Luminance candela_per_m2 = Luminance::base_unit();
inline constexpr Illuminance lux = Illuminance::base_unit();

} // namespace vesper
