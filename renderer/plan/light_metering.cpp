#include "vesper/plan/light_metering.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace vesper {
namespace {

/// Cells across the shorter side: a degree each, but not so few that a narrow field is one cell, nor so many that small
/// pictures have no pixel for each.
constexpr double fewest_cells = 24.0;
constexpr double most_cells = 120.0;
/// And along the longer one, in pictures that are next to a line.
constexpr double most_cells_along = 4096.0;
/// Samples of a picture, about.
constexpr double all_samples = 65536.0;
constexpr int most_samples = 8;

double field_deg(const View& view) {
  switch (view.projection) {
  case Projection::equirectangular:
    return 180.0;
  case Projection::cubemap:
    return 90.0;
  default:
    return view.fov.to(deg);
  }
}

/// Cells darker than the mean brightness by this factor count as that dark: black says nothing.
constexpr double darkest_share = 1.0 / 300.0;

Luminance field_luminance(const LightHistogram::Bins& bins) {
  double cube_root = 0.0;
  double lit = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    cube_root += bins.at(i) * std::cbrt(f64::tone_bin_luminance(static_cast<double>(i)));
    lit += bins.at(i);
  }
  if (cube_root <= 0.0) {
    return {};
  }
  const double darkest = darkest_share * cube_root * cube_root * cube_root;
  double sum = std::max(1.0 - lit, 0.0) * std::log(darkest);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    sum += bins.at(i) * std::log(std::max(f64::tone_bin_luminance(static_cast<double>(i)), darkest));
  }
  return std::exp(sum) * candela_per_m2;
}

} // namespace

MeteringGrid metering_grid(const View& view) {
  const double least_side = std::min(view.width, view.height);
  const double most = most_cells_along * least_side / std::max(view.width, view.height);
  const double shorter = std::min(std::clamp(std::round(field_deg(view)), fewest_cells, most_cells), most);
  MeteringGrid grid;
  grid.columns = std::max(static_cast<int>(std::lround(shorter * view.width / least_side)), 1);
  grid.rows = std::max(static_cast<int>(std::lround(shorter * view.height / least_side)), 1);
  const double cells = static_cast<double>(grid.columns) * grid.rows;
  grid.samples = std::clamp(static_cast<int>(std::lround(std::sqrt(all_samples / cells))), 2, most_samples);
  return grid;
}

void add_to(LightHistogram::Bins& bins, double luminance_cd_m2, double share) {
  const double place = f64::tone_bin(luminance_cd_m2);
  const double low = std::floor(place);
  const double above = place - low;
  if (low >= 0.0) {
    bins.at(static_cast<std::size_t>(low)) += (1.0 - above) * share;
  }
  if (low >= -1.0 && low + 1.0 < f64::tone_bins) {
    bins.at(static_cast<std::size_t>(low + 1.0)) += above * share;
  }
}

AdaptationState adapted_to(const LightHistogram& histogram) {
  return {field_luminance(histogram.seen), field_luminance(histogram.scotopic)};
}

std::vector<AdaptationState> adapt(std::span<const MeteredInstant> sequence) {
  std::vector<AdaptationState> states;
  states.reserve(sequence.size());
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const AdaptationState& field = sequence[i].field;
    if (i == 0) {
      states.push_back(field);
      continue;
    }
    const double elapsed = sequence[i].seconds - sequence[i - 1].seconds;
    if (!(elapsed >= 0.0)) {
      throw Error(ErrorKind::argument,
                  fmt::format("instant {} of the sequence, {} s, is before the one at {} s", i, sequence[i].seconds,
                              sequence[i - 1].seconds),
                  {"", "", "Give the instants in order of time"});
    }
    const AdaptationState& last = states.back();
    const f64::vec2 state = f64::adapted({field.cones.to(candela_per_m2), field.rods.to(candela_per_m2)},
                                         {last.cones.to(candela_per_m2), last.rods.to(candela_per_m2)}, elapsed);
    states.push_back({state.x * candela_per_m2, state.y * candela_per_m2});
  }
  return states;
}

} // namespace vesper
