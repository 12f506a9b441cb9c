// What the searches for eclipses of the Sun and of the Moon share.
#pragma once

#include "vesper/astro/crossings.hpp"
#include "vesper/astro/syzygy.hpp"

#include <utility>
#include <vector>

namespace vesper {

/// Seconds since `origin` at which a shadow passes nearest to a body, within a day of the mean syzygy.
/// \param squared_distance of the two, a function of these seconds
template <class Function>
[[nodiscard]] double nearest_pass(Function&& squared_distance, Syzygy phase, int lunation, JulianDate<TT> origin) {
  constexpr double first_step_s = 6.0 * 3600.0;
  constexpr double last_step_s = 120.0;
  const double guess_s = mean_syzygy(phase, lunation).days_since(origin) * seconds_per_day;
  return minimum_near(squared_distance, guess_s, first_step_s, last_step_s);
}

/// The eclipses whose `greatest` lies in [from, to), in order. Throws Error(argument) for a span beyond the supported
/// one. \param eclipse_of gives that of a lunation, of type `none` where there is none, near an instant in it
template <class Function>
[[nodiscard]] auto eclipses_between(const Instant& from, const Instant& to, Syzygy phase, Function&& eclipse_of) {
  require_supported(from.tt);
  require_supported(to.tt);
  using Eclipse = decltype(eclipse_of(from, 0));
  std::vector<Eclipse> found;
  for (const int lunation : eclipse_lunations(phase, from.tt, to.tt)) {
    Eclipse eclipse = eclipse_of(instant_from_tt(mean_syzygy(phase, lunation)), lunation);
    const JulianDate<TT> greatest = eclipse.greatest.tt;
    const bool in_span = greatest.days_since(from.tt) >= 0.0 && greatest.days_since(to.tt) < 0.0;
    if (in_span && eclipse.type != decltype(eclipse.type)::none) {
      found.push_back(std::move(eclipse));
    }
  }
  return found;
}

} // namespace vesper
