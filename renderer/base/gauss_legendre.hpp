// Gauss and Legendre's rule of integration.
#pragma once

#include <cstddef>
#include <vector>

namespace vesper {

/// A place in [0, 1] and its weight; weights sum to 1.
struct QuadratureNode {
  double place;
  double weight;
};

/// The rule that is exact for polynomials of degree 2 count - 1, by Newton's method from Tricomi's first guess (Press
/// et al. 2007, Numerical Recipes, sec. 4.6). Descending places. \param count at least 1
[[nodiscard]] std::vector<QuadratureNode> gauss_legendre(std::size_t count);

} // namespace vesper
