// What eclipses leave of the light of Sun and Moon.
#pragma once

#include "vesper/astro/lunar_eclipse.hpp"
#include "vesper/astro/solar_eclipse.hpp"
#include "vesper/astro/tier.hpp"
#include "vesper/atmosphere/earth_shadow_light.hpp"
#include "vesper/light/solar_disc.hpp"
#include "vesper/light/spectrum.hpp"

#include <memory>
#include <span>

namespace vesper {

/// Shares, 0 to 1 to rounding, of the light of discs of brightness mu^powers[k] that pass another disc. The angles may
/// be in any one unit.
/// \param sun, other radii, positive
/// \param separation of the centres, >= 0
/// \param powers 0 (a uniform disc) to 5
[[nodiscard]] LimbSeries sunlight_seen(double sun, double other, double separation, const LimbPowers& powers);

/// The Sun's light past the Moon, by wavelength, over that of the Sun's disc: 1 without an eclipse, and redder the
/// thinner the crescent. The corona's, 1.4e-6 at most, is in it, so that it never ends; light from outside the shadow
/// is not.
[[nodiscard]] Spectrum sunlight_past_moon(const SolarEclipseState& eclipse,
                                          LimbDarkening law = LimbDarkening::hestroffer_magnan);

/// What an eclipse of the Moon looks like beside its geometry.
struct EclipseAir {
  /// Danjon's L of the Earth's air, 0 (after great volcanic eruptions) to 4 (clear): earth_shadow_load.hpp. By default
  /// that of years without volcanic dust, which gives the magnitude measured on 3 March 2007 within 0.25.
  double danjon = 2.5;
  /// Of the air as a whole; nothing for that of clear_medium().
  std::shared_ptr<const EarthShadowLight> light;
};

/// A place of the Moon's surface, and how much of its light without an eclipse comes from there.
struct MoonPlace {
  Vec3 normal; ///< ICRS axes
  double share = 0.0;
};

/// The Sun's light on the Moon past the Earth, by wavelength: the mean of what lunar_eclipse_shares gives its places.
/// With Tier::cheap that of the published colour map.
/// \param face places whose shares sum to 1
/// Throws Error(argument) for an L out of its range.
[[nodiscard]] Spectrum sunlight_on_moon(const LunarEclipseState& eclipse, std::span<const MoonPlace> face,
                                        const EclipseAir& air = {}, Tier tier = Tier::standard);
/// The same for a Moon that is equally bright all over the disc that faces the Earth.
[[nodiscard]] Spectrum sunlight_on_moon(const LunarEclipseState& eclipse, const EclipseAir& air = {},
                                        Tier tier = Tier::standard);

/// The table for the points of the Moon. Outside an eclipse its frame is that of lunar_eclipse_none, with Tier::cheap
/// that of lunar_eclipse_published; both have no texels.
/// \param moonlight without an eclipse, in any unit: only its colour counts
/// Throws Error(argument) for an L out of its range.
[[nodiscard]] LunarEclipseTable lunar_eclipse_table(const LunarEclipseState& eclipse, const Spectrum& moonlight,
                                                    const EclipseAir& air = {}, Tier tier = Tier::standard);

/// Magnitudes in V by which sunlight is dimmed to a share of it: 0 for all, infinite for none.
[[nodiscard]] double dimming_v_mag(const Spectrum& share);

/// The L that an eclipse will be given by who sees it: not only the air makes it bright, but also how deep the Moon
/// stands in the shadow. L is 0 where 1e-6 of the light is left at mid-eclipse and 4 where 1e-4 is, linear in the
/// magnitude between, which meets estimates within 1 (28 September 2015: 2e-5 of the light, L = 1.9 of 28 observers).
/// \param dimming_mag dimming_v_mag of the light on the disc at mid-totality
[[nodiscard]] double seen_danjon(double dimming_mag);

} // namespace vesper
