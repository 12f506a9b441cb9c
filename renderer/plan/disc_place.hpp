// Where the disc of a far sphere lies in a picture.
#pragma once

#include "vesper/astro/refraction.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/view.hpp"

#include <vector>

namespace vesper {

/// A rectangle of whole pixels, high excluded.
struct PixelBox {
  int low_x = 0;
  int low_y = 0;
  int high_x = 0;
  int high_y = 0;
};

/// Round and small enough to have a middle: a sphere's disc, or what surrounds it.
struct SkyCircle {
  Vec3 direction;     ///< of its centre without refraction, horizon frame, unit vector
  Angle radius;       ///< of its limb, 0 to below 90 degrees
  double scale = 1.0; ///< its picture is larger by this factor about its centre: sine of its radius, product below 1
};

/// The circle in the form of shaders/lib/disc.glsl.
[[nodiscard]] f64::DiscFrame disc_frame(const SkyCircle& circle, const View& view, const Refraction& refraction);

/// Few boxes that hold all pixels that show some of the circle, and not many others: one, two where the picture wraps
/// round, one for each face of a cube map. Empty where it is out of the picture.
[[nodiscard]] std::vector<PixelBox> disc_boxes(const SkyCircle& circle, const View& view, const Refraction& refraction);

/// Diameter of the circle's picture from the area of the pixels at its centre; 0 where the picture has no pixel there.
[[nodiscard]] double disc_diameter_px(const SkyCircle& circle, const View& view, const Refraction& refraction);

} // namespace vesper
