#include "vesper/light/star_color.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/photometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vesper {
namespace {

constexpr double steps_per_magnitude = 100.0;
constexpr std::size_t steps = 640;
static_assert(min_star_b_v + static_cast<double>(steps) / steps_per_magnitude == max_star_b_v);

struct Entry {
  Xyzs color;
  double lux_ratio = 0;
};
using Table = std::array<Entry, steps + 1>;

double in_range(double b_v) {
  if (!std::isfinite(b_v)) {
    throw Error(ErrorKind::argument, "the colour index B-V is not finite", {"", "", "Give a number"});
  }
  return std::clamp(b_v, min_star_b_v, max_star_b_v);
}

Table make_table() {
  Table table;
  const double a0 = lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  for (std::size_t i = 0; i <= steps; ++i) {
    const Spectrum spectrum =
        planck_spectrum(star_temperature_k(min_star_b_v + static_cast<double>(i) / steps_per_magnitude));
    const Xyzs light = integrate_xyzs(spectrum);
    table[i].color = {light.x / light.y, 1.0, light.z / light.y, light.s / light.y};
    table[i].lux_ratio = light.y / integrate_v_band(spectrum) / a0;
  }
  return table;
}

Entry look_up(double b_v) {
  static const Table table = make_table();
  const double at = (in_range(b_v) - min_star_b_v) * steps_per_magnitude;
  const std::size_t i = std::min(static_cast<std::size_t>(at), steps - 1);
  const double t = at - static_cast<double>(i);
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  const Entry& a = table[i];
  const Entry& b = table[i + 1];
  return {{mix(a.color.x, b.color.x), 1.0, mix(a.color.z, b.color.z), mix(a.color.s, b.color.s)},
          mix(a.lux_ratio, b.lux_ratio)};
}

} // namespace

double star_temperature_k(double b_v) {
  const double c = 0.92 * in_range(b_v);
  return 4600.0 * (1.0 / (c + 1.7) + 1.0 / (c + 0.62));
}

Xyzs star_color(double b_v) { return look_up(b_v).color; }

double star_lux_ratio(double b_v) { return look_up(b_v).lux_ratio; }

} // namespace vesper
