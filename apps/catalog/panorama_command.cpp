// panorama: a picture of the sky becomes a cube map in cd/m2.

#include "catalog/commands.hpp"
#include "catalog/product_path.hpp"
#include "common/option_text.hpp"
#include "common/program.hpp"
#include "common/progress_bar.hpp"

#include "vesper/assets/default_stars.hpp"
#include "vesper/assets/sky_map.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/sha256.hpp"
#include "vesper/catalog_tools/fits_picture.hpp"
#include "vesper/catalog_tools/image_picture.hpp"
#include "vesper/catalog_tools/panorama.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <spdlog/spdlog.h>
#include <string>
#include <vector>

namespace vesper {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct PanoramaCommand {
  std::vector<std::string> inputs;
  std::string output;
  int face = 1024;
  int hdu = 0;
  std::vector<int> planes;
  std::string frame;
  std::optional<double> origin;
  bool mirrored = false;
  std::string transform;
  std::string calibrate;
  std::optional<double> zero_point;
  std::string stars;
  std::string remove_stars;
  std::optional<double> epoch;
  double star_radius = 3.0;
  std::optional<double> saturation;
  std::optional<double> missing;
  std::string credit = "none stated";
  bool dry_run = false;
  bool json = false;
};

volatile std::sig_atomic_t interrupted = 0;
extern "C" void note_interrupt(int) { interrupted = 1; }

/// While it lives an interrupt is noted instead of ending the program, so that nothing is left half done.
class InterruptWatch {
public:
  InterruptWatch()
      : before_int_(std::signal(SIGINT, note_interrupt)), before_term_(std::signal(SIGTERM, note_interrupt)) {}
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
  ~InterruptWatch() {
    std::signal(SIGINT, before_int_);
    std::signal(SIGTERM, before_term_);
  }
  static void check(const std::string& output) {
    if (interrupted != 0) {
      throw Error(ErrorKind::file, "interrupted", {output, "", "The earlier file, if any, is unchanged"});
    }
  }

private:
  using Handler = void (*)(int);
  Handler before_int_, before_term_;
};

bool is_fits(const std::string& path) {
  constexpr std::string_view beginning = "SIMPLE  =";
  std::string start(beginning.size(), ' ');
  std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
  if (start == beginning) {
    return true;
  }
  std::string name = fs::path(path).filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array endings{".fits", ".fit", ".fts", ".fits.gz", ".fit.gz", ".fts.gz", ".fits.fz", ".fz"};
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return name.ends_with(ending); });
}

/// A picture with its coordinates and what messages call it.
struct OpenedPicture {
  std::unique_ptr<PictureSource> picture;
  std::optional<PictureWcs> wcs;
  std::string file, place;
  FitsRemarks remarks;
  double least_value = 0.0; ///< above zero that its numbers can express; 0 for floating-point ones
};

PictureWcs wcs_of(const FitsPicture& fits, const PanoramaCommand& command) {
  if (!command.frame.empty()) {
    return {whole_sky_cards(command.frame, command.origin.value_or(0.0), command.mirrored, fits.width(), fits.height(),
                            false),
            fits.name(), fits.place()};
  }
  PictureWcs wcs(fits.cards(), fits.name(), fits.place());
  wcs.require_on_sphere(fits.width(), fits.height());
  for (std::size_t i = 1; i < fits.file_count(); ++i) {
    PictureWcs other(fits.cards(i), fits.name(i), fits.place(i));
    for (const double part : {0.3, 0.5, 0.7}) {
      const Vec2 at(part * fits.width(), part * fits.height());
      constexpr double tolerance_px = 0.1;
      const double pixel = distance(wcs.direction(at), wcs.direction(at + Vec2(0.0, 1.0)));
      if (distance(wcs.direction(at), other.direction(at)) > tolerance_px * pixel) {
        throw Error(ErrorKind::input, fmt::format("the coordinates are not those of {}", fits.name()),
                    {fits.name(i), fits.place(i) + ", CRVAL, CRPIX, CD", "Give channels that lie on one another"});
      }
    }
  }
  return wcs;
}

OpenedPicture open_picture(const PanoramaCommand& command) {
  OpenedPicture opened;
  opened.file = command.inputs.front();
  if (is_fits(opened.file)) {
    auto fits = std::make_unique<FitsPicture>(std::vector<fs::path>(command.inputs.begin(), command.inputs.end()),
                                              command.hdu, command.planes);
    opened.place = fits->place();
    opened.remarks = fits->remarks();
    opened.wcs.emplace(wcs_of(*fits, command));
    opened.picture = std::move(fits);
    return opened;
  }
  if (command.inputs.size() > 1) {
    throw Error(ErrorKind::argument, "several pictures that are not FITS", {"", "", "Give one"});
  }
  if (command.frame.empty()) {
    // A file that is neither FITS nor a picture is called so before anything is asked of the user.
    const ImageRows readable(opened.file);
    throw Error(
        ErrorKind::argument, "--frame is missing: the picture does not say where on the sky it lies",
        {opened.file, "", "Give --frame galactic|icrs|fk5|ecliptic, and --origin for the longitude in its middle"});
  }
  auto image = std::make_unique<ImagePicture>(opened.file);
  opened.wcs.emplace(whole_sky_cards(command.frame, command.origin.value_or(0.0), command.mirrored, image->width(),
                                     image->height(), true),
                     opened.file, "picture");
  opened.place = "picture";
  opened.least_value = image->least_value();
  opened.picture = std::move(image);
  return opened;
}

/// Units that mean a luminance in cd/m2.
bool is_luminance_unit(std::string unit) {
  unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
  constexpr std::array known{"cd/m2", "cdm-2", "cd/m**2", "cd/m^2", "cd.m-2", "cdm**-2", "nit", "cd*m-2"};
  return std::find(known.begin(), known.end(), unit) != known.end();
}

void choose_calibration(const PanoramaCommand& command, const OpenedPicture& opened, PanoramaOptions& options) {
  if (command.zero_point) {
    if (!command.calibrate.empty()) {
      throw Error(ErrorKind::argument, "--zero-point and --calibrate exclude each other", {"", "", "Give one of them"});
    }
    options.cd_m2_per_unit = luminance_of_magnitude(*command.zero_point);
  } else if (command.calibrate == "stars") {
    options.calibration = PanoramaCalibration::stars;
  } else if (command.calibrate == "anchors") {
    options.calibration = PanoramaCalibration::anchors;
  } else if (!is_luminance_unit(opened.remarks.unit)) {
    throw Error(ErrorKind::input,
                opened.remarks.unit.empty()
                    ? "the unit of the values is missing"
                    : fmt::format("values in \"{}\" have no known luminance", opened.remarks.unit),
                {opened.file, opened.place + ", BUNIT",
                 "Give --calibrate stars for a linear picture, --calibrate anchors for another, or --zero-point"});
  }
}

std::string calibration_text(const PanoramaOptions& options, const PanoramaReport& r, const OpenedPicture& opened) {
  if (r.fit) {
    return fmt::format("fitted to {} stars ({} rejected): {:.6e} cd/m2 per unit of Y ({:.4f} mag/arcsec2), residual "
                       "{:.3f} mag a star; transform {}",
                       r.fit->stars, r.fit->rejected, r.fit->cd_m2_per_unit,
                       magnitude_of_luminance(r.fit->cd_m2_per_unit), r.fit->residual_mag, options.transform.name);
  }
  if (r.anchors) {
    return fmt::format(
        "uncalibrated: tied to {} mag/arcsec2 in Sagittarius, {} at the anticentre and {} at the galactic "
        "poles by {:.4e} cd/m2 x Y^{:.3f} + {:.4e} cd/m2, mean colour that of B-V = {}, colours halved; "
        "transform {}",
        sky_fields()[3].anchor_mag_arcsec2, sky_fields()[2].anchor_mag_arcsec2, sky_fields()[0].anchor_mag_arcsec2,
        r.anchors->scale_cd_m2, r.anchors->exponent, r.anchors->black_cd_m2, milky_way_b_v, options.transform.name);
  }
  return fmt::format("{}: {:.6e} cd/m2 per unit of Y ({:.4f} mag/arcsec2); transform {}",
                     is_luminance_unit(opened.remarks.unit) ? "by BUNIT" : "given", options.cd_m2_per_unit,
                     magnitude_of_luminance(options.cd_m2_per_unit), options.transform.name);
}

double square_degrees(double solid_angle_sr) {
  constexpr double square_degrees_per_sr = 3282.806350011744;
  return solid_angle_sr * square_degrees_per_sr;
}

Json light_json(const LightTotal& total, int channels) {
  Json light = Json::array();
  for (int channel = 0; channel < channels; ++channel) {
    light.push_back(total.light[static_cast<std::size_t>(channel)]);
  }
  return {{"light", light}, {"area_deg2", square_degrees(total.solid_angle_sr)}};
}

Json budget_json(const PanoramaReport& r, int channels) {
  return {{"in", light_json(r.in, channels)},
          {"removed", light_json(r.removed, channels)},
          {"overlapped", light_json(r.overlapped, channels)},
          {"filled", light_json(r.filled, channels)},
          {"out", light_json(r.out, channels)},
          {"out_xyzs_lux", r.out_xyzs}};
}

Json report_json(const PanoramaReport& r, const SkyMapProvenance& p, const OpenedPicture& opened, int face) {
  Json json{{"source_files", p.source_files},
            {"source_sha256", p.source_sha256},
            {"coordinates", p.coordinates},
            {"width", opened.picture->width()},
            {"height", opened.picture->height()},
            {"channels", opened.picture->channels()},
            {"face_size", face},
            {"options", p.options},
            {"calibration", p.calibration},
            {"calibrated", !r.anchors.has_value()},
            {"budget", budget_json(r, opened.picture->channels())},
            {"holes_filled", r.holes},
            {"dark_area_deg2", square_degrees(r.dark_sr)},
            {"saturated_pixels", r.saturated_pixels}};
  if (r.fit) {
    json["fit"] = {{"stars", r.fit->stars},
                   {"rejected", r.fit->rejected},
                   {"residual_mag", r.fit->residual_mag},
                   {"cd_m2_per_unit", r.fit->cd_m2_per_unit}};
  }
  if (r.stars) {
    json["stars"] = {
        {"in_picture", r.stars->in_picture}, {"found", r.stars->found}, {"catalogue_lux", r.stars->catalogue_lux}};
  }
  Json fields = Json::object();
  for (const FieldLight& f : r.fields) {
    const double magnitude = magnitude_of_luminance(f.xyzs[1]);
    fields[f.field.name] = {{"xyzs_cd_m2", f.xyzs},
                            {"mag_arcsec2", std::isfinite(magnitude) ? Json(magnitude) : Json(nullptr)}};
  }
  json["fields"] = std::move(fields);
  return json;
}

std::string report_text(const PanoramaReport& r, const SkyMapProvenance& p, const OpenedPicture& opened, int face) {
  std::string text = fmt::format("source       {} (SHA-256 {})\n", p.source_files, p.source_sha256);
  text +=
      fmt::format("             {} x {} pixels, {} channel{}, {}\n", opened.picture->width(), opened.picture->height(),
                  opened.picture->channels(), opened.picture->channels() == 1 ? "" : "s", p.coordinates);
  text += fmt::format("map          6 faces of {0} x {0}\n", face);
  text += fmt::format("calibration  {}\n", p.calibration);
  if (r.stars) {
    text += fmt::format("stars        {} in the picture, {} found ({:.4e} lx by the catalogue)\n", r.stars->in_picture,
                        r.stars->found, r.stars->catalogue_lux);
  }
  text += "light        by channel, unit x sr\n";
  const auto line = [&](const char* name, const LightTotal& total, const std::string& remark) {
    text += fmt::format("  {:<10}", name);
    for (int channel = 0; channel < opened.picture->channels(); ++channel) {
      text += fmt::format(" {:>15.8e}", total.light[static_cast<std::size_t>(channel)]);
    }
    text += fmt::format("  {:>12.4f} deg2{}\n", square_degrees(total.solid_angle_sr), remark);
  };
  line("in", r.in, "");
  line("removed", r.removed, " under stars");
  line("overlapped", r.overlapped, "");
  line("filled", r.filled, fmt::format(", {} hole{}", r.holes, r.holes == 1 ? "" : "s"));
  line("out", r.out, "");
  text += fmt::format("  dark       {:.2f} deg2 outside of the picture\n", square_degrees(r.dark_sr));
  text += fmt::format("  X Y Z S    {:.6e} lx\n", fmt::join(r.out_xyzs, " "));
  text += fmt::format("brightness   mean over {} degrees\n", 2.0 * field_radius_deg);
  for (const FieldLight& f : r.fields) {
    text += fmt::format("  {:<20} {:.4e} cd/m2, {:.2f} mag/arcsec2\n", f.field.name, f.xyzs[1],
                        magnitude_of_luminance(f.xyzs[1]));
  }
  return text;
}

/// The options that shape the content, as on a command line.
std::string content_options(const PanoramaCommand& c, const PanoramaOptions& options) {
  std::string text = fmt::format("--face {} --transform {}", c.face, options.transform.name);
  const auto add = [&](bool given, const std::string& option) { text += given ? " " + option : ""; };
  add(c.hdu != 0, fmt::format("--hdu {}", c.hdu));
  add(!c.planes.empty(), fmt::format("--planes {}", fmt::join(c.planes, ",")));
  add(!c.frame.empty(),
      fmt::format("--frame {} --origin {}{}", c.frame, c.origin.value_or(0.0), c.mirrored ? " --mirrored" : ""));
  add(!c.calibrate.empty(), "--calibrate " + c.calibrate);
  add(c.zero_point.has_value(), fmt::format("--zero-point {}", c.zero_point.value_or(0.0)));
  add(!c.stars.empty(), "--stars " + fs::path(c.stars).filename().string());
  add(!c.remove_stars.empty(), "--remove-stars " + fs::path(c.remove_stars).filename().string());
  add(c.epoch.has_value(), fmt::format("--epoch {}", c.epoch.value_or(0.0)));
  add(c.star_radius != PanoramaStarOptions().radius_px, fmt::format("--star-radius {}", c.star_radius));
  add(c.saturation.has_value(), fmt::format("--saturation {}", c.saturation.value_or(0.0)));
  add(c.missing.has_value(), fmt::format("--missing {}", c.missing.value_or(0.0)));
  return text;
}

void run_panorama(const PanoramaCommand& command) {
  const InterruptWatch watch;
  require_product_path(command.output, ".exr", command.dry_run, command.inputs);
  if (command.frame.empty() && (command.origin || command.mirrored)) {
    throw Error(ErrorKind::argument, "--origin and --mirrored belong to --frame", {"", "", "Give --frame too"});
  }
  OpenedPicture opened = open_picture(command);
  PanoramaOptions options;
  options.face_size = command.face;
  const std::string usual_transform = opened.picture->channels() == 1 ? "mono" : "srgb";
  options.transform =
      channel_transform(command.transform.empty() ? usual_transform : command.transform, opened.picture->channels());
  choose_calibration(command, opened, options);
  options.missing = command.missing;
  options.least_value = opened.least_value;
  options.star_options.remove = !command.remove_stars.empty();
  options.star_options.radius_px = command.star_radius;
  options.star_options.epoch_jyear = command.epoch ? *command.epoch : opened.remarks.epoch_jyear.value_or(2000.0);
  options.star_options.saturation = command.saturation ? command.saturation : opened.remarks.saturation;
  options.fill_saturated = options.star_options.remove || command.saturation.has_value();
  const std::string star_file = !command.remove_stars.empty() ? command.remove_stars : command.stars;
  std::optional<StarCatalogue> read_stars;
  if (!star_file.empty()) {
    read_stars.emplace(read_star_glb(star_file));
    options.stars = &*read_stars;
    options.star_file = star_file;
  } else if (options.calibration == PanoramaCalibration::stars) {
    options.stars = &default_star_catalogue();
    options.star_file = "embedded stars";
  }

  std::optional<PanoramaProduct> product;
  {
    ProgressBar bar("Spreading the picture", static_cast<std::size_t>(opened.picture->height()));
    options.progress = [&](std::size_t rows) {
      InterruptWatch::check(command.output);
      bar.advance(rows);
    };
    product.emplace(make_panorama(*opened.picture, *opened.wcs, opened.file, opened.place, options));
  }
  SkyMapProvenance p;
  for (const std::string& input : command.inputs) {
    p.source_files += (p.source_files.empty() ? "" : " ") + fs::path(input).filename().string();
    p.source_sha256 += (p.source_sha256.empty() ? "" : " ") + sha256_of_file(input);
    InterruptWatch::check(command.output);
  }
  p.coordinates = opened.wcs->description();
  p.tool = "vesper-catalog " VESPER_VERSION;
  p.options = content_options(command, options);
  p.calibration = calibration_text(options, product->report, opened);
  p.credit = command.credit;
  p.budget = budget_json(product->report, opened.picture->channels()).dump();
  if (product->report.anchors) {
    spdlog::warn("the map is uncalibrated: its brightness is tied to published figures of four fields");
  }
  if (!command.dry_run) {
    write_sky_map(command.output, command.face, p, [&](int first_row, std::span<float> xyzs) {
      InterruptWatch::check(command.output);
      product->map.fill_rows(first_row, xyzs);
    });
    spdlog::info("wrote {} ({} bytes)", command.output, fs::file_size(command.output));
  }
  write_standard_output(
      command.json
          ? report_json(product->report, p, opened, command.face).dump(2, ' ', false, Json::error_handler_t::replace) +
                "\n"
          : report_text(product->report, p, opened, command.face));
}

} // namespace

std::function<void()> add_panorama_command(CLI::App& app) {
  auto command = std::make_shared<PanoramaCommand>();
  PanoramaCommand& c = *command;
  CLI::App* panorama = app.add_subcommand("panorama", "Make a cube map of the sky's light from a picture of the sky");
  panorama->add_option("input", c.inputs, "FITS, one file or one for each channel; or a picture of the whole sky")
      ->required()
      ->expected(1, 3)
      ->type_name("IN");
  panorama->add_option("-o,--output", c.output, "The map to write")->type_name("OUT.exr");
  panorama->add_option("--face", c.face, "Texels along a side of the cube's faces (1024)")
      ->type_name("N")
      ->check(numbers_within(least_sky_face, most_sky_face));
  panorama->add_option("--hdu", c.hdu, "Which HDU of a FITS file, counted from 1 (the first that holds a picture)")
      ->type_name("N")
      ->check(numbers_within(1, 10000));
  panorama->add_option("--planes", c.planes, "Which planes of the third axis, counted from 1, one or three (all)")
      ->delimiter(',')
      ->type_name("N,N,N");
  panorama->add_option("--frame", c.frame, "Axes of a whole-sky picture without coordinates, latitude -90 to 90 upward")
      ->check(CLI::IsMember({"galactic", "icrs", "fk5", "ecliptic"}));
  panorama->add_option("--origin", c.origin, "Longitude in the middle of such a picture, degrees (0)")
      ->type_name("DEG")
      ->check(numbers_within(-360.0, 360.0));
  panorama->add_flag("--mirrored", c.mirrored, "Longitude grows to the right in it, not to the left");
  panorama->add_option("--transform", c.transform, "From channels to X, Y, Z: srgb, mono, or nine numbers, X first")
      ->type_name("NAME");
  panorama
      ->add_option("--calibrate", c.calibrate,
                   "stars: fit the zero point to stars of a linear picture; anchors: tie another to published figures")
      ->check(CLI::IsMember({"stars", "anchors"}));
  panorama->add_option("--zero-point", c.zero_point, "V mag/arcsec2 of a picture whose Y is 1")
      ->type_name("MAG")
      ->check(numbers_within(-30.0, 60.0));
  panorama->add_option("--stars", c.stars, "Star buffer for the fit (the one built in)")->type_name("STARS.glb");
  panorama->add_option("--remove-stars", c.remove_stars, "Take out the light of these stars, which are drawn as stars")
      ->type_name("STARS.glb");
  panorama->add_option("--epoch", c.epoch, "Julian year of the picture (its date, or 2000)")
      ->type_name("YEAR")
      ->check(numbers_within(1000.0, 3000.0));
  panorama->add_option("--star-radius", c.star_radius, "Pixels around a star that hold its light (3)")
      ->type_name("PX")
      ->check(numbers_within(1.0, 4.0));
  panorama->add_option("--saturation", c.saturation, "Values from here on are cut off (SATURATE)")->type_name("VALUE");
  panorama->add_option("--missing", c.missing, "Pixels of this value in all channels are missing")->type_name("VALUE");
  panorama->add_option("--credit", c.credit, "Whose picture it is, for the map's provenance")->type_name("TEXT");
  panorama->add_flag("--dry-run", c.dry_run, "Report, but write nothing");
  panorama->add_flag("--json", c.json, "Report as JSON");
  return [command] { run_panorama(*command); };
}

} // namespace vesper
