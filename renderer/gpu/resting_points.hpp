// Point sources with places of their own, for the star pass, which reckons with motions and parallaxes of a catalogue.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/sky/sky_state.hpp"

namespace vesper::gpu {

/// A star that stands at the given direction of the horizon frame in the catalogue of a resting observer. What a float
/// leaves of the direction goes into a proper motion of one year.
/// \param light X, Y, Z, S in lux; none without any Y
[[nodiscard]] StarRecord resting_star(const Vec3& direction, const Vec4& light);

/// The same sky for an observer at rest, whose catalogue is written in horizon axes a year ago.
[[nodiscard]] SkyState resting(const SkyState& sky);

} // namespace vesper::gpu
