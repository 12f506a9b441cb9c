#include "vesper/light/corona.hpp"

#include "vesper/base/shader_math.hpp"
#include "vesper/light/seen_rings.hpp"
#include "vesper/light/solar_disc.hpp"

#include <cmath>

namespace vesper {
namespace {

/// The light of brightness r^-power between two radii, over the area of a circle of radius 1.
double between(double from, double to, double power) {
  return 2.0 / (power - 2.0) * (std::pow(from, 2.0 - power) - std::pow(to, 2.0 - power));
}

CoronaLight ring(double from, double to) {
  return {f64::k_corona_inner * between(from, to, 17.0) + f64::k_corona_outer * between(from, to, 7.0),
          f64::f_corona_all * between(from, to, 2.5)};
}

} // namespace

double corona_unit() { return 1.0e-6 / solar_disc_mean(550.0); }

double dust_reddening(double wavelength_nm) {
  const double decades = std::log10(wavelength_nm / 500.0);
  return 1.0 + (decades < 0.0 ? 0.8 : 1.2) * decades;
}

CoronaLight corona_seen(double sun, double other, double separation) {
  const SeenRings rings = rings_past_disc(other / sun, separation / sun, 1.0, f64::corona_edge);
  const CoronaLight near = ring(1.0, rings.inside_until);
  const CoronaLight far = ring(rings.outside_from, f64::corona_edge);
  double electrons = near.electrons + far.electrons;
  double dust = near.dust + far.dust;
  for (const SeenRings::Node& node : rings.crossed) {
    electrons += 2.0 * node.radius * node.weight * f64::k_corona(node.radius);
    dust += 2.0 * node.radius * node.weight * f64::f_corona(node.radius);
  }
  const double unit = corona_unit();
  return {unit * electrons, unit * dust};
}

} // namespace vesper
