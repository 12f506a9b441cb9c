// Sun and Moon as lights of the air, and what their light amounts to.
#pragma once

#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/light/spectrum.hpp"
#include "vesper/sky/sky_state.hpp"

#include <string>
#include <vector>

namespace vesper {

/// A light so far away that it looks the same from all of the air.
struct SkyLight {
  std::string name; ///< "sun" or "moon"
  Vec3 direction;   ///< towards its centre, without refraction: horizon frame
  Angle angular_radius;
  Spectrum irradiance; ///< above the air, W/(m2 nm)
};

[[nodiscard]] SkyLight sun_light(const Vec3& direction, Length distance);
/// \param phase_angle 0 to 180 degrees
[[nodiscard]] SkyLight moon_light(const Vec3& direction, Length distance, Length from_sun, Angle phase_angle);

/// Sun and Moon of a scene at their airless places: straight rays from there bring a level surface as much as bent ones
/// do, because what falls on the air above it is the same. Left out is what stands so deep that it gives the zenith
/// less than 1e-4 of the darkest night: the Sun some 23 degrees below the observer's horizon, the full Moon 11.
/// Eclipses do not dim them.
[[nodiscard]] std::vector<SkyLight> lights_of(const SkyState& sky);

/// The observer's height above the medium's ground: that above the ellipsoid, and 0 in places below it.
[[nodiscard]] Length height_in_air(const Observer& observer);

/// A light with the quantities that it is asked for.
struct WeightedLight {
  SkyLight light;
  std::vector<SpectralFunctional> functionals;
  std::uint64_t stream = 0; ///< of random numbers, its own
};

/// What several lights give together.
struct SkyEstimate {
  std::vector<Estimate> quantities; ///< one for each functional
  std::uint64_t paths = 0;
};

/// How well the light of several is to be known together. The greatest number of paths holds for each light; the
/// stream does not count.
struct LightBudget {
  PathBudget paths;
  double faint = 0.0; ///< sums below it need no smaller error than a sum that is as bright; in the functionals' unit
};

/// Radiance of the sky, summed over the lights so that the sum is as well known as the budget asks; of lights that are
/// faint beside others less is then known.
/// \param quantities number of each light's functionals
[[nodiscard]] SkyEstimate sky_radiance(const ReferenceTransport& transport, Length height, const Vec3& view_direction,
                                       const std::vector<WeightedLight>& lights, std::size_t quantities,
                                       const LightBudget& budget);

/// Light on a level surface, in the units of the lights' first functional.
struct LevelLight {
  double direct = 0.0; ///< of the lights themselves, without error of chance
  Estimate total;      ///< with that of sky and ground; the budget's relative error is that of the sky's part
  std::uint64_t paths = 0;
};
[[nodiscard]] LevelLight level_light(const ReferenceTransport& transport, Length height,
                                     const std::vector<WeightedLight>& lights, const LightBudget& budget);

} // namespace vesper
