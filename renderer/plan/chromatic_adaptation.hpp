// Colours as they look to an eye that is adapted to the light of the scene, on a display that has another white.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// How far an eye is adapted to the colour of the light that it sees by, 0 to 1: D of CIECAM02 (CIE 159:2004) and
/// CIECAM16 (CIE 248:2022) with the average surround, F = 1. 0.82 in the dark, 0.99 at 300 cd/m2.
/// \param field mean luminance of what it looks at, 0 or more
[[nodiscard]] double degree_of_adaptation(Luminance field);

/// From X, Y, Z seen by an eye that is adapted to one white to those that look alike to one adapted to another: CAT16
/// (Li et al. 2017, Color Res. Appl. 42, 703) in one step, von Kries' scaling by D w' / w + 1 - D. Whites have Y = 1.
/// \param degree D, 0 (nothing changes) to 1 (white becomes white)
[[nodiscard]] Mat3 chromatic_adaptation(const Vec3& from_white, const Vec3& to_white, double degree);

/// What a display has to show for a viewer who is adapted to its white. The default is the scene as it measures.
struct ColorAdaptation {
  Mat3 shown_from_xyz{1.0};      ///< keeps Y, which is for the tone curve to settle
  Vec3 rod_hue = f64::night_hue; ///< of the scene, Y = 1, that is shown as night_hue: what rods see has no white
};

/// CAT16 but for Y, which CAT16 changes by up to a per cent for what a display can show and this does not: within
/// 0.0015 in x and y for whites between sunlight's and moonlight's. \param light of the scene, X, Y, Z in lux on level
/// ground (adapting_light() in vesper/sky/scene_white.hpp): its
///        chromaticity is the white; a fifth of the luminance that it gives a white surface is the field's, as is
///        customary with these models. Throws Error(argument) unless all three are positive and finite.
/// \param display_white Y = 1
[[nodiscard]] ColorAdaptation adapted_to_light(const Vec3& light, const Vec3& display_white);

} // namespace vesper
