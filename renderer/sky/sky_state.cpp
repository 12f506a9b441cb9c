#include "vesper/sky/sky_state.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/earth_state.hpp"

namespace vesper {

SkyState sky_state(const Instant& instant, const Observer& observer, Tier tier) {
  const EarthState earth = earth_state(instant, observer, tier);
  const StarFrame frame = star_frame(earth);
  const Vec3 sun_au = sun_from_observer_au(earth);
  const Vec3 moon_au = moon_from_observer_au(earth);

  SkyState state;
  state.instant = instant;
  state.observer = observer;
  state.tier = tier;
  state.refraction = standard_refraction(observer.height, tier);
  state.stars = tier == Tier::cheap ? star_frame(instant, observer, tier) : frame;
  state.sun = apparent_place(sun_au, frame);
  state.moon = moon_state(earth, frame, moon_au, sun_au);
  state.planets = planet_states(earth, frame, sun_au);
  state.lunar_eclipse = lunar_eclipse_state(apparent_sun_moon(earth.bodies));
  state.solar_eclipse =
      solar_eclipse_state(state.sun.direction_horizon * state.sun.distance.to(kilometre),
                          state.moon.place.direction_horizon * state.moon.place.distance.to(kilometre));
  state.seconds = instant.tt.days_since(j2000<TT>) * seconds_per_day;
  return state;
}

} // namespace vesper
