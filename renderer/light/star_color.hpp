// From the colour index B-V of a star to its light.
#pragma once

#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// The range of B-V over which colours change: from stars bluer than any to carbon stars. Values beyond an end have the
/// colour of that end.
inline constexpr double min_star_b_v = -0.4;
inline constexpr double max_star_b_v = 6.0;

/// Colour temperature in K of a star of colour index B-V (Ballesteros 2012, EPL 97, 34008, eq. 14), 21 707 K to 1 386 K
/// over the range above. Throws Error(argument) unless B-V is finite.
[[nodiscard]] double star_temperature_k(double b_v);

/// The light of a star above the atmosphere for an illuminance of 1 lux (y = 1), from a black body of its colour
/// temperature. Against the solar spectrum ASTM E-490 (B-V = 0.65) it is right within 0.004 in CIE x, y; molecular
/// bands of cool stars and the Balmer jump of A stars are not in it. From a table of steps of 0.01 in B-V, linear
/// between. Throws Error(argument) unless B-V is finite.
[[nodiscard]] Xyzs star_color(double b_v);

/// Lux per V-band flux relative to an A0 star (B-V = 0): 0.990 at -0.4, 1.023 at 0.65, 1.042 at 1.1, 1.071 at 1.7. From
/// the same table. Throws Error(argument) unless B-V is finite.
[[nodiscard]] double star_lux_ratio(double b_v);

} // namespace vesper
