// info and check: a product read back.

#include "catalog/commands.hpp"
#include "common/program.hpp"

#include "vesper/assets/image_file.hpp"
#include "vesper/assets/moon_map.hpp"
#include "vesper/assets/sky_map.hpp"
#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/sha256.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <string>

namespace vesper {
namespace {

using Json = nlohmann::ordered_json;

struct InspectOptions {
  std::string file;
  bool json = false;
};

void print(const Json& json) { write_standard_output(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); }

/// A float as it prints: 7.96, not 7.960000038146973.
double shortest(float value) { return std::stod(fmt::format("{}", value)); }

enum class Product { stars, sky, moon };

/// A map is known by its channels.
Product product_of(std::span<const std::byte> bytes, const std::string& file) {
  constexpr std::array magic{std::byte{0x76}, std::byte{0x2f}, std::byte{0x31}, std::byte{0x01}};
  if (bytes.size() < magic.size() || !std::equal(magic.begin(), magic.end(), bytes.begin())) {
    return Product::stars;
  }
  const ImageRows image(file);
  const std::vector<std::string>& channels = image.channel_names();
  return std::find(channels.begin(), channels.end(), "S") != channels.end() ? Product::sky : Product::moon;
}

Json star_info(const Bytes& bytes, const std::string& file) {
  const StarCatalogue catalogue = decode_star_glb(bytes, file);
  const StarProvenance& p = catalogue.provenance;
  return {{"stars", catalogue.stars.size()},
          {"brightest_magnitude", shortest(catalogue.identities.front().magnitude)},
          {"faintest_magnitude", shortest(catalogue.identities.back().magnitude)},
          {"illuminance_lux", total_illuminance_lux(catalogue)},
          {"epoch_jyear", p.epoch_jyear},
          {"source", p.source},
          {"source_file", p.source_file},
          {"source_sha256", p.source_sha256},
          {"source_entries", p.read},
          {"tool", p.tool},
          {"options", p.options},
          {"licence", p.licence}};
}

Json moon_info(const Bytes& bytes, const std::string& file) {
  const MoonMap map = decode_moon_map(bytes, file);
  const MoonMapProvenance& p = map.provenance;
  return {{"face_size", map.face_size},
          {"disc_albedo", moon_disc_albedo(map)},
          {"albedo_scale", p.albedo_scale},
          {"albedo_file", p.albedo_file},
          {"albedo_sha256", p.albedo_sha256},
          {"albedo_pixels", p.albedo_pixels},
          {"albedo_filled", p.albedo_filled},
          {"elevation_file", p.elevation_file},
          {"elevation_sha256", p.elevation_sha256},
          {"label_sha256", p.label_sha256},
          {"elevation_pixels", p.elevation_pixels},
          {"elevation_filled", p.elevation_filled},
          {"tool", p.tool},
          {"options", p.options}};
}

/// The budget of a map's light as its maker wrote it, or nothing of it where that is no JSON.
Json budget_of(const SkyMap& map) { return Json::parse(map.provenance.budget, nullptr, false); }

Json sky_info(const Bytes& bytes, const std::string& file) {
  const SkyMap map = decode_sky_map(bytes, file);
  const SkyMapProvenance& p = map.provenance;
  const Json budget = budget_of(map);
  const auto light = sky_illuminance(map);
  return {{"face_size", map.face_size},
          {"calibrated", !p.calibration.starts_with("uncalibrated")},
          {"mean_luminance_cd_m2", light[1] / (4.0 * std::numbers::pi)},
          {"light_xyzs_lux", light},
          {"source_files", p.source_files},
          {"source_sha256", p.source_sha256},
          {"coordinates", p.coordinates},
          {"tool", p.tool},
          {"options", p.options},
          {"calibration", p.calibration},
          {"credit", p.credit},
          {"budget", budget.is_discarded() ? Json(p.budget) : budget}};
}

void run_info(const InspectOptions& options) {
  const Bytes bytes = read_file(options.file);
  Json json{{"file", options.file}, {"bytes", bytes.size()}, {"sha256", sha256_hex(bytes)}};
  const auto info = [&] {
    switch (product_of(bytes, options.file)) {
    case Product::sky:
      return sky_info(bytes, options.file);
    case Product::moon:
      return moon_info(bytes, options.file);
    default:
      return star_info(bytes, options.file);
    }
  };
  json.update(info());
  if (options.json) {
    print(json);
    return;
  }
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text += fmt::format("{:<20} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  write_standard_output(text);
}

/// What was found, as JSON and in words.
struct Finding {
  Json json;
  std::string text;
};

Finding check_stars(const Bytes& bytes, const std::string& file) {
  const StarCatalogue catalogue = decode_star_glb(bytes, file);
  const double total = total_illuminance_lux(catalogue);
  const double stated = catalogue.provenance.illuminance_lux;
  const double change = (total - stated) / stated;
  return {{{"stars", catalogue.stars.size()}, {"illuminance_lux", total}, {"illuminance_relative_change", change}},
          fmt::format("{} stars, {:.9e} lx together ({:+.1e} relative to the source)", catalogue.stars.size(), total,
                      change)};
}

Finding check_moon(const Bytes& bytes, const std::string& file) {
  const MoonMap map = decode_moon_map(bytes, file);
  const double albedo = moon_disc_albedo(map);
  return {{{"face_size", map.face_size}, {"disc_albedo", albedo}},
          fmt::format("a map of the Moon, 6 faces of {0} x {0}, albedo of the disc {1:.4f}", map.face_size, albedo)};
}

/// That the light is what the budget says, to the rounding of its sum, and that none is negative.
Finding check_sky(const Bytes& bytes, const std::string& file) {
  const SkyMap map = decode_sky_map(bytes, file);
  const auto light = sky_illuminance(map);
  const Json budget = budget_of(map);
  const char* key = "out_xyzs_lux";
  const Json counted = budget.is_object() ? budget.value(key, Json()) : Json();
  const bool stated = counted.is_array() && counted.size() == light.size() && counted.at(1).is_number();
  if (stated) {
    const double luminous = counted.at(1).get<double>();
    if (!(std::abs(light[1] - luminous) <= 1.0e-6 * std::abs(luminous))) {
      throw Error(ErrorKind::input, fmt::format("holds {:.6e} lx where its maker counted {:.6e}", light[1], luminous),
                  {file, fmt::format("budget, {}", key), "Make the map again with vesper-catalog panorama"});
    }
  }
  std::size_t negative = 0;
  for (std::size_t i = 1; i < map.texels.size(); i += 4) {
    negative += map.texels[i] < 0.0F ? 1U : 0U;
  }
  return {{{"face_size", map.face_size},
           {"calibrated", !map.provenance.calibration.starts_with("uncalibrated")},
           {"light_xyzs_lux", light},
           {"budget_stated", stated},
           {"negative_texels", negative}},
          fmt::format("a map of the sky, 6 faces of {0} x {0}, {1:.6e} lx together{2}{3}", map.face_size, light[1],
                      stated ? ", as its maker counted" : "",
                      negative > 0 ? fmt::format(", {} texels below zero", negative) : "")};
}

void run_check(const InspectOptions& options) {
  const Bytes bytes = read_file(options.file);
  try {
    const Product product = product_of(bytes, options.file);
    const Finding found = product == Product::sky    ? check_sky(bytes, options.file)
                          : product == Product::moon ? check_moon(bytes, options.file)
                                                     : check_stars(bytes, options.file);
    if (options.json) {
      Json json{{"file", options.file}, {"valid", true}};
      json.update(found.json);
      print(json);
    } else {
      write_standard_output(fmt::format("{}: valid, {}\n", options.file, found.text));
    }
  } catch (const Error& error) {
    if (options.json && error.kind() == ErrorKind::input) {
      print({{"file", options.file}, {"valid", false}, {"error", error.what()}});
    }
    throw;
  }
}

void add_inspection(CLI::App& app, const char* name, const char* help, InspectOptions& options) {
  CLI::App* command = app.add_subcommand(name, help);
  command->add_option("file", options.file, "A star buffer (.glb), a map of the sky or of the Moon (.exr)")
      ->required()
      ->type_name("FILE");
  command->add_flag("--json", options.json, "Print JSON");
}

} // namespace

std::function<void()> add_info_command(CLI::App& app) {
  auto options = std::make_shared<InspectOptions>();
  add_inspection(app, "info", "Say what a product holds and where it comes from", *options);
  return [options] { run_info(*options); };
}

std::function<void()> add_check_command(CLI::App& app) {
  auto options = std::make_shared<InspectOptions>();
  add_inspection(app, "check", "Verify a product: layout, values, order, counts, and its light", *options);
  return [options] { run_check(*options); };
}

} // namespace vesper
