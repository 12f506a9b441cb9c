// The light of the night sky itself, before the air: airglow, zodiacal light and the stars too faint to be drawn.
#pragma once

#include "vesper/assets/cube_pyramid.hpp"
#include "vesper/atmosphere/city_glow.hpp"
#include "vesper/atmosphere/light_through_air.hpp"
#include "vesper/atmosphere/refracted_columns.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/sky/sky_state.hpp"

#include <memory>
#include <optional>

namespace vesper {

/// What no ephemeris tells about a night.
struct DarkSkyOptions {
  /// Of the Sun at 10.7 cm, which the airglow follows: airglow_s10 in night_light.hpp. Without one, that of the date in
  /// a mean cycle of activity (solar_activity in sun_disc.hpp), 80 to 200.
  std::optional<double> solar_flux_sfu;
  CityGlow glow;                                ///< none by default
  std::shared_ptr<const CubePyramid> milky_way; ///< default_milky_way() where there is none
};

/// The sources of one scene. Directions are unit vectors of the horizon frame, luminances X, Y, Z, S in cd/m2.
///
/// No light counts twice: point stars are the catalogue's; all other light from beyond the solar system is in the map
/// of the Milky Way, from which drawn stars were removed. It holds the light that dust and other galaxies add.
struct DarkSky {
  Mat3 helioecliptic_from_horizon{1.0}; ///< x towards the Sun in the ecliptic of date, z to the ecliptic's north pole
  Mat3 icrs_from_horizon{1.0};
  double zodiacal_scale = 1.0; ///< R^-2.3
  double sin_sun_radius = 0.0;
  Vec4 dust_corona{}; ///< over f64::f_corona: what the Sun's layer draws and zodiacal light leaves out
  Vec4 airglow{};     ///< of the shell seen square on
  CityGlow glow;
  std::shared_ptr<const CubePyramid> milky_way; ///< in ICRS axes; default_milky_way() where there is none
};

/// Throws Error(argument) for options out of their range.
[[nodiscard]] DarkSky dark_sky(const SkyState& sky, const DarkSkyOptions& options = {});

/// Outside the air.
[[nodiscard]] Vec4 zodiacal_light(const DarkSky& sky, const Vec3& direction);
/// \param width over which the map is averaged; where its texels are wider, it is between them
[[nodiscard]] Vec4 faint_starlight(const DarkSky& sky, const Vec3& direction, Angle width);
/// The width by which a field is named as bright: published figures are means over it.
inline constexpr Angle starlight_field = 5.0 * deg;

/// The air before one observer's dark sky.
class DarkSkyAir {
public:
  /// As RefractedColumns and LightThroughAir.
  DarkSkyAir(const Medium& medium, Length height, const std::optional<RefractionConditions>& bending);

  /// Direct light of the airglow, without what the air scatters. \param sin_altitude as it is seen
  [[nodiscard]] Vec4 airglow(const DarkSky& sky, double sin_altitude) const;
  /// Shares of X, Y, Z and S that the air leaves of the others. For light without edges it does not matter whether
  /// refraction raises the direction.
  [[nodiscard]] Vec4 zodiacal_share(double sin_altitude) const;
  [[nodiscard]] Vec4 starlight_share(double sin_altitude) const;

private:
  [[nodiscard]] std::vector<double> columns_km(double sin_altitude) const;

  RefractedColumns columns_;
  LightThroughAir airglow_;
  LightThroughAir zodiacal_;
  LightThroughAir starlight_;
  double height_km_;
  double ground_km_;
};

/// Airglow as the air below it is lit by it: seen from the ground without air.
[[nodiscard]] Vec4 airglow_above(const DarkSky& sky, double sin_altitude);

} // namespace vesper
