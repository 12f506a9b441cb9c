#include "vesper/atmosphere/transport_guide.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

/// Heights go as the power of their number: half of them lie in the lowest sixth of the air.
constexpr double height_power = 2.5;

constexpr double lookup_step_km = 0.05;

} // namespace

TransportGuide::TransportGuide(const SampledAir& air, const SpectralAir& optics, std::vector<std::size_t> wavelengths,
                               unsigned threads)
    : air_(air), optics_(optics), wavelengths_(std::move(wavelengths)) {
  for (std::size_t i = 0; i < heights; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(heights - 1);
    heights_km_[i] = (air.top_km() - air.ground_km()) * std::pow(share, height_power);
    // Bins crowd at the horizon of this height.
    const double radius_km = air.ground_km() + heights_km_[i];
    const double dip = std::acos(std::min(1.0, air.ground_km() / radius_km));
    std::array<double, zenith_bins + 1>& edges = zenith_edges_[i];
    for (std::size_t j = 0; j <= below_bins; ++j) {
      const double t = 1.0 - static_cast<double>(j) / below_bins;
      edges[j] = std::sin(-dip - (0.5 * pi - dip) * t * t);
    }
    for (std::size_t j = 1; j <= above_bins; ++j) {
      const double t = static_cast<double>(j) / above_bins;
      edges[below_bins + j] = std::sin(-dip + (0.5 * pi + dip) * t * t);
    }
    edges.front() = -1.0;
    edges.back() = 1.0;
  }
  for (std::size_t i = 0, below = 0; static_cast<double>(i) * lookup_step_km <= heights_km_.back(); ++i) {
    while (below + 2 < heights && heights_km_[below + 1] <= static_cast<double>(i) * lookup_step_km) {
      ++below;
    }
    height_below_.push_back(static_cast<unsigned char>(below));
  }
  solve_beam(threads);
  solve_scattered(threads);
}

TransportGuide::HeightPlace TransportGuide::height_place(double height_km) const {
  const double height = std::clamp(height_km, 0.0, heights_km_.back());
  std::size_t below = height_below_[static_cast<std::size_t>(height / lookup_step_km)];
  while (below + 2 < heights && heights_km_[below + 1] <= height) {
    ++below;
  }
  return {below, (height - heights_km_[below]) / (heights_km_[below + 1] - heights_km_[below])};
}

TransportGuide::Light TransportGuide::light(double radius_km, double cos_light_zenith) const {
  const Corner place = corner(height_place(radius_km - air_.ground_km()), cos_light_zenith);
  return {between(beam_, place), between(scattered_, place)};
}

TransportGuide::Values TransportGuide::on_ground(const std::vector<Values>& by_angle, double cos_light_zenith) {
  const Corner place = corner({0, 0.0}, cos_light_zenith);
  const Values* row = &by_angle[place.angle];
  Values result{};
  for (std::size_t k = 0; k < most_wavelengths; ++k) {
    result[k] = row[0][k] + place.angle_fraction * (row[1][k] - row[0][k]);
  }
  return result;
}

TransportGuide::Values TransportGuide::ground_irradiance(double cos_light_zenith) const {
  return on_ground(ground_, cos_light_zenith);
}

double TransportGuide::cos_light_zenith(std::size_t angle) {
  return 2.0 * static_cast<double>(angle) / static_cast<double>(angles - 1) - 1.0;
}

double TransportGuide::bin_cos_zenith(std::size_t height, std::size_t zenith_bin) const {
  return 0.5 * (zenith_edges_[height][zenith_bin] + zenith_edges_[height][zenith_bin + 1]);
}

double TransportGuide::bin_sr(std::size_t height, std::size_t zenith_bin) const {
  return 2.0 * pi / azimuth_bins * (zenith_edges_[height][zenith_bin + 1] - zenith_edges_[height][zenith_bin]);
}

std::size_t TransportGuide::cell(double radius_km, double cos_light_zenith) const {
  const HeightPlace at = height_place(radius_km - air_.ground_km());
  const std::size_t height = at.below + (at.fraction < 0.5 ? 0 : 1);
  const double place = std::clamp(0.5 * (cos_light_zenith + 1.0), 0.0, 1.0) * static_cast<double>(angles - 1);
  return height * angles + static_cast<std::size_t>(std::lround(place));
}

bool TransportGuide::lit(std::size_t cell, std::size_t k) const {
  return cumulative_[(cell * wavelengths_.size() + k + 1) * bins - 1] > 0.0F;
}

TransportGuide::Direction TransportGuide::sample(std::size_t cell, std::size_t k, RandomStream& random) const {
  const float* begin = &cumulative_[(cell * wavelengths_.size() + k) * bins];
  const auto bin = static_cast<std::size_t>(std::min<std::ptrdiff_t>(
      std::upper_bound(begin, begin + bins, random(),
                       [](double value, float sum) { return value < static_cast<double>(sum); }) -
          begin,
      bins - 1));
  const std::size_t zenith = bin / azimuth_bins;
  const std::array<double, zenith_bins + 1>& edges = zenith_edges_[cell / angles];
  const double cos_zenith = edges[zenith] + random() * (edges[zenith + 1] - edges[zenith]);
  // On either side of the light's vertical plane.
  const double across = 2.0 * random() - 1.0;
  const double azimuth_rad = pi * (static_cast<double>(bin % azimuth_bins) + std::abs(across)) / azimuth_bins;
  return {cos_zenith, std::copysign(azimuth_rad, across)};
}

std::size_t TransportGuide::zenith_bin(std::size_t height, double cos_zenith) const {
  const std::array<double, zenith_bins + 1>& edges = zenith_edges_[height];
  const auto* const above = std::upper_bound(edges.begin() + 1, edges.end() - 1, cos_zenith);
  return static_cast<std::size_t>(above - edges.begin()) - 1;
}

TransportGuide::Values TransportGuide::density(std::size_t cell, Direction direction) const {
  const std::size_t height = cell / angles;
  const std::size_t zenith = zenith_bin(height, direction.cos_zenith);
  const auto azimuth =
      std::min(static_cast<std::size_t>(std::abs(direction.azimuth_rad) / pi * azimuth_bins), azimuth_bins - 1);
  const std::size_t bin = zenith * azimuth_bins + azimuth;
  const double solid_angle_sr = bin_sr(height, zenith);
  Values result{};
  for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
    const float* row = &cumulative_[(cell * wavelengths_.size() + k) * bins];
    const double share = static_cast<double>(row[bin]) - (bin > 0 ? static_cast<double>(row[bin - 1]) : 0.0);
    result[k] = share / solid_angle_sr;
  }
  return result;
}

} // namespace vesper
