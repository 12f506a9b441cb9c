#include "vesper/astro/refraction.hpp"
#include "vesper/astro/refraction_trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vesper {
namespace {

constexpr int below = f64::refraction_intervals_below;
constexpr int above = f64::refraction_intervals_above;
constexpr int last = below + above;
constexpr std::size_t node_count = std::size_t{last} + 1;

/// The bend has its limit at the zenith within 1e-7 of what it is at this sine, where it still can be divided.
constexpr double next_to_the_pole = 1.0 - 1.0e-7;

using Nodes = std::array<double, node_count>;
double& at(Nodes& nodes, int i) { return nodes.at(static_cast<std::size_t>(i)); }

/// Sine of the altitude of a node.
double sine_of(int node, double horizon, const f64::vec2& scale) {
  if (node == 0 || node == last) {
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
Nodes slopes_of(const Nodes& bends, const f64::vec2& scale) {
  Nodes slopes{};
  for (int i = 0; i < below; ++i) {
    at(slopes, i) = scale.x * slope_at(bends.data(), below + 1, i);
  }
  for (int i = below; i <= last; ++i) {
    at(slopes, i) = scale.y * slope_at(bends.data() + below, above + 1, i - below);
  }
  return slopes;
}

/// Altitude seen at a true one, from the half of the table that leads from apparent to true altitudes.
double solved_apparent_rad(double true_altitude, double start, const RefractionTable& table) {
  const f64::sampler1D sampler = refraction_sampler(table);
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

/// The bends at apparent altitudes: traced down to the horizon and carried on below.
void trace_apparent_half(const RefractionTracer& tracer, RefractionTable& table) {
  const f64::RefractionFrame& frame = table.frame;
  const auto sine_at = [&](int node) { return sine_of(node, frame.horizon_apparent, frame.scale_apparent); };
  Nodes bends{};
  for (int node = below; node <= last; ++node) {
    const double altitude =
        node == below ? table.horizon.to(rad) : altitude_rad(std::min(sine_at(node), next_to_the_pole));
    at(bends, node) = tracer.trace(altitude * rad).refraction.to(rad) / std::cos(altitude);
  }
  // No light comes from below: go on with the horizon's slope and level out, the refraction vanishing at the nadir
  // with the cosine of the altitude.
  const double slope = frame.scale_apparent.y * slope_at(&at(bends, below), above + 1, 0);
  for (int node = 0; node < below; ++node) {
    const double depth = (frame.horizon_apparent - sine_at(node)) / f64::refraction_width;
    at(bends, node) = at(bends, below) - slope * depth / (1.0 + depth);
  }
  const Nodes slopes = slopes_of(bends, frame.scale_apparent);
  for (std::size_t i = 0; i < node_count; ++i) {
    table.texels[i].x = bends.at(i);
    table.texels[i].y = slopes.at(i);
  }
}

/// The bends at true altitudes, which lead back along the other half.
void invert_into_true_half(RefractionTable& table) {
  const f64::RefractionFrame& frame = table.frame;
  Nodes bends{};
  double apparent = -0.5 * std::numbers::pi;
  for (int node = 0; node <= last; ++node) {
    const double sine = sine_of(node, frame.horizon_true, frame.scale_true);
    const double altitude = altitude_rad(std::clamp(sine, -next_to_the_pole, next_to_the_pole));
    apparent = solved_apparent_rad(altitude, std::max(apparent, altitude), table);
    at(bends, node) = (apparent - altitude) / std::cos(altitude);
  }
  const Nodes slopes = slopes_of(bends, frame.scale_true);
  for (std::size_t i = 0; i < node_count; ++i) {
    table.texels[i].z = bends.at(i);
    table.texels[i].w = slopes.at(i);
  }
}

} // namespace

RefractionTable make_refraction_table(const RefractionConditions& conditions) {
  const RefractionTracer tracer(conditions, fast_trace);
  RefractionTable table;
  table.conditions = conditions;
  table.horizon = tracer.horizon();
  table.texels.resize(node_count);
  f64::RefractionFrame& frame = table.frame;
  frame.kind = f64::refraction_traced;
  frame.strength = 1.0;
  frame.horizon_apparent = std::sin(table.horizon.to(rad));
  frame.horizon_true = std::sin((table.horizon - tracer.trace(table.horizon).refraction).to(rad));
  frame.scale_apparent = scale_for(frame.horizon_apparent);
  frame.scale_true = scale_for(frame.horizon_true);
  trace_apparent_half(tracer, table);
  invert_into_true_half(table);
  return table;
}

} // namespace vesper
