#include "vesper/gpu/point_pass.hpp"

#include "vesper/gpu/resting_points.hpp"

namespace vesper::gpu {

void PointPass::place(const PointLight& point, const SkyState& sky, const View& view, const FramePlan& plan) {
  StarCatalogue catalogue;
  catalogue.stars.push_back(resting_star(point.direction, point.light));
  points_.load(catalogue);
  // Place and light are as they are seen, and a disc is too wide to twinkle.
  FramePlan alone;
  alone.options.layers = plan.options.layers;
  alone.options.air.scintillation = false;
  alone.star_count = 1;
  alone.star_copies = plan.star_copies;
  points_.place(resting(sky), view, alone);
}

} // namespace vesper::gpu
