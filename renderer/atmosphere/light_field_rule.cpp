// The directions from which the solver gathers light, and what it weighs in aerosol's sources.
#include "vesper/atmosphere/light_field_model.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/base/sine.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper {
namespace {

using std::numbers::pi;

} // namespace

LightRule LightFieldModel::first_rule(unsigned threads) const {
  return rule(size_.zeniths, size_.azimuths, 0.4 * size_.step_growth, 0.4 * size_.least_step_km, threads);
}

LightRule LightFieldModel::later_rule(unsigned threads) const {
  return rule(size_.later_zeniths, size_.later_azimuths, size_.step_growth, size_.least_step_km, threads);
}

LightRule LightFieldModel::rule(std::size_t zeniths, std::size_t azimuths, double growth, double least_km,
                                unsigned threads) const {
  LightRule rule{zeniths, azimuths, std::vector<LightRay>(size_.heights * zeniths), {}, {}};
  // Azimuths over half a turn crowd at the light, zenith angles at each height's own horizon.
  const std::vector<QuadratureNode> turn = gauss_legendre(azimuths);
  const std::size_t below = zeniths * 2 / 5;
  const std::vector<QuadratureNode> rule_below = gauss_legendre(below);
  const std::vector<QuadratureNode> rule_above = gauss_legendre(zeniths - below);
  const auto single = [](double x) { return static_cast<float>(x); };
  for (std::size_t i = 0; i < size_.heights; ++i) {
    const double depression = dip(air_.ground_km() + node_height_km(i));
    for (std::size_t d = 0; d < zeniths; ++d) {
      const QuadratureNode& node = d < below ? rule_below[d] : rule_above[d - below];
      const double range = d < below ? -(0.5 * pi - depression) : 0.5 * pi + depression;
      const double altitude = -depression + range * node.place * node.place;
      const double share = std::cos(altitude) * std::abs(range) * node.place * node.weight;
      for (const QuadratureNode& side : turn) {
        const double cos_azimuth = std::cos(pi * side.place * side.place);
        rule.directions.push_back({single(std::cos(altitude) * cos_azimuth), single(std::sin(altitude)),
                                   single(share * 2.0 * side.place * side.weight), single(cos_azimuth)});
      }
    }
  }
  parallel_for(
      rule.rays.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const auto sin_altitude = static_cast<double>(rule.directions[k * azimuths].z);
          rule.rays[k] = ray(air_.ground_km() + node_height_km(k / zeniths), sin_altitude, growth, least_km);
        }
      },
      threads);
  rule.phase_matrix.resize(source_heights_ * source_directions * rule.size() * blocks_);
  parallel_for(
      source_heights_, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          add_phase_matrix(i, rule);
        }
      },
      threads);
  return rule;
}

void LightFieldModel::add_phase_matrix(std::size_t height, LightRule& rule) const {
  const double radius_km = air_.ground_km() + node_height_km(height);
  const SampledAir::PerComponent density = air_.density(radius_km);
  const std::size_t count = rule.size();
  std::vector<Lanes> shares(scatterers() * blocks_); ///< of the scatterers in what aerosol scatters
  for (std::size_t l = 0; l < optics_.size(); ++l) {
    double all = 0.0;
    for (std::size_t s = 1; s < scatterers(); ++s) {
      all += scattering_per_km(scatterers_[s], density, l);
    }
    for (std::size_t s = 1; s < scatterers(); ++s) {
      const double share =
          all > 0.0 ? scattering_per_km(scatterers_[s], density, l) / all : 1.0 / static_cast<double>(scatterers() - 1);
      shares[s * blocks_ + l / Lanes::size].values[l % Lanes::size] = static_cast<float>(share);
    }
  }
  std::vector<Lanes> row(count * blocks_);
  std::vector<Lanes> before(blocks_);
  std::vector<Lanes> behind(blocks_);
  for (std::size_t toward = 0; toward < source_directions; ++toward) {
    const double z = std::sin(source_altitude(toward / f32::source_azimuths, dip(radius_km)));
    const double azimuth_share = static_cast<double>(toward % f32::source_azimuths) / (f32::source_azimuths - 1);
    const double azimuth = 2.0 * std::asin(azimuth_share);
    for (std::size_t s = 1; s < scatterers(); ++s) {
      std::vector<Lanes> sum(blocks_);
      for (std::size_t d = 0; d < count; ++d) {
        const f32::LightDirection& from = rule.directions[height * count + d];
        const auto from_z = static_cast<double>(from.z);
        const double level = sine_of(z) * sine_of(from_z);
        const double from_azimuth = std::acos(static_cast<double>(from.cos_azimuth));
        // From both sides of the light's vertical plane.
        phase(s, std::clamp(z * from_z + level * std::cos(azimuth - from_azimuth), -1.0, 1.0), before.data());
        phase(s, std::clamp(z * from_z + level * std::cos(azimuth + from_azimuth), -1.0, 1.0), behind.data());
        for (std::size_t b = 0; b < blocks_; ++b) {
          row[d * blocks_ + b] = from.share * (before[b] + behind[b]);
          sum[b] += row[d * blocks_ + b];
        }
      }
      Lanes* matrix = &rule.phase_matrix[(height * source_directions + toward) * count * blocks_];
      for (std::size_t k = 0; k < count * blocks_; ++k) {
        // What a coarse rule makes of a peak, it shall neither take nor add light.
        matrix[k] += shares[s * blocks_ + k % blocks_] * row[k] / max(sum[k % blocks_], Lanes(1.0e-30F));
      }
    }
  }
}

} // namespace vesper
