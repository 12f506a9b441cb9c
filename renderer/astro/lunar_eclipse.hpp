// Eclipses of the Moon: the Earth's shadow at any instant, contacts, and the eclipses of a span of time.
#pragma once

#include "vesper/astro/apparent_sun_moon.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace vesper {

/// How much the air widens the shadow, and how. pi are parallaxes (the Earth's equatorial radius), s_s is the Sun's
/// semidiameter; umbra with -, penumbra with +.
enum class ShadowModel {
  danjon,    ///< 1.01 pi_moon + pi_sun -+ s_s (Danjon 1951)
  chauvenet, ///< 1.02 (0.998340 pi_moon + pi_sun -+ s_s) (Chauvenet 1863, as in NASA's catalogue)
};

/// The Moon against the Earth's shadow, seen from the Earth's centre. Defined wherever the Moon stands.
struct LunarEclipseState {
  /// Share of the Moon's diameter inside the shadow, measured along the line to the axis: negative outside, above 1
  /// when it is covered with room to spare. Never clipped.
  double umbral_magnitude = 0.0;
  double penumbral_magnitude = 0.0;
  Angle axis_distance; ///< of the Moon's centre from the antisolar point, 0 to 180 degrees
  Angle umbra_radius;  ///< at the Moon's distance, as are the following
  Angle penumbra_radius;
  Angle moon_semidiameter;  ///< k = 0.2725076
  Vec3 axis{0.0, 0.0, 1.0}; ///< of the shadow, unit vector away from the apparent Sun, ICRS axes
  Vec3 moon_km{};           ///< apparent Moon from the Earth's centre, ICRS axes
  Length sun_distance;
};

[[nodiscard]] LunarEclipseState lunar_eclipse_state(const ApparentSunMoon& seen,
                                                    ShadowModel model = ShadowModel::danjon);

/// The shadow for shaders/lib/eclipse.glsl: Danjon's, whose edge is that of an Earth larger by 1 %.
/// \param to_frame turns ICRS axes to those in which points will be given
[[nodiscard]] f64::EarthShadow earth_shadow(const LunarEclipseState& state, const Mat3& to_frame = Mat3(1.0));

enum class LunarEclipseType {
  none,
  penumbral,
  total_penumbral, ///< all of the Moon in the penumbra and none in the umbra
  partial,
  total,
};
/// "none", "penumbral", "total penumbral", "partial", "total".
[[nodiscard]] std::string_view name_of(LunarEclipseType type);

/// Where the Moon's limb touches a shadow's edge from outside (1, 4) or inside (2, 3).
enum class LunarContact { p1, u1, u2, u3, u4, p4 };
inline constexpr int lunar_contact_count = 6;

struct LunarEclipse {
  LunarEclipseType type = LunarEclipseType::none;
  Instant greatest;   ///< least distance, in km, of the Moon's centre from the axis
  double gamma = 0.0; ///< that distance in equatorial radii of the Earth, positive where the Moon passes north
  double umbral_magnitude = 0.0; ///< at greatest eclipse, as in LunarEclipseState
  double penumbral_magnitude = 0.0;
  std::array<std::optional<Instant>, lunar_contact_count> contacts; ///< by LunarContact; empty where there is none

  [[nodiscard]] const std::optional<Instant>& contact(LunarContact c) const {
    return contacts[static_cast<std::size_t>(c)];
  }
};

/// The full Moon nearest to an instant (within a week), eclipsed or not. The instants keep the given one's difference
/// to the Delta-T table.
[[nodiscard]] LunarEclipse lunar_eclipse_near(const Instant& instant, ShadowModel model = ShadowModel::danjon);

/// All eclipses, penumbral ones included, whose greatest phase lies in [from, to), in order.
[[nodiscard]] std::vector<LunarEclipse> lunar_eclipses(const Instant& from, const Instant& to,
                                                       ShadowModel model = ShadowModel::danjon);

} // namespace vesper
