// The chain from the light of a scene to a display: glare of the eye, metering, adaptation, vision, tone, display.
//
// How its members meet: glare and acuity run first and leave what they make in textures of their own (SeenLight); one
// compute stage (display_chain.comp) then reads frame, points and these textures once per pixel, applies vision, tone
// curve, points, noise and display model in registers, and writes the code values once.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/gpu/display_mapping.hpp"
#include "vesper/gpu/display_model.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/shader_library.hpp"

#include <cstdint>
#include <optional>

namespace vesper::gpu {

/// How luminance of the scene becomes luminance of the display.
enum class ToneOperator {
  visibility,   ///< what can be seen in the scene is seen on the display: Ward Larson, Rushmeier and Piatko 1997
  reinhard,     ///< extended, on luminance: Reinhard et al. 2002
  hable,        ///< the filmic curve with an exposure
  photographic, ///< linear, as a camera of a given exposure value
  false_color,  ///< colours tell luminance; a legend is drawn in
};

/// What changes light in the eye. Off for pictures as cameras take them.
struct EyeSettings {
  bool glare = true;
  bool acuity = true;
  bool night_vision = true; ///< colours as rods and cones see them
  bool noise = false;
  double age_years = 30.0;
  double field_factor = 1.7; ///< of thresholds: Crumey 2014
};

struct DisplaySettings {
  ToneOperator tone = ToneOperator::visibility;
  double exposure_stops = 0.0; ///< over what the operator finds by itself; of photographic: over the metered one
  std::optional<double> exposure_value; ///< of photographic (at ISO 100), in place of the metered one
  Display display;
  EyeSettings eye;
  double seconds = 0.0;   ///< of the noise
  std::uint32_t seed = 0; ///< of the noise
};

/// What glare and acuity leave for the last stage. Textures cover the whole picture, at any size, and are read between
/// texels at (pixel / size of the picture).
struct SeenLight {
  const Texture* veil = nullptr;    ///< rgba32f light that the eye scatters over the picture, added; none if null
  double kept = 1.0;                ///< share of the light of frame and points that stays where it is
  const Texture* blurred = nullptr; ///< rgba32f with mipmaps: the frame without points, to be read at the level that
                                    ///< acuity_level() of shaders/lib/acuity.glsl gives for the luminance there
};

class DisplayChain : public DisplayMapping {
public:
  /// The library must outlive the chain. Throws Error(argument) for settings out of range.
  DisplayChain(const ShaderLibrary& library, const DisplaySettings& settings);

  void meter(const PictureLight& picture) override;
  void map(const PictureLight& strip, const Texture& pixels) override;

private:
  DisplaySettings settings_;
};

} // namespace vesper::gpu
