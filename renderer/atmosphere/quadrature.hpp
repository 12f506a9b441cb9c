// Integrals with a bound of their error: the rule of Gauss with 7 nodes inside that of Kronrod with 15.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vesper {

struct Integral {
  double value = 0.0;
  double error = 0.0; ///< bound, beyond rounding
};

/// Nodes from the end of the interval to its middle, and their weights (Piessens et al. 1983, QUADPACK). Every second
/// node is Gauss's too.
inline constexpr std::array<double, 8> kronrod_nodes{
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144045693360, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0};
inline constexpr std::array<double, 8> kronrod_weights{
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204, 0.104790010322250183839876322541518,
    0.140653259715525918745189590510238, 0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
inline constexpr std::array<double, 8> gauss_weights{
    0.0, 0.129484966168869693270611432679082, 0.0, 0.279705391489276667901467771423780,
    0.0, 0.381830050505118944950369775488975, 0.0, 0.417959183673469387755102040816327};

/// Calls visit(x, kronrod, gauss) at each node from begin to end, with the node's weights in the two integrals. Their
/// difference bounds the error of the finer one, far from tightly, wherever the function is smooth.
template <class Visit> void visit_kronrod_nodes(double begin, double end, Visit&& visit) {
  const double middle = 0.5 * (begin + end);
  const double half = 0.5 * (end - begin);
  for (std::size_t i = 0; i < 15; ++i) {
    const std::size_t k = std::min(i, 14 - i);
    const double offset = half * kronrod_nodes[k];
    visit(i < 7 ? middle - offset : middle + offset, half * kronrod_weights[k], half * gauss_weights[k]);
  }
}

/// The integral of f, the interval halved until the two rules agree to 1e-9 of each piece or to 1e-12 (for columns in
/// km: to what no sky shows).
template <class Function> Integral integrate(const Function& f, double begin, double end, int halvings = 40) {
  double fine = 0.0;
  double coarse = 0.0;
  visit_kronrod_nodes(begin, end, [&](double x, double kronrod, double gauss) {
    const double value = f(x);
    fine += kronrod * value;
    coarse += gauss * value;
  });
  const double error = std::abs(fine - coarse);
  constexpr double relative = 1.0e-9;
  constexpr double negligible = 1.0e-12;
  if (halvings == 0 || error <= std::max(relative * std::abs(fine), negligible)) {
    return {fine, error};
  }
  const double middle = 0.5 * (begin + end);
  const Integral left = integrate(f, begin, middle, halvings - 1);
  const Integral right = integrate(f, middle, end, halvings - 1);
  return {left.value + right.value, left.error + right.error};
}

} // namespace vesper
