#include "vesper/base/gauss_legendre.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {

std::vector<QuadratureNode> gauss_legendre(std::size_t count) {
  std::vector<QuadratureNode> nodes;
  const auto n = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double last = 1.0;
      double value = x;
      for (std::size_t k = 2; k <= count; ++k) {
        const auto degree = static_cast<double>(k);
        last = std::exchange(value, ((2.0 * degree - 1.0) * x * value - (degree - 1.0) * last) / degree);
      }
      slope = n * (x * value - last) / (x * x - 1.0);
      const double step = value / slope;
      x -= step;
      if (std::abs(step) < 1.0e-15) {
        break;
      }
    }
    nodes.push_back({0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return nodes;
}

} // namespace vesper
