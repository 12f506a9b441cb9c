#include "vesper/base/sampled_function.hpp"

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

using Samples = SampledFunction::Samples;
constexpr int degree = SampledFunction::degree;
constexpr std::size_t count = SampledFunction::sample_count;

/// cos(pi j k / degree) for all samples j and polynomials k.
std::array<Samples, count> make_cosines() {
  std::array<Samples, count> cosines{};
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t k = 0; k < count; ++k) {
      // The angle within one turn keeps the ends and the middle exact.
      const auto turns = static_cast<double>(j * k % (2 * std::size_t{degree})) / degree;
      cosines[j][k] = std::cos(std::numbers::pi * turns);
    }
  }
  return cosines;
}

const std::array<Samples, count>& cosines() {
  static const std::array<Samples, count> table = make_cosines();
  return table;
}

/// Clenshaw's recurrence for a sum of Chebyshev polynomials.
double sum_at(const Samples& coefficients, double x) {
  double next = 0.0;
  double after = 0.0;
  for (std::size_t k = count - 1; k > 0; --k) {
    const double here = coefficients[k] + 2.0 * x * next - after;
    after = next;
    next = here;
  }
  return coefficients[0] + x * next - after;
}

/// Coefficients of the derivative: c'_(k-1) = c'_(k+1) + 2 k c_k.
Samples differentiated(const Samples& c) {
  Samples d{};
  for (std::size_t k = count - 1; k > 0; --k) {
    d[k - 1] = (k + 1 < count ? d[k + 1] : 0.0) + 2.0 * static_cast<double>(k) * c[k];
  }
  d[0] *= 0.5;
  return d;
}

/// No Chebyshev polynomial exceeds 1 on [-1, 1].
double bound_of(const Samples& coefficients) {
  double sum = 0.0;
  for (const double c : coefficients) {
    sum += std::abs(c);
  }
  return sum;
}

} // namespace

const Samples& SampledFunction::points() {
  static const Samples ascending = [] {
    Samples points{};
    for (std::size_t j = 0; j < count; ++j) {
      points[j] = cosines()[degree - j][1];
    }
    return points;
  }();
  return ascending;
}

SampledFunction::SampledFunction(const Samples& samples) : first_(samples.front()), last_(samples.back()) {
  for (std::size_t k = 0; k < count; ++k) {
    const Samples& cosine = cosines()[k];
    double sum = 0.5 * (samples[degree] + cosine[degree] * samples[0]);
    for (std::size_t j = 1; j < degree; ++j) {
      sum += cosine[j] * samples[degree - j];
    }
    coefficients_[k] = sum * (k == 0 || k == degree ? 1.0 : 2.0) / degree;
  }
  slope_coefficients_ = differentiated(coefficients_);
  slope_bound_ = bound_of(slope_coefficients_);
  curvature_bound_ = bound_of(differentiated(slope_coefficients_));
}

double SampledFunction::value(double x) const {
  if (x == -1.0) {
    return first_;
  }
  return x == 1.0 ? last_ : sum_at(coefficients_, x);
}

double SampledFunction::slope(double x) const { return sum_at(slope_coefficients_, x); }

SampledFunction SampledFunction::derivative() const {
  SampledFunction d;
  d.coefficients_ = slope_coefficients_;
  d.slope_coefficients_ = differentiated(slope_coefficients_);
  d.first_ = slope(-1.0);
  d.last_ = slope(1.0);
  d.slope_bound_ = curvature_bound_;
  d.curvature_bound_ = bound_of(differentiated(d.slope_coefficients_));
  return d;
}

bool SampledFunction::positive_before(double x) const {
  const double here = value(x);
  return here > 0.0 || (here == 0.0 && slope(x) < 0.0);
}

double SampledFunction::zero_between(End from, End to) const {
  double low = from.x;
  double high = to.x;
  double x = 0.5 * (low + high);
  // Newton's step where it stays inside the bracket, else its half; the piece is monotone, so a handful suffice.
  constexpr int enough_to_halve_to_rounding = 60;
  for (int i = 0; i < enough_to_halve_to_rounding; ++i) {
    const double here = value(x);
    if (here == 0.0) {
      return x;
    }
    ((here > 0.0) == from.positive ? low : high) = x;
    const double newton = x - here / slope(x);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - x) <= 1e-15) {
      return next;
    }
    x = next;
  }
  return x;
}

void SampledFunction::collect(End from, End to, std::vector<SignChange>& changes) const {
  constexpr double resolution = 1e-8;
  constexpr double rounding = 1e-15; // of a function of order one: no sign is to be had below it
  const double middle = 0.5 * (from.x + to.x);
  const double half = 0.5 * (to.x - from.x);
  const double here = value(middle);
  if (std::abs(here) > slope_bound_ * half) {
    return;
  }
  const bool monotone = std::abs(slope(middle)) > curvature_bound_ * half;
  if (monotone || half < resolution || slope_bound_ * half < rounding) {
    if (from.positive != to.positive) {
      changes.push_back({zero_between(from, to), to.positive});
    }
    return;
  }
  const End between{middle, positive_before(middle)};
  collect(from, between, changes);
  collect(between, to, changes);
}

std::vector<SampledFunction::SignChange> SampledFunction::sign_changes() const {
  std::vector<SignChange> changes;
  collect({-1.0, positive_before(-1.0)}, {1.0, positive_before(1.0)}, changes);
  return changes;
}

} // namespace vesper
