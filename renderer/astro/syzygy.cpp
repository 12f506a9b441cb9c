#include "vesper/astro/syzygy.hpp"

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

constexpr JulianDate<TT> mean_new_moon_2000{2451550.0, 0.09766};
constexpr double synodic_month_days = 29.530588861;
constexpr double lunations_per_century = 1236.85;

/// Lunations since the epoch; full Moons stand at halves.
double number_of(Syzygy phase, int lunation) { return phase == Syzygy::full_moon ? lunation + 0.5 : lunation; }

/// False where the Moon is surely too far from its node: about three of four lunations.
bool eclipse_possible(Syzygy phase, int lunation) {
  constexpr double largest_sine = 0.40;
  const double k = number_of(phase, lunation);
  const double t = k / lunations_per_century;
  const double latitude_argument_deg = 160.7108 + 390.67050284 * k - t * t * (0.0016118 + t * 0.00000227);
  return std::abs(std::sin(latitude_argument_deg * std::numbers::pi / 180.0)) < largest_sine;
}

} // namespace

JulianDate<TT> mean_syzygy(Syzygy phase, int lunation) {
  const double k = number_of(phase, lunation);
  const double t = k / lunations_per_century;
  return mean_new_moon_2000.plus_days(synodic_month_days * k +
                                      t * t * (0.00015437 + t * (-0.000000150 + t * 0.00000000073)));
}

int nearest_lunation(Syzygy phase, JulianDate<TT> tt) {
  const double lunations = tt.days_since(mean_new_moon_2000) / synodic_month_days;
  return static_cast<int>(std::lround(lunations - number_of(phase, 0)));
}

std::vector<int> eclipse_lunations(Syzygy phase, JulianDate<TT> from, JulianDate<TT> to) {
  std::vector<int> lunations;
  constexpr int margin = 2;
  const int last = nearest_lunation(phase, to) + margin;
  for (int lunation = nearest_lunation(phase, from) - margin; lunation <= last; ++lunation) {
    if (eclipse_possible(phase, lunation)) {
      lunations.push_back(lunation);
    }
  }
  return lunations;
}

} // namespace vesper
