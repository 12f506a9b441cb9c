#include "report/scene_text.hpp"

#include "report/body_columns.hpp"
#include "report/sky_figures.hpp"
#include "report/star_report.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/sky/moon_illumination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace vesper {
namespace {

constexpr std::size_t brightest_count = 12;
// A star lower than this drowns in the haze of the horizon; a figure should stand clear of roofs and trees.
constexpr Angle star_lowest = 5.0 * deg;
constexpr Angle figure_lowest = 15.0 * deg;

std::string where(Angle azimuth, Angle altitude) {
  return fmt::format("altitude {:5.1f}°, azimuth {:5.1f}° {}", altitude.to(deg), azimuth.to(deg),
                     compass_point(azimuth));
}

/// The same with the altitude that refraction makes of it, for what stands above or little below the horizon.
std::string where(const BodyPlace& body, const Refraction& refraction, Angle horizon) {
  std::string text = where(body.azimuth, body.altitude);
  const Angle hidden_below = horizon - 2.0 * deg;
  if (refraction.model != RefractionModel::none && body.altitude > hidden_below) {
    const Angle apparent = horizontal_of(apparent_direction(body.direction_horizon, refraction)).altitude;
    text += fmt::format(", apparent altitude {:.2f}°", apparent.to(deg));
  }
  return text;
}

std::string star_label(const StarIdentity& star) {
  if (const std::string_view name = proper_name(star.hr); !name.empty()) {
    return std::string(name);
  }
  return star.name.empty() ? fmt::format("HR {}", star.hr) : star.name;
}

struct Up {
  const StarIdentity* star;
  Vec3 direction; ///< horizon axes
};

std::vector<Up> stars_up(const SkyState& sky, const StarCatalogue& catalogue) {
  const f64::StarPlaceFrame frame = place_frame(sky.stars, catalogue.provenance.epoch_jyear);
  std::vector<Up> up;
  for (std::size_t i = 0; i < catalogue.stars.size() && up.size() < brightest_count; ++i) {
    const Vec3 direction = sky.stars.horizon_from_icrs * star_place_icrs(catalogue_star(catalogue.stars[i]), frame);
    if (horizontal_of(direction).altitude > star_lowest) {
      up.push_back({&catalogue.identities[i], direction});
    }
  }
  return up;
}

/// How the Moon's globe is turned: what part beyond the mean limb libration shows, and where its north lies.
std::string face_text(const MoonState& moon) {
  const double longitude = moon.libration.longitude.to(deg);
  const double latitude = moon.libration.latitude.to(deg);
  return fmt::format("shows {:.1f}° more of its {} and {:.1f}° more of its {} limb; axis at {:.1f}°, bright limb at "
                     "{:.1f}° (north through east)",
                     std::abs(longitude), longitude < 0.0 ? "western" : "eastern", std::abs(latitude),
                     latitude < 0.0 ? "southern" : "northern", moon.axis.to(deg), moon.bright_limb.to(deg));
}

std::string planets_text(const SkyState& sky) {
  std::string text;
  for (std::size_t i = 0; i < sky.planets.size(); ++i) {
    const PlanetState& planet = sky.planets.at(i);
    if (planet.place.altitude > 0.0 * deg) {
      std::string name(name_of(static_cast<Planet>(i)));
      name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
      fmt::format_to(std::back_inserter(text), "  {:<16} {:5.2f} mag  {}; {:4.1f}\" across, {:.0f} % lit\n", name,
                     planet.appearance.magnitude, where(planet.place.azimuth, planet.place.altitude),
                     planet.appearance.diameter.to(arcsec), 100.0 * planet.appearance.illuminated_fraction);
    }
  }
  return text;
}

/// Figures all of whose stars stand clear of the horizon, with the middle of each, highest first.
std::vector<std::pair<std::string_view, Horizontal>> figures_up(const SkyState& sky, const StarCatalogue& catalogue) {
  std::unordered_map<std::uint32_t, std::size_t> index_of_hr;
  for (std::size_t i = 0; i < catalogue.identities.size(); ++i) {
    index_of_hr.emplace(catalogue.identities[i].hr, i);
  }
  const f64::StarPlaceFrame frame = place_frame(sky.stars, catalogue.provenance.epoch_jyear);
  std::vector<std::pair<std::string_view, Horizontal>> up;
  for (const SkyFigure& figure : sky_figures()) {
    Vec3 middle(0.0);
    const bool clear = std::all_of(figure.stars.begin(), figure.stars.end(), [&](std::uint16_t hr) {
      const auto found = index_of_hr.find(hr);
      if (found == index_of_hr.end()) {
        return false;
      }
      const Vec3 direction =
          sky.stars.horizon_from_icrs * star_place_icrs(catalogue_star(catalogue.stars[found->second]), frame);
      middle += direction;
      return horizontal_of(direction).altitude > figure_lowest;
    });
    if (clear) {
      up.emplace_back(figure.name, horizontal_of(middle));
    }
  }
  std::sort(up.begin(), up.end(), [](const auto& a, const auto& b) { return a.second.altitude > b.second.altitude; });
  return up;
}

/// A line for an eclipse that is on.
std::string eclipse_text(const SkyState& sky) {
  const LunarEclipseState& lunar = sky.lunar_eclipse;
  const SolarEclipseState& solar = sky.solar_eclipse;
  const auto down = [](const BodyPlace& place) {
    return place.altitude > almanac_sunrise_altitude ? "" : ", below the horizon";
  };
  if (solar.magnitude > 0.0) {
    return fmt::format("Eclipse of the Sun: magnitude {:.3f}, {:.1f} % of the disc covered{}\n", solar.magnitude,
                       100.0 * solar.obscuration, down(sky.sun));
  }
  if (lunar.penumbral_magnitude > 0.0) {
    const bool umbral = lunar.umbral_magnitude > 0.0;
    const double danjon = seen_danjon_of(sky);
    return fmt::format("Eclipse of the Moon: {} magnitude {:.3f}{}{}\n", umbral ? "umbral" : "penumbral",
                       umbral ? lunar.umbral_magnitude : lunar.penumbral_magnitude,
                       std::isnan(danjon) ? "" : fmt::format(", Danjon's L = {:.1f}", danjon), down(sky.moon.place));
  }
  return "";
}

/// What Sun and Moon give, to three digits.
std::string light_text(const SceneLight& light) {
  std::string text;
  for (const auto& [name, source] : {std::pair("Sun", light.sun), std::pair("Moon", light.moon)}) {
    if (source.diffuse_lux > 0.0) {
      fmt::format_to(std::back_inserter(text),
                     "{}{:.3g} lx of the {} on level ground, {:.3g} lx of it from the sky; zenith {:.3g} cd/m²\n",
                     text.empty() ? "Light   " : "        ", source.direct_lux + source.diffuse_lux, name,
                     source.diffuse_lux, source.zenith_luminance_cd_m2);
    }
  }
  return text;
}

/// What the dark sky adds, where it is not lost in daylight.
std::string dark_text(const DarkLight& dark, bool first) {
  const DarkSourceLight all = dark.sum();
  std::string text =
      fmt::format("{}{:.3g} lx of the dark sky on level ground; zenith {:.3g} cd/m² ({:.2f} mag/arcsec²):\n"
                  "        airglow {:.2g}, zodiacal light {:.2g}, faint stars {:.2g}",
                  first ? "Light   " : "        ", all.illuminance_lux, all.zenith_luminance_cd_m2,
                  v_per_arcsec2(all.zenith_luminance_cd_m2 * candela_per_m2), dark.airglow.zenith_luminance_cd_m2,
                  dark.zodiacal.zenith_luminance_cd_m2, dark.starlight.zenith_luminance_cd_m2);
  if (dark.sky_glow.zenith_luminance_cd_m2 > 0.0) {
    text += fmt::format(", sky glow {:.2g}", dark.sky_glow.zenith_luminance_cd_m2);
  }
  return text + "\n";
}

std::string place_text(const Observer& observer) {
  const double latitude = observer.latitude.to(deg);
  const double longitude = std::remainder(observer.longitude.to(deg), 360.0);
  return fmt::format("{:.4f}° {}, {:.4f}° {}, {:.0f} m", std::abs(latitude), latitude < 0.0 ? 'S' : 'N',
                     std::abs(longitude), longitude < 0.0 ? 'W' : 'E', observer.height.to(metre));
}

} // namespace

std::string_view compass_point(Angle azimuth) {
  constexpr std::array<std::string_view, 16> points{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                                    "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  const double turns = azimuth.to(deg) / 360.0;
  const auto sector = static_cast<std::size_t>(std::lround((turns - std::floor(turns)) * 16.0));
  return points.at(sector % points.size());
}

std::string_view sky_condition(Angle sun_altitude) {
  return sun_altitude > almanac_sunrise_altitude    ? "day"
         : sun_altitude > civil_twilight_end        ? "civil twilight"
         : sun_altitude > nautical_twilight_end     ? "nautical twilight"
         : sun_altitude > astronomical_twilight_end ? "astronomical twilight"
                                                    : "night";
}

std::string_view moon_phase_name(double illuminated_fraction, bool waxing) {
  if (illuminated_fraction < 0.02) {
    return "new Moon";
  }
  if (illuminated_fraction > 0.98) {
    return "full Moon";
  }
  if (illuminated_fraction > 0.45 && illuminated_fraction < 0.55) {
    return waxing ? "first quarter" : "last quarter";
  }
  if (illuminated_fraction < 0.5) {
    return waxing ? "waxing crescent" : "waning crescent";
  }
  return waxing ? "waxing gibbous" : "waning gibbous";
}

std::string scene_text(const SkyState& sky, const StarCatalogue& catalogue, const SceneLight& light,
                       const DarkLight& dark, std::optional<double> limiting_magnitude) {
  const BodyPlace& moon = sky.moon.place;
  const Refraction refraction = with_table(sky.refraction);
  const Angle horizon = horizon_altitude(refraction, sky.observer.height);
  const bool waxing = std::sin((moon.right_ascension - sky.sun.right_ascension).to(rad)) > 0.0;
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "Time    {}\n", to_iso8601(sky.instant));
  for (const std::string& remark : time_remarks(sky.instant)) {
    fmt::format_to(out, "        {}\n", remark);
  }
  fmt::format_to(out, "Place   {}\n", place_text(sky.observer));
  fmt::format_to(out, "Sky     {}\n", sky_condition(sky.sun.altitude));
  fmt::format_to(out, "Sun     {}\n", where(sky.sun, refraction, horizon));
  fmt::format_to(out, "Moon    {}; {}, {:.0f} % lit, {:.2f} mag\n", where(moon, refraction, horizon),
                 moon_phase_name(sky.moon.illuminated_fraction, waxing), 100.0 * sky.moon.illuminated_fraction,
                 v_magnitude(moonlight_of(sky)));
  text += eclipse_text(sky);
  fmt::format_to(out, "        {}\n", face_text(sky.moon));
  const std::string of_sun_and_moon = light_text(light);
  text += of_sun_and_moon;
  if (sky.sun.altitude < civil_twilight_end) {
    text += dark_text(dark, of_sun_and_moon.empty());
  }
  if (limiting_magnitude) {
    fmt::format_to(out, "Limit   {:.1f} mag in the zenith\n", *limiting_magnitude);
  }
  if (const std::string planets = planets_text(sky); !planets.empty()) {
    fmt::format_to(out, "\nPlanets up\n{}", planets);
  }
  const std::vector<Up> stars = stars_up(sky, catalogue);
  const bool hidden =
      limiting_magnitude && !stars.empty() && static_cast<double>(stars.front().star->magnitude) > *limiting_magnitude;
  fmt::format_to(out, "\nBrightest stars up{}\n", hidden ? " (too faint to be seen now)" : "");
  for (const Up& up : stars) {
    const Horizontal place = horizontal_of(up.direction);
    fmt::format_to(out, "  {:<16} {:5.2f} mag  {}\n", star_label(*up.star), up.star->magnitude,
                   where(place.azimuth, place.altitude));
  }
  const auto figures = figures_up(sky, catalogue);
  if (!figures.empty()) {
    fmt::format_to(out, "\nFigures that stand clear of the horizon\n");
    for (const auto& [name, place] : figures) {
      fmt::format_to(out, "  {:<26} {}\n", name, where(place.azimuth, place.altitude));
    }
  }
  return text;
}

} // namespace vesper
