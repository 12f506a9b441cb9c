// How bright the sky is behind what is looked at, and what makes it so.
#pragma once

#include "vesper/astro/star_place.hpp"
#include "vesper/atmosphere/eclipsed_sky.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/sky_state.hpp"

#include <memory>
#include <vector>

namespace vesper {

/// Light of the sky in one direction by its sources, direct and scattered: X, Y, Z, S in cd/m2. Without the discs of
/// Sun and Moon and without point stars.
struct SkyBackground {
  Vec4 sun{};
  Vec4 moon{};
  Vec4 airglow{};
  Vec4 zodiacal{};
  Vec4 starlight{}; ///< of stars too faint for the catalogue
  Vec4 sky_glow{};  ///< of cities

  [[nodiscard]] Vec4 sum() const { return sun + moon + airglow + zodiacal + starlight + sky_glow; }
};

/// Of an observer whose air the tables are of. Takes 10 ms and a tenth of one a direction.
/// \param directions airless; one below the horizontal counts as level
/// \param eclipse what the Moon's shadow leaves of the Sun's light in the air; none where it is far away
[[nodiscard]] std::vector<SkyBackground> sky_backgrounds(const SkyState& sky, const Medium& medium,
                                                         const std::shared_ptr<const SkyTables>& tables,
                                                         const DarkSkyOptions& options,
                                                         const std::vector<Horizontal>& directions,
                                                         const EclipsedSky* eclipse = nullptr);

} // namespace vesper
