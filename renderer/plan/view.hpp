// Where the camera looks and what shape the picture has.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace vesper {

/// Numbered as shaders/lib/projection.glsl numbers them.
enum class Projection {
  perspective = 0,     ///< gnomonic; fov below 170 degrees
  fisheye = 1,         ///< azimuthal equidistant, zero outside its circle; fov to 360 degrees
  stereographic = 2,   ///< fov below 350 degrees
  equirectangular = 3, ///< the sphere, view direction in the middle
  cubemap = 4,         ///< the sphere, six faces stacked as OpenEXR orders them; the view looks along -Z
};

/// Names in the order of the enumeration.
[[nodiscard]] std::span<const std::string_view> projection_names();
[[nodiscard]] std::optional<Projection> projection_from_name(std::string_view name);

/// A view in the horizon frame. Up in the picture is increasing altitude; looking at the zenith the view azimuth lies
/// at the bottom. Row 0 is on top and pixel centres lie at +0.5.
struct View {
  Projection projection = Projection::fisheye;
  Angle azimuth = 180.0 * deg; ///< of the view direction, north through east
  Angle altitude = 90.0 * deg; ///< of the view direction, -90 to 90 degrees
  Angle roll;                  ///< positive turns the picture clockwise
  Angle fov = 180.0 * deg;     ///< full angle across the shorter side; unused by the projections of the sphere
  int width = 1024;            ///< pixels
  int height = 1024;           ///< pixels; 6 times the width for a cube map
};

/// Largest allowed field of view: itself allowed for a fisheye, excluded for the others.
[[nodiscard]] Angle largest_fov(Projection projection);

/// Throws Error(argument) naming the member, its value and the allowed range.
void validate(const View& view);

/// View axes (x right, y up, z forward) from the horizon frame (x East, y North, z zenith).
[[nodiscard]] Mat3 view_from_horizon(const View& view);

/// The projection in the form that shaders/lib/projection.glsl takes, in double precision.
[[nodiscard]] f64::ProjectionFrame projection_frame(const View& view);

/// Pixels that a degree takes in the middle of the picture.
[[nodiscard]] double view_pixels_per_degree(const View& view);

} // namespace vesper
