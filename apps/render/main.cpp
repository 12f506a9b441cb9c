// vesper-render: one picture of the sky, without a window.
#include "common/display_options.hpp"
#include "common/program.hpp"
#include "common/scene_options.hpp"
#include "common/sky_tables_cache.hpp"

#include "vesper/assets/default_stars.hpp"
#include "vesper/assets/image_file.hpp"
#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"
#include "vesper/gpu/display_chain.hpp"
#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/renderer.hpp"
#include "vesper/plan/display_files.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/sky/scene_white.hpp"
#include "vesper/sky/sky_state.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <spdlog/spdlog.h>
#include <string>
#include <vector>

namespace {

using namespace vesper;

struct RenderOptions {
  std::string output;
  std::string catalogue;
  std::string shader_dir;
  std::string moon_map;
  std::string sun_law = "hestroffer-magnan";
  std::string streamers = "on";
  double moon_scale = 1.0;
  double sun_scale = 1.0;
  std::string scintillation = "on";
  std::string extinction = "on";
  std::string refraction = "on";
  std::string exr = "scene"; // what an EXR holds
  double exposure_time_s = AirOptions{}.exposure_s;
  std::string tone = "visibility";
  double exposure_stops = 0.0;
  std::optional<double> exposure_value;
  std::string metering = "whole";
  std::optional<std::string> night_vision;
  std::optional<std::string> white_adaptation;
  std::optional<std::string> glare;
  std::optional<std::string> acuity;
  std::string noise = "off";
  double age = gpu::EyeOpticsSettings{}.age_years;
  bool timings = false;
};

/// Display pixels, the scene's light or linear display values.
enum class OutputKind { png, scene_exr, display_exr };

OutputKind output_kind(const RenderOptions& options) {
  const std::string& path = options.output;
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (extension == ".png") {
    return OutputKind::png;
  }
  if (extension == ".exr") {
    return options.exr == "scene" ? OutputKind::scene_exr : OutputKind::display_exr;
  }
  throw Error(ErrorKind::argument, fmt::format("--output {} names no picture format", path),
              {"", "", "End the name in .png (display pixels) or .exr (X, Y, Z, S in cd/m2)"});
}

/// What the air scatters is found by tables.
bool needs_sky_tables(const LayerSet& layers) { return has(layers, Layer::sky) || draws_dark_sky(layers); }

std::string air_text(const Refraction& refraction) {
  return refraction.model == RefractionModel::none
             ? "no refraction"
             : fmt::format("{:.2f} hPa, {:.2f} C", refraction.conditions.pressure_hpa,
                           refraction.conditions.temperature_c);
}

std::string units_text(OutputKind kind, const Display& display) {
  if (kind == OutputKind::scene_exr) {
    return "X Y Z: CIE 1931, Y in cd/m2; S: scotopic luminance in cd/m2";
  }
  return fmt::format("{} of a display: peak {} cd/m2, black {}, ambient {}, primaries {}, transfer {}",
                     kind == OutputKind::png ? "code values" : "linear R, G, B", display.peak.to(candela_per_m2),
                     display.black.to(candela_per_m2), display.ambient.to(candela_per_m2),
                     primaries_names()[static_cast<std::size_t>(display.primaries)],
                     transfer_names()[static_cast<std::size_t>(display.transfer)]);
}

ImageMetadata describe(const SceneOptions& scene, const FramePlan& plan, const std::string& units) {
  const View& view = scene.view;
  return {
      {"vesper:time", to_iso8601(scene.instant)},
      {"vesper:place", fmt::format("latitude {} deg, longitude {} deg, height {} m", scene.observer.latitude.to(deg),
                                   scene.observer.longitude.to(deg), scene.observer.height.to(metre))},
      {"vesper:air", air_text(plan.refraction)},
      {"vesper:medium", plan.options.air.extinction ? scene.medium_name : "none"},
      {"vesper:view", fmt::format("{}, azimuth {} deg, altitude {} deg, roll {} deg, fov {} deg",
                                  projection_names()[static_cast<std::size_t>(view.projection)], view.azimuth.to(deg),
                                  view.altitude.to(deg), view.roll.to(deg), view.fov.to(deg))},
      {"vesper:units", units}};
}

void print_timings(const std::vector<gpu::PassTiming>& timings) {
  std::string text;
  for (const gpu::PassTiming& timing : timings) {
    text += fmt::format("{:<10} {:10.3f} ms\n", timing.name, timing.milliseconds);
  }
  write_standard_output(text);
}

DiscOptions disc_options(const RenderOptions& options) {
  DiscOptions discs;
  if (!options.moon_map.empty()) {
    discs.moon = make_moon_globe(read_moon_map(options.moon_map));
  }
  discs.sun.law = options.sun_law == "neckel" ? LimbDarkening::neckel : LimbDarkening::hestroffer_magnan;
  discs.sun.streamers = options.streamers == "on";
  discs.moon_scale = options.moon_scale;
  discs.sun_scale = options.sun_scale;
  return discs;
}

gpu::DisplaySettings display_settings(const RenderOptions& options, OutputKind kind,
                                      const DisplayOptions& display_options, const View& view, const SkyState& sky) {
  gpu::DisplaySettings settings;
  settings.display = display_options.display;
  if (!display_options.pixels_per_degree_given) {
    settings.display.pixels_per_degree = usual_pixels_per_degree(settings.display, view);
  }
  const bool deep = kind == OutputKind::display_exr || display_options.bits == 16;
  settings.format = deep ? gpu::PixelFormat::rgba16 : gpu::PixelFormat::rgba8;
  settings.tone.tone = *tone_operator_from_name(options.tone);
  settings.tone.stops = options.exposure_stops;
  settings.tone.exposure_value = options.exposure_value;
  settings.metering = options.metering == "foveal" ? Metering::foveal : Metering::whole_field;
  // A camera has no eye's faults.
  const bool eye = settings.tone.tone != ToneOperator::photographic;
  settings.optics.glare = options.glare ? *options.glare == "on" : eye;
  settings.optics.acuity = options.acuity ? *options.acuity == "on" : eye;
  settings.optics.age_years = options.age;
  settings.noise = options.noise == "on";
  settings.night_vision = options.night_vision ? *options.night_vision == "on" : eye;
  if (options.white_adaptation ? *options.white_adaptation == "on" : eye) {
    settings.light = adapting_light(sky);
  }
  return settings;
}

std::vector<std::string> tone_operators() {
  const auto names = tone_operator_names();
  return {names.begin(), names.end()};
}

void write_picture(const gpu::Frame& frame, OutputKind kind, const std::string& path, const Display& display,
                   const ImageMetadata& metadata) {
  switch (kind) {
  case OutputKind::png:
    if (frame.rgba16.empty()) {
      write_png(path, frame.width, frame.height, frame.rgba, metadata, color_tags(display));
    } else {
      write_png(path, frame.width, frame.height, frame.rgba16, metadata, color_tags(display));
    }
    break;
  case OutputKind::scene_exr:
    write_exr(path, frame.width, frame.height, frame.xyzs, metadata);
    break;
  case OutputKind::display_exr:
    write_rgb_exr(path, frame.width, frame.height, display_signals(frame.rgba16, display), linear_colors(display),
                  metadata);
    break;
  }
}

void render(const SceneOptions& scene, const RenderOptions& options, const DisplayOptions& display_options) {
  const OutputKind kind = output_kind(options);
  if (options.exposure_value && options.tone != "photographic") {
    refuse_option("--ev", fmt::format("{}", *options.exposure_value), "only with --operator photographic");
  }
  require_writable(options.output);
  std::optional<StarCatalogue> own;
  if (!options.catalogue.empty()) {
    own = read_star_glb(options.catalogue);
  }
  if (scene.sky == SkyModel::reference && needs_sky_tables(scene.layers)) {
    throw Error(ErrorKind::argument, "--sky reference is too slow for a frame",
                {"", "", "Give --sky tables or small-tables, or ask vesper-report sky --reference for a picture"});
  }
  const StarCatalogue& catalogue = own ? *own : default_star_catalogue();

  FrameOptions frame_options;
  frame_options.layers = scene.layers;
  frame_options.seed = static_cast<std::uint32_t>(scene.seed ^ (scene.seed >> 32U));
  frame_options.air.refraction = options.refraction == "on";
  frame_options.air.medium = scene.medium;
  if (needs_sky_tables(scene.layers)) {
    frame_options.air.sky_tables = scene_sky_tables(scene);
  }
  frame_options.dark_sky = scene.dark_sky;
  frame_options.air.extinction = options.extinction == "on";
  frame_options.air.scintillation = options.scintillation == "on";
  frame_options.air.exposure_s = options.exposure_time_s;
  frame_options.discs = disc_options(options);

  SkyState sky = sky_state_of(scene);
  if (frame_options.air.refraction) {
    sky.refraction = with_table(sky.refraction);
  }
  const FramePlan plan = plan_frame(sky, scene.view, catalogue.stars, frame_options);

  const gpu::HeadlessContext context;
  spdlog::debug("drawing with {}", context.description());
  const gpu::ShaderLibrary shaders =
      options.shader_dir.empty() ? gpu::ShaderLibrary() : gpu::ShaderLibrary(options.shader_dir);
  gpu::Renderer renderer(shaders);
  renderer.load(catalogue);
  const gpu::DisplaySettings display = display_settings(options, kind, display_options, scene.view, sky);
  gpu::DisplayChain chain(shaders, display);
  gpu::RenderOutputs outputs;
  outputs.xyzs = kind == OutputKind::scene_exr;
  if (!outputs.xyzs && scene.view.projection == Projection::cubemap &&
      (display.optics.glare || display.optics.acuity)) {
    spdlog::warn("a cube map goes without the eye's glare and acuity, which belong to whoever looks at it through a "
                 "program of theirs. Give --glare off --acuity off to say so, or --projection equirectangular for a "
                 "whole sky that has them");
  }
  outputs.mapping = outputs.xyzs ? nullptr : &chain;
  outputs.timings = options.timings;
  if (options.timings) {
    // The first frame pays for compiling programs and says nothing about a sequence.
    static_cast<void>(renderer.render(sky, scene.view, plan, outputs));
  }
  gpu::Frame frame = renderer.render(sky, scene.view, plan, outputs);

  const auto start = std::chrono::steady_clock::now();
  write_picture(frame, kind, options.output, display_options.display,
                describe(scene, plan, units_text(kind, display_options.display)));
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  frame.timings.push_back({"write", elapsed.count()});
  if (options.timings) {
    print_timings(frame.timings);
  }
}

} // namespace

// Only an option declared twice could throw before run_program catches.
int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape)
  CLI::App app{"Renders the real sky to a PNG (for a display) or an EXR (X, Y, Z, S in cd/m2).", "vesper-render"};
  prepare_program(app);
  const SceneOptionSet scene_options(app);
  const DisplayOptionSet display_options(app);
  RenderOptions options;
  const CLI::Validator on_off = CLI::IsMember({"on", "off"});
  app.add_option("-o,--output", options.output, "picture to write: NAME.png or NAME.exr")->required();
  app.add_option(
         "--exr", options.exr,
         "what an EXR holds: scene (default), its light; or display, linear R, G, B of 1 at the display's white")
      ->check(CLI::IsMember({"scene", "display"}));
  app.add_option("--catalogue", options.catalogue, "star buffer (.glb) in place of the embedded Bright Star Catalogue");
  app.add_option("--moon-map", options.moon_map, "map of the Moon (.exr) in place of the embedded one");
  const CLI::Validator disc_scale = numbers_within(1.0, largest_disc_scale);
  app.add_option("--moon-scale", options.moon_scale,
                 "factor of the Moon's diameter, 1 to 100, with the same light as a whole; default 1")
      ->check(disc_scale);
  app.add_option("--sun-scale", options.sun_scale, "the same of the Sun")->check(disc_scale);
  app.add_option("--limb-darkening", options.sun_law, "of the Sun: hestroffer-magnan (default) or neckel")
      ->check(CLI::IsMember({"hestroffer-magnan", "neckel"}));
  app.add_option("--streamers", options.streamers, "of the corona: on, off")->check(on_off);
  app.add_option("--scintillation", options.scintillation, "twinkling of the stars: on, off")->check(on_off);
  app.add_option("--exposure-time", options.exposure_time_s,
                 "seconds that scintillation is averaged over (default 0.1, the eye's)")
      ->check(numbers_within(0.0, 1.0e6));
  app.add_option("--extinction", options.extinction, "dimming of the stars by the air: on, off")->check(on_off);
  app.add_option("--refraction", options.refraction, "bending of light by the air: on, off")->check(on_off);
  app.add_option(
         "--operator", options.tone,
         "from the scene's luminance to the display's: visibility (default; shows what the eye would see), "
         "reinhard, hable, photographic (linear, as a camera), false-color (luminance by colours, with a legend)")
      ->check(CLI::IsMember(tone_operators()));
  app.add_option("--exposure", options.exposure_stops, "stops over the exposure that the operator finds, -30 to 30")
      ->check(numbers_within(-30.0, 30.0));
  app.add_option("--ev", options.exposure_value,
                 "exposure value at ISO 100 of --operator photographic, -30 to 30; as a meter tells by default")
      ->check(numbers_within(-30.0, 30.0));
  app.add_option("--metering", options.metering,
                 "what the eye is adapted to: whole (default), the field; foveal, its middle")
      ->check(CLI::IsMember({"whole", "foveal"}));
  app.add_option("--night-vision", options.night_vision,
                 "colours fade where it is dark, as rods see: on, off; on but for --operator photographic")
      ->check(on_off);
  app.add_option("--white-adaptation", options.white_adaptation,
                 "the light of Sun or Moon looks white, as to an eye that is adapted to it: on, off; on but for "
                 "--operator photographic")
      ->check(on_off);
  app.add_option("--glare", options.glare,
                 "light that the eye scatters: on, off; on but for --operator photographic and cube maps")
      ->check(on_off);
  app.add_option("--acuity", options.acuity,
                 "detail fades where it is dark: on, off; on but for --operator photographic and cube maps")
      ->check(on_off);
  app.add_option("--noise", options.noise, "grain that is seen in the dark: on, off (default)")->check(on_off);
  app.add_option("--age", options.age, "years of the eye that scatters, 0 to 100; default 30")
      ->check(numbers_within(0.0, 100.0));
  app.add_option("--shader-dir", options.shader_dir, "folder whose shader files override the embedded ones")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--timings", options.timings, "print the wall-clock time of each pass");
  return run_program(argc, argv, app, [&] { render(scene_options.resolve(), options, display_options.resolve()); });
}
