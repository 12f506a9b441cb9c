#include "vesper/astro/delta_t.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vesper {
namespace {

constexpr auto observed_s = std::to_array<double>({
#include "vesper/astro/delta_t_observed.inl"
});
constexpr double observed_begin_jd = 2441714.5; // 1973-02-01
constexpr double days_per_month = 365.2425 / 12.0;

/// Julian date of 0h on the first day of a month, counted from February 1973.
double month_jd(int months) {
  const int since_january = months + 1;
  return midnight_jd({1973 + since_january / 12, since_january % 12 + 1, 1}, Calendar::gregorian);
}

double observed_end_jd() {
  static const double jd = month_jd(static_cast<int>(observed_s.size()) - 1);
  return jd;
}

bool is_observed(double jd) { return jd >= observed_begin_jd && jd <= observed_end_jd(); }

double observed(double jd) {
  const int last_interval = static_cast<int>(observed_s.size()) - 2;
  int i = std::clamp(static_cast<int>((jd - observed_begin_jd) / days_per_month), 0, last_interval);
  if (i > 0 && month_jd(i) > jd) {
    --i;
  } else if (i < last_interval && month_jd(i + 1) <= jd) {
    ++i;
  }
  const auto index = static_cast<std::size_t>(i);
  return std::lerp(observed_s.at(index), observed_s.at(index + 1),
                   (jd - month_jd(i)) / (month_jd(i + 1) - month_jd(i)));
}

/// a0 + a1 t + a2 t^2 + a3 t^3 with t from 0 to 1 between two years.
struct Spline {
  double year0, year1, a0, a1, a2, a3;
};
constexpr std::array splines{
    // Morrison et al. 2021, table S15 (version 2020), up to the observed values.
    Spline{-720, -100, 20371.848, -9999.586, 776.247, 409.160},
    Spline{-100, 400, 11557.668, -5822.270, 1303.151, -503.433},
    Spline{400, 1000, 6535.116, -5671.519, -298.291, 1085.087},
    Spline{1000, 1150, 1650.393, -753.210, 184.811, -25.346},
    Spline{1150, 1300, 1056.647, -459.628, 108.771, -24.641},
    Spline{1300, 1500, 681.149, -421.345, 61.953, -29.414},
    Spline{1500, 1600, 292.343, -192.841, -6.572, 16.197},
    Spline{1600, 1650, 109.127, -78.697, 10.505, 3.018},
    Spline{1650, 1720, 43.952, -68.089, 38.333, -2.127},
    Spline{1720, 1800, 12.068, 2.507, 41.731, -37.939},
    Spline{1800, 1810, 18.367, -3.481, -1.126, 1.918},
    Spline{1810, 1820, 15.678, 0.021, 4.629, -3.812},
    Spline{1820, 1830, 16.516, -2.157, -6.806, 3.250},
    Spline{1830, 1840, 10.804, -6.018, 2.944, -0.096},
    Spline{1840, 1850, 7.634, -0.416, 2.658, -0.539},
    Spline{1850, 1855, 9.338, 1.642, 0.261, -0.883},
    Spline{1855, 1860, 10.357, -0.486, -2.389, 1.558},
    Spline{1860, 1865, 9.040, -0.591, 2.284, -2.477},
    Spline{1865, 1870, 8.255, -3.456, -5.148, 2.720},
    Spline{1870, 1875, 2.371, -5.593, 3.011, -0.914},
    Spline{1875, 1880, -1.126, -2.314, 0.269, -0.039},
    Spline{1880, 1885, -3.210, -1.893, 0.152, 0.563},
    Spline{1885, 1890, -4.388, 0.101, 1.842, -1.438},
    Spline{1890, 1895, -3.884, -0.531, -2.474, 1.871},
    Spline{1895, 1900, -5.017, 0.134, 3.138, -0.232},
    Spline{1900, 1905, -1.977, 5.715, 2.443, -1.257},
    Spline{1905, 1910, 4.923, 6.828, -1.329, 0.720},
    Spline{1910, 1915, 11.142, 6.330, 0.831, -0.825},
    Spline{1915, 1920, 17.479, 5.518, -1.643, 0.262},
    Spline{1920, 1925, 21.617, 3.020, -0.856, 0.008},
    Spline{1925, 1930, 23.789, 1.333, -0.831, 0.127},
    Spline{1930, 1935, 24.418, 0.052, -0.449, 0.142},
    Spline{1935, 1940, 24.164, -0.419, -0.022, 0.702},
    Spline{1940, 1945, 24.426, 1.645, 2.086, -1.106},
    Spline{1945, 1950, 27.050, 2.499, -1.232, 0.614},
    Spline{1950, 1953, 28.932, 1.127, 0.220, -0.277},
    Spline{1953, 1956, 30.002, 0.737, -0.610, 0.631},
    Spline{1956, 1959, 30.760, 1.409, 1.282, -0.799},
    Spline{1959, 1962, 32.652, 1.577, -1.115, 0.507},
    Spline{1962, 1965, 33.621, 0.868, 0.406, 0.199},
    Spline{1965, 1968, 35.093, 2.275, 1.002, -0.414},
    Spline{1968, 1971, 37.956, 3.035, -0.242, 0.202},
    Spline{1971, 1974, 40.951, 3.157, 0.364, -0.229},
};

double evaluate(const Spline& s, double year) {
  const double t = (year - s.year0) / (s.year1 - s.year0);
  return s.a0 + t * (s.a1 + t * (s.a2 + t * s.a3));
}

/// The paper's years are Julian years that agree with the calendar's at year 0.
double year_of(double jd) { return (jd - 1721045.0) / days_per_julian_year; }

double historic(double year) {
  const auto* const after = std::upper_bound(splines.begin(), splines.end(), year,
                                             [](double y, const Spline& spline) { return y < spline.year0; });
  const Spline& spline = *(after == splines.begin() ? after : after - 1);
  double value = evaluate(spline, year);
  if (&spline == &splines.back()) {
    static const double observed_begin_year = year_of(observed_begin_jd);
    static const double gap = observed_s.front() - evaluate(splines.back(), observed_begin_year);
    value += gap * (year - spline.year0) / (observed_begin_year - spline.year0);
  }
  return value;
}

/// The integral of the long-term excess length of day, up to a constant.
double long_term(double year) {
  constexpr double linear_ms = 1.72;
  constexpr double periodic_ms = 3.5;
  constexpr double period_cy = 14.0;
  constexpr double phase_cy = 0.75;
  constexpr double s_per_ms_day = days_per_julian_century / 1000.0; // seconds that 1 ms a day adds up to in a century
  const double t = (year - 1825.0) / 100.0;
  const double frequency = 2.0 * std::numbers::pi / period_cy;
  return s_per_ms_day * (0.5 * linear_ms * t * t + periodic_ms / frequency * std::cos(frequency * (t + phase_cy)));
}

struct Uncertainty {
  double year, seconds;
};
// HM Nautical Almanac Office, the error estimates beside table S15 (2020).
constexpr std::array uncertainties{
    Uncertainty{-2000, 1080}, Uncertainty{-1600, 720}, Uncertainty{-900, 360}, Uncertainty{-720, 180},
    Uncertainty{-700, 170},   Uncertainty{-600, 160},  Uncertainty{-500, 150}, Uncertainty{-400, 130},
    Uncertainty{-300, 120},   Uncertainty{-200, 110},  Uncertainty{-100, 100}, Uncertainty{0, 90},
    Uncertainty{100, 80},     Uncertainty{200, 70},    Uncertainty{300, 60},   Uncertainty{400, 50},
    Uncertainty{500, 40},     Uncertainty{700, 30},    Uncertainty{800, 25},   Uncertainty{900, 20},
    Uncertainty{1000, 15},    Uncertainty{1620, 20},   Uncertainty{1660, 15},  Uncertainty{1670, 10},
    Uncertainty{1680, 5},     Uncertainty{1730, 2},    Uncertainty{1770, 1},   Uncertainty{1800, 0.5},
    Uncertainty{1802, 0.4},   Uncertainty{1805, 0.3},  Uncertainty{1809, 0.2}, Uncertainty{1831, 0.1},
    Uncertainty{1870, 0.05},  Uncertainty{2022, 0.1},  Uncertainty{2023, 1},   Uncertainty{2030, 2},
    Uncertainty{2040, 4},     Uncertainty{2050, 6},    Uncertainty{2100, 10},  Uncertainty{2200, 20},
    Uncertainty{2300, 30},    Uncertainty{2400, 50},   Uncertainty{2500, 100},
};

} // namespace

double delta_t_uncertainty_s(JulianDate<TT> tt) {
  constexpr double observed_error_s = 0.01;
  const double jd = tt.value();
  if (is_observed(jd)) {
    return observed_error_s;
  }
  const double year = year_of(jd);
  // Huber 2000 (Brownian motion of the length of day), for predictions of some decades.
  const double lead_years = year - year_of(observed_end_jd());
  const double huber_s =
      0.36525 * lead_years * std::sqrt(std::max(lead_years, 0.0) * 0.058 / 3.0 * (1.0 + lead_years / 2500.0));
  const auto grown = [year](const Uncertainty& from) {
    const double ratio = (year - 1825.0) / (from.year - 1825.0);
    return from.seconds * ratio * ratio;
  };
  if (year <= uncertainties.front().year) {
    return grown(uncertainties.front());
  }
  if (year >= uncertainties.back().year) {
    return grown(uncertainties.back());
  }
  const auto* const after = std::upper_bound(uncertainties.begin(), uncertainties.end(), year,
                                             [](double y, const Uncertainty& u) { return y < u.year; });
  const auto* const before = after - 1;
  const double published =
      std::lerp(before->seconds, after->seconds, (year - before->year) / (after->year - before->year));
  return lead_years > 0.0 ? std::min(published, observed_error_s + huber_s) : published;
}

double delta_t_s(JulianDate<TT> tt) {
  const double jd = tt.value();
  if (is_observed(jd)) {
    return observed(jd);
  }
  const double year = year_of(jd);
  if (jd > observed_end_jd()) {
    return observed_s.back() + long_term(year) - long_term(year_of(observed_end_jd()));
  }
  if (year < splines.front().year0) {
    return splines.front().a0 + long_term(year) - long_term(splines.front().year0);
  }
  return historic(year);
}

} // namespace vesper
