// New and full Moons by their number, and which of them can be eclipses.
#pragma once

#include "vesper/astro/time.hpp"

namespace vesper {

enum class Syzygy { new_moon, full_moon };

/// Mean new or full Moon number `lunation` since that of January 2000 (Chapront et al. 2002, as printed in Meeus 1998,
/// eq. 49.1); the true one lies within 15 hours from 0 to 4000, within a day from -4712 to 9999.
[[nodiscard]] JulianDate<TT> mean_syzygy(Syzygy phase, int lunation);

/// The lunation whose mean syzygy lies nearest, give or take one in the far past and future.
[[nodiscard]] int nearest_lunation(Syzygy phase, JulianDate<TT> tt);

/// False where the Moon is surely too far from its node for any eclipse: about three of four lunations. By its mean
/// argument of latitude (Meeus 1998, chapter 54: an eclipse needs a sine below 0.36), with some margin for far years.
[[nodiscard]] bool eclipse_possible(Syzygy phase, int lunation);

} // namespace vesper
