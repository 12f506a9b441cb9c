#include "vesper/sky/star_visibility.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/star_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vesper {
namespace {

constexpr double usual_b_v = 0.7;

struct HidingLight {
  Vec4 SkyBackground::*source;
  Hidden hidden;
};

} // namespace

StarLight usual_star(const Vec4& share) {
  static const Vec4 light = vector_of(star_color(usual_b_v));
  static const double lux_ratio = star_lux_ratio(usual_b_v);
  return {light * share, lux_ratio};
}

double limiting_magnitude(const Vec4& background, const StarLight& star, double field_factor) {
  const double cones = f64::mesopic_cone_share(background.y, background.w);
  const double seen = f64::seen_light(star.at_the_eye.y, star.at_the_eye.w, cones);
  if (!(seen > 0.0)) {
    return -std::numeric_limits<double>::infinity();
  }
  const double least_lux =
      f64::threshold_illuminance_lux(f64::seen_light(background.y, background.w, cones), field_factor);
  return v_of_illuminance(least_lux / seen * lux, star.lux_ratio);
}

std::string_view name_of(Hidden hidden) {
  constexpr std::array<std::string_view, 8> names{"visible",      "below the horizon", "in daylight",    "in twilight",
                                                  "in moonlight", "in sky glow",       "low in the air", "too faint"};
  return names.at(static_cast<std::size_t>(hidden));
}

StarSight star_sight(const StarView& star, const SkyBackground& background, Angle sun_altitude, Angle horizon,
                     double field_factor) {
  StarSight sight{limiting_magnitude(background.sum(), star.light, field_factor), Hidden::no};
  if (star.altitude < horizon) {
    sight.hidden = Hidden::below_horizon;
    return sight;
  }
  if (star.magnitude <= sight.limiting_magnitude) {
    return sight;
  }
  const auto seen = [&](const SkyBackground& sky, const StarLight& light) {
    return star.magnitude <= limiting_magnitude(sky.sum(), light, field_factor);
  };
  const std::array hiding{HidingLight{&SkyBackground::sun, sun_altitude > almanac_sunrise_altitude
                                                               ? Hidden::by_daylight
                                                               : Hidden::by_twilight},
                          HidingLight{&SkyBackground::moon, Hidden::by_moonlight},
                          HidingLight{&SkyBackground::sky_glow, Hidden::by_sky_glow}};
  SkyBackground natural = background;
  for (const HidingLight& light : hiding) {
    SkyBackground without = background;
    without.*light.source = natural.*light.source = Vec4(0.0);
    if (seen(without, star.light)) {
      sight.hidden = light.hidden;
      return sight;
    }
  }
  const auto brightest = [&] {
    return std::max_element(hiding.begin(), hiding.end(),
                            [&](const HidingLight& a, const HidingLight& b) {
                              return (background.*a.source).y < (background.*b.source).y;
                            })
        ->hidden;
  };
  sight.hidden = !seen(natural, star.in_zenith)                                   ? Hidden::too_faint
                 : seen(natural, star.light) || !seen(background, star.in_zenith) ? brightest()
                                                                                  : Hidden::low_in_the_air;
  return sight;
}

} // namespace vesper
