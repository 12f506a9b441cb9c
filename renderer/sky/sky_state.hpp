// Everything true about the sky at one instant for one observer.
#pragma once

#include "vesper/astro/lunar_eclipse.hpp"
#include "vesper/astro/observer.hpp"
#include "vesper/astro/refraction.hpp"
#include "vesper/astro/solar_eclipse.hpp"
#include "vesper/astro/star_frame.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/sky/apparent_place.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/moon_state.hpp"
#include "vesper/sky/planet_state.hpp"

namespace vesper {

struct SkyState {
  Instant instant;
  Observer observer;
  Tier tier = Tier::standard;
  StarFrame stars;
  Refraction refraction; ///< of the standard atmosphere, without a table, as sky_state() leaves it
  BodyPlace sun;
  MoonState moon;
  LunarEclipseState lunar_eclipse; ///< Danjon's shadow, whether the Moon is near it or not
  EclipseAir eclipse_air;          ///< of eclipses of the Moon
  SolarEclipseState solar_eclipse; ///< for the observer, whether Sun and Moon are up or not
  PlanetStates planets;
  double seconds = 0.0; ///< TT seconds since J2000.0, the clock of scintillation
};

/// Throws Error(argument) outside the supported span of time (time.hpp).
[[nodiscard]] SkyState sky_state(const Instant& instant, const Observer& observer, Tier tier = Tier::standard);

} // namespace vesper
