// The chain from the light of a scene to a display: the eye's glare and acuity, metering, adaptation, colour by rods
// and cones, tone, points of light, display.
#pragma once

#include "vesper/gpu/display_mapping.hpp"
#include "vesper/gpu/eye_optics.hpp"
#include "vesper/gpu/light_meter.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/shader_library.hpp"
#include "vesper/plan/chromatic_adaptation.hpp"
#include "vesper/plan/display.hpp"
#include "vesper/plan/tone_curve.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace vesper::gpu {

struct DisplaySettings {
  ToneSettings tone;
  Metering metering = Metering::whole_field;
  /// What the eye is adapted to; what each picture adapts it to where there is none.
  std::optional<AdaptationState> adaptation;
  /// What the scene is seen by, lux, X, Y, Z (adapting_light() in vesper/sky/scene_white.hpp): the eye is adapted to
  /// its colour. Without it colours are shown as they measure.
  std::optional<Vec3> light;
  EyeOpticsSettings optics; ///< glare and acuity; its magnification is found from view and display
  bool night_vision = true; ///< colours fade as rods take over; off: as by day, or for a camera
  bool noise = false;       ///< the grain that is seen in the dark, at an instant
  double seconds = 0.0;
  Display display;
  PixelFormat format = PixelFormat::rgba8; ///< rgba8 or rgba16
  std::uint32_t seed = 0;                  ///< of dither and grain
};

/// Cube maps go without glare and acuity: they are seen through another program's view.
class DisplayChain : public DisplayMapping {
public:
  /// The library must outlive the chain. Throws Error(argument) for settings out of range.
  explicit DisplayChain(const ShaderLibrary& library, const DisplaySettings& settings = {});

  [[nodiscard]] PixelFormat format() const override { return settings_.format; }
  void start(const View& view) override;
  void look(const StripLight& light) override;
  void map(const StripLight& light, const Texture& pixels) override;

  /// Of the picture that was mapped last: what it held, what it would adapt an eye to, and the curve it got.
  [[nodiscard]] const LightHistogram& histogram() const { return histogram_; }
  [[nodiscard]] const ToneCurve& curve() const { return curve_; }

  /// For the next pictures: cheaper than another chain. Throws as the constructor does.
  void use(const DisplaySettings& settings);

private:
  void find_curve();

  const ShaderLibrary& library_;
  DisplaySettings settings_;
  f64::DisplayModel display_{};
  ColorAdaptation color_adaptation_;
  ProgramVariants programs_;
  LightMeter meter_;
  std::unique_ptr<EyeOptics> optics_;              ///< once it is asked for
  bool through_optics_ = false;                    ///< this picture
  std::array<const ProgramHandle*, 2> of_tiles_{}; ///< without points, with them
  View view_;
  bool looked_ = false; ///< and no curve found yet
  LightHistogram histogram_;
  ToneCurve curve_;
  Texture nodes_;
};

} // namespace vesper::gpu
