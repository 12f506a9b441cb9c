// The sky inside and around the Moon's shadow: dark above, lit at the horizon by the air outside.
#pragma once

#include "vesper/atmosphere/eclipsed_air.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace vesper {

/// The Moon's shadow as the air at one instant is in it. Along axes at the observer whose z points to the zenith.
struct MoonShadowInAir {
  f32::MoonShadow shadow{};
  /// Shares of the Sun's light over moon_shadow_gap_place, 0 to 1, at the wavelengths of an EclipsedAir. At least two.
  std::vector<f32::vec4> shares;
};

/// Places are in km from the observer.
[[nodiscard]] f32::vec4 sunlight_at(const MoonShadowInAir& in_air, const f32::vec3& place_km);

/// What an eclipse leaves of the light of the sky, one number each for X, Y, Z and S: 1 outside the shadow.
///
/// Light scattered once is summed along a view with each place's own sunlight; the rest comes from a chart of the
/// diffuse light, 1024 km wide, whose waves an EclipsedAir answers. Further away diffuse light is taken to be dimmed as
/// the place's sunlight is, but never to nothing. How near this comes to a Monte Carlo stands in docs/ACCURACY.md.
class EclipsedSky {
public:
  struct Ratios {
    f32::vec4 all{1.0F};          ///< air and ground
    f32::vec4 without_peak{1.0F}; ///< the same without the peak of what aerosol scatters forward (sky_map.glsl)
    f32::vec4 aerosol{1.0F};      ///< scattered once by aerosol
  };

  /// Takes some hundredths of a second.
  /// \param height of the observer above the ground, >= 0; anywhere
  EclipsedSky(std::shared_ptr<const EclipsedAir> air, MoonShadowInAir shadow, Length height, unsigned threads = 0);

  /// \param view unit vector, without refraction
  /// \param with_ground whether views that end on the ground show it
  [[nodiscard]] Ratios ratios(const Vec3& view, bool with_ground = true) const;

  /// Of the diffuse illuminance of a level surface that looks up.
  [[nodiscard]] f32::vec4 level_ratio() const;

private:
  static constexpr std::size_t side = 64;
  static constexpr double spacing_km = 16.0;
  /// The diffuse light of a place as EclipsedAir gives it.
  struct Node {
    f32::vec4 open;          ///< without the Moon
    f32::vec4 left;          ///< share of that which the Moon leaves
    f32::vec4 vertical;      ///< EclipsedAir::Diffuse::vertical over `open`, without the Moon
    f32::vec4 vertical_left; ///< and with it
  };
  struct Place;
  struct Light;

  void fill_chart(std::size_t wavelength);
  [[nodiscard]] Place place(const f32::vec3& at_km, float height_km) const;
  [[nodiscard]] Node chart(const Place& place) const;
  [[nodiscard]] Light march(const Vec3& view, bool with_ground) const;

  std::shared_ptr<const EclipsedAir> air_;
  MoonShadowInAir shadow_;
  double height_km_;
  std::vector<Node> chart_; ///< by place of the air, row and column
};

} // namespace vesper
