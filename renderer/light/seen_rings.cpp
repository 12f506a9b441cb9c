#include "vesper/light/seen_rings.hpp"

#include "vesper/base/gauss_legendre.hpp"
#include "vesper/base/shader_math.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vesper {

SeenRings rings_past_disc(double radius, double distance, double inner, double outer) {
  using std::numbers::pi;
  const double first = std::clamp(std::abs(distance - radius), inner, outer);
  const double last = std::clamp(distance + radius, inner, outer);
  SeenRings seen{distance >= radius ? first : inner, last, {}};
  static const std::vector<QuadratureNode> rule = gauss_legendre(seen.crossed.size());
  for (std::size_t i = 0; i < rule.size(); ++i) {
    // Nodes crowd at both ends, where arcs and brightness change as square roots.
    const double r = first + (last - first) * 0.5 * (1.0 - std::cos(pi * rule[i].place));
    const double width = (last - first) * 0.5 * pi * std::sin(pi * rule[i].place) * rule[i].weight;
    seen.crossed.at(i) = {r, width * (1.0 - f64::common_chord_half_angle(r, radius, distance) / pi)};
  }
  return seen;
}

} // namespace vesper
