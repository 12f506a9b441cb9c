// What a picture's light tells about how it is to be shown.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/plan/view.hpp"

#include <array>
#include <span>
#include <vector>

namespace vesper {

/// Where the picture's light counts.
enum class Metering {
  whole_field, ///< everywhere, by solid angle
  foveal,      ///< by solid angle, and less away from the view's direction: half at 5 degrees
};

/// The cells that a picture is metered by: about a degree wide, as the fovea is (Larson, Rushmeier and Piatko 1997),
/// each the mean of samples x samples pixels. They depend on the view's field and shape alone, so that a picture in
/// more pixels is metered alike.
struct MeteringGrid {
  int columns = 0;
  int rows = 0;
  int samples = 0; ///< along a cell's edge
};
[[nodiscard]] MeteringGrid metering_grid(const View& view);

/// Shares of the field by luminance of its cells, in the bins of shaders/lib/tone.glsl. What is missing to 1 is black.
struct LightHistogram {
  using Bins = std::array<double, f64::tone_bins>;
  Bins seen{};     ///< by luminance as an eye sees it that is adapted to it: mesopic, photopic by day
  Bins scotopic{}; ///< by S
};

/// Adds a cell with a share of the field to the two bins next to its luminance.
void add_to(LightHistogram::Bins& bins, double luminance_cd_m2, double share);

/// The luminances that cones and rods are adapted to.
struct AdaptationState {
  Luminance cones;
  Luminance rods; ///< scotopic
};

/// The state of an eye that has looked at a picture for long: the mean of the logarithm over its field. What is darker
/// than 1/300 of the mean brightness (which goes about as the cube root of luminance: Stevens 1961) counts as that, so
/// that neither a small bright disc nor a black half of the field governs it.
[[nodiscard]] AdaptationState adapted_to(const LightHistogram& histogram);

/// An instant of a sequence, and what its picture would adapt an eye to.
struct MeteredInstant {
  double seconds = 0.0;
  AdaptationState field;
};

/// States of an eye that looks at a sequence: fully adapted at its first instant, then as cones and rods follow, each
/// with its own time towards light and towards darkness (`adapted` in shaders/lib/vision.glsl). A pure function: frames
/// may then be drawn in any order. Throws Error(argument) unless the instants ascend.
[[nodiscard]] std::vector<AdaptationState> adapt(std::span<const MeteredInstant> sequence);

} // namespace vesper
