// Where a smooth function of time is least and where it crosses zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace vesper {

/// The zero of `f` between a and b, where its values fa and fb differ in sign: false position with Illinois' halving,
/// until the bracket or the step is below `tolerance`.
template <class Function>
[[nodiscard]] double zero_between(Function&& f, double a, double fa, double b, double fb, double tolerance) {
  double x = b;
  for (int i = 0; i < 100 && std::abs(b - a) > tolerance; ++i) {
    const double before = x;
    x = b - fb * (b - a) / (fb - fa);
    const double fx = f(x);
    if (fx == 0.0 || (i > 0 && std::abs(x - before) < 0.01 * tolerance)) {
      return x;
    }
    if ((fx < 0.0) != (fb < 0.0)) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = x;
    fb = fx;
  }
  return x;
}

/// The first zero that is met from `start`, where `f` must be negative, in steps of `step` (negative: backwards) no
/// farther than `limit`, to a millisecond when x counts seconds; empty where `f` stays negative or begins positive.
template <class Function>
[[nodiscard]] std::optional<double> first_crossing(Function&& f, double start, double step, double limit) {
  constexpr double tolerance = 1e-3;
  double a = start;
  double fa = f(a);
  while (fa < 0.0 && std::abs(a - start) < limit) {
    const double b = a + step;
    const double fb = f(b);
    if (fb >= 0.0) {
      return zero_between(f, a, fa, b, fb, tolerance);
    }
    a = b;
    fa = fb;
  }
  return std::nullopt;
}

/// The minimum near `x` of a function that is nearly a parabola (a squared distance), by vertices of ever narrower
/// parabolas.
/// \param step first half-width, `least_step` the last: the result's error is about least_step^2 times f'''/(6 f'')
template <class Function> [[nodiscard]] double minimum_near(Function&& f, double x, double step, double least_step) {
  for (int i = 0; i < 60; ++i) {
    const double before = f(x - step);
    const double after = f(x + step);
    const double curvature = before - 2.0 * f(x) + after;
    const double slope = after - before;
    // Where the function is no valley, downhill by a step.
    const double move = curvature > 0.0 ? std::clamp(-0.5 * step * slope / curvature, -4.0 * step, 4.0 * step)
                                        : std::copysign(step, -slope);
    x += move;
    if (std::abs(move) < step) {
      if (step == least_step) {
        return x;
      }
      step = std::max(step / 12.0, least_step);
    }
  }
  return x;
}

} // namespace vesper
