#include "vesper/plan/planned_disc.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace vesper {
namespace {

void require_scale(double scale, const char* whose) {
  if (!(scale >= 1.0 && scale <= largest_disc_scale)) {
    throw Error(ErrorKind::argument, fmt::format("a scale of {} for the {}", scale, whose),
                {"", "", fmt::format("Give 1 to {:.0f}", largest_disc_scale)});
  }
}

/// Whether the uppermost of a circle is below the ground.
bool is_hidden(const SkyCircle& circle, const DiscScene& scene) {
  if (!scene.ground_sin_altitude) {
    return false;
  }
  const Mat3 axes = horizon_from_disc(circle.direction);
  const double sine = std::min(circle.scale * std::sin(circle.radius.to(rad)), 1.0);
  const Vec3 top = sine * axes[1] + std::sqrt(1.0 - sine * sine) * axes[2];
  constexpr double room = 1.0e-3; // rad: half a pixel at the horizon, from pictures of 3000 pixels on
  return apparent_direction(top, scene.refraction).z < *scene.ground_sin_altitude - room &&
         apparent_direction(circle.direction, scene.refraction).z < *scene.ground_sin_altitude - room;
}

/// A disc as its light seen in the centre of it.
PointLight point_of(const Vec3& direction, const Vec4& light, double flattening, const DiscScene& scene) {
  const Vec3 seen = apparent_direction(direction, scene.refraction);
  return {seen, flattening * light * scene.air(seen.z, light)};
}

/// The Moon as it is lit, eclipse included.
DiscGrid grid_of(const PlannedMoon& moon) {
  const double sine = std::sin(moon.disc.angular_radius.to(rad));
  DiscGrid grid(moon_cells_of_edge);
  auto lit = moon.disc.cells.begin();
  for (DiscGrid::Cell& cell : grid.cells) {
    const MoonCell& by = *lit++;
    if (cell.inside > 0.0) {
      const Vec3 normal = moon.disc.fixed_from_disc * f64::disc_normal(cell.place, sine);
      const Vec4 past_earth = f64::lunar_eclipse_shares(moon.from_earth_km + moon_mean_radius.to(kilometre) * normal,
                                                        moon.shadow, moon.eclipse.frame, moon.eclipse.sampler());
      cell.light = cell.inside * (static_cast<double>(by.sun) * past_earth * moon.disc.lighting.sunlit +
                                  static_cast<double>(by.earth) * moon.disc.lighting.earthlit);
      cell.hides = cell.inside;
    }
  }
  return grid;
}

/// Into what a small Moon's pixels are cut for its light.
void cut(PlannedMoon& moon, const SkyState& sky) {
  const Angle phase = sky.moon.phase_angle;
  double lit_width = 1.0 + std::cos(phase.to(rad)); // in radii, at the most
  const double lit_px = std::numbers::pi / 8.0 * lit_width * std::pow(moon.picture.width_px, 2);
  constexpr double many_px = 8000.0; // of which each may take its light from its middle
  if (phase > 100.0 * deg) {
    moon.picture.cells_of_radius = 20.0;
    if (lit_px < many_px) {
      // So many places leave 0.1 to 0.2 % of noise in its light. They cost the most, against the disc, from where its
      // pixels are cut no more to where the lit ones are as many as the places.
      const bool costly = moon.picture.width_px > 32.0 && moon.picture.width_px < 80.0;
      const double lit_rad = std::numbers::pi - phase.to(rad) + f64::lunar_relief_reach;
      moon.crescent_cells = std::min(std::sqrt((costly ? 4200.0 : 5000.0) / (2.0 * lit_rad)), costly ? 74.0 : 117.0);
    }
    return;
  }
  // What the Earth's shadow leaves in the sunlight is cut as its width asks for.
  const double umbral = sky.lunar_eclipse.umbral_magnitude;
  if (umbral > 0.0 && umbral < 1.0) {
    lit_width = std::min(lit_width, 2.0 * (1.0 - umbral));
  }
  moon.picture.cells_of_radius = std::clamp(20.0 / std::max(lit_width, 1.0e-3), 12.0, 64.0);
}

/// The Sun's disc past the Moon.
DiscGrid grid_of(const PlannedSun& sun, double drawn_sine) {
  DiscGrid grid(moon_cells_of_edge);
  const double width = 2.0 / grid.edge;
  for (DiscGrid::Cell& cell : grid.cells) {
    const double outside = glm::length(f64::disc_sight(cell.place, drawn_sine) - Vec3(sun.moon)) - sun.moon.w;
    const double free = sun.moon.w > 0.0 ? std::clamp(0.5 + outside / (width * drawn_sine), 0.0, 1.0) : 1.0;
    cell.hides = free * cell.inside;
    if (cell.hides > 0.0) {
      cell.light =
          cell.hides * f64::sun_disc_luminance(f64::disc_inner(glm::length(cell.place), width), sun.disc.shading);
    }
  }
  return grid;
}

/// A disc too narrow to be drawn for each pixel of its own.
/// \param light of the whole disc above the air, lux
void make_small(PlannedDisc& disc, const SkyCircle& circle, const DiscGrid& grid, const Vec4& light,
                const DiscScene& scene) {
  if (disc.width_px < narrowest_disc_px) {
    const Vec2 across = circle.scale * std::sin(circle.radius.to(rad)) * grid.centre_of_light();
    const Vec3 centre = horizon_from_disc(circle.direction) * Vec3(across, std::sqrt(1.0 - glm::dot(across, across)));
    disc.point = point_of(centre, light, disc.frame.flattening, scene);
    return;
  }
  disc.sprite = disc_sprite(circle, scene.view, scene.refraction, disc.boxes, grid, light, scene.air);
}

bool is_small(const PlannedDisc& disc) { return disc.width_px > 0.0 && disc.width_px < widest_sprite_px; }

} // namespace

std::shared_ptr<const MoonGlobe> make_moon_globe(MoonMap map) {
  return std::make_shared<const MoonGlobe>(moon_globe(std::move(map)));
}

std::optional<PlannedMoon> plan_moon(const DiscScene& scene, const DiscOptions& options) {
  require_scale(options.moon_scale, "Moon");
  const BodyPlace& moon = scene.sky.moon.place;
  if (!(moon.distance > moon_mean_radius)) {
    return std::nullopt; // a sky of stars alone
  }
  const auto globe = options.moon != nullptr ? options.moon : default_moon_globe();
  const SkyCircle circle{moon.direction_horizon, std::asin(moon_mean_radius / moon.distance) * rad, options.moon_scale};
  if (is_hidden(circle, scene)) {
    return std::nullopt;
  }
  std::vector<PixelBox> boxes = disc_boxes(circle, scene.view, scene.refraction);
  if (boxes.empty()) {
    return std::nullopt;
  }
  const MoonIllumination& illumination = scene.moon_illumination();
  const LunarEclipseState& eclipse = scene.sky.lunar_eclipse;
  const Mat3& fixed_from_icrs = scene.sky.moon.moon_fixed_from_icrs;
  PlannedMoon planned{{},
                      0.0,
                      moon_disc(scene.sky, *globe, illumination),
                      globe,
                      lunar_eclipse_table(eclipse, illumination.sunlit_moon, scene.sky.eclipse_air, scene.sky.tier),
                      earth_shadow(eclipse, fixed_from_icrs),
                      fixed_from_icrs * eclipse.moon_km};
  planned.picture.frame = disc_frame(circle, scene.view, scene.refraction);
  planned.picture.boxes = std::move(boxes);
  planned.picture.width_px = disc_diameter_px(circle, scene.view, scene.refraction);
  cut(planned, scene.sky);
  if (is_small(planned.picture)) {
    make_small(planned.picture, circle, grid_of(planned), vector_of(planned.disc.illuminance), scene);
  }
  return planned;
}

std::optional<PlannedSun> plan_sun(const DiscScene& scene, const DiscOptions& options) {
  require_scale(options.sun_scale, "Sun");
  if (!(scene.sky.sun.distance > sun_radius)) {
    return std::nullopt; // a sky of stars alone
  }
  const SunDisc disc = sun_disc(scene.sky, options.sun);
  const SkyCircle circle{disc.direction, disc.angular_radius, options.sun_scale};
  const double obscuration = scene.sky.solar_eclipse.obscuration;
  constexpr double outshone = 0.95; // by what is left of the disc
  const bool corona = !scene.bright_sky || obscuration > outshone;
  SkyCircle shown = circle;
  if (corona) {
    const double reach = std::min(f64::corona_edge * options.sun_scale * std::sin(circle.radius.to(rad)), 0.9);
    shown = {circle.direction, std::asin(reach) * rad, 1.0};
  }
  if (is_hidden(shown, scene)) {
    return std::nullopt;
  }
  std::vector<PixelBox> boxes = disc_boxes(shown, scene.view, scene.refraction);
  if (boxes.empty()) {
    return std::nullopt;
  }
  PlannedSun planned{{}, disc, corona, Vec4(0.0), Vec4(0.0)};
  planned.picture.frame = disc_frame(circle, scene.view, scene.refraction);
  planned.picture.boxes = std::move(boxes);
  planned.picture.width_px = disc_diameter_px(circle, scene.view, scene.refraction);
  const Mat3 axes = horizon_from_disc(circle.direction);
  planned.turn = {glm::dot(disc.shading.aside, axes[0]), glm::dot(disc.shading.aside, axes[1]),
                  glm::dot(disc.shading.upward, axes[0]), glm::dot(disc.shading.upward, axes[1])};
  const Vec3 moon = glm::transpose(axes) * disc.shading.moon_direction;
  if (moon.z > 0.0) {
    planned.moon = Vec4(moon, disc.shading.moon_chord * options.moon_scale);
  }
  if (!corona && is_small(planned.picture)) {
    const Vec4 light =
        vector_of(integrate_xyzs(filtered(disc.irradiance, sunlight_past_moon(scene.sky.solar_eclipse))));
    make_small(planned.picture, circle, grid_of(planned, options.sun_scale * planned.picture.frame.sine), light, scene);
  }
  return planned;
}

} // namespace vesper
