// Everything true about the sky at one instant for one observer.
#pragma once

#include "vesper/astro/observer.hpp"
#include "vesper/astro/star_frame.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/sky/apparent_place.hpp"
#include "vesper/sky/moon_state.hpp"
#include "vesper/sky/planet_state.hpp"

namespace vesper {

struct SkyState {
  Instant instant;
  Observer observer;
  Tier tier = Tier::standard;
  StarFrame stars;
  BodyPlace sun;
  MoonState moon;
  PlanetStates planets;
  double seconds = 0.0; ///< TT seconds since J2000.0, the clock of scintillation
};

[[nodiscard]] SkyState sky_state(const Instant& instant, const Observer& observer, Tier tier = Tier::standard);

} // namespace vesper
