#include "vesper/plan/display.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace vesper {
namespace {

constexpr std::array<std::string_view, 3> names_of_primaries{"srgb", "display-p3", "rec2020"};
constexpr std::array<std::string_view, 3> names_of_transfers{"srgb", "gamma", "pq"};

template <class Enumeration>
std::optional<Enumeration> named(std::span<const std::string_view> names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Enumeration>(found - names.begin()));
}

void require_within(const char* what, double value, const ValueRange& range, const char* unit) {
  if (!(value >= range.lowest && value <= range.highest)) {
    throw Error(ErrorKind::argument, fmt::format("the display's {} of {}{} is out of range", what, value, unit),
                {"", "", fmt::format("Give {} to {}{}", range.lowest, range.highest, unit)});
  }
}

} // namespace

std::span<const std::string_view> primaries_names() { return names_of_primaries; }
std::optional<Primaries> primaries_from_name(std::string_view name) {
  return named<Primaries>(names_of_primaries, name);
}
std::span<const std::string_view> transfer_names() { return names_of_transfers; }
std::optional<Transfer> transfer_from_name(std::string_view name) { return named<Transfer>(names_of_transfers, name); }

double pixels_per_degree(Length pitch, Length distance) {
  return 1.0 * deg / (2.0 * std::atan(0.5 * (pitch / distance)) * rad);
}

void validate(const Display& display) {
  const double peak = display.peak.to(candela_per_m2);
  const double black = display.black.to(candela_per_m2);
  require_within("peak luminance", peak, display_peak_range_cd_m2, " cd/m2");
  require_within("black luminance", black, display_black_range_cd_m2, " cd/m2");
  require_within("ambient luminance", display.ambient.to(candela_per_m2), display_ambient_range_cd_m2, " cd/m2");
  require_within("gamma", display.gamma, display_gamma_range, "");
  require_within("dome gain", display.dome_gain, dome_gain_range, "");
  require_within("dome reflectance", display.dome_reflectance, dome_reflectance_range, "");
  require_within("resolution", display.pixels_per_degree, pixels_per_degree_range, " pixels per degree");
  if (black > 0.5 * peak) {
    throw Error(ErrorKind::argument,
                fmt::format("the display's black of {} cd/m2 leaves no range below its peak of {}", black, peak),
                {"", "", "Give a black of at most half the peak"});
  }
  if (display.transfer == Transfer::pq && display.dome_gain * peak > f64::pq_peak_cd_m2) {
    throw Error(ErrorKind::argument,
                fmt::format("the display's peak of {} cd/m2 has no code value in PQ", display.dome_gain * peak),
                {"", "", fmt::format("Give a peak, times the dome's gain, of at most {}", f64::pq_peak_cd_m2)});
  }
}

double usual_pixels_per_degree(const Display& display, const View& view) {
  constexpr double monitor_rows = 1080.0;
  const double filling = Display().pixels_per_degree * std::min(view.width, view.height) / monitor_rows;
  return std::clamp(display.dome_reflectance > 0.0 ? view_pixels_per_degree(view) : filling,
                    pixels_per_degree_range.lowest, pixels_per_degree_range.highest);
}

f64::DisplayModel display_model(const Display& display) {
  validate(display);
  // What a hemisphere sends out reaches itself to this share: the rest leaves through the opening.
  constexpr double hemisphere_of_sphere = 0.5;
  f64::DisplayModel model{};
  model.rgb_from_xyz = glm::inverse(f64::xyz_from_rgb(f64::chromaticities_of(static_cast<int>(display.primaries))));
  model.transfer = static_cast<int>(display.transfer);
  model.gamma = display.gamma;
  model.black_cd_m2 = display.dome_gain * display.black.to(candela_per_m2);
  model.range_cd_m2 = display.dome_gain * (display.peak - display.black).to(candela_per_m2);
  model.ambient_cd_m2 = display.ambient.to(candela_per_m2);
  model.cross_reflection = hemisphere_of_sphere * display.dome_reflectance;
  const double pixel_rad = (1.0 * deg).to(rad) / display.pixels_per_degree;
  model.pixel_sr = pixel_rad * pixel_rad;
  return model;
}

} // namespace vesper
