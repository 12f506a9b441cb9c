// Illuminance as it was measured: tables of tests/data/atmosphere, and the places that belong to them.
#pragma once

#include "vesper/base/csv.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/moonlight.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace vesper::test {

inline CsvTable atmosphere_table(const std::string& name) {
  const std::string path = std::string(VESPER_TEST_DATA) + "/atmosphere/" + name;
  return {read_file(path), path};
}

/// Where a body stands without air that is seen at an altitude from 0 up: Bennett 1982 (J. Navig. 35, 255, eq. G). Bent
/// rays give a level surface what straight ones from there give it, because what falls on the air above it is the same.
inline double airless_altitude_deg(double apparent_deg) {
  if (apparent_deg < 0.0) {
    return apparent_deg;
  }
  const double argument_deg = apparent_deg + 7.31 / (apparent_deg + 4.4);
  return apparent_deg - 1.0 / (60.0 * std::tan(argument_deg * std::numbers::pi / 180.0));
}

/// The full Moon of these tables, whose law of phases has no opposition surge (Janiczek and DeYoung 1987).
inline Spectrum full_moon_without_surge() {
  return scaled(moon_irradiance(0.0 * deg, moon_mean_distance, astronomical_unit),
                std::pow(10.0, -0.4 * f64::lunar_surge_mag(0.0)));
}

} // namespace vesper::test
