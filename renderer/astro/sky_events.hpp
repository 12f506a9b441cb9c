// Rise, set, transit and twilights of Sun, Moon, planets and stars.
#pragma once

#include "vesper/astro/constants.hpp"
#include "vesper/astro/ephemeris.hpp"
#include "vesper/astro/observer.hpp"
#include "vesper/astro/refraction.hpp"
#include "vesper/astro/star_place.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/units.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace vesper {

enum class Luminary { sun, moon };

/// A catalogue star with the Julian year of its position.
struct DatedStar {
  CatalogueStar star;
  double epoch_jyear = 2000.0;
};

using SkyBody = std::variant<Luminary, Planet, DatedStar>;

/// What counts as rise and set: the airless altitude of the upper limb (of planets and stars the centre).
struct HorizonRule {
  Angle limb_altitude = -almanac_refraction;
  /// What the Sun's centre lies below its limb; its true semidiameter where absent. The Moon's is always the true one,
  /// at its distance from the observer (moon_mean_radius).
  std::optional<Angle> sun_semidiameter = almanac_sun_semidiameter;

  /// The convention of almanacs, which the defaults give too (constants.hpp): the Sun's centre stands at -50'. Height
  /// shifts no horizon: dip is ignored.
  [[nodiscard]] static HorizonRule almanac() { return {}; }

  /// What is seen: the upper limb on a horizon, both as the air shows them, and the Sun in its true size.
  /// \param apparent_horizon its altitude; horizon_altitude(refraction, height) is that of the sea
  [[nodiscard]] static HorizonRule seen(const Refraction& refraction, Angle apparent_horizon);
};

enum class SkyEventKind {
  astronomical_dawn, ///< the Sun's centre rises through -18 degrees, airless
  nautical_dawn,     ///< -12 degrees
  civil_dawn,        ///< -6 degrees
  rise,
  upper_transit, ///< the meridian from pole to pole through the zenith, hour angle 0
  lower_transit, ///< the other half of the meridian
  set,
  civil_dusk,
  nautical_dusk,
  astronomical_dusk
};

/// "rise", "set", "transit", "lower transit", "civil dawn", ...
[[nodiscard]] std::string_view name_of(SkyEventKind kind);

struct SkyEvent {
  SkyEventKind kind{};
  Instant instant;
  Horizontal place; ///< apparent, topocentric, airless, of the centre
};

struct AltitudeExtreme {
  Instant instant;
  Horizontal place; ///< apparent, topocentric, airless, of the centre
};

/// What a body does at the horizon of HorizonRule.
enum class HorizonConduct { crosses, stays_above, stays_below };

struct BodyEvents {
  std::vector<SkyEvent> events; ///< by time
  HorizonConduct conduct = HorizonConduct::crosses;
  AltitudeExtreme lowest;  ///< of the altitude of the centre; on its border if need be
  AltitudeExtreme highest; ///< so too
};

/// All that each of `bodies` does in [begin, end): every crossing, also the two of a polar Sun that touches the horizon
/// for a second.
///
/// Apparent topocentric places are computed at 19 instants a day; between them they are interpolated within 0.003" for
/// the Moon and 0.00001" for all else, which at the horizon is worth a millisecond where nothing grazes it. An event on
/// the border of two intervals that share the same Instant belongs to one of them. UT1 between goes by the Delta-T of
/// `begin` (see later()). Cost for Sun and Moon: 30 microseconds a day inside the ephemeris table, a millisecond
/// outside (bench_events). Throws Error(argument) when `end` lies before `begin`.
[[nodiscard]] std::vector<BodyEvents> sky_events(const Instant& begin, const Instant& end, const Observer& observer,
                                                 std::span<const SkyBody> bodies,
                                                 const HorizonRule& rule = HorizonRule::almanac(),
                                                 Tier tier = Tier::standard);

/// Apparent topocentric direction, a unit vector along horizon axes (x = East, y = North, z = zenith), airless, and
/// the distance; that of a star is infinite.
struct HorizonPlace {
  Vec3 direction{};
  double distance_au = 0.0;
};
[[nodiscard]] HorizonPlace horizon_place(const SkyBody& body, const EarthState& earth, const StarFrame& frame);

} // namespace vesper
