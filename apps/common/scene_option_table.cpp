#include "common/scene_option_table.hpp"

#include "common/option_text.hpp"
#include "common/sky_glow_text.hpp"

#include "vesper/atmosphere/earth_shadow_load.hpp"
#include "vesper/atmosphere/medium_file.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/light/night_light.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace vesper {
namespace {

std::string join(std::span<const std::string_view> names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string apply_time_scale(std::string_view text, SceneOptions& scene) {
  if (text == "utc") {
    scene.time_scale = TimeScale::utc;
  } else if (text == "ut1") {
    scene.time_scale = TimeScale::ut1;
  } else if (text == "tt") {
    scene.time_scale = TimeScale::tt;
  } else {
    return "utc, ut1, tt";
  }
  return "";
}

std::string apply_calendar(std::string_view text, SceneOptions& scene) {
  if (text == "gregorian") {
    scene.calendar = Calendar::gregorian;
  } else if (text == "julian") {
    scene.calendar = Calendar::julian;
  } else {
    return "gregorian, julian";
  }
  return "";
}

std::string apply_time(std::string_view text, SceneOptions& scene) {
  scene.instant = parse_instant(text, scene.time_scale, scene.calendar);
  return "";
}

std::string apply_latitude(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, -90.0, 90.0);
  if (!value) {
    return "-90 to 90 degrees";
  }
  scene.observer.latitude = *value * deg;
  scene.latitude_given = true;
  return "";
}

std::string apply_longitude(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, -180.0, 360.0);
  if (!value) {
    return "-180 to 360 degrees, east positive";
  }
  scene.observer.longitude = *value * deg;
  scene.longitude_given = true;
  return "";
}

std::string apply_height(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, lowest_height_m, highest_height_m);
  if (!value) {
    return fmt::format("{:.0f} to {:.0f} metres above the ellipsoid", lowest_height_m, highest_height_m);
  }
  scene.observer.height = *value * metre;
  scene.height_given = true;
  return "";
}

std::string apply_pressure(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, 0.0, 1100.0);
  if (!value) {
    return "0 to 1100 hPa";
  }
  scene.pressure_hpa = *value;
  return "";
}

std::string apply_temperature(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, -90.0, 60.0);
  if (!value) {
    return "-90 to 60 degrees Celsius";
  }
  scene.temperature_c = *value;
  return "";
}

std::string apply_projection(std::string_view text, SceneOptions& scene) {
  const auto projection = projection_from_name(text);
  if (!projection) {
    return join(projection_names());
  }
  scene.view.projection = *projection;
  return "";
}

std::string apply_azimuth(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, -360.0, 360.0);
  if (!value) {
    return "-360 to 360 degrees, north through east";
  }
  scene.view.azimuth = *value * deg;
  return "";
}

std::string apply_altitude(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, -90.0, 90.0);
  if (!value) {
    return "-90 to 90 degrees";
  }
  scene.view.altitude = *value * deg;
  return "";
}

std::string apply_roll(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, -360.0, 360.0);
  if (!value) {
    return "-360 to 360 degrees, positive clockwise";
  }
  scene.view.roll = *value * deg;
  return "";
}

std::string apply_fov(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, 0.0, 360.0);
  switch (scene.view.projection) {
  case Projection::perspective:
    if (!value || *value <= 0.0 || *value >= 170.0) {
      return "perspective takes 0 < fov < 170 degrees";
    }
    break;
  case Projection::stereographic:
    if (!value || *value <= 0.0 || *value >= 350.0) {
      return "stereographic takes 0 < fov < 350 degrees";
    }
    break;
  default:
    if (!value || *value <= 0.0) {
      return fmt::format("{} takes 0 < fov <= 360 degrees",
                         projection_names()[static_cast<std::size_t>(scene.view.projection)]);
    }
  }
  scene.view.fov = *value * deg;
  return "";
}

constexpr int largest_side = 16384; // pixels

std::string apply_size(std::string_view text, SceneOptions& scene) {
  const std::size_t cross = text.find('x');
  const auto width = parse_number<int>(text.substr(0, cross));
  const auto height = cross == std::string_view::npos ? std::nullopt : parse_number<int>(text.substr(cross + 1));
  const bool cube = scene.view.projection == Projection::cubemap;
  // A square cube map is the size of a face: six of them are stacked.
  const auto stacked = cube && width && height && *width == *height ? height.value() * 6LL : height.value_or(0);
  const bool in_range = width && height && *width >= 1 && *width <= largest_side && *height >= 1 &&
                        (cube || *height <= largest_side) && stacked <= 6LL * largest_side;
  if (!in_range || (cube && stacked != 6LL * *width)) {
    return cube ? fmt::format("cubemap takes WxW, the size of a face, or Wx6W, with W from 1 to {}", largest_side)
                : fmt::format("WIDTHxHEIGHT, each 1 to {} pixels", largest_side);
  }
  scene.view.width = *width;
  scene.view.height = static_cast<int>(stacked);
  return "";
}

std::string apply_tier(std::string_view text, SceneOptions& scene) {
  if (text == "cheap") {
    scene.tier = Tier::cheap;
  } else if (text == "default") {
    scene.tier = Tier::standard;
  } else if (text == "reference") {
    scene.tier = Tier::reference;
  } else {
    return "cheap, default, reference";
  }
  return "";
}

std::string apply_medium(std::string_view text, SceneOptions& scene) {
  std::optional<Medium> medium = names_a_file(text) ? read_medium_file(text) : medium_by_name(text);
  if (!medium) {
    return join(medium_names()) + " or a file, its name with a slash or ending in .toml";
  }
  scene.medium_name = text;
  scene.medium = std::make_shared<const Medium>(*std::move(medium));
  return "";
}

std::string apply_layers(std::string_view text, SceneOptions& scene) {
  LayerSet layers;
  for (const std::string_view name : list_items(text)) {
    const auto layer = layer_from_name(name);
    if (!layer) {
      return "a comma-separated list of " + join(layer_names());
    }
    layers.set(static_cast<std::size_t>(*layer));
  }
  scene.layers = layers;
  return "";
}

std::string apply_sky(std::string_view text, SceneOptions& scene) {
  if (text == "tables") {
    scene.sky = SkyModel::tables;
  } else if (text == "small-tables") {
    scene.sky = SkyModel::small_tables;
  } else if (text == "reference") {
    scene.sky = SkyModel::reference;
  } else {
    return "tables, small-tables, reference";
  }
  return "";
}

std::string apply_solar_flux(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, lowest_solar_flux_sfu, highest_solar_flux_sfu);
  if (!value) {
    return fmt::format("{:.0f} to {:.0f} solar flux units", lowest_solar_flux_sfu, highest_solar_flux_sfu);
  }
  scene.dark_sky.solar_flux_sfu = *value;
  return "";
}

std::string apply_sky_glow(std::string_view text, SceneOptions& scene) {
  const auto value = sky_glow_from_text(text);
  if (!value) {
    return std::string(sky_glow_texts);
  }
  scene.dark_sky.glow.zenith = *value;
  return "";
}

std::string apply_sky_glow_azimuth(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, -360.0, 360.0);
  if (!value) {
    return "-360 to 360 degrees, north through east";
  }
  scene.dark_sky.glow.azimuth = *value * deg;
  return "";
}

std::string apply_sky_glow_distance(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, nearest_city_km, farthest_city_km);
  if (!value) {
    return fmt::format("{:.0f} to {:.0f} km", nearest_city_km, farthest_city_km);
  }
  scene.dark_sky.glow.distance = *value * kilometre;
  return "";
}

std::string apply_field_factor(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, 0.5, 10.0);
  if (!value) {
    return "0.5 to 10, keen to casual";
  }
  scene.field_factor = *value;
  return "";
}

std::string apply_danjon(std::string_view text, SceneOptions& scene) {
  const auto value = number_within(text, least_danjon, most_danjon);
  if (!value) {
    return fmt::format("{:.0f} to {:.0f}, dark to bright", least_danjon, most_danjon);
  }
  scene.danjon = *value;
  return "";
}

std::string apply_seed(std::string_view text, SceneOptions& scene) {
  const auto value = parse_number<std::uint64_t>(text);
  if (!value) {
    return "an integer from 0 to 18446744073709551615";
  }
  scene.seed = *value;
  return "";
}

using Kind = SceneValueKind;
constexpr std::string_view place = "Time and place";
constexpr std::string_view view = "View";
constexpr std::string_view model = "Model";

// Options that others depend on stand before them.
constexpr std::array table{
    SceneOptionDescription{"time-scale", Kind::text, "SCALE", place,
                           "Scale of a time stamp: utc, ut1 or tt; default utc", apply_time_scale},
    SceneOptionDescription{"calendar", Kind::text, "NAME", place,
                           "Calendar of a time stamp: gregorian or julian, over all time; default gregorian",
                           apply_calendar},
    SceneOptionDescription{"time", Kind::time, "STAMP", place, "2026-08-12T22:00:00Z, JD2461265.4 or now; default now",
                           apply_time},
    SceneOptionDescription{"latitude", Kind::number, "DEG", place,
                           "Geodetic latitude, -90 to 90; default Greenwich, 51.4769", apply_latitude},
    SceneOptionDescription{"longitude", Kind::number, "DEG", place,
                           "Longitude, east positive, -180 to 360; default Greenwich, 0", apply_longitude},
    SceneOptionDescription{"height", Kind::number, "M", place,
                           "Height above the ellipsoid, -500 to 100000000; default 0, at Greenwich 47", apply_height},
    SceneOptionDescription{"pressure", Kind::number, "HPA", place,
                           "Air pressure at the observer, 0 to 1100; default that of the standard atmosphere",
                           apply_pressure},
    SceneOptionDescription{"temperature", Kind::number, "C", place,
                           "Air temperature at the observer, -90 to 60; default that of the standard atmosphere",
                           apply_temperature},
    SceneOptionDescription{"projection", Kind::text, "NAME", view,
                           "perspective, fisheye, stereographic, equirectangular or cubemap; default fisheye",
                           apply_projection},
    SceneOptionDescription{"azimuth", Kind::number, "DEG", view,
                           "Azimuth of the view, north 0, east 90, -360 to 360; default 180", apply_azimuth},
    SceneOptionDescription{"altitude", Kind::number, "DEG", view,
                           "Altitude of the view, -90 to 90; default 90, the zenith", apply_altitude},
    SceneOptionDescription{"roll", Kind::number, "DEG", view, "Turns the picture clockwise, -360 to 360; default 0",
                           apply_roll},
    SceneOptionDescription{"fov", Kind::number, "DEG", view,
                           "Full angle across the shorter side: perspective below 170 (default 60), fisheye to 360, "
                           "stereographic below 350 (default 180)",
                           apply_fov},
    SceneOptionDescription{"size", Kind::text, "WxH", view,
                           "Pixels, each side 1 to 16384; default 1024x1024. For a cube map the size of a face",
                           apply_size},
    SceneOptionDescription{"tier", Kind::text, "NAME", model, "cheap, default or reference; default default",
                           apply_tier},
    SceneOptionDescription{"medium", Kind::name_or_file, "NAME|FILE", model,
                           "The air: clear, published or a TOML file (docs/MEDIUM.md); default clear", apply_medium},
    SceneOptionDescription{"layers", Kind::list, "LIST", model,
                           "What to draw, comma-separated: stars, planets, milky-way, moon, sun, sky, airglow, "
                           "zodiacal, sky-glow, ground; default all",
                           apply_layers},
    SceneOptionDescription{
        "sky", Kind::text, "NAME", model,
        "How the light of the air is found: tables, solved once for a medium and kept; small-tables, "
        "a cheap way that is good by day; or reference, a Monte Carlo; default tables",
        apply_sky},
    SceneOptionDescription{
        "solar-flux", Kind::number, "SFU", model,
        "The Sun at 10.7 cm, which the airglow follows, 60 to 400: about 70 at solar minimum, 200 at "
        "maximum; default that of the date in a mean cycle",
        apply_solar_flux},
    SceneOptionDescription{"sky-glow", Kind::number_or_text, "LEVEL", model,
                           "Artificial light at the zenith: its luminance (0.002, in cd/m2), the whole zenith's "
                           "brightness as a meter gives it (20.5mag) or a class (bortle5); default off",
                           apply_sky_glow},
    SceneOptionDescription{"sky-glow-azimuth", Kind::number, "DEG", model,
                           "Azimuth of the city that it comes from, -360 to 360; default cities all around",
                           apply_sky_glow_azimuth},
    SceneOptionDescription{"sky-glow-distance", Kind::number, "KM", model,
                           "Distance of the city or cities, 1 to 300; default 30", apply_sky_glow_distance},
    SceneOptionDescription{"danjon", Kind::number, "L", model,
                           "How clear the Earth's air is in eclipses of the Moon, on Danjon's scale: 0, after great "
                           "eruptions, to 4; default 2.5",
                           apply_danjon},
    SceneOptionDescription{"field-factor", Kind::number, "F", model,
                           "Light that the observer needs to see a star, over the least in the laboratory, 0.5 to 10: "
                           "1.4 keen, 2.4 casual; default 1.7",
                           apply_field_factor},
    SceneOptionDescription{"seed", Kind::integer, "N", model, "Seed of everything random, 0 or above; default 0",
                           apply_seed},
};

} // namespace

std::span<const SceneOptionDescription> scene_option_table() { return table; }

bool names_a_file(std::string_view value) {
  return value.find('/') != std::string_view::npos || value.ends_with(".toml");
}

} // namespace vesper
