#include "vesper/astro/refraction.hpp"
#include "vesper/astro/refraction_trace.hpp"

#include <array>
#include <cmath>

namespace vesper {
namespace {

constexpr int below = f64::refraction_intervals_below;
constexpr int above = f64::refraction_intervals_above;
constexpr auto node_count = static_cast<std::size_t>(below + above + 1);

/// Sine of the altitude of a node.
double sine_of(int node, double horizon, const f64::vec2& scale) {
  if (node == 0 || node == below + above) {
    return node == 0 ? -1.0 : 1.0;
  }
  return horizon + f64::refraction_width * std::sinh((node - below) / (node < below ? scale.x : scale.y));
}

f64::vec2 scale_for(double horizon) {
  return {below / f64::arc_sinh((1.0 + horizon) / f64::refraction_width),
          above / f64::arc_sinh((1.0 - horizon) / f64::refraction_width)};
}

double altitude_rad(double sine) { return std::atan2(sine, std::sqrt((1.0 - sine) * (1.0 + sine))); }

/// Derivative of values at equal unit steps, to the fourth order; one-sided at both ends.
double slope_at(const double* values, int count, int i) {
  if (i >= 2 && i <= count - 3) {
    return (values[i - 2] - values[i + 2] + 8.0 * (values[i + 1] - values[i - 1])) / 12.0;
  }
  const bool left = i < 2;
  const auto v = [&](int k) { return left ? values[k] : values[count - 1 - k]; };
  const int k = left ? i : count - 1 - i;
  const double slope = k == 0 ? (-25.0 * v(0) + 48.0 * v(1) - 36.0 * v(2) + 16.0 * v(3) - 3.0 * v(4)) / 12.0
                              : (-3.0 * v(0) - 10.0 * v(1) + 18.0 * v(2) - 6.0 * v(3) + v(4)) / 12.0;
  return left ? slope : -slope;
}

/// Slopes by arc_sinh on both sides of the horizon; at it the upper side's, so that the curve has no corner.
std::array<double, node_count> slopes_of(const std::array<double, node_count>& bends, const f64::vec2& scale) {
  std::array<double, node_count> slopes{};
  for (int i = 0; i < below; ++i) {
    slopes.at(static_cast<std::size_t>(i)) = scale.x * slope_at(bends.data(), below + 1, i);
  }
  for (int i = 0; i <= above; ++i) {
    slopes.at(static_cast<std::size_t>(below + i)) = scale.y * slope_at(bends.data() + below, above + 1, i);
  }
  return slopes;
}

/// Altitude seen at a true one, from the half of the table that leads from apparent to true altitudes.
double solved_apparent_rad(double true_altitude, double start, const RefractionTable& table) {
  const f64::sampler1D sampler{table.texels.data(), static_cast<int>(table.texels.size())};
  const auto excess = [&](double apparent) {
    const double bend = f64::table_bend(std::sin(apparent), true, table.frame, sampler);
    return apparent - bend * std::cos(apparent) - true_altitude;
  };
  constexpr double step = 1.0e-6;
  double apparent = start;
  for (int i = 0; i < 20; ++i) {
    const double correction = excess(apparent) * 2.0 * step / (excess(apparent + step) - excess(apparent - step));
    apparent -= correction;
    if (std::abs(correction) < 1.0e-11) {
      break;
    }
  }
  return apparent;
}

} // namespace

RefractionTable make_refraction_table(const RefractionConditions& conditions) {
  const RefractionTracer tracer(conditions, TraceQuality::fast);
  RefractionTable table;
  table.conditions = conditions;
  table.horizon = tracer.horizon();
  const double horizon = table.horizon.to(rad);
  const double grazing = tracer.trace(table.horizon).refraction.to(rad);
  f64::RefractionFrame& frame = table.frame;
  frame.kind = f64::refraction_traced;
  frame.strength = 1.0;
  frame.horizon_apparent = std::sin(horizon);
  frame.horizon_true = std::sin(horizon - grazing);
  frame.scale_apparent = scale_for(frame.horizon_apparent);
  frame.scale_true = scale_for(frame.horizon_true);
  table.texels.resize(node_count);

  std::array<double, node_count> bends{};
  const auto bend_at = [&](int node) -> double& { return bends.at(static_cast<std::size_t>(node)); };
  for (int node = below; node <= below + above; ++node) {
    // Next to the zenith the bend has its limit within 1e-7 of itself.
    const double sine = std::min(sine_of(node, frame.horizon_apparent, frame.scale_apparent), 1.0 - 1.0e-7);
    const double altitude = node == below ? horizon : altitude_rad(sine);
    bend_at(node) = tracer.trace(altitude * rad).refraction.to(rad) / std::cos(altitude);
  }
  // No light comes from below: go on with the horizon's slope and level out, the refraction vanishing at the nadir
  // with the cosine of the altitude.
  const double slope = frame.scale_apparent.y / f64::refraction_width * slope_at(&bend_at(below), above + 1, 0);
  for (int node = 0; node < below; ++node) {
    const double depth =
        (frame.horizon_apparent - sine_of(node, frame.horizon_apparent, frame.scale_apparent)) / f64::refraction_width;
    bend_at(node) = bend_at(below) - slope * f64::refraction_width * depth / (1.0 + depth);
  }
  std::array<double, node_count> slopes = slopes_of(bends, frame.scale_apparent);
  for (std::size_t i = 0; i < node_count; ++i) {
    table.texels[i].x = bends.at(i);
    table.texels[i].y = slopes.at(i);
  }

  double apparent = -0.5 * std::numbers::pi;
  for (int node = 0; node <= below + above; ++node) {
    const double sine =
        std::min(std::max(sine_of(node, frame.horizon_true, frame.scale_true), 1.0e-7 - 1.0), 1.0 - 1.0e-7);
    const double altitude = altitude_rad(sine);
    apparent = solved_apparent_rad(altitude, std::max(apparent, altitude), table);
    bend_at(node) = (apparent - altitude) / std::cos(altitude);
  }
  slopes = slopes_of(bends, frame.scale_true);
  for (std::size_t i = 0; i < node_count; ++i) {
    table.texels[i].z = bends.at(i);
    table.texels[i].w = slopes.at(i);
  }
  return table;
}

} // namespace vesper
