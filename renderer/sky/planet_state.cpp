#include "vesper/sky/planet_state.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/spherical.hpp"

namespace vesper {

PlanetStates planet_states(const EarthState& earth, const StarFrame& frame, const Vec3& sun_au) {
  const Vec3 sun_direction = apparent_equatorial(sun_au, frame);
  PlanetStates states;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto planet = static_cast<Planet>(i);
    const Vec3 planet_au = planet_from_observer_au(planet, earth);
    PlanetState& state = states.at(i);
    state.place = apparent_place(planet_au, frame);
    // Of the Sun at the time when it lit the planet: within 4 hours it moves by 200 km.
    state.appearance = planet_appearance(planet, planet_au, planet_au - sun_au, earth.tdb);
    state.bright_limb = position_angle(state.place.direction_equatorial, sun_direction);
  }
  return states;
}

} // namespace vesper
