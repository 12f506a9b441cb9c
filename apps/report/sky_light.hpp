// What the light of Sun and Moon in the air amounts to, by the reference transport.
#pragma once

#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/sky/sky_light.hpp"

#include <vector>

namespace vesper {

/// A light with the quantities that it is asked for.
struct WeightedLight {
  SkyLight light;
  std::vector<SpectralFunctional> functionals;
  std::uint64_t stream = 0; ///< of random numbers, its own
  LightShare share{};       ///< of a light in another body's shadow
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
