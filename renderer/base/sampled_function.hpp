// A smooth function known by samples: its value, its slope and every place where it changes sign.
#pragma once

#include <array>
#include <vector>

namespace vesper {

/// The polynomial through samples at Chebyshev points, on [-1, 1].
///
/// Of an analytic function it is as good as the function is slow: through the 19 points used here cos(w x) holds within
/// 2e-15 for w = pi/2, 1e-13 for pi, 3e-8 for 2 pi (Trefethen 2013, Approximation Theory and Approximation Practice,
/// ch. 2, 3 and 18 for the interpolant and its derivative).
class SampledFunction {
public:
  static constexpr int degree = 18;
  static constexpr int sample_count = degree + 1;
  using Samples = std::array<double, sample_count>;

  /// Where the samples lie, ascending from exactly -1 to exactly 1.
  [[nodiscard]] static const Samples& points();

  explicit SampledFunction(const Samples& samples);

  /// \param x -1 to 1. At both ends the sample itself, to the last bit.
  [[nodiscard]] double value(double x) const;
  [[nodiscard]] double slope(double x) const;
  [[nodiscard]] SampledFunction derivative() const;

  struct SignChange {
    double x;
    bool upward; ///< from negative to positive
  };

  /// Every x where the function changes its sign, ascending, upward and downward by turns, to the rounding of a double;
  /// of changes nearer than 2e-8 to each other only an odd one out. The function is of order one: what varies by less
  /// than 1e-15 has no signs.
  ///
  /// Nothing is sampled on hope: bounds of the first two derivatives prove that a piece has no zero or one, or it is
  /// cut in two (Moore, Kearfott and Cloud 2009, Introduction to Interval Analysis, ch. 8). The sign at an end where
  /// the function is zero is the one before it, so that a zero on the border of two pieces with the same sample there
  /// belongs to the latter alone.
  [[nodiscard]] std::vector<SignChange> sign_changes() const;

private:
  struct End {
    double x;
    bool positive;
  };
  SampledFunction() = default;
  void collect(End from, End to, std::vector<SignChange>& changes) const;
  [[nodiscard]] bool positive_before(double x) const;
  [[nodiscard]] double zero_between(End from, End to) const;

  Samples coefficients_{};       ///< of the Chebyshev polynomials
  Samples slope_coefficients_{}; ///< of the derivative's
  double first_ = 0.0;
  double last_ = 0.0;
  double slope_bound_ = 0.0;     ///< no slope on [-1, 1] is larger
  double curvature_bound_ = 0.0; ///< no second derivative on [-1, 1] is larger
};

} // namespace vesper
