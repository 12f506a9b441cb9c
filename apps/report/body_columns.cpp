#include "report/body_columns.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/moon_illumination.hpp"
#include "vesper/sky/sky_light.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace vesper {
namespace {

/// Found once a scene: in an eclipse it takes most of a row's time.
const DiscBrightness& discs_of(const ReportedScene& scene) {
  if (!scene.discs) {
    const SkyState& sky = scene.sky;
    const Spectrum sunlight = sunlight_of(sky);
    const MoonIllumination moon = moon_illumination(sky);
    scene.discs = {v_magnitude(sunlight), integrate_xyzs(sunlight).y,
                   moon_brightness(moonlight_of(moon), sky.moon.place.distance), seen_danjon_of(sky, moon)};
  }
  return *scene.discs;
}

double sun_disc_luminance_cd_m2(const ReportedScene& scene) {
  const double sine = sun_radius / scene.sky.sun.distance;
  return discs_of(scene).sun_illuminance_lux / (std::numbers::pi * sine * sine);
}

constexpr std::array of_bodies{
    SceneColumn{"sun_magnitude", [](const ReportedScene& s) { return discs_of(s).sun_magnitude; }},
    SceneColumn{"sun_illuminance_lux", [](const ReportedScene& s) { return discs_of(s).sun_illuminance_lux; }},
    SceneColumn{"sun_disc_luminance_cd_m2", sun_disc_luminance_cd_m2},
    SceneColumn{"moon_magnitude", [](const ReportedScene& s) { return discs_of(s).moon.v_magnitude; }},
    SceneColumn{"moon_illuminance_lux", [](const ReportedScene& s) { return discs_of(s).moon.illuminance.y; }},
    SceneColumn{"moon_disc_luminance_cd_m2",
                [](const ReportedScene& s) { return discs_of(s).moon.mean_luminance.to(candela_per_m2); }},
    SceneColumn{"moon_danjon", [](const ReportedScene& s) { return discs_of(s).moon_danjon; }},
};

} // namespace

double seen_danjon_of(const SkyState& sky, const MoonIllumination& moon) {
  return sky.lunar_eclipse.umbral_magnitude >= 1.0 && moon.past_earth ? seen_danjon(dimming_v_mag(*moon.past_earth))
                                                                      : std::numeric_limits<double>::quiet_NaN();
}

std::span<const SceneColumn> body_columns() { return of_bodies; }

} // namespace vesper
