#include "catalog/commands.hpp"
#include "catalog/product_path.hpp"
#include "common/option_text.hpp"
#include "common/program.hpp"
#include "common/progress_bar.hpp"

#include "vesper/assets/moon_map.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/sha256.hpp"
#include "vesper/catalog_tools/albedo_picture.hpp"
#include "vesper/catalog_tools/elevation_grid.hpp"
#include "vesper/catalog_tools/moon_products.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>
#include <string>

namespace vesper {
namespace {

using Json = nlohmann::ordered_json;

struct MoonOptions {
  std::string albedo;
  std::string elevation;
  std::string label;
  std::string output;
  std::string longitude_origin = "0";
  std::string encoding = "automatic";
  std::string face = "256";
  bool dry_run = false;
  bool json = false;
};

double parse_longitude(const std::string& text) {
  const auto value = number_within(text, -360.0, 360.0);
  if (!value) {
    refuse_option("--longitude-origin", text, "degrees from -360 to 360");
  }
  return *value;
}

int parse_face(const std::string& text) {
  const auto value = number_within(text, least_moon_face, most_moon_face);
  if (!value || *value % 2 != 0) {
    refuse_option("--face", text, fmt::format("even numbers from {} to {}", least_moon_face, most_moon_face));
  }
  return *value;
}

AlbedoEncoding parse_encoding(const std::string& text) {
  try {
    return parse_albedo_encoding(text);
  } catch (const Error&) {
    refuse_option("--albedo-encoding", text, "automatic, srgb, linear");
  }
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string report_json(const MoonProductReport& r, const MoonMap& map) {
  const MoonMapProvenance& p = map.provenance;
  const Json json{
      {"albedo_file", p.albedo_file},
      {"albedo_sha256", p.albedo_sha256},
      {"elevation_file", p.elevation_file},
      {"elevation_sha256", p.elevation_sha256},
      {"label_sha256", p.label_sha256},
      {"options", p.options},
      {"face_size", map.face_size},
      {"albedo_pixels", p.albedo_pixels},
      {"albedo_filled", r.albedo_fill.filled},
      {"albedo_filled_area", r.albedo_fill.area_share},
      {"elevation_pixels", p.elevation_pixels},
      {"elevation_filled", r.elevation_fill.filled},
      {"elevation_filled_area", r.elevation_fill.area_share},
      {"albedo_scale", r.albedo_scale},
      {"disc_albedo", moon_disc_albedo(map)},
      {"least_albedo", r.least_albedo},
      {"most_albedo", r.most_albedo},
      {"lowest_m", r.lowest_m},
      {"highest_m", r.highest_m},
      {"slope_rms_deg", r.mean_slope.to(deg)},
  };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_text(const MoonProductReport& r, const MoonMap& map) {
  const MoonMapProvenance& p = map.provenance;
  const auto filled = [](const FillReport& fill, std::uint64_t of) {
    return fmt::format("{} of {} pixels missing, filled from around them ({:.3f} % of the area)", fill.filled, of,
                       100.0 * fill.area_share);
  };
  return fmt::format("albedo       {} (SHA-256 {})\n"
                     "             {}\n"
                     "             {:.4f} to {:.4f}, {:.4f} on the disc ({:.4f} for a picture value of 1)\n"
                     "elevation    {} (SHA-256 {})\n"
                     "             {}\n"
                     "             {:.0f} to {:.0f} m\n"
                     "map          6 faces of {} x {}, slopes {:.2f} deg rms\n",
                     p.albedo_file, p.albedo_sha256, filled(r.albedo_fill, p.albedo_pixels), r.least_albedo,
                     r.most_albedo, moon_disc_albedo(map), r.albedo_scale, p.elevation_file, p.elevation_sha256,
                     filled(r.elevation_fill, p.elevation_pixels), r.lowest_m, r.highest_m, map.face_size,
                     map.face_size, r.mean_slope.to(deg));
}

void run_moon(const MoonOptions& options) {
  const double longitude_deg = parse_longitude(options.longitude_origin);
  const AlbedoEncoding encoding = parse_encoding(options.encoding);
  const int face_size = parse_face(options.face);
  const std::string label_file = options.label.empty() ? find_pds_label(options.elevation).string() : options.label;
  require_product_path(options.output, ".exr", options.dry_run,
                       std::array{options.albedo, options.elevation, label_file});

  const Bytes label = read_file(label_file);
  const Bytes content = read_file(options.elevation);
  GlobeGrid elevation = read_elevation_grid(
      PdsLabel({reinterpret_cast<const char*>(label.data()), label.size()}, label_file), content, options.elevation);
  GlobeGrid albedo = read_albedo_picture(options.albedo, {longitude_deg * deg, encoding});

  MoonProduct product;
  {
    ProgressBar bar("Making the map", moon_product_work(face_size));
    product = make_moon_product(std::move(albedo), std::move(elevation),
                                {face_size, [&bar](std::size_t units) { bar.advance(units); }});
  }
  MoonMapProvenance& p = product.map.provenance;
  p.albedo_file = file_name(options.albedo);
  p.albedo_sha256 = sha256_hex(read_file(options.albedo));
  p.elevation_file = file_name(options.elevation);
  p.elevation_sha256 = sha256_hex(content);
  p.label_sha256 = sha256_hex(label);
  p.tool = "vesper-catalog " VESPER_VERSION;
  p.options =
      fmt::format("--longitude-origin {} --albedo-encoding {} --face {}", longitude_deg, options.encoding, face_size);
  if (!options.dry_run) {
    write_moon_map(options.output, product.map);
    spdlog::info("wrote {} ({} bytes)", options.output, std::filesystem::file_size(options.output));
  }
  write_standard_output(options.json ? report_json(product.report, product.map)
                                     : report_text(product.report, product.map));
}

} // namespace

std::function<void()> add_moon_command(CLI::App& app) {
  auto options = std::make_shared<MoonOptions>();
  CLI::App* moon = app.add_subcommand("moon", "Make a cube map of the Moon from an albedo map and an elevation grid");
  moon->add_option("--albedo", options->albedo, "A picture of the whole Moon, equirectangular, north up, east right")
      ->required()
      ->type_name("IMAGE");
  moon->add_option("--elevation", options->elevation, "An elevation grid of the Planetary Data System")
      ->required()
      ->type_name("IN.IMG");
  moon->add_option("--label", options->label, "The grid's label; else the one of its name beside it")
      ->type_name("IN.LBL");
  moon->add_option("-o,--output", options->output, "The map to write")->type_name("OUT.exr");
  moon->add_option("--longitude-origin", options->longitude_origin,
                   "Longitude at the centre of the picture, degrees east (0)")
      ->type_name("DEG");
  moon->add_option("--albedo-encoding", options->encoding,
                   "What the picture's numbers are: srgb, linear, or automatic: srgb if whole, linear if floating")
      ->type_name("NAME");
  moon->add_option("--face", options->face, "Texels along a side of the cube's faces (256)")->type_name("N");
  moon->add_flag("--dry-run", options->dry_run, "Report, but write nothing");
  moon->add_flag("--json", options->json, "Report as JSON");
  return [options] { run_moon(*options); };
}

} // namespace vesper
