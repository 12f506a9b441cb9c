#include "vesper/atmosphere/level_illuminance.hpp"

#include "vesper/atmosphere/sky_table_parts.hpp"
#include "vesper/base/gauss_legendre.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr int azimuths = f32::sky_azimuths;
constexpr std::size_t azimuth_nodes = 24;
constexpr std::size_t altitude_nodes = 20; // between the horizon and the light, and between it and the zenith

Vec3 at_altitude(Angle altitude) { return {std::cos(altitude.to(rad)), 0.0, std::sin(altitude.to(rad))}; }

/// A place of the quadrature over half a turn of azimuth, crowded at the light's where aerosol makes a peak.
struct AzimuthNode {
  float cosine;
  float weight;
  std::array<float, azimuths> cosines; ///< of its multiples
};

const std::vector<AzimuthNode>& azimuth_rule() {
  static const std::vector<AzimuthNode> rule = [] {
    std::vector<AzimuthNode> nodes;
    for (const QuadratureNode& node : gauss_legendre(azimuth_nodes)) {
      const double azimuth = pi * node.place * node.place;
      AzimuthNode& made = nodes.emplace_back();
      made.cosine = static_cast<float>(std::cos(azimuth));
      made.weight = static_cast<float>(2.0 * 2.0 * pi * node.place * node.weight); // both halves of the turn
      for (int m = 0; m < azimuths; ++m) {
        made.cosines[static_cast<std::size_t>(m)] = static_cast<float>(std::cos(m * azimuth));
      }
    }
    return nodes;
  }();
  return rule;
}

/// Altitudes with their weights, crowded at the ends of both ranges: at the horizon, and at the light.
std::vector<QuadratureNode> altitude_rule(double light_rad) {
  static const std::vector<QuadratureNode> rule = gauss_legendre(altitude_nodes);
  const double middle = std::clamp(light_rad, 0.0, 0.5 * pi);
  std::vector<QuadratureNode> nodes;
  for (const auto& [from, to] : {std::pair(0.0, middle), std::pair(middle, 0.5 * pi)}) {
    for (const QuadratureNode& node : rule) {
      const double altitude = from + (to - from) * 0.5 * (1.0 - std::cos(pi * node.place));
      const double step = (to - from) * 0.5 * pi * std::sin(pi * node.place) * node.weight;
      nodes.push_back({altitude, step * std::sin(altitude) * std::cos(altitude)});
    }
  }
  return nodes;
}

/// By node and number: shares of the nodes in the cosine series through them.
const std::array<std::array<float, azimuths>, azimuths>& series_weights() {
  static const auto made = [] {
    std::array<std::array<float, azimuths>, azimuths> weights{};
    for (int k = 0; k < azimuths; ++k) {
      for (int m = 0; m < azimuths; ++m) {
        weights[static_cast<std::size_t>(k)][static_cast<std::size_t>(m)] = f32::sky_series_weight(m, k);
      }
    }
    return weights;
  }();
  return made;
}

/// A table's cosine series by row above the horizon, for one height and one altitude of the light.
class Slice {
public:
  using Series = std::array<f32::vec4, azimuths>;

  /// \param node logarithm of the mean source by row and number of the node over the azimuth
  template <class Node> Slice(int rows, const Node& node) : rows_(static_cast<std::size_t>(rows)) {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (int k = 0; k < azimuths; ++k) {
        const f32::vec4 value = node(static_cast<int>(row), k);
        for (int m = 0; m < azimuths; ++m) {
          rows_[row][static_cast<std::size_t>(m)] +=
              series_weights()[static_cast<std::size_t>(k)][static_cast<std::size_t>(m)] * value;
        }
      }
    }
  }

  /// Between the rows.
  [[nodiscard]] Series at(const f32::SkyViewPlace& view) const {
    const f32::SkyNodes nodes = f32::sky_nodes(view.place, view.rows);
    Series series{};
    for (int k = 0; k < 4; ++k) {
      const Series& row = rows_[static_cast<std::size_t>(f32::sky_node(nodes, k, view.rows))];
      for (std::size_t m = 0; m < series.size(); ++m) {
        series[m] += nodes.weights[k] * row[m];
      }
    }
    return series;
  }

private:
  std::vector<Series> rows_;
};

struct Slices {
  Slice other;
  Slice aerosol;
};

Slices slices_of_large(const SkyTables& tables, float height_km, float light_rad) {
  const f32::SkyTableFrame& frame = tables.frame;
  const f32::SkyNodes heights = f32::sky_nodes(f32::sky_height_place(height_km, frame), frame.heights);
  const f32::SkyNodes lights = f32::sky_nodes(f32::sky_light_place(light_rad, frame), frame.lights);
  const auto slice = [&](const std::vector<f32::vec4>& table) {
    const f32::sampler3D texels = sampler(tables, table);
    return Slice(frame.views_above, [&](int row, int k) {
      return f32::sky_table_between(texels, heights, lights, frame.views_below + row, k, frame);
    });
  };
  return {slice(tables.other), slice(tables.aerosol)};
}

Slices slices_of_small(const SkyTables& tables, float height_km, float light_rad) {
  const f32::SkyTableFrame& frame = tables.frame;
  const float dip = f32::sky_dip(height_km, frame);
  std::vector<SkySources> nodes;
  for (int row = 0; row < frame.views_above; ++row) {
    const float altitude = f32::sky_node_altitude_rad(frame.views_below + row, dip, frame);
    for (int k = 0; k < azimuths; ++k) {
      const auto cosine = static_cast<float>(std::cos(pi * k / (azimuths - 1)));
      nodes.push_back(sky_sources(tables, height_km, altitude, false, light_rad, cosine));
    }
  }
  const auto slice = [&](f32::vec4 SkySources::*part) {
    return Slice(frame.views_above, [&](int row, int k) {
      return log2_of(nodes[static_cast<std::size_t>(row) * azimuths + static_cast<std::size_t>(k)].*part,
                     sky_darkest_log2);
    });
  };
  return {slice(&SkySources::other), slice(&SkySources::aerosol)};
}

f32::vec4 exp2_of(const Slice::Series& series, const AzimuthNode& azimuth) {
  f32::vec4 sum(0.0F);
  for (std::size_t m = 0; m < series.size(); ++m) {
    sum += azimuth.cosines[m] * series[m];
  }
  return glm::exp2(sum);
}

} // namespace

Xyzs direct_illuminance(const SkyTables& tables, Length height, Angle light_altitude, Angle light_radius) {
  validate({height, at_altitude(light_altitude), light_radius, {0.0, 0.0, 1.0}});
  const auto height_km = static_cast<float>(height.to(kilometre));
  // Strips of equal altitude across the disc: Gauss and Chebyshev's rule of the second kind carries their lengths.
  constexpr int strips = 32;
  f32::vec4 sum(0.0F);
  for (int i = 1; i <= strips; ++i) {
    const double angle = pi * i / (strips + 1.0);
    const double weight = 2.0 / (strips + 1.0) * std::sin(angle) * std::sin(angle);
    const double altitude = (light_altitude + std::cos(angle) * light_radius).to(rad);
    if (std::sin(altitude) > 0.0) {
      sum +=
          static_cast<float>(weight * std::sin(altitude)) *
          glm::exp2(f32::sky_transmittance_log2(transmittance_sampler(tables), height_km, static_cast<float>(altitude),
                                                tables.transmittance_frame, tables.frame));
    }
  }
  return to_xyzs(sum * tables.light);
}

Xyzs diffuse_illuminance(const SkyTables& tables, Length height, Angle light_altitude) {
  validate({height, at_altitude(light_altitude), 0.0 * deg, {0.0, 0.0, 1.0}});
  const f32::SkyTableFrame& frame = tables.frame;
  const auto height_km = static_cast<float>(height.to(kilometre));
  if (height_km >= frame.top_km - frame.ground_km) {
    return {};
  }
  const auto light = static_cast<float>(light_altitude.to(rad));
  const Slices slices =
      tables.small ? slices_of_small(tables, height_km, light) : slices_of_large(tables, height_km, light);
  const float dip = f32::sky_dip(height_km, frame);
  const f32::sampler1D phases = line_sampler(tables.phase);
  f32::vec4 sum(0.0F);
  for (const QuadratureNode& ring : altitude_rule(light_altitude.to(rad))) {
    const auto altitude = static_cast<float>(ring.place);
    const f32::SkyViewPlace view = f32::sky_view_place(altitude, dip, false, frame);
    const Slice::Series other_series = slices.other.at(view);
    const Slice::Series aerosol_series = slices.aerosol.at(view);
    const float level = std::cos(altitude) * std::cos(light);
    const float upright = std::sin(altitude) * std::sin(light);
    f32::vec4 around(0.0F);
    for (const AzimuthNode& azimuth : azimuth_rule()) {
      const float phase =
          f32::sky_aerosol_phase(phases, upright + level * azimuth.cosine, static_cast<int>(tables.phase.size()));
      around += azimuth.weight * (exp2_of(other_series, azimuth) + phase * exp2_of(aerosol_series, azimuth));
    }
    sum += static_cast<float>(ring.weight) * f32::sky_path_share(height_km, altitude, false, frame) * around;
  }
  return to_xyzs(sum);
}

} // namespace vesper
