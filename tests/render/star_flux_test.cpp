// The light of a star is conserved: its pixels' luminance times solid angle sums to its illuminance, for any
// projection, field, size and sub-pixel position.
#include "render/render_fixture.hpp"
#include "support/thorough.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace vesper::test {
namespace {

struct FluxStatistics {
  double sum_abs = 0.0;
  double worst = 0.0;
  int count = 0;

  void add(double relative_error) {
    sum_abs += std::abs(relative_error);
    worst = std::max(worst, std::abs(relative_error));
    ++count;
  }
  void expect_within_limits(const std::string& name) const {
    std::printf("%-32s %5d stars: mean %.4f %%, worst %.4f %%\n", name.c_str(), count, 100.0 * sum_abs / count,
                100.0 * worst);
    EXPECT_LE(sum_abs / count, 0.005) << name;
    EXPECT_LE(worst, 0.01) << name;
  }
};

/// One frame of isolated random stars, one per cell of a grid, each summed over its cell.
void add_grid_frame(gpu::Renderer& renderer, const View& view, std::mt19937_64& random, int stars_wanted,
                    FluxStatistics& statistics) {
  constexpr int cell = 28;
  constexpr double margin = 12.0; // the largest spread and a pixel
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  struct Placed {
    int column;
    int row;
    double lux;
  };
  std::vector<std::pair<StarRecord, Placed>> stars;
  const double radius = 0.5 * std::min(view.width, view.height) - margin;
  std::vector<std::pair<int, int>> cells;
  for (int row = 0; row + cell <= view.height; row += cell) {
    for (int column = 0; column + cell <= view.width; column += cell) {
      cells.emplace_back(column, row);
    }
  }
  std::shuffle(cells.begin(), cells.end(), random);
  for (const auto& [column, row] : cells) {
    if (static_cast<int>(stars.size()) == stars_wanted) {
      break;
    }
    const Vec2 pixel(column + margin + unit(random) * (cell - 2.0 * margin),
                     row + margin + unit(random) * (cell - 2.0 * margin));
    if (view.projection == Projection::fisheye && glm::length(pixel - 0.5 * Vec2(view.width, view.height)) > radius) {
      continue;
    }
    const double lux = 2.54e-6 * std::pow(10.0, -0.4 * (8.0 * unit(random) - 1.5));
    stars.emplace_back(white_star(direction_at(view, pixel), lux), Placed{column, row, lux});
  }
  std::sort(stars.begin(), stars.end(),
            [](const auto& a, const auto& b) { return a.first.illuminance > b.first.illuminance; });
  std::vector<StarRecord> records;
  records.reserve(stars.size());
  for (const auto& star : stars) {
    records.push_back(star.first);
  }
  const SkyState sky = still_sky();
  renderer.load(catalogue_of(records));
  const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, records, bare_stars()));
  for (const auto& [record, placed] : stars) {
    const double measured = illuminance_in(frame, view, placed.column, placed.row, cell, cell);
    statistics.add(measured / static_cast<double>(record.illuminance) - 1.0);
  }
}

struct FluxCase {
  Projection projection;
  double fov_deg;
  int size;
};

class StarFlux : public RenderTest, public testing::WithParamInterface<FluxCase> {};

TEST_P(StarFlux, SumsToTheIlluminance) {
  const FluxCase& parameters = GetParam();
  View view;
  view.projection = parameters.projection;
  view.fov = parameters.fov_deg * deg;
  view.width = view.height = parameters.size;
  view.altitude = 37.0 * deg;
  view.azimuth = 211.0 * deg;
  view.roll = 13.0 * deg;
  std::mt19937_64 random(42);
  FluxStatistics statistics;
  while (statistics.count < 1000) {
    add_grid_frame(renderer, view, random, std::min(1000 - statistics.count, 1000), statistics);
  }
  statistics.expect_within_limits(std::string(projection_names()[static_cast<std::size_t>(view.projection)]) + " " +
                                  std::to_string(parameters.fov_deg).substr(0, 5) + " deg " +
                                  std::to_string(parameters.size));
}

/// Corners and middles of the grid of fields and sizes; `./run test --full` takes all of it.
std::vector<FluxCase> flux_cases() {
  if (!test::thorough()) {
    return {{Projection::perspective, 0.5, 256},     {Projection::perspective, 0.5, 4096},
            {Projection::perspective, 60.0, 1024},   {Projection::perspective, 140.0, 256},
            {Projection::perspective, 169.9, 4096},  {Projection::fisheye, 0.5, 1024},
            {Projection::fisheye, 180.0, 256},       {Projection::fisheye, 180.0, 4096},
            {Projection::fisheye, 60.0, 512},        {Projection::stereographic, 0.5, 4096},
            {Projection::stereographic, 60.0, 256},  {Projection::stereographic, 180.0, 256},
            {Projection::stereographic, 180.0, 4096}};
  }
  std::vector<FluxCase> cases;
  for (const Projection projection : {Projection::perspective, Projection::fisheye, Projection::stereographic}) {
    for (const double fov : {0.5, 2.0, 10.0, 45.0, 90.0, 120.0, 150.0, 169.9, 180.0}) {
      for (const int size : {256, 512, 1024, 2048, 4096}) {
        if (projection != Projection::perspective || fov < 170.0) {
          cases.push_back({projection, fov, size});
        }
      }
    }
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Fields, StarFlux, testing::ValuesIn(flux_cases()));

/// Random stars all over the sphere, one a frame, seams, corners and poles included.
void sphere_statistics(gpu::Renderer& renderer, const View& view, int count, FluxStatistics& statistics) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const SkyState sky = still_sky();
  for (int i = 0; i < count; ++i) {
    Vec3 direction = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
    if (i % 4 == 1) {
      // Near an edge or corner of the cube, and near the poles of the map.
      direction = glm::normalize(Vec3(direction.x > 0 ? 1.0 : -1.0, direction.y > 0 ? 1.0 : -1.0, direction.z) +
                                 0.02 * direction);
    } else if (i % 4 == 2) {
      direction = glm::normalize(Vec3(0.02 * direction.x, 0.02 * direction.y, direction.z > 0 ? 1.0 : -1.0));
    }
    const std::vector<StarRecord> records{white_star(glm::transpose(view_from_horizon(view)) * direction,
                                                     2.54e-6 * std::pow(10.0, -0.4 * (8.0 * unit(random) - 1.5)))};
    renderer.load(catalogue_of(records));
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, records, bare_stars()));
    const double measured = illuminance_in(frame, view, 0, 0, frame.width, frame.height);
    statistics.add(measured / static_cast<double>(records.front().illuminance) - 1.0);
  }
}

using StarFluxOnTheSphere = RenderTest;

TEST_F(StarFluxOnTheSphere, Equirectangular) {
  for (const int width : {256, 1000}) {
    View view;
    view.projection = Projection::equirectangular;
    view.altitude = 0.0 * deg;
    view.width = width;
    view.height = width / 2;
    FluxStatistics statistics;
    sphere_statistics(renderer, view, 500, statistics);
    statistics.expect_within_limits("equirectangular " + std::to_string(width));
  }
}

TEST_F(StarFluxOnTheSphere, Cubemap) {
  for (const int side : {64, 256}) {
    View view;
    view.projection = Projection::cubemap;
    view.altitude = 20.0 * deg;
    view.width = side;
    view.height = 6 * side;
    FluxStatistics statistics;
    sphere_statistics(renderer, view, 500, statistics);
    statistics.expect_within_limits("cubemap " + std::to_string(side));
  }
}

TEST_F(StarFluxOnTheSphere, LargeMaps) {
  View map;
  map.projection = Projection::equirectangular;
  map.altitude = 0.0 * deg;
  map.width = 4096;
  map.height = 2048;
  FluxStatistics statistics;
  sphere_statistics(renderer, map, 12, statistics);
  statistics.expect_within_limits("equirectangular 4096");
  View cube;
  cube.projection = Projection::cubemap;
  cube.width = 2048;
  cube.height = 6 * 2048;
  FluxStatistics cube_statistics;
  sphere_statistics(renderer, cube, 8, cube_statistics);
  cube_statistics.expect_within_limits("cubemap 2048");
}

using StarFlicker = RenderTest;

TEST_F(StarFlicker, SubPixelMotionKeepsTheTotalAndBoundsThePeak) {
  View view;
  view.projection = Projection::perspective;
  view.fov = 20.0 * deg;
  view.width = view.height = 64;
  const double lux = 2.54e-8; // V = 5: the smallest spread, the worst case
  double lowest_peak = 1.0e30;
  double highest_peak = 0.0;
  FluxStatistics totals;
  const SkyState sky = still_sky();
  for (int step = 0; step < 100; ++step) {
    const Vec2 pixel(31.0 + 0.01 * step, 31.3 + 0.0061 * step);
    const std::vector<StarRecord> records{white_star(direction_at(view, pixel), lux)};
    renderer.load(catalogue_of(records));
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, records, bare_stars()));
    double peak = 0.0;
    for (std::size_t i = 1; i < frame.xyzs.size(); i += 4) {
      peak = std::max(peak, static_cast<double>(frame.xyzs[i]));
    }
    lowest_peak = std::min(lowest_peak, peak);
    highest_peak = std::max(highest_peak, peak);
    totals.add(illuminance_in(frame, view, 0, 0, 64, 64) / static_cast<double>(records.front().illuminance) - 1.0);
  }
  std::printf("peak varies by a factor %.3f, the total by %.2e\n", highest_peak / lowest_peak, totals.worst);
  EXPECT_LT(highest_peak / lowest_peak, 1.46);
  EXPECT_LT(totals.worst, 1.0e-3);
}

} // namespace
} // namespace vesper::test
