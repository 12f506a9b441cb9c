#include "common/display_options.hpp"

#include "common/option_text.hpp"

#include <array>
#include <fmt/format.h>

namespace vesper {
namespace {

constexpr double usual_contrast = 1000.0; // of a monitor's panel, between its peak and its black

/// Reads a number of a range; what is allowed if there is none.
std::string take(std::string_view text, const ValueRange& range, std::string_view unit, double& value) {
  const auto number = number_within(text, range.lowest, range.highest);
  if (!number) {
    return fmt::format("{} to {}{}", range.lowest, range.highest, unit);
  }
  value = *number;
  return "";
}

std::string take_luminance(std::string_view text, const ValueRange& range_cd_m2, Luminance& luminance) {
  double value = luminance.to(candela_per_m2);
  std::string allowed = take(text, range_cd_m2, " cd/m2", value);
  luminance = value * candela_per_m2;
  return allowed;
}

std::string apply_display_peak(std::string_view text, DisplayOptions& options) {
  return take_luminance(text, display_peak_range_cd_m2, options.display.peak);
}

std::string apply_display_black(std::string_view text, DisplayOptions& options) {
  options.black_given = true;
  return take_luminance(text, display_black_range_cd_m2, options.display.black);
}

std::string apply_ambient(std::string_view text, DisplayOptions& options) {
  options.ambient_given = true;
  return take_luminance(text, display_ambient_range_cd_m2, options.display.ambient);
}

std::string apply_primaries(std::string_view text, DisplayOptions& options) {
  const auto primaries = primaries_from_name(text);
  if (!primaries) {
    return fmt::format("{}", fmt::join(primaries_names(), ", "));
  }
  options.display.primaries = *primaries;
  return "";
}

std::string apply_transfer(std::string_view text, DisplayOptions& options) {
  const auto transfer = transfer_from_name(text);
  if (!transfer) {
    return fmt::format("{}", fmt::join(transfer_names(), ", "));
  }
  options.display.transfer = *transfer;
  return "";
}

std::string apply_gamma(std::string_view text, DisplayOptions& options) {
  if (options.display.transfer != Transfer::gamma) {
    return "only with --transfer gamma";
  }
  return take(text, display_gamma_range, "", options.display.gamma);
}

std::string apply_dome_gain(std::string_view text, DisplayOptions& options) {
  return take(text, dome_gain_range, "", options.display.dome_gain);
}

std::string apply_dome_reflectance(std::string_view text, DisplayOptions& options) {
  return take(text, dome_reflectance_range, "", options.display.dome_reflectance);
}

std::string apply_pixels_per_degree(std::string_view text, DisplayOptions& options) {
  options.pixels_per_degree_given = true;
  return take(text, pixels_per_degree_range, " pixels per degree", options.display.pixels_per_degree);
}

std::string apply_bits(std::string_view text, DisplayOptions& options) {
  const auto bits = parse_number<int>(text);
  if (!bits || (*bits != 8 && *bits != 16)) {
    return "8, 16";
  }
  options.bits = *bits;
  return "";
}

// Options that others depend on stand before them.
constexpr std::array display_options{
    DisplayOptionDescription{"display-peak", "CD_M2",
                             "Luminance of the display's white in the dark, 0.001 to 10000; of a projector on a white "
                             "screen; default 200",
                             apply_display_peak},
    DisplayOptionDescription{"display-black", "CD_M2",
                             "Luminance of its black in the dark, 0 to half the peak; default a thousandth of the peak",
                             apply_display_black},
    DisplayOptionDescription{"ambient", "CD_M2",
                             "Luminance of the display switched off, by what it reflects of its room, 0 to 1000: a "
                             "matt monitor shows some 0.01 for each lux on it; default 0.5, in a dome 0",
                             apply_ambient},
    DisplayOptionDescription{"primaries", "NAME", "srgb, display-p3 or rec2020; default srgb", apply_primaries},
    DisplayOptionDescription{"transfer", "NAME",
                             "From light to code values: srgb, gamma or pq, which is absolute; default srgb",
                             apply_transfer},
    DisplayOptionDescription{"gamma", "NUMBER", "Exponent of --transfer gamma, 1 to 4; default 2.2", apply_gamma},
    DisplayOptionDescription{"dome-gain", "NUMBER",
                             "Luminance of a dome over that of a perfect white screen, 0.05 to 10; default 1",
                             apply_dome_gain},
    DisplayOptionDescription{"dome-reflectance", "SHARE",
                             "Share of light that a dome throws back, also onto itself, 0 to 0.98; default 0, no dome",
                             apply_dome_reflectance},
    DisplayOptionDescription{
        "pixels-per-degree", "NUMBER",
        "As the viewer sees them, 0.1 to 1000; by default the picture fills the height of a 24-inch "
        "monitor at 60 cm (37.8 for 1080 rows), in a dome angles are as in the scene",
        apply_pixels_per_degree},
    DisplayOptionDescription{"bits", "N", "Of a code value of a PNG, 8 or 16; default 8", apply_bits},
};

} // namespace

std::span<const DisplayOptionDescription> display_option_table() { return display_options; }

DisplayOptionSet::DisplayOptionSet(CLI::App& app) {
  for (const DisplayOptionDescription& described : display_option_table()) {
    std::string& value = values_.emplace_back();
    const CLI::Option* option = app.add_option("--" + std::string(described.name), value, std::string(described.help))
                                    ->type_name(std::string(described.value_name))
                                    ->group("Display");
    bound_.push_back({described, option});
  }
}

DisplayOptions DisplayOptionSet::resolve() const {
  DisplayOptions options;
  for (std::size_t i = 0; i < bound_.size(); ++i) {
    const auto& [described, option] = bound_[i];
    if (option->count() == 0) {
      continue;
    }
    if (const std::string allowed = described.apply(values_[i], options); !allowed.empty()) {
      refuse_option("--" + std::string(described.name), values_[i], allowed);
    }
  }
  if (!options.black_given) {
    options.display.black = options.display.peak / usual_contrast;
  }
  if (!options.ambient_given && options.display.dome_reflectance > 0.0) {
    options.display.ambient = Luminance();
  }
  validate(options.display);
  return options;
}

} // namespace vesper
