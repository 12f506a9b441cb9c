// info and check: a product read back.

#include "catalog/commands.hpp"
#include "common/program.hpp"

#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/sha256.hpp"

#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
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

void run_info(const InspectOptions& options) {
  const Bytes bytes = read_file(options.file);
  const StarCatalogue catalogue = decode_star_glb(bytes, options.file);
  const StarProvenance& p = catalogue.provenance;
  const Json json{{"file", options.file},
                  {"bytes", bytes.size()},
                  {"sha256", sha256_hex(bytes)},
                  {"stars", catalogue.stars.size()},
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

void run_check(const InspectOptions& options) {
  const Bytes bytes = read_file(options.file);
  try {
    const StarCatalogue catalogue = decode_star_glb(bytes, options.file);
    const double total = total_illuminance_lux(catalogue);
    const double stated = catalogue.provenance.illuminance_lux;
    if (options.json) {
      print({{"file", options.file},
             {"valid", true},
             {"stars", catalogue.stars.size()},
             {"illuminance_lux", total},
             {"illuminance_relative_change", (total - stated) / stated}});
    } else {
      write_standard_output(fmt::format("{}: valid, {} stars, {:.9e} lx together ({:+.1e} relative to the source)\n",
                                        options.file, catalogue.stars.size(), total, (total - stated) / stated));
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
  command->add_option("file", options.file, "A star buffer (.glb)")->required()->type_name("FILE");
  command->add_flag("--json", options.json, "Print JSON");
}

} // namespace

std::function<void()> add_info_command(CLI::App& app) {
  auto options = std::make_shared<InspectOptions>();
  add_inspection(app, "info", "Say what a star buffer holds and where it comes from", *options);
  return [options] { run_info(*options); };
}

std::function<void()> add_check_command(CLI::App& app) {
  auto options = std::make_shared<InspectOptions>();
  add_inspection(app, "check", "Verify a star buffer: layout, values, order, counts and total illuminance", *options);
  return [options] { run_check(*options); };
}

} // namespace vesper
