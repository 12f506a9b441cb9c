// New and full Moons by their number, and which of them can be eclipses.
#pragma once

#include "vesper/astro/time.hpp"

#include <vector>

namespace vesper {

enum class Syzygy { new_moon, full_moon };

/// Mean new or full Moon number `lunation` since that of January 2000 (Chapront et al. 2002, as printed in Meeus 1998,
/// eq. 49.1); the true one lies within 15 hours from 0 to 4000, within a day from -4712 to 9999.
[[nodiscard]] JulianDate<TT> mean_syzygy(Syzygy phase, int lunation);

/// The lunation whose mean syzygy lies nearest, give or take one in the far past and future.
[[nodiscard]] int nearest_lunation(Syzygy phase, JulianDate<TT> tt);

/// The lunations about a span of time that may bring an eclipse, some beyond either end: those whose mean argument of
/// latitude puts the Moon near a node (Meeus 1998, chapter 54: a sine below 0.36; 0.40 here, for far years).
[[nodiscard]] std::vector<int> eclipse_lunations(Syzygy phase, JulianDate<TT> from, JulianDate<TT> to);

} // namespace vesper
