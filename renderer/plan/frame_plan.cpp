#include "vesper/plan/frame_plan.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/star_extinction.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

int copies_of(Projection projection) {
  switch (projection) {
  case Projection::equirectangular:
    return 2;
  case Projection::cubemap:
    return most_star_copies;
  default:
    return 1;
  }
}

} // namespace

FramePlan plan_frame(const SkyState& sky, const View& view, std::span<const StarRecord> stars,
                     const FrameOptions& options) {
  validate(view);
  FramePlan plan;
  plan.options = options;
  plan.cheap_stars = sky.tier == Tier::cheap;
  if (has(options.layers, Layer::stars)) {
    // The catalogue is sorted by V, along which illuminance falls only nearly monotonically.
    const auto last = std::find_if(stars.rbegin(), stars.rend(), [&](const StarRecord& star) {
      return static_cast<double>(star.illuminance) >= options.faintest_lux;
    });
    plan.star_count = static_cast<std::size_t>(stars.rend() - last);
  }
  plan.star_copies = copies_of(view.projection);
  if (options.air.extinction) {
    static const Medium clear = clear_medium();
    plan.optical_depth = star_optical_depth_xyzs(options.air.medium ? *options.air.medium : clear, sky.observer.height);
  }
  if (options.air.refraction) {
    plan.refraction = with_table(sky.refraction);
  }
  plan.horizon_sin_altitude = std::sin(horizon_altitude(plan.refraction, sky.observer.height).to(rad));
  return plan;
}

} // namespace vesper
