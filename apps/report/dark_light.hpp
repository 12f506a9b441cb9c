// What the dark sky's own light amounts to at a place.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/sky_state.hpp"

#include <memory>

namespace vesper {

/// The air at one height before the dark sky: made in 10 ms, for any scene there.
struct DarkAir {
  DarkSkyAir direct;
  SpreadLightViews scattered; ///< in the zenith alone
  double glow_lux = 0.0;      ///< on a level surface, by a sky glow that makes the zenith 1 cd/m2; 0 without sky glow

  DarkAir(const Medium& medium, std::shared_ptr<const SkyTables> tables, Length height, const CityGlow& glow);
};

/// Direct and scattered light together.
struct DarkSourceLight {
  double illuminance_lux = 0.0; ///< of a level surface
  double zenith_luminance_cd_m2 = 0.0;
  double zenith_scotopic_cd_m2 = 0.0;
};

struct DarkLight {
  DarkSourceLight airglow, zodiacal, starlight, sky_glow;
  [[nodiscard]] DarkSourceLight sum() const;
};

[[nodiscard]] DarkLight dark_light(const SkyState& sky, const DarkAir& air, const DarkSkyOptions& options);

} // namespace vesper
