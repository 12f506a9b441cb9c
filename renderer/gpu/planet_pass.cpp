#include "vesper/gpu/planet_pass.hpp"

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

/// A star that stands at the given direction in the axes of a resting observer's catalogue. What a float leaves of the
/// direction goes into a proper motion of one year.
StarRecord resting_star(const Vec3& direction) {
  StarRecord record{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double exact = direction[static_cast<int>(i)];
    record.position.at(i) = static_cast<float>(exact);
    record.proper_motion.at(i) = static_cast<float>(exact - static_cast<double>(record.position.at(i)));
  }
  return record;
}

Points points_of(const SkyState& sky, double faintest_lux) {
  Points points;
  for (std::size_t i = 0; i < sky.planets.size(); ++i) {
    const auto planet = static_cast<Planet>(i);
    const PlanetState& state = sky.planets.at(i);
    const double lux_above = planet_illuminance(planet, state.appearance.magnitude).to(lux);
    if (!(lux_above > 0.0) || lux_above < faintest_lux) {
      continue;
    }
    StarRecord record = resting_star(state.place.direction_horizon);
    record.illuminance = static_cast<float>(lux_above);
    const Xyzs& color = planet_light(planet).color;
    record.color = {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z),
                    static_cast<float>(color.s)};
    points.catalogue.stars.push_back(record);
    points.catalogue.identities.push_back({planet_flag | static_cast<std::uint32_t>(i), 0, 0.0F, ""});
    points.disc_rad.push_back(static_cast<float>(state.appearance.diameter.to(rad)));
  }
  return points;
}

/// The same sky for an observer at rest, whose catalogue is written in horizon axes a year ago.
SkyState resting(const SkyState& sky) {
  SkyState still = sky;
  still.stars = StarFrame();
  still.stars.sun_to_observer = Vec3(1.0, 0.0, 0.0);
  still.stars.years_since_j2000 = 1.0;
  return still;
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
