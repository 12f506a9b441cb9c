// The Moon's shadow in the air around an observer.
#pragma once

#include "vesper/atmosphere/eclipsed_sky.hpp"
#include "vesper/atmosphere/sky_query.hpp"
#include "vesper/sky/sky_state.hpp"

#include <optional>
#include <span>

namespace vesper {

/// Air that an observer on the ground can see stands no further away than this.
inline constexpr Length eclipsed_air_distance = 1200.0 * kilometre;

/// The shadow, in the observer's horizon frame, if it falls on air within `eclipsed_air_distance` of the observer,
/// wherever Sun and Moon stand.
/// \param wavelengths_nm of an EclipsedAir, 0 to 4
[[nodiscard]] std::optional<MoonShadowInAir> moon_shadow(const SkyState& sky, std::span<const double> wavelengths_nm);

/// The same of two bodies: places of their centres in km from the observer, along any axes.
[[nodiscard]] std::optional<MoonShadowInAir> moon_shadow(const Vec3& sun_km, const Vec3& moon_km,
                                                         std::span<const double> wavelengths_nm);

/// The same shadow for the reference transport, at any number of wavelengths; none where there is none.
[[nodiscard]] LightShare moon_shadow_share(const SkyState& sky, std::span<const double> wavelengths_nm);

} // namespace vesper
