#include "vesper/catalog_tools/moon_products.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/half_float.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"
#include "vesper/light/lunar_surface.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace vesper {
namespace {

// Areas that a texel's mean is taken over, along each side.
constexpr int samples_a_side = 4;
constexpr double most_missing = 0.5;

/// Mean over the square of the cube's face around a place, which may reach beyond the face's edge.
double square_mean(const GlobeMeans& means, int face, const Vec2& centre, double side) {
  const double step = side / samples_a_side;
  double sum = 0.0;
  double weights = 0.0;
  for (int j = 0; j < samples_a_side; ++j) {
    for (int i = 0; i < samples_a_side; ++i) {
      const Vec2 offset(i + 0.5 - 0.5 * samples_a_side, j + 0.5 - 0.5 * samples_a_side);
      const Vec3 point = f64::cube_direction(face, centre + step * offset);
      const double length = glm::length(point);
      const double weight = 1.0 / (length * length * length); // the solid angle, by step^2
      sum += weight * means.mean(point / length, step * std::sqrt(weight));
      weights += weight;
    }
  }
  return sum / weights;
}

/// The mean around every place of a lattice of `nodes` by `nodes` on each face, `side` apart, the first at
/// -1 + offset.
std::vector<double> lattice_means(const GlobeGrid& grid, int nodes, double offset, double side,
                                  const std::function<void(std::size_t)>& progress) {
  const GlobeMeans means(grid);
  const auto n = static_cast<std::size_t>(nodes);
  std::vector<double> values(6 * n * n);
  parallel_for(6 * n, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t column = 0; column < n; ++column) {
        const Vec2 place(-1.0 + offset + side * static_cast<double>(column),
                         1.0 - offset - side * static_cast<double>(row % n));
        values[row * n + column] = square_mean(means, static_cast<int>(row / n), place, side);
      }
      progress(n);
    }
  });
  return values;
}

/// Outward normal of a texel from the heights at its corners.
Vec3 relief_normal(int face, const Vec2& place, double side, const double* above, const double* below) {
  const double radius_m = moon_reference_radius.to(metre);
  const double along_right = 0.5 * (above[1] - above[0] + below[1] - below[0]) / side;
  const double along_up = 0.5 * (above[0] - below[0] + above[1] - below[1]) / side;
  const double height = 0.25 * (above[0] + above[1] + below[0] + below[1]);
  // A height that depends on the direction alone does not change along it, which gives the gradient's third part.
  const Vec3 gradient(along_right, along_up, -(place.x * along_right + place.y * along_up));
  const Vec3 point(place, 1.0);
  const double length = glm::length(point);
  return f64::cube_face_axes(face) * glm::normalize(point / length - (length / (radius_m + height)) * gradient);
}

// The rounding of 16-bit floats turns a normal by 0.02 degrees at most: little beside a texel of 0.1 to 0.2.
constexpr int most_half_face = 512;

FillReport fill(GlobeGrid& grid, const char* what) {
  const FillReport report = fill_missing(grid);
  if (report.area_share > most_missing) {
    throw Error(ErrorKind::input,
                fmt::format("{:.1f} % of the {} is missing; allowed are {:.0f} %", 100.0 * report.area_share, what,
                            100.0 * most_missing),
                {grid.file, "", "Choose a map of the whole Moon"});
  }
  return report;
}

} // namespace

std::size_t moon_product_work(int face_size) { return cube_texel_count(face_size) + cube_texel_count(face_size + 1); }

MoonProduct make_moon_product(GlobeGrid albedo, GlobeGrid elevation_m, const MoonProductOptions& options) {
  const int face_size = options.face_size;
  if (face_size < least_moon_face || face_size > most_moon_face || face_size % 2 != 0) {
    throw Error(ErrorKind::argument, fmt::format("a face of {} texels is not allowed", face_size),
                {"", "", fmt::format("Allowed are even numbers from {} to {}", least_moon_face, most_moon_face)});
  }
  MoonProduct product;
  auto& [map, report] = product;
  report.albedo_fill = fill(albedo, "albedo map");
  report.elevation_fill = fill(elevation_m, "elevation grid");
  const auto [lowest, highest] = std::minmax_element(elevation_m.values.begin(), elevation_m.values.end());
  report.lowest_m = static_cast<double>(*lowest);
  report.highest_m = static_cast<double>(*highest);

  const double side = 2.0 / face_size;
  const auto rounded = [&](double v) { return face_size <= most_half_face ? nearest_half(v) : static_cast<float>(v); };
  const std::vector<double> albedos = lattice_means(albedo, face_size, 0.5 * side, side, options.progress);
  const std::vector<double> heights = lattice_means(elevation_m, face_size + 1, 0.0, side, options.progress);

  map.face_size = face_size;
  map.texels.resize(4 * albedos.size());
  const auto n = static_cast<std::size_t>(face_size);
  double slopes = 0.0;
  double areas = 0.0;
  double disc_light = 0.0;
  double disc_area = 0.0;
  for (std::size_t i = 0; i < albedos.size(); ++i) {
    const std::size_t row = i / n;
    const std::size_t column = i % n;
    const std::size_t face = row / n;
    const double* above = &heights[(face * (n + 1) + row % n) * (n + 1) + column];
    const Vec2 place(side * (static_cast<double>(column) + 0.5) - 1.0,
                     1.0 - side * (static_cast<double>(row % n) + 0.5));
    const Vec3 normal = relief_normal(static_cast<int>(face), place, side, above, above + n + 1);
    for (int axis = 0; axis < 3; ++axis) {
      map.texels[4 * i + 1 + static_cast<std::size_t>(axis)] = rounded(normal[axis]);
    }
    const CubeTexel texel = cube_texel(face_size, i);
    const double slope = std::acos(std::min(glm::dot(normal, texel.direction), 1.0));
    slopes += slope * slope * texel.solid_angle_sr;
    areas += texel.solid_angle_sr;
    disc_light += albedos[i] * std::max(texel.direction.x, 0.0) * texel.solid_angle_sr;
    disc_area += std::max(texel.direction.x, 0.0) * texel.solid_angle_sr;
  }
  report.mean_slope = std::sqrt(slopes / areas) * rad;
  report.albedo_scale = lunar_geometric_albedo * disc_area / disc_light;
  const auto [least, most] = std::minmax_element(albedos.begin(), albedos.end());
  report.least_albedo = *least * report.albedo_scale;
  report.most_albedo = *most * report.albedo_scale;
  if (!(report.most_albedo <= 1.0)) {
    throw Error(ErrorKind::input,
                fmt::format("the brightest texel has an albedo of {:.2f} when the disc has {}; allowed is 1",
                            report.most_albedo, lunar_geometric_albedo),
                {albedo.file, "", "Check the albedo map and its encoding"});
  }
  for (std::size_t i = 0; i < albedos.size(); ++i) {
    map.texels[4 * i] = rounded(report.albedo_scale * albedos[i]);
  }
  map.provenance.albedo_pixels = albedo.values.size();
  map.provenance.albedo_filled = report.albedo_fill.filled;
  map.provenance.elevation_pixels = elevation_m.values.size();
  map.provenance.elevation_filled = report.elevation_fill.filled;
  map.provenance.albedo_scale = report.albedo_scale;
  return product;
}

} // namespace vesper
