#include "vesper/astro/sky_events.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/constants.hpp"
#include "vesper/astro/earth_state.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/sampled_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vesper {
namespace {

using Samples = SampledFunction::Samples;
constexpr std::size_t sample_count = SampledFunction::sample_count;

struct Twilight {
  Angle sun_altitude;
  SkyEventKind dawn;
  SkyEventKind dusk;
};
constexpr std::array twilights{
    Twilight{civil_twilight_end, SkyEventKind::civil_dawn, SkyEventKind::civil_dusk},
    Twilight{nautical_twilight_end, SkyEventKind::nautical_dawn, SkyEventKind::nautical_dusk},
    Twilight{astronomical_twilight_end, SkyEventKind::astronomical_dawn, SkyEventKind::astronomical_dusk},
};

bool is(const SkyBody& body, Luminary luminary) {
  const auto* found = std::get_if<Luminary>(&body);
  return found != nullptr && *found == luminary;
}

/// Airless altitude of the centre at rise and set.
Angle centre_at_horizon(const SkyBody& body, double distance_au, const HorizonRule& rule) {
  if (is(body, Luminary::moon)) {
    return rule.limb_altitude - std::asin(moon_mean_radius / (distance_au * astronomical_unit)) * rad;
  }
  if (is(body, Luminary::sun)) {
    const Angle true_semidiameter = std::asin(sun_radius / (distance_au * astronomical_unit)) * rad;
    return rule.limb_altitude - rule.sun_semidiameter.value_or(true_semidiameter);
  }
  return rule.limb_altitude;
}

/// A stretch of at most a day: its borders and the states of the Earth at the points of a SampledFunction.
struct Stretch {
  const Instant* begin = nullptr;
  double from_s = 0.0; ///< seconds of TT since `begin`
  double to_s = 0.0;
  std::array<EarthState, sample_count> earth;
  std::array<StarFrame, sample_count> frames;

  [[nodiscard]] double seconds_at(double x) const { return from_s + 0.5 * (x + 1.0) * (to_s - from_s); }
};

/// One body over one stretch: smooth functions also where an altitude or azimuth has its cusps, at the zenith.
class Track {
public:
  Track(const SkyBody& body, const Stretch& stretch, const HorizonRule& rule) : Track(sample(body, stretch, rule)) {}

  [[nodiscard]] Horizontal place_at(double x) const {
    return horizontal_of({east_.value(x), north_.value(x), up_.value(x)});
  }
  [[nodiscard]] const SampledFunction& east() const { return east_; }
  [[nodiscard]] const SampledFunction& up() const { return up_; }
  [[nodiscard]] const SampledFunction& above_horizon() const { return above_horizon_; }
  [[nodiscard]] SampledFunction above(Angle altitude) const {
    Samples above = samples_.up;
    for (double& sample : above) {
      sample -= std::sin(altitude.to(rad));
    }
    return SampledFunction(above);
  }
  /// Towards the highest point of the equator: positive in upper transit.
  [[nodiscard]] double along_meridian(double x, Angle latitude) const {
    return std::cos(latitude.to(rad)) * up_.value(x) - std::sin(latitude.to(rad)) * north_.value(x);
  }

private:
  struct Sampled {
    Samples east{}, north{}, up{}, above_horizon{};
  };
  static Sampled sample(const SkyBody& body, const Stretch& stretch, const HorizonRule& rule) {
    Sampled samples;
    for (std::size_t i = 0; i < sample_count; ++i) {
      const HorizonPlace place = horizon_place(body, stretch.earth.at(i), stretch.frames.at(i));
      samples.east.at(i) = place.direction.x;
      samples.north.at(i) = place.direction.y;
      samples.up.at(i) = place.direction.z;
      samples.above_horizon.at(i) =
          place.direction.z - std::sin(centre_at_horizon(body, place.distance_au, rule).to(rad));
    }
    return samples;
  }
  explicit Track(const Sampled& samples)
      : samples_(samples), east_(samples.east), north_(samples.north), up_(samples.up),
        above_horizon_(samples.above_horizon) {}

  Sampled samples_;
  SampledFunction east_, north_, up_, above_horizon_;
};

/// Gathers what one body does, stretch after stretch.
class Gatherer {
public:
  Gatherer(const SkyBody& body, Angle latitude, const HorizonRule& rule)
      : body_(body), latitude_(latitude), rule_(rule) {}

  void add(const Stretch& stretch) {
    const Track track(body_, stretch, rule_);
    crossings(stretch, track, track.above_horizon(), SkyEventKind::rise, SkyEventKind::set);
    if (is(body_, Luminary::sun)) {
      for (const Twilight& twilight : twilights) {
        crossings(stretch, track, track.above(twilight.sun_altitude), twilight.dawn, twilight.dusk);
      }
    }
    for (const auto& change : track.east().sign_changes()) {
      const bool upper = track.along_meridian(change.x, latitude_) > 0.0;
      add_event(stretch, track, change.x, upper ? SkyEventKind::upper_transit : SkyEventKind::lower_transit);
    }
    widen(stretch, track, -1.0);
    for (const auto& change : track.up().derivative().sign_changes()) {
      widen(stretch, track, change.x);
    }
    widen(stretch, track, 1.0);
    above_ = track.above_horizon().value(0.0) > 0.0;
  }

  [[nodiscard]] BodyEvents result() && {
    auto& events = result_.events;
    std::stable_sort(events.begin(), events.end(),
                     [](const SkyEvent& a, const SkyEvent& b) { return a.instant.tt.days_since(b.instant.tt) < 0.0; });
    const bool crosses = std::any_of(events.begin(), events.end(), [](const SkyEvent& event) {
      return event.kind == SkyEventKind::rise || event.kind == SkyEventKind::set;
    });
    result_.conduct = crosses  ? HorizonConduct::crosses
                      : above_ ? HorizonConduct::stays_above
                               : HorizonConduct::stays_below;
    return std::move(result_);
  }

private:
  void crossings(const Stretch& stretch, const Track& track, const SampledFunction& above, SkyEventKind upwards,
                 SkyEventKind downwards) {
    for (const auto& change : above.sign_changes()) {
      add_event(stretch, track, change.x, change.upward ? upwards : downwards);
    }
  }
  void add_event(const Stretch& stretch, const Track& track, double x, SkyEventKind kind) {
    result_.events.push_back({kind, later(*stretch.begin, stretch.seconds_at(x)), track.place_at(x)});
  }
  void widen(const Stretch& stretch, const Track& track, double x) {
    const Horizontal place = track.place_at(x);
    if (place.altitude < lowest_) {
      lowest_ = place.altitude;
      result_.lowest = {later(*stretch.begin, stretch.seconds_at(x)), place};
    }
    if (place.altitude > highest_) {
      highest_ = place.altitude;
      result_.highest = {later(*stretch.begin, stretch.seconds_at(x)), place};
    }
  }

  const SkyBody& body_;
  Angle latitude_;
  const HorizonRule& rule_;
  BodyEvents result_;
  bool above_ = false;
  Angle lowest_ = 91.0 * deg;
  Angle highest_ = -91.0 * deg;
};

} // namespace

HorizonRule HorizonRule::seen(const Refraction& refraction, Angle apparent_horizon) {
  const double altitude = apparent_horizon.to(rad);
  const Vec3 airless = true_direction({0.0, std::cos(altitude), std::sin(altitude)}, refraction);
  return {horizontal_of(airless).altitude, std::nullopt};
}

std::string_view name_of(SkyEventKind kind) {
  constexpr std::array<std::string_view, 10> names{"astronomical dawn", "nautical dawn",    "civil dawn", "rise",
                                                   "transit",           "lower transit",    "set",        "civil dusk",
                                                   "nautical dusk",     "astronomical dusk"};
  return names.at(static_cast<std::size_t>(kind));
}

HorizonPlace horizon_place(const SkyBody& body, const EarthState& earth, const StarFrame& frame) {
  if (const auto* dated = std::get_if<DatedStar>(&body)) {
    const Vec3 icrs = star_place_icrs(dated->star, place_frame(frame, dated->epoch_jyear));
    return {glm::normalize(frame.horizon_from_icrs * icrs), std::numeric_limits<double>::infinity()};
  }
  const auto* planet = std::get_if<Planet>(&body);
  const Vec3 from_observer_au = planet != nullptr         ? planet_from_observer_au(*planet, earth)
                                : is(body, Luminary::sun) ? sun_from_observer_au(earth)
                                                          : moon_from_observer_au(earth);
  return {glm::normalize(frame.horizon_from_icrs * apparent_direction_icrs(from_observer_au, frame)),
          glm::length(from_observer_au)};
}

std::vector<BodyEvents> sky_events(const Instant& begin, const Instant& end, const Observer& observer,
                                   std::span<const SkyBody> bodies, const HorizonRule& rule, Tier tier) {
  const double duration_s = end.tt.days_since(begin.tt) * seconds_per_day;
  if (!(duration_s >= 0.0)) {
    throw Error(ErrorKind::argument, "the end of the interval lies before its beginning");
  }
  std::vector<Gatherer> gatherers;
  gatherers.reserve(bodies.size());
  for (const SkyBody& body : bodies) {
    gatherers.emplace_back(body, observer.latitude, rule);
  }
  // A day with its leap second is still one stretch: a thousandth more costs no accuracy.
  const auto stretches = static_cast<int>(std::max(1.0, std::ceil(duration_s / (1.001 * seconds_per_day))));
  Stretch stretch;
  stretch.begin = &begin;
  for (int i = 0; i < stretches; ++i) {
    stretch.from_s = duration_s * i / stretches;
    stretch.to_s = duration_s * (i + 1) / stretches;
    for (std::size_t j = 0; j < sample_count; ++j) {
      if (i > 0 && j == 0) { // the same sample on both sides of a border: no event falls between them
        stretch.earth.front() = stretch.earth.back();
        stretch.frames.front() = stretch.frames.back();
        continue;
      }
      const bool is_begin = i == 0 && j == 0;
      const bool is_end = i + 1 == stretches && j + 1 == sample_count;
      stretch.earth.at(j) = earth_state(is_begin ? begin
                                        : is_end ? end
                                                 : later(begin, stretch.seconds_at(SampledFunction::points().at(j))),
                                        observer, tier);
      stretch.frames.at(j) = star_frame(stretch.earth.at(j));
    }
    for (Gatherer& gatherer : gatherers) {
      gatherer.add(stretch);
    }
  }
  std::vector<BodyEvents> results;
  results.reserve(bodies.size());
  for (Gatherer& gatherer : gatherers) {
    results.push_back(std::move(gatherer).result());
  }
  return results;
}

} // namespace vesper
