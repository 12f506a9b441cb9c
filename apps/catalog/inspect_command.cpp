// info and check: a product read back.

#include "catalog/commands.hpp"
#include "common/program.hpp"

#include "vesper/assets/moon_map.hpp"
#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/sha256.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
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

bool is_exr(std::span<const std::byte> bytes) {
  constexpr std::array magic{std::byte{0x76}, std::byte{0x2f}, std::byte{0x31}, std::byte{0x01}};
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
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

void run_info(const InspectOptions& options) {
  const Bytes bytes = read_file(options.file);
  Json json{{"file", options.file}, {"bytes", bytes.size()}, {"sha256", sha256_hex(bytes)}};
  json.update(is_exr(bytes) ? moon_info(bytes, options.file) : star_info(bytes, options.file));
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

void run_check(const InspectOptions& options) {
  const Bytes bytes = read_file(options.file);
  try {
    const Finding found = is_exr(bytes) ? check_moon(bytes, options.file) : check_stars(bytes, options.file);
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
  command->add_option("file", options.file, "A star buffer (.glb) or a map of the Moon (.exr)")
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
