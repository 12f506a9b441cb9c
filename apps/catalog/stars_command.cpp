#include "catalog/commands.hpp"
#include "catalog/product_path.hpp"
#include "common/program.hpp"

#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/sha256.hpp"
#include "vesper/catalog_tools/bright_star_catalogue.hpp"
#include "vesper/catalog_tools/star_products.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <spdlog/spdlog.h>
#include <string>

namespace vesper {
namespace {

using Json = nlohmann::ordered_json;

constexpr double brightest_limit = -2.0;
constexpr double faintest_limit = 30.0;

struct StarsOptions {
  std::string input;
  std::string output;
  std::string limit_magnitude;
  bool dry_run = false;
  bool json = false;
};

std::optional<double> parse_limit(const std::string& text) {
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || !(value >= brightest_limit) ||
      !(value <= faintest_limit)) {
    return std::nullopt;
  }
  return value;
}

std::string limit_fault(const std::string& text) {
  return parse_limit(text) ? ""
                           : fmt::format("\"{}\" is not a number from {} to {}", text, brightest_limit, faintest_limit);
}

double relative_change(const StarProductReport& r) {
  return (r.illuminance_after_lux - r.illuminance_before_lux) / r.illuminance_before_lux;
}

std::string report_json(const StarProductReport& r, const StarProvenance& p) {
  Json counts = Json::object();
  for (const auto& [magnitude, count] : r.count_by_magnitude) {
    counts[std::to_string(magnitude)] = count;
  }
  const Json json{
      {"source_file", p.source_file},
      {"source_sha256", p.source_sha256},
      {"options", p.options},
      {"read", r.read},
      {"kept", r.kept},
      {"dropped", r.read - r.kept},
      {"dropped_without_position", r.dropped_without_position},
      {"dropped_without_magnitude", r.dropped_without_magnitude},
      {"dropped_by_limit", r.dropped_by_limit},
      {"inferred_colors", r.inferred_colors},
      {"assumed_colors", r.assumed_colors},
      {"without_proper_motion", r.without_proper_motion},
      {"without_parallax", r.without_parallax},
      {"negative_parallaxes", r.negative_parallaxes},
      {"without_radial_velocity", r.without_radial_velocity},
      {"multiple", r.multiple},
      {"variable", r.variable},
      {"count_by_magnitude", std::move(counts)},
      {"illuminance_before_lux", r.illuminance_before_lux},
      {"illuminance_after_lux", r.illuminance_after_lux},
      {"illuminance_relative_change", relative_change(r)},
  };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_text(const StarProductReport& r, const StarProvenance& p) {
  std::string text = fmt::format("source       {} (SHA-256 {})\n", p.source_file, p.source_sha256);
  const auto line = [&](const char* name, std::size_t count, const char* meaning) {
    text += fmt::format("{:<12} {:>5}  {}\n", name, count, meaning);
  };
  line("read", r.read, "entries");
  line("kept", r.kept, "stars");
  line("dropped", r.dropped_without_position, "without a position");
  line("", r.dropped_without_magnitude, "without a magnitude");
  line("", r.dropped_by_limit, "fainter than the limit");
  line("colours", r.inferred_colors, "inferred from the spectral type");
  line("", r.assumed_colors, "assumed (B-V = 0.65): neither B-V nor a known spectral type");
  line("unknown", r.without_proper_motion, "proper motions");
  line("", r.without_parallax, "parallaxes");
  line("", r.negative_parallaxes, "parallaxes negative, taken as unknown");
  line("", r.without_radial_velocity, "radial velocities");
  line("multiple", r.multiple, "double and multiple stars, one point each");
  line("variable", r.variable, "variable stars, amplitude not in the catalogue: 0 in the product");
  for (const auto& [magnitude, count] : r.count_by_magnitude) {
    line(magnitude == r.count_by_magnitude.begin()->first ? "magnitude" : "", count,
         fmt::format("of V = {} +-0.5", magnitude).c_str());
  }
  return text + fmt::format("illuminance  {:.9e} lx before, {:.9e} lx after ({:+.1e} relative)\n",
                            r.illuminance_before_lux, r.illuminance_after_lux, relative_change(r));
}

void run_stars(const StarsOptions& options) {
  require_product_path(options.output, ".glb", options.dry_run, std::array{options.input});
  StarProductOptions product_options;
  std::string content_options;
  if (!options.limit_magnitude.empty()) {
    product_options.limit_magnitude = parse_limit(options.limit_magnitude).value();
    content_options = fmt::format("--limit-magnitude {}", product_options.limit_magnitude);
  }
  const Bytes content = read_file(options.input);
  StarProduct product = make_star_product(read_bright_star_catalogue(content, options.input), product_options);
  StarProvenance& provenance = product.catalogue.provenance;
  provenance.source = bright_star_source;
  provenance.source_file = std::filesystem::path(options.input).filename().string();
  provenance.source_sha256 = sha256_hex(content);
  provenance.tool = "vesper-catalog " VESPER_VERSION;
  provenance.options = content_options;
  provenance.licence = bright_star_licence;
  const Bytes encoded = encode_star_glb(product.catalogue);
  if (!options.dry_run) {
    write_file_atomically(options.output, encoded);
    spdlog::info("wrote {} ({} bytes)", options.output, encoded.size());
  }
  write_standard_output(options.json ? report_json(product.report, provenance)
                                     : report_text(product.report, provenance));
}

} // namespace

std::function<void()> add_stars_command(CLI::App& app) {
  auto options = std::make_shared<StarsOptions>();
  CLI::App* stars = app.add_subcommand("stars", "Make a star buffer from the Yale Bright Star Catalogue");
  stars->add_option("input", options->input, "The catalogue's fixed-width records, plain or gzipped")
      ->required()
      ->type_name("IN");
  stars->add_option("-o,--output", options->output, "The star buffer to write")->type_name("OUT.glb");
  stars->add_option("--limit-magnitude", options->limit_magnitude, "Keep stars up to this V magnitude, -2 to 30")
      ->type_name("M")
      ->check(CLI::Validator(limit_fault, ""));
  stars->add_flag("--dry-run", options->dry_run, "Report, but write nothing");
  stars->add_flag("--json", options->json, "Report as JSON");
  return [options] { run_stars(*options); };
}

} // namespace vesper
