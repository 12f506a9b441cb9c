#include "vesper/gpu/planet_pass.hpp"

#include "vesper/gpu/resting_points.hpp"
#include "vesper/sky/planet_light.hpp"

#include <epoxy/gl.h>

namespace vesper::gpu {
namespace {

/// Marks the numbers that seed the planets' scintillation: no star has them.
constexpr std::uint32_t planet_flag = 0x40000000U;
constexpr GLuint discs_binding = 3;

struct Points {
  StarCatalogue catalogue;
  std::vector<float> disc_rad;
};

Points points_of(const SkyState& sky, double faintest_lux) {
  Points points;
  for (std::size_t i = 0; i < sky.planets.size(); ++i) {
    const auto planet = static_cast<Planet>(i);
    const PlanetState& state = sky.planets.at(i);
    const double lux_above = planet_illuminance(planet, state.appearance.magnitude).to(lux);
    if (!(lux_above > 0.0) || lux_above < faintest_lux) {
      continue;
    }
    const Xyzs& color = planet_light(planet).color;
    points.catalogue.stars.push_back(resting_star(state.place.direction_horizon, lux_above * vector_of(color)));
    points.catalogue.identities.push_back({planet_flag | static_cast<std::uint32_t>(i), 0, 0.0F, ""});
    points.disc_rad.push_back(static_cast<float>(state.appearance.diameter.to(rad)));
  }
  return points;
}

} // namespace

void PlanetPass::place(const SkyState& sky, const View& view, const FramePlan& plan) {
  const Points points = points_of(sky, plan.options.faintest_lux);
  points_.load(points.catalogue);
  FramePlan planets_only = plan;
  planets_only.star_count = points.catalogue.stars.size();
  if (planets_only.star_count > 0) {
    discs_ = make_static_buffer(std::as_bytes(std::span(points.disc_rad)));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, discs_binding, discs_.name());
  }
  points_.place(resting(sky), view, planets_only);
}

} // namespace vesper::gpu
