#include "vesper/atmosphere/light_field.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr double light_radius_rad = 0.2666 * pi / 180.0; ///< of Sun and Moon
/// Of what is dark. Smaller numbers would leave the range of a float.
constexpr float darkest = 1.0e-36F;

/// Azimuths from the light's over half a turn, crowded at the light, with weights that sum to 1.
std::vector<QuadratureNode> azimuth_rule(std::size_t count) {
  std::vector<QuadratureNode> rule = gauss_legendre(count);
  for (QuadratureNode& node : rule) {
    node.weight *= 2.0 * node.place;
    node.place *= pi * node.place;
  }
  return rule;
}

} // namespace

/// What each direction's radiance weighs in the sources toward each of the nodes' directions, by node's direction,
/// ray's direction (zenith, azimuth) and lane. \param directions cosine of the zenith angle and solid angle of the band
std::vector<float> LightField::phase_matrix(std::size_t height, const std::vector<Vec2>& directions,
                                            std::size_t azimuths) const {
  const std::vector<QuadratureNode> rule = azimuth_rule(azimuths);
  const double radius_km = air_.ground_km() + node_height_km(height);
  const SampledAir::PerComponent density = air_.density(radius_km);
  const std::size_t rays = directions.size() * azimuths;
  std::vector<float> matrix(source_directions * rays * lanes_, 0.0F);
  std::vector<double> row(rays);
  for (std::size_t toward = 0; toward < source_directions; ++toward) {
    const double z = std::sin(node_altitude(toward / azimuth_nodes, dip(radius_km)));
    const double level = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double azimuth = pi * static_cast<double>(toward % azimuth_nodes) / static_cast<double>(azimuth_nodes - 1);
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      double all = 0.0;
      for (std::size_t c = 0; c < air_.component_count(); ++c) {
        all += molecular_[c] ? 0.0 : density[c] * optics_.scattering_per_km(c, l);
      }
      for (std::size_t c = 0; c < air_.component_count() && all > 0.0; ++c) {
        const double share = molecular_[c] ? 0.0 : density[c] * optics_.scattering_per_km(c, l) / all;
        if (share == 0.0) {
          continue;
        }
        double sum = 0.0;
        for (std::size_t d = 0; d < directions.size(); ++d) {
          const double from_z = directions[d].x;
          const double from_level = std::sqrt(std::max(0.0, 1.0 - from_z * from_z));
          for (std::size_t b = 0; b < azimuths; ++b) {
            const double from = rule[b].place;
            const auto phase = [&](double between) {
              return optics_.phase(c, l, std::clamp(z * from_z + level * from_level * std::cos(between), -1.0, 1.0));
            };
            // From both sides of the light's vertical plane.
            row[d * azimuths + b] =
                directions[d].y * rule[b].weight * 0.5 * (phase(azimuth - from) + phase(azimuth + from));
            sum += row[d * azimuths + b];
          }
        }
        // What a coarse rule makes of a peak, it shall neither take nor add light.
        for (std::size_t k = 0; k < rays; ++k) {
          matrix[(toward * rays + k) * lanes_ + l] += static_cast<float>(share * row[k] / sum);
        }
      }
    }
  }
  return matrix;
}

void LightField::solve(const LightFieldSize& size, unsigned threads) {
  const std::size_t angles = angle_cos_.size();
  const std::size_t lanes = lanes_;
  const std::vector<QuadratureNode> azimuths = azimuth_rule(size.azimuths);
  // Directions crowd at each height's own horizon.
  const std::size_t below = size.zeniths * 2 / 5;
  const std::vector<QuadratureNode> rule_below = gauss_legendre(below);
  const std::vector<QuadratureNode> rule_above = gauss_legendre(size.zeniths - below);
  std::vector<Vec2> directions; ///< cosine of the zenith angle, and solid angle of the band of azimuths
  for (std::size_t i = 0; i < heights_; ++i) {
    const double depression = dip(air_.ground_km() + node_height_km(i));
    const auto add = [&](const std::vector<QuadratureNode>& nodes, double range) {
      for (const QuadratureNode& node : nodes) {
        const double altitude = -depression + range * node.place * node.place;
        directions.emplace_back(std::sin(altitude),
                                2.0 * pi * std::cos(altitude) * 2.0 * std::abs(range) * node.place * node.weight);
      }
    };
    add(rule_below, -(0.5 * pi - depression));
    add(rule_above, 0.5 * pi + depression);
  }
  std::vector<ViewRay> rays(directions.size());
  const auto make_rays = [&](double growth, double least_km) {
    parallel_for(
        rays.size(), 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            rays[k] = view_ray(air_.ground_km() + node_height_km(k / size.zeniths), directions[k].x, growth, least_km);
          }
        },
        threads);
  };
  std::vector<std::vector<float>> matrices(heights_);
  parallel_for(
      heights_, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto own = directions.begin() + static_cast<std::ptrdiff_t>(i * size.zeniths);
          matrices[i] = phase_matrix(i, {own, own + static_cast<std::ptrdiff_t>(size.zeniths)}, size.azimuths);
        }
      },
      threads);

  const std::size_t nodes = heights_ * angles;
  const std::size_t node_rays = size.zeniths * size.azimuths;
  std::vector<float> once(nodes * node_rays * lanes, 0.0F); ///< radiance of the first order, by node and direction
  std::vector<float> next_field(nodes * moments * lanes, 0.0F);
  std::vector<float> next_aerosol(nodes * source_directions * lanes, 0.0F);
  std::vector<float> next_ground(angles * lanes, 0.0F);

  // What the radiances of a node amount to.
  const auto sum_up = [&](std::size_t node, const float* radiances) {
    const std::size_t i = node / angles;
    std::array<std::array<float, most_wavelengths>, moments> sums{};
    std::array<float, most_wavelengths> level{};
    for (std::size_t d = 0; d < size.zeniths; ++d) {
      const Vec2& direction = directions[i * size.zeniths + d];
      const auto nz = static_cast<float>(direction.x);
      for (std::size_t b = 0; b < size.azimuths; ++b) {
        const auto weight = static_cast<float>(direction.y * azimuths[b].weight);
        const auto nx = static_cast<float>(std::sqrt(1.0 - direction.x * direction.x) * std::cos(azimuths[b].place));
        const float* radiance = radiances + (d * size.azimuths + b) * lanes;
        for (std::size_t l = 0; l < lanes; ++l) {
          const float light = weight * radiance[l];
          sums[mean_log2][l] += light;
          sums[xx][l] += light * nx * nx;
          sums[zz][l] += light * nz * nz;
          sums[xz][l] += light * nx * nz;
          level[l] += light * std::max(0.0F, nz);
        }
      }
    }
    for (std::size_t l = 0; l < lanes; ++l) {
      const float all = std::max(sums[mean_log2][l], darkest);
      float* field = &next_field[node * moments * lanes + l];
      field[0] = std::log2(all) - 3.6514961294723187F; // of 4 pi
      for (std::size_t moment = 1; moment < moments; ++moment) {
        field[moment * lanes] = sums.at(moment)[l] / all;
      }
      if (i == 0) {
        next_ground[node * lanes + l] = std::log2(std::max(level[l], darkest));
      }
    }
    const float* matrix = matrices[i].data();
    for (std::size_t toward = 0; toward < source_directions; ++toward) {
      std::array<float, most_wavelengths> source{};
      for (std::size_t k = 0; k < node_rays * lanes; k += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) {
          source[l] += matrix[l] * radiances[k + l];
        }
        matrix += lanes;
      }
      for (std::size_t l = 0; l < lanes; ++l) {
        next_aerosol[(node * source_directions + toward) * lanes + l] = std::log2(std::max(source[l], darkest));
      }
    }
  };
  const auto each_node = [&](const auto& radiance_of) {
    parallel_for(
        nodes, 4,
        [&](std::size_t begin, std::size_t end) {
          std::vector<float> radiances(node_rays * lanes);
          for (std::size_t node = begin; node < end; ++node) {
            const double cos_light = angle_cos_[node % angles];
            const double sin_light = std::sqrt(std::max(0.0, (1.0 - cos_light) * (1.0 + cos_light)));
            float* own = &once[node * node_rays * lanes];
            for (std::size_t k = 0; k < node_rays; ++k) {
              radiance_of(rays[node / angles * size.zeniths + k / size.azimuths], cos_light, sin_light,
                          std::cos(azimuths[k % size.azimuths].place), own + k * lanes, &radiances[k * lanes]);
            }
            sum_up(node, radiances.data());
          }
        },
        threads);
    std::swap(field_, next_field);
    std::swap(aerosol_, next_aerosol);
    std::swap(ground_, next_ground);
  };

  field_ = next_field;
  aerosol_ = next_aerosol;
  ground_ = next_ground;
  make_rays(0.4 * size.step_growth, 0.4 * size.least_step_km);
  each_node(
      [&](const ViewRay& ray, double cos_light, double sin_light, double cos_azimuth, float* own, float* radiance) {
        add_direct(ray, cos_light, sin_light, cos_azimuth, light_radius_rad, own, own, own);
        std::copy_n(own, lanes, radiance);
      });
  make_rays(size.step_growth, size.least_step_km);
  for (int order = 2; order <= size.orders; ++order) {
    each_node([&](const ViewRay& ray, double cos_light, double sin_light, double cos_azimuth, const float* own,
                  float* radiance) {
      std::copy_n(own, lanes, radiance);
      add_scattered(ray, cos_light, sin_light, cos_azimuth, radiance, radiance);
    });
  }
}

} // namespace vesper
