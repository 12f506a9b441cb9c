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

MoonBrightness moon_of(const SkyState& sky) { return moon_brightness(moonlight_of(sky), sky.moon.place.distance); }

double sun_illuminance_lux(const SkyState& sky) { return integrate_xyzs(sunlight_of(sky)).y; }

double sun_disc_luminance_cd_m2(const SkyState& sky) {
  const double sine = sun_radius / sky.sun.distance;
  return sun_illuminance_lux(sky) / (std::numbers::pi * sine * sine);
}

constexpr std::array columns{
    SceneColumn{"sun_magnitude", [](const ReportedScene& s) { return v_magnitude(sunlight_of(s.sky)); }},
    SceneColumn{"sun_illuminance_lux", [](const ReportedScene& s) { return sun_illuminance_lux(s.sky); }},
    SceneColumn{"sun_disc_luminance_cd_m2", [](const ReportedScene& s) { return sun_disc_luminance_cd_m2(s.sky); }},
    SceneColumn{"moon_magnitude", [](const ReportedScene& s) { return moon_of(s.sky).v_magnitude; }},
    SceneColumn{"moon_illuminance_lux", [](const ReportedScene& s) { return moon_of(s.sky).illuminance.y; }},
    SceneColumn{"moon_disc_luminance_cd_m2",
                [](const ReportedScene& s) { return moon_of(s.sky).mean_luminance.to(candela_per_m2); }},
    SceneColumn{"moon_danjon", [](const ReportedScene& s) { return seen_danjon_of(s.sky); }},
};

} // namespace

double seen_danjon_of(const SkyState& sky) {
  return sky.lunar_eclipse.umbral_magnitude < 1.0 ? std::numeric_limits<double>::quiet_NaN()
                                                  : seen_danjon(dimming_v_mag(sunlight_on_moon(sky)));
}

std::span<const SceneColumn> body_columns() { return columns; }

} // namespace vesper
