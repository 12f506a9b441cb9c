// The curve by which luminance in a scene becomes luminance on a display.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/plan/light_metering.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vesper {

/// How luminance of the scene becomes luminance of the display.
enum class ToneOperator {
  visibility,   ///< what can be told apart in the scene can on the display: Larson, Rushmeier and Piatko 1997
  reinhard,     ///< Reinhard et al. 2002, extended, on luminance, with the key of Krawczyk et al. 2005
  hable,        ///< the filmic curve of Atmosphere Plus, exposed by the same key
  photographic, ///< linear, as a camera exposes; points count by their luminance
  false_color,  ///< colours tell luminance, with a legend; the curve goes unused
};
/// Names in the order of the enumeration.
[[nodiscard]] std::span<const std::string_view> tone_operator_names();
[[nodiscard]] std::optional<ToneOperator> tone_operator_from_name(std::string_view name);

struct ToneSettings {
  ToneOperator tone = ToneOperator::visibility;
  double stops = 0.0; ///< brighter by 2^stops than the operator itself has it; not of false_color
  /// Of photographic, at ISO 100 before `stops`; as a meter tells where there is none.
  std::optional<double> exposure_value;
};

/// Luminance on the display by luminance as it is seen in the scene, in the form of tone_curve() in
/// shaders/lib/tone.glsl.
struct ToneCurve {
  /// x: luminance that the display adds to its floor, cd/m2, never falling; y: its rise to the next node.
  /// z: luminance that a point adds, summed over its pixels and times a pixel's solid angle as it is seen, over its
  /// illuminance (lux, `seen_light`): a point at its threshold in the scene is at it on the display. Of photographic:
  /// of a pixel's luminance added over that of its points. w: one over that threshold in the scene, 1/lux. z and w hold
  /// within 4.5 % between two nodes (7 % where the night's contrast is raised).
  std::vector<f64::vec4> nodes;
  double floor_cd_m2 = 0.0; ///< what the display shows at its darkest, with the mean of this picture
  double mean_cd_m2 = 0.0;  ///< what it shows in the mean, by the histogram
};

/// \param state     what the eye is adapted to
/// \param histogram of the picture; the mean counts its cells by their solid angle
[[nodiscard]] ToneCurve make_tone_curve(const ToneSettings& settings, const LightHistogram& histogram,
                                        const AdaptationState& state, const f64::DisplayModel& display);

} // namespace vesper
