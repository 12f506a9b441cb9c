#pragma once

#include "vesper/astro/time.hpp"

namespace vesper {

/// TT - UT1 in seconds.
///
/// - 1973-02 to 2026-10: monthly values of the IERS Rapid Service, linear between (about 0.002 s).
/// - Before, from -720: cubic splines of Morrison, Stephenson, Hohenkerk and Zawilski 2021 (Proc. R. Soc. A 477,
///   20200776, table S15), a smoothing good to about 0.4 s after 1800; the last piece is led to the first monthly
///   value.
/// - Outside both: the long-term length of day of the same paper (1.72 t - 3.5 sin(2 pi (t + 0.75) / 14) ms, t in
///   centuries since 1825), integrated and joined to the neighbour; in 2050 about 71.6 s, uncertain by seconds.
[[nodiscard]] double delta_t_s(JulianDate<TT> tt);

/// Standard error of `delta_t_s` in seconds: the estimates that accompany the same paper, from 1080 s in -2000 over 0.1
/// s about 1831 to 100 s in 2500, linear between its years; outside growing with the square of the time from 1825. The
/// monthly values are good to 0.01 s, and for some decades after them the estimate of Huber 2000 (0.36525 t
/// sqrt(0.058 t / 3 (1 + t / 2500)) s after t years) is smaller and taken.
[[nodiscard]] double delta_t_uncertainty_s(JulianDate<TT> tt);

} // namespace vesper
