// What the light of Sun and Moon in the air amounts to, by the tables of the sky.
#pragma once

#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/sky/sky_light.hpp"

namespace vesper {

/// What a light gives at a place.
struct SourceLight {
  double direct_lux = 0.0;             ///< on a level surface, by itself
  double diffuse_lux = 0.0;            ///< on the same, by way of air and ground
  double zenith_luminance_cd_m2 = 0.0; ///< of the sky, without discs
  double zenith_scotopic_cd_m2 = 0.0;  ///< by the tables alone
};

struct SceneLight {
  SourceLight sun, moon;
};

/// \param lights of lights_of; what is not among them gives nothing
[[nodiscard]] SceneLight table_light(const SkyTables& tables, Length height, const std::vector<SkyLight>& lights);

} // namespace vesper
