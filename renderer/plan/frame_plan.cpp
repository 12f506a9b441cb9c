#include "vesper/plan/frame_plan.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/star_extinction.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/moon_shadow.hpp"
#include "vesper/sky/sky_light.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

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

std::optional<RefractionConditions> bending_of(const SkyState& sky, const AirOptions& air) {
  if (air.refraction && sky.refraction.model != RefractionModel::none) {
    return sky.refraction.conditions;
  }
  return std::nullopt;
}

using ExtinctionMaker = StarExtinction (*)(const Medium&, Length, const std::optional<RefractionConditions>&);

/// \param before that of an earlier frame, which serves again where it was made for the same
std::shared_ptr<const PlannedExtinction> extinction_for(const SkyState& sky, const AirOptions& air,
                                                        std::shared_ptr<const Medium> medium, ExtinctionMaker make,
                                                        std::shared_ptr<const PlannedExtinction> before) {
  const std::optional<RefractionConditions> bending = bending_of(sky, air);
  const Length height = sky.observer.height;
  if (before != nullptr && before->medium == medium && before->height == height && before->bending == bending) {
    return before;
  }
  StarExtinction table = make(*medium, height, bending);
  return std::make_shared<const PlannedExtinction>(
      PlannedExtinction{std::move(medium), height, bending, std::move(table)});
}

PlannedEclipse eclipse_for(const SkyState& sky, const std::vector<SkyLight>& lights,
                           std::shared_ptr<const Medium> medium, const FramePlan* before) {
  PlannedEclipse eclipse;
  if (before != nullptr && before->eclipse.medium == medium) {
    eclipse.air = before->eclipse.air;
  }
  eclipse.medium = std::move(medium);
  const bool sunlit =
      std::any_of(lights.begin(), lights.end(), [](const SkyLight& light) { return light.name == "sun"; });
  if (sunlit && moon_shadow(sky, {})) {
    if (eclipse.air == nullptr) {
      eclipse.air = std::make_shared<const EclipsedAir>(*eclipse.medium);
    }
    eclipse.sky = std::make_shared<const EclipsedSky>(
        eclipse.air, moon_shadow(sky, eclipse.air->wavelengths_nm()).value(), height_in_air(sky.observer));
  }
  return eclipse;
}

std::vector<PlannedLight> planned_lights(const std::vector<SkyLight>& lights, const Refraction& refraction) {
  std::vector<PlannedLight> planned;
  planned.reserve(lights.size());
  for (const SkyLight& light : lights) {
    planned.push_back({light.direction, apparent_direction(light.direction, refraction), light.angular_radius,
                       integrate_xyzs(light.irradiance).y * response_matrix(solar_irradiance_1au(), light.irradiance)});
  }
  return planned;
}

/// What the air leaves of the light of Moon and Sun, as their passes have it.
Vec4 share_through_air(const FramePlan& plan, double sin_altitude, const Vec4& light) {
  if (plan.sunlight_extinction != nullptr) {
    return star_extinction(plan.sunlight_extinction->table, sin_altitude, light);
  }
  const double path = f64::optical_path(sin_altitude, plan.observer_height.to(kilometre));
  return f64::modulate_xyzs(light, f64::extinction(plan.optical_depth, path)) / light;
}

void plan_discs(const SkyState& sky, const View& view, const std::function<const MoonIllumination&()>& moon,
                FramePlan& plan) {
  DiscScene scene{
      sky,
      view,
      plan.refraction,
      [&plan](double sin_altitude, const Vec4& light) { return share_through_air(plan, sin_altitude, light); },
      moon,
      std::nullopt,
      !plan.lights.empty()};
  if (has(plan.options.layers, Layer::ground)) {
    scene.ground_sin_altitude = plan.horizon_sin_altitude;
  }
  if (has(plan.options.layers, Layer::moon)) {
    plan.moon = plan_moon(scene, plan.options.discs);
  }
  if (has(plan.options.layers, Layer::sun)) {
    plan.sun = plan_sun(scene, plan.options.discs);
  }
}

} // namespace

FramePlan plan_frame(const SkyState& sky, const View& view, std::span<const StarRecord> stars,
                     const FrameOptions& options, const FramePlan* before) {
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
  static const auto clear = std::make_shared<const Medium>(clear_medium());
  const std::shared_ptr<const Medium>& medium = options.air.medium != nullptr ? options.air.medium : clear;
  const bool beyond_air = has(options.layers, Layer::zodiacal) || has(options.layers, Layer::milky_way);
  if (options.air.extinction) {
    if (plan.cheap_stars) {
      plan.optical_depth = star_optical_depth_xyzs(*medium, sky.observer.height);
    }
    const bool again = before != nullptr;
    if (!plan.cheap_stars || beyond_air) {
      plan.extinction =
          extinction_for(sky, options.air, medium, make_star_extinction, again ? before->extinction : nullptr);
    }
    if (!plan.cheap_stars && (has(options.layers, Layer::moon) || has(options.layers, Layer::sun))) {
      plan.sunlight_extinction = extinction_for(sky, options.air, medium, make_sunlight_extinction,
                                                again ? before->sunlight_extinction : nullptr);
    }
  }
  if (options.air.refraction) {
    plan.refraction = with_table(sky.refraction);
  }
  std::optional<MoonIllumination> moon;
  const auto moonlit = [&sky, &moon]() -> const MoonIllumination& {
    if (!moon) {
      moon = moon_illumination(sky);
    }
    return *moon;
  };
  if (has(options.layers, Layer::sky) && options.air.sky_tables != nullptr) {
    const std::vector<SkyLight> lights = lights_of(sky, SunInEclipse::outside_the_shadow, moonlight_of(moonlit()));
    plan.lights = planned_lights(lights, plan.refraction);
    plan.eclipse = eclipse_for(sky, lights, medium, before);
  }
  plan.observer_height = sky.observer.height;
  plan.horizon_sin_altitude = std::sin(horizon_altitude(plan.refraction, sky.observer.height).to(rad));
  DarkSkySetting setting{options.air.extinction ? medium : nullptr,
                         options.air.sky_tables,
                         nullptr,
                         plan.refraction,
                         height_in_air(sky.observer),
                         plan.horizon_sin_altitude,
                         options.dark_sky.glow};
  if (beyond_air && plan.extinction != nullptr) {
    setting.extinction = {plan.extinction, &plan.extinction->table};
  }
  plan.dark_sky = plan_dark_sky(sky, options.layers, options.dark_sky, std::move(setting), !plan.lights.empty(),
                                before != nullptr ? before->dark_sky.get() : nullptr);
  plan_discs(sky, view, moonlit, plan);
  return plan;
}

} // namespace vesper
