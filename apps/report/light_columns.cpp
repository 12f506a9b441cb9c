#include "report/light_columns.hpp"

#include "report/sky_light.hpp"

#include "vesper/atmosphere/random_stream.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/moon_shadow.hpp"
#include "vesper/sky/star_visibility.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace vesper {
namespace {

enum Measure : std::uint64_t { illuminance, zenith_luminance };

/// A stream of random numbers of this scene's own.
std::uint64_t stream_of(const SkyState& sky, Measure measure, std::size_t light) {
  std::uint64_t stream = 2 * measure + light;
  for (const double part : {sky.instant.tt.value(), sky.observer.latitude.to(deg), sky.observer.longitude.to(deg),
                            sky.observer.height.to(metre)}) {
    stream = RandomStream::mix(stream ^ std::bit_cast<std::uint64_t>(part));
  }
  return stream;
}

/// Sun and Moon or one of them, each to be seen by the eye.
std::vector<WeightedLight> lights_for_eyes(const ReportedScene& scene, Measure measure, std::string_view only) {
  std::vector<WeightedLight> weighted;
  const std::vector<double>& wavelengths_nm = scene.air.transport().wavelengths_nm();
  for (SkyLight& light : lights_of(scene.sky, SunInEclipse::outside_the_shadow)) {
    if (!only.empty() && light.name != only) {
      continue;
    }
    const std::vector<double> y = spectral_weights(light.irradiance, wavelengths_nm).y;
    const std::uint64_t stream = stream_of(scene.sky, measure, light.name == "sun" ? 0 : 1);
    LightShare share = light.name == "sun" ? moon_shadow_share(scene.sky, wavelengths_nm) : LightShare{};
    weighted.push_back({std::move(light), {y}, stream, std::move(share)});
  }
  return weighted;
}

// A hundredth of the darkest night. What is fainter would take long to be known as well, and nobody could tell.
constexpr double faint_lux = 6.0e-6;
constexpr double faint_cd_m2 = 1.7e-6;

LevelLight reference_illuminance(const ReportedScene& scene, std::string_view only = "") {
  return level_light(scene.air.transport(), height_in_air(scene.sky.observer),
                     lights_for_eyes(scene, illuminance, only), {scene.air.budget(), faint_lux});
}

double reference_zenith(const ReportedScene& scene, std::string_view only = "") {
  return sky_radiance(scene.air.transport(), height_in_air(scene.sky.observer), {0.0, 0.0, 1.0},
                      lights_for_eyes(scene, zenith_luminance, only), 1, {scene.air.budget(), faint_cd_m2})
      .quantities[0]
      .mean;
}

SourceLight reference_light(const ReportedScene& scene, std::string_view source) {
  const LevelLight level = reference_illuminance(scene, source);
  return {level.direct, level.total.mean - level.direct, reference_zenith(scene, source)};
}

/// By the tables. In an eclipse the air dims the Sun place by place, and the observer sees what is left of it here.
SceneLight light_by_tables(const ReportedScene& scene) {
  const SkyTables& tables = scene.air.tables();
  const Length height = height_in_air(scene.sky.observer);
  const std::vector<SkyLight> lights = lights_of(scene.sky, SunInEclipse::outside_the_shadow);
  SceneLight light = table_light(tables, height, lights);
  const bool sunlit = std::any_of(lights.begin(), lights.end(), [](const SkyLight& l) { return l.name == "sun"; });
  if (sunlit && moon_shadow(scene.sky, {})) {
    const std::shared_ptr<const EclipsedAir>& air = scene.air.eclipsed();
    const EclipsedSky sky(air, moon_shadow(scene.sky, air->wavelengths_nm()).value(), height, 1);
    light.sun.direct_lux = table_light(tables, height, lights_of(scene.sky)).sun.direct_lux;
    light.sun.diffuse_lux *= static_cast<double>(sky.level_ratio().y);
    const f32::vec4 left = sky.ratios({0.0, 0.0, 1.0}).all;
    light.sun.zenith_luminance_cd_m2 *= static_cast<double>(left.y);
    light.sun.zenith_scotopic_cd_m2 *= static_cast<double>(left.w);
  }
  return light;
}

bool by_tables(const ReportedScene& scene) { return scene.air.model() != SkyModel::reference; }

double horizontal_illuminance_lux(const ReportedScene& scene) {
  const double dark = dark_light_of(scene).sum().illuminance_lux;
  if (by_tables(scene)) {
    const auto& [sun, moon] = light_of(scene);
    return sun.direct_lux + sun.diffuse_lux + moon.direct_lux + moon.diffuse_lux + dark;
  }
  return reference_illuminance(scene).total.mean + dark; // at less cost than the sum of its parts
}

double zenith_luminance_cd_m2(const ReportedScene& scene) {
  const double dark = dark_light_of(scene).sum().zenith_luminance_cd_m2;
  if (by_tables(scene)) {
    return light_of(scene).sun.zenith_luminance_cd_m2 + light_of(scene).moon.zenith_luminance_cd_m2 + dark;
  }
  return reference_zenith(scene) + dark;
}

template <DarkSourceLight DarkLight::*source, double DarkSourceLight::*part>
double dark_part(const ReportedScene& scene) {
  return dark_light_of(scene).*source.*part;
}

double zenith_limiting_magnitude(const ReportedScene& scene) {
  const SceneLight light = by_tables(scene) ? light_of(scene) : light_by_tables(scene);
  const DarkSourceLight dark = dark_light_of(scene).sum();
  const Vec4 background(
      0.0, light.sun.zenith_luminance_cd_m2 + light.moon.zenith_luminance_cd_m2 + dark.zenith_luminance_cd_m2, 0.0,
      light.sun.zenith_scotopic_cd_m2 + light.moon.zenith_scotopic_cd_m2 + dark.zenith_scotopic_cd_m2);
  const Vec4 share = scene.air.dark_air(height_in_air(scene.sky.observer))->direct.starlight_share(1.0);
  return limiting_magnitude(background, usual_star(share), scene.air.field_factor());
}

double zenith_extinction(const ReportedScene& scene) {
  return zenith_extinction_v_mag(scene.air.medium(), height_in_air(scene.sky.observer), solar_irradiance_1au());
}

constexpr std::array of_light{
    SceneColumn{"zenith_extinction_v_mag", zenith_extinction},
    SceneColumn{"horizontal_illuminance_lux", horizontal_illuminance_lux, true},
    SceneColumn{"zenith_luminance_cd_m2", zenith_luminance_cd_m2, true},
    SceneColumn{"limiting_magnitude", zenith_limiting_magnitude, true},
    SceneColumn{"sun_direct_illuminance_lux", [](const ReportedScene& s) { return light_of(s).sun.direct_lux; }, true},
    SceneColumn{"sun_diffuse_illuminance_lux", [](const ReportedScene& s) { return light_of(s).sun.diffuse_lux; },
                true},
    SceneColumn{"sun_zenith_luminance_cd_m2",
                [](const ReportedScene& s) { return light_of(s).sun.zenith_luminance_cd_m2; }, true},
    SceneColumn{"moon_direct_illuminance_lux", [](const ReportedScene& s) { return light_of(s).moon.direct_lux; },
                true},
    SceneColumn{"moon_diffuse_illuminance_lux", [](const ReportedScene& s) { return light_of(s).moon.diffuse_lux; },
                true},
    SceneColumn{"moon_zenith_luminance_cd_m2",
                [](const ReportedScene& s) { return light_of(s).moon.zenith_luminance_cd_m2; }, true},
    SceneColumn{"airglow_illuminance_lux", dark_part<&DarkLight::airglow, &DarkSourceLight::illuminance_lux>, true},
    SceneColumn{"airglow_zenith_luminance_cd_m2",
                dark_part<&DarkLight::airglow, &DarkSourceLight::zenith_luminance_cd_m2>, true},
    SceneColumn{"zodiacal_illuminance_lux", dark_part<&DarkLight::zodiacal, &DarkSourceLight::illuminance_lux>, true},
    SceneColumn{"zodiacal_zenith_luminance_cd_m2",
                dark_part<&DarkLight::zodiacal, &DarkSourceLight::zenith_luminance_cd_m2>, true},
    SceneColumn{"starlight_illuminance_lux", dark_part<&DarkLight::starlight, &DarkSourceLight::illuminance_lux>, true},
    SceneColumn{"starlight_zenith_luminance_cd_m2",
                dark_part<&DarkLight::starlight, &DarkSourceLight::zenith_luminance_cd_m2>, true},
    SceneColumn{"sky_glow_illuminance_lux", dark_part<&DarkLight::sky_glow, &DarkSourceLight::illuminance_lux>, true},
    SceneColumn{"sky_glow_zenith_luminance_cd_m2",
                dark_part<&DarkLight::sky_glow, &DarkSourceLight::zenith_luminance_cd_m2>, true},
};

} // namespace

const SceneLight& light_of(const ReportedScene& scene) {
  if (!scene.light) {
    scene.light = by_tables(scene) ? light_by_tables(scene)
                                   : SceneLight{reference_light(scene, "sun"), reference_light(scene, "moon")};
  }
  return *scene.light;
}

const DarkLight& dark_light_of(const ReportedScene& scene) {
  if (!scene.dark) {
    scene.dark = dark_light(scene.sky, *scene.air.dark_air(height_in_air(scene.sky.observer)), scene.air.dark_sky());
  }
  return *scene.dark;
}

std::span<const SceneColumn> light_columns() { return of_light; }

} // namespace vesper
