#include "vesper/sky/corona_streamers.hpp"

#include "vesper/base/error.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace vesper {
namespace {

/// Mean of exp(sharpness (cos angle - 1)) over all angles. The rule of equal steps is exact here to rounding.
double mean_height(double sharpness) {
  constexpr int steps = 128;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    sum += std::exp(sharpness * (std::cos(2.0 * std::numbers::pi * i / steps) - 1.0));
  }
  return sum / steps;
}

} // namespace

std::array<f64::vec4, f64::sun_streamers> corona_streamers(double activity, std::uint32_t seed) {
  if (!(activity >= 0.0 && activity <= 1.0)) {
    throw Error(ErrorKind::argument, "an activity of the Sun of " + std::to_string(activity), {"", "", "Give 0 to 1"});
  }
  constexpr double share = 0.6;
  constexpr int on_a_side = f64::sun_streamers / 2;
  std::array<f64::vec4, f64::sun_streamers> streamers{};
  double sum = 0.0;
  for (std::uint32_t k = 0; k < streamers.size(); ++k) {
    const auto chance = [&](std::uint32_t which) {
      return f64::hash_unit(f64::hash_pair(f64::hash_pair(seed, k), which));
    };
    const double middle = k < on_a_side ? 0.0 : std::numbers::pi; // the equator, in the plane of the disc's places
    const double spread = (10.0 + 80.0 * activity) * std::numbers::pi / 180.0;
    // Each in its part of the range, so that they do not crowd.
    const double angle = middle + spread * (2.0 * (k % on_a_side + chance(0)) / on_a_side - 1.0);
    const double sharpness = 4.0 + 16.0 * chance(1);
    const double strength = 0.5 + chance(2);
    const double foot = strength / mean_height(sharpness) * std::exp(-sharpness);
    streamers.at(k) = {sharpness * std::cos(angle), sharpness * std::sin(angle), foot, strength};
    sum += strength;
  }
  for (f64::vec4& streamer : streamers) {
    streamer.z *= share / sum;
    streamer.w *= share / sum;
  }
  return streamers;
}

} // namespace vesper
