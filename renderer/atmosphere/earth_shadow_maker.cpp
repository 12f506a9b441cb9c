#include "vesper/astro/constants.hpp"
#include "vesper/atmosphere/earth_shadow_light.hpp"
#include "vesper/atmosphere/earth_shadow_solver.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vesper {
namespace {

// Places of the Moon's surface, with some to spare.
constexpr double nearest_km = 354000.0;
constexpr double farthest_km = 410000.0;
constexpr int inner = 80;
constexpr int outer = 64;

/// Every 20 nm, as far as the medium is known; beyond, its light is that of the ends.
std::vector<double> map_wavelengths_nm(const Medium& medium) {
  if (medium.wavelengths_nm.empty()) {
    throw Error(ErrorKind::argument, "a medium without wavelengths", {"", "", "Give it one at least"});
  }
  constexpr int first_nm = 400;
  constexpr int last_nm = 720;
  const double first = std::clamp<double>(medium.wavelengths_nm.front(), first_nm, last_nm);
  const double last = std::clamp<double>(medium.wavelengths_nm.back(), first_nm, last_nm);
  std::vector<double> wavelengths{first};
  for (int nm = first_nm; nm <= last_nm; nm += 20) {
    if (nm > first && nm < last) {
      wavelengths.push_back(nm);
    }
  }
  if (last > first) {
    wavelengths.push_back(last);
  }
  return wavelengths;
}

} // namespace

EarthShadowLight make_earth_shadow_light(const Medium& medium) {
  EarthShadowLight light;
  constexpr std::size_t rows = EarthShadowLight::rows;
  light.frame = {inner,
                 outer,
                 static_cast<int>(rows),
                 nearest_km,
                 static_cast<double>(rows - 1) / (farthest_km - nearest_km),
                 f64::earth_radius_km + 65.0,
                 f64::earth_radius_km + 120.0,
                 250.0};
  light.wavelengths_nm = map_wavelengths_nm(medium);
  light.nearest_sun_au = 0.982;
  light.farthest_sun_au = 1.018;
  light.log_shares.resize(light.size());

  const EarthShadowSolver solver(medium, light.wavelengths_nm, {earth_shadow_loads.begin(), earth_shadow_loads.end()});
  const std::size_t count = light.wavelengths_nm.size();
  const std::size_t places = light.columns() * rows * EarthShadowLight::suns;
  for (std::size_t place = 0; place < places; ++place) {
    const auto column = static_cast<double>(place % light.columns());
    const auto row = static_cast<double>(place / light.columns() % rows);
    const Length sun = (place < places / 2 ? light.nearest_sun_au : light.farthest_sun_au) * astronomical_unit;
    const f64::EarthShadow shadow{Vec3(0.0, 0.0, 1.0), sun.to(kilometre), sun_radius.to(kilometre), 0.0};
    const double along_km = nearest_km + row / light.frame.rows_per_km;
    const Vec2 place_km(f64::lunar_eclipse_axis_distance_km(column, along_km, shadow, light.frame), along_km);
    const std::vector<double> shares = solver.shares(place_km, sun);
    for (std::size_t load = 0; load < earth_shadow_loads.size(); ++load) {
      for (std::size_t i = 0; i < count; ++i) {
        const double depth = -std::log(shares[load * count + i]) * EarthShadowLight::logs_per_unit;
        light.log_shares[(load * places + place) * count + i] =
            static_cast<std::uint16_t>(std::lround(std::clamp(depth, 0.0, 65535.0)));
      }
    }
  }
  return light;
}

} // namespace vesper
