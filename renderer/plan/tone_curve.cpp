#include "vesper/plan/tone_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vesper {
namespace {

constexpr std::array<std::string_view, 5> names_of_operators{"visibility", "reinhard", "hable", "photographic",
                                                             "false-color"};

/// Reinhard's white, in units of the scaled luminance: a scene's adaptation luminance has its key there.
constexpr double reinhard_white = 8.0;
/// A display's viewer is adapted to that share of its white: a picture's customary mean is a fifth, but a sky fills it
/// and is what is bright in most pictures.
constexpr double viewer_share_of_peak = 0.3;
/// The scene's adaptation luminance is shown at that share of the display's range at most, so that what is brighter
/// keeps some room.
constexpr double most_of_range = 0.7;
/// Share of the contrast above the adaptation luminance that goes to luminances by their octaves, however few cells
/// have them: so that small discs, too, have a surface.
constexpr double even_share = 0.05;
/// In the dark, contrast around the adaptation luminance and above it, that of the Milky Way, is raised by up to this
/// share of its logarithm: a choice of taste, for a picture of the night is looked at in a room that is not as dark.
/// All of it under the darkest sky, nothing under one a hundred times brighter.
constexpr double more_contrast_by_night = 1.0;
constexpr double darkest_sky_cd_m2 = 5.0e-4;
constexpr double bright_night_cd_m2 = 5.0e-2;
/// Matched steps show all days alike, as Weber's law has it. The brighter ones look brighter by this power of luminance
/// from where cones obey it, so that noon is brighter than sunset: a choice of taste.
constexpr double brighter_by_day = 0.06;
constexpr double weber_from_cd_m2 = 80.0;
constexpr double octaves_per_node = 1.0 / f64::tone_nodes_per_octave;

double octave_of(std::size_t node) { return f64::tone_lowest_octave + octaves_per_node * static_cast<double>(node); }

double in_dark(double luminance_cd_m2) { return std::max(luminance_cd_m2, f64::dark_background_cd_m2); }

/// Rise of the logarithm of what a display adds to its floor, over the scene's logarithm of luminance, at which all
/// that leaves the display has the scene's contrast. At most 2: a room so bright that it would take more hides the
/// night.
double rise_of_equal_contrast(double added_cd_m2, double floor_cd_m2) {
  return std::min(1.0 + floor_cd_m2 / added_cd_m2, 2.0);
}

/// What a viewer of the display can just tell apart there, who never adapts to less than a share of its white.
double display_step(double shown_cd_m2, double adaptation_cd_m2) {
  return f64::just_noticeable_cd_m2(std::max(shown_cd_m2, adaptation_cd_m2));
}

/// What the scene's eye can just tell apart in its state.
double scene_step(const AdaptationState& state) {
  return std::min(f64::cone_threshold_cd_m2(state.cones.to(candela_per_m2)),
                  f64::rod_threshold_cd_m2(state.rods.to(candela_per_m2)));
}

/// Visibility matching. Around the adaptation luminance steps that can just be seen in the scene become such steps on
/// the display (Ward 1994; Ferwerda et al. 1996, sec. 4.2), below it likewise: there the eye is adapted to what is
/// brighter. Above, luminances share the rest of the display's range in proportion to how often they occur, but none
/// has more contrast than it is seen with in the scene (Larson, Rushmeier and Piatko 1997).
class VisibilityCurve {
public:
  VisibilityCurve(const LightHistogram& histogram, const AdaptationState& state, double stops, double floor_cd_m2,
                  double range_cd_m2)
      : histogram_(histogram), floor_(floor_cd_m2), range_(range_cd_m2), eye_step_(scene_step(state)) {
    viewer_ = viewer_share_of_peak * (floor_ + range_);
    const double field = in_dark(adapted_to(histogram).cones.to(candela_per_m2));
    anchor_ = std::log2(field);
    const double darkness = std::log(bright_night_cd_m2 / field) / std::log(bright_night_cd_m2 / darkest_sky_cd_m2);
    more_contrast_ = more_contrast_by_night * std::clamp(darkness, 0.0, 1.0);
    const double day = std::pow(std::max(field / weber_from_cd_m2, 1.0), brighter_by_day);
    const double shown = field * day * std::exp2(stops) * display_step(0.0, viewer_) / eye_step_;
    anchor_shown_ = std::log2(std::min(shown, most_of_range * range_));
  }

  [[nodiscard]] std::vector<double> octaves() const {
    std::vector<double> shown(f64::tone_nodes);
    std::size_t first = 0;
    while (octave_of(first) <= anchor_) {
      ++first;
    }
    // Down to black, which is never reached, by one power.
    const double rise = rise_of_equal_contrast(std::exp2(anchor_shown_), floor_);
    double from = anchor_;
    double at = anchor_shown_;
    for (std::size_t node = first; node-- > 0;) {
      at -= rise * more_contrast(0.5 * (from + octave_of(node))) * (from - octave_of(node));
      shown[node] = at;
      from = octave_of(node);
    }
    const double top = brightest();
    const std::vector<double> share = shares(first, top);
    constexpr double without_limit = 1.0e9;
    if (climb(first, top, share, without_limit, shown) > std::log2(range_)) {
      double low = 1.0e-3;
      double high = 1.0e3;
      for (int i = 0; i < 30; ++i) {
        const double middle = std::sqrt(low * high);
        (climb(first, top, share, middle, shown) > std::log2(range_) ? high : low) = middle;
      }
      climb(first, top, share, low, shown);
    }
    return shown;
  }

private:
  /// Factor of contrast at log2 of a luminance: most half an octave above the adaptation luminance, 1 from half an
  /// octave below it downwards and again some octaves above.
  [[nodiscard]] double more_contrast(double octave) const {
    const double x = std::max(octave - anchor_ + 0.5, 0.0);
    return 1.0 + more_contrast_ * x * std::exp(0.5 - 0.5 * x * x);
  }

  /// log2 of the brightest cell's luminance.
  [[nodiscard]] double brightest() const {
    std::size_t bin = histogram_.seen.size();
    while (bin > 0 && histogram_.seen.at(bin - 1) <= 0.0) {
      --bin;
    }
    return f64::tone_lowest_octave + static_cast<double>(bin) / f64::tone_bins_per_octave;
  }

  /// How often luminances of about a node's occur: weighted over an octave to both sides, because few cells would make
  /// steps that show as rings around a light.
  [[nodiscard]] double occurrence(std::size_t node) const {
    constexpr int nodes_per_bin = f64::tone_nodes_per_octave / f64::tone_bins_per_octave;
    constexpr int reach = f64::tone_bins_per_octave;
    const int bin = (static_cast<int>(node) - 1) / nodes_per_bin;
    double sum = 0.0;
    for (int i = std::max(bin - reach, 0); i <= std::min(bin + reach, f64::tone_bins - 1); ++i) {
      sum += histogram_.seen.at(static_cast<std::size_t>(i)) * (1.0 - std::abs(i - bin) / (reach + 1.0));
    }
    return sum;
  }

  /// How much of the range above the anchor each step would have, per octave.
  [[nodiscard]] std::vector<double> shares(std::size_t first, double top) const {
    std::vector<double> share(f64::tone_nodes, 0.0);
    double sum = 0.0;
    for (std::size_t node = first; node < share.size(); ++node) {
      share[node] = occurrence(node);
      sum += share[node] * octaves_per_node;
    }
    for (std::size_t node = first; node < share.size(); ++node) {
      const double even = octave_of(node) < top ? even_share / (top - anchor_) : 0.0;
      share[node] = (sum > 0.0 ? (1.0 - even_share) * share[node] / sum : 0.0) + even;
    }
    return share;
  }

  /// The curve above the anchor, of which `octaves` are shared out; returns where it ends.
  double climb(std::size_t first, double top, const std::vector<double>& share, double octaves,
               std::vector<double>& shown) const {
    double from = anchor_;
    double at = anchor_shown_;
    double end = at;
    for (std::size_t node = first; node < shown.size(); ++node) {
      const double rise = more_contrast(0.5 * (from + octave_of(node))) * rise_of_equal_contrast(std::exp2(at), floor_);
      // Beyond the brightest cell, for single pixels and glare, it nears the display's white.
      const bool occurs = from < top;
      const double room = std::max(1.0 - std::exp2(at) / range_, 0.0);
      at += (octave_of(node) - from) * (occurs ? std::min(rise, octaves * share[node]) : room * rise);
      if (occurs) {
        end = at;
      }
      shown[node] = std::min(at, std::log2(range_));
      from = octave_of(node);
    }
    return end;
  }

  const LightHistogram& histogram_;
  double floor_;
  double range_;
  double eye_step_;
  double viewer_ = 0.0;
  double more_contrast_ = 0.0;
  double anchor_ = 0.0;
  double anchor_shown_ = 0.0;
};

/// What a camera's meter reads: the mean over the field of what the sensor holds when it is exposed by that reading, so
/// that the Sun's disc counts as no more than white, and a Moon amid black sky by its own light.
double metered_cd_m2(const LightHistogram::Bins& bins) {
  double white = std::numeric_limits<double>::infinity();
  double mean = 0.0;
  for (int round = 0; round < 50; ++round) { // each nearer by the share of the field that is white, times 9.6
    mean = 0.0;
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
      mean += bins.at(bin) * std::min(f64::tone_bin_luminance(static_cast<double>(bin)), white);
    }
    white = f64::photographic_white_cd_m2(f64::metered_exposure_value(mean));
  }
  return mean;
}

/// log2 of the display's luminance at the nodes.
std::vector<double> curve_of(const ToneSettings& settings, const LightHistogram& histogram,
                             const AdaptationState& state, double floor_cd_m2, double range_cd_m2) {
  if (settings.tone == ToneOperator::visibility) {
    return VisibilityCurve(histogram, state, settings.stops, floor_cd_m2, range_cd_m2).octaves();
  }
  const double adaptation = in_dark(state.cones.to(candela_per_m2));
  const double key = f64::automatic_key(adaptation) * std::exp2(settings.stops) / adaptation;
  // In a sequence the exposure follows as the eye does.
  const double follows = adaptation / in_dark(adapted_to(histogram).cones.to(candela_per_m2));
  const double metered = in_dark(metered_cd_m2(histogram.seen)) * follows;
  const double exposure_value = settings.exposure_value.value_or(f64::metered_exposure_value(metered)) - settings.stops;
  std::vector<double> shown(f64::tone_nodes);
  for (std::size_t node = 0; node < shown.size(); ++node) {
    const double luminance = std::exp2(octave_of(node));
    double share = luminance / f64::photographic_white_cd_m2(exposure_value);
    if (settings.tone == ToneOperator::reinhard) {
      share = f64::reinhard_extended(key * luminance, reinhard_white);
    } else if (settings.tone == ToneOperator::hable) {
      share = f64::hable_curve(key * luminance);
    }
    shown[node] = std::log2(range_cd_m2 * std::clamp(share, 1.0e-12, 1.0));
  }
  return shown;
}

/// The least illuminance of a point that an eye in its state sees: until it has adapted to darkness, over the
/// background that would hide as much (Crawford 1937). Before rods have, cones see, whose threshold ends where rods
/// take over.
double point_threshold_lux(double background_cd_m2, const AdaptationState& state, const AdaptationState& field) {
  constexpr double cones_end_cd_m2 = 0.0216;
  const auto over = [&](Luminance at, Luminance of_field) {
    const double excess = std::max((at - of_field).to(candela_per_m2), 0.0);
    return f64::threshold_illuminance_lux(background_cd_m2 + excess, f64::default_field_factor);
  };
  const double by_cones = std::max(over(state.cones, field.cones),
                                   f64::threshold_illuminance_lux(cones_end_cd_m2, f64::default_field_factor));
  const double by_rods = over(state.rods, field.rods);
  return by_rods < by_cones ? by_rods : std::max(by_cones, over(field.cones, field.cones));
}

/// A mesopic luminance as threshold_illuminance_lux counts it.
double as_background(double seen_cd_m2) {
  const double m = f64::cone_share_of_octave(std::log2(seen_cd_m2));
  // S of light of that mesopic luminance and a usual star's S/P.
  const double rods = (1.0 - m) * f64::rods_at_555_nm;
  const double photopic = seen_cd_m2 * (m + rods) / (m + rods * f64::usual_star_sp_ratio);
  return f64::seen_light(photopic, f64::usual_star_sp_ratio * photopic, m);
}

} // namespace

std::span<const std::string_view> tone_operator_names() { return names_of_operators; }

std::optional<ToneOperator> tone_operator_from_name(std::string_view name) {
  const std::span<const std::string_view> names = names_of_operators;
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<ToneOperator>(found - names.begin()));
}

ToneCurve make_tone_curve(const ToneSettings& settings, const LightHistogram& histogram, const AdaptationState& state,
                          const f64::DisplayModel& display) {
  const double range = display.range_cd_m2;
  ToneCurve curve;
  curve.floor_cd_m2 = f64::display_floor_cd_m2(display, 0.0);
  std::vector<double> shown;
  // A dome's own light raises its floor, and with it what its viewer is adapted to: a few rounds settle it.
  for (int round = 0; round < (display.cross_reflection > 0.0 ? 4 : 1); ++round) {
    shown = curve_of(settings, histogram, state, curve.floor_cd_m2, range);
    double added = 0.0;
    constexpr std::size_t nodes_per_bin = f64::tone_nodes_per_octave / f64::tone_bins_per_octave;
    for (std::size_t bin = 0; bin < histogram.seen.size(); ++bin) {
      added += histogram.seen.at(bin) * std::exp2(shown.at(nodes_per_bin * bin + nodes_per_bin / 2));
    }
    // mean = floor(mean) + added, and floor() is linear in the mean.
    const double room = display.ambient_cd_m2;
    curve.mean_cd_m2 =
        (display.black_cd_m2 + room - display.cross_reflection * room + added) / (1.0 - display.cross_reflection);
    curve.floor_cd_m2 = f64::display_floor_cd_m2(display, curve.mean_cd_m2);
  }
  const AdaptationState field = adapted_to(histogram);
  curve.nodes.resize(shown.size());
  for (std::size_t node = 0; node < shown.size(); ++node) {
    const std::size_t next = std::min(node + 1, shown.size() - 1);
    const double here = std::exp2(shown[node]);
    // Of points, what holds in the middle between two nodes.
    const double luminance = std::exp2(octave_of(node) + 0.5 * octaves_per_node);
    const double threshold = point_threshold_lux(as_background(luminance), state, field);
    const double on_display = f64::threshold_illuminance_lux(
        curve.floor_cd_m2 + std::exp2(0.5 * (shown[node] + shown[next])), f64::default_field_factor);
    const double points =
        settings.tone == ToneOperator::photographic ? std::exp2(shown.front() - octave_of(0)) : on_display / threshold;
    curve.nodes[node] = {here, std::exp2(shown[next]) - here, points, 1.0 / threshold};
  }
  return curve;
}

} // namespace vesper
