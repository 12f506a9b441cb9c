// Moon and Sun as one frame draws them.
#pragma once

#include "vesper/assets/moon_map.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/disc_place.hpp"
#include "vesper/plan/disc_sprite.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/moon_disc.hpp"
#include "vesper/sky/moon_samples.hpp"
#include "vesper/sky/sky_state.hpp"
#include "vesper/sky/sun_disc.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace vesper {

/// Frames share a globe: it is copied to the GPU once.
[[nodiscard]] std::shared_ptr<const MoonGlobe> make_moon_globe(MoonMap map);
/// Of the embedded map, made at the first call.
[[nodiscard]] std::shared_ptr<const MoonGlobe> default_moon_globe();

/// How Moon and Sun are drawn.
struct DiscOptions {
  std::shared_ptr<const MoonGlobe> moon; ///< default_moon_globe() where there is none
  SunOptions sun;
  /// Factors of the discs' diameters, 1 to `largest_disc_scale`, each about its own centre: the light stays the same,
  /// so that luminance falls with the square. Where the Moon stands before the Sun it covers it as the enlarged discs
  /// lie; the light of the eclipse is that of the real ones.
  double moon_scale = 1.0;
  double sun_scale = 1.0;
};
inline constexpr double largest_disc_scale = 100.0;

/// A disc too small to show as one.
struct PointLight {
  Vec3 direction; ///< where the centre of its light is seen, horizon frame
  Vec4 light;     ///< X, Y, Z, S behind the air, lux
};

/// Where and how a disc is drawn.
struct PlannedDisc {
  f64::DiscFrame frame{};
  std::vector<PixelBox> boxes;
  std::optional<PointLight> point;  ///< in place of the boxes
  std::optional<DiscSprite> sprite; ///< fills the one box
  double width_px = 0.0;            ///< as disc_diameter_px has it
  double cells_of_radius = 20.0;    ///< into which a small disc's radius is cut for its light, at least
};
/// Discs narrower than that are points, pixels. A disc of this width spreads its light as far as the sharpest star
/// (psf_sigma in shaders/lib/star_psf.glsl).
inline constexpr double narrowest_disc_px = 3.0;
/// From there to here they are sprites, where the picture allows it.
inline constexpr double widest_sprite_px = 16.0;

struct PlannedMoon {
  PlannedDisc picture;
  /// A crescent of few pixels: into how many a radian of the sphere is cut between limb and terminator.
  double crescent_cells = 0.0;
  MoonDisc disc;
  std::shared_ptr<const MoonGlobe> globe;
  LunarEclipseTable eclipse;
  f64::EarthShadow shadow; ///< along mean-Earth axes
  Vec3 from_earth_km;      ///< the Moon's centre from the Earth's, likewise
};

struct PlannedSun {
  PlannedDisc picture;
  SunDisc disc;
  bool corona = false; ///< where neither the disc nor the sky outshines it
  Vec4 moon{}; ///< its direction along the axes of horizon_from_disc; w: distance of its limb on the unit sphere
  Vec4 turn{}; ///< rows of the matrix from places on the disc to those of the shading
};

/// What is common to the discs of a frame.
struct DiscScene {
  const SkyState& sky;
  const View& view;
  const Refraction& refraction; ///< with its table
  AirShares air;
  /// moon_illumination() of the sky, found when it is first asked for.
  std::function<const MoonIllumination&()> moon_illumination;
  std::optional<double> ground_sin_altitude; ///< below it nothing is seen
  bool bright_sky = false;                   ///< the light of the air is drawn
};

/// Nothing where the disc is out of the picture or below the ground, and in a sky without these bodies. Throws
/// Error(argument) for scales out of range.
[[nodiscard]] std::optional<PlannedMoon> plan_moon(const DiscScene& scene, const DiscOptions& options);
[[nodiscard]] std::optional<PlannedSun> plan_sun(const DiscScene& scene, const DiscOptions& options);

} // namespace vesper
