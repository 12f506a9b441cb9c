#include "vesper/atmosphere/transmittance.hpp"

#include "vesper/atmosphere/ray_column.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace vesper {
namespace {

AirColumns columns(const Medium& medium, const Vec3& from_km, const Vec3& direction, double length_km) {
  validate_radii(medium);
  const double ground_km = medium.ground_radius.to(kilometre);
  const double top_km = medium.top_radius.to(kilometre);
  AirColumns result;
  result.km.assign(medium.components.size(), 0.0);
  result.error_km = result.km;

  const double along = glm::dot(from_km, direction);
  const double perigee_km = glm::length(glm::cross(from_km, direction));
  const double reach = crossing_km(perigee_km, top_km);
  const RaySpan ray{perigee_km, std::max(along, -reach), std::min(along + length_km, reach)};
  if (!(ray.end_km > ray.begin_km)) {
    return result;
  }
  const double nearest = std::clamp(0.0, ray.begin_km, ray.end_km);
  constexpr double rounding = 1.0e-12;
  if (std::hypot(perigee_km, nearest) < ground_km * (1.0 - rounding)) {
    result.blocked = true;
    return result;
  }
  for (std::size_t i = 0; i < medium.components.size(); ++i) {
    const Integral sum = column(medium.components[i].profile, ray, ground_km);
    result.km[i] = sum.value;
    result.error_km[i] = sum.error;
  }
  return result;
}

} // namespace

AirColumns columns_between(const Medium& medium, const Vec3& from_km, const Vec3& to_km) {
  const double length_km = glm::length(to_km - from_km);
  if (!std::isfinite(length_km) || !std::isfinite(glm::length(from_km))) {
    throw Error(ErrorKind::argument, "a path whose end is not finite", {"", "", "Give finite points"});
  }
  const Vec3 direction = length_km > 0.0 ? (to_km - from_km) / length_km : Vec3(0.0, 0.0, 1.0);
  return columns(medium, from_km, direction, length_km);
}

AirColumns columns_to_space(const Medium& medium, const Vec3& from_km, const Vec3& direction) {
  constexpr double tolerance = 1.0e-9;
  if (!(std::abs(glm::length(direction) - 1.0) <= tolerance) || !std::isfinite(glm::length(from_km))) {
    throw Error(ErrorKind::argument, "a path without a place or a direction",
                {"", "", "Give a finite point and a vector of unit length"});
  }
  return columns(medium, from_km, direction, std::numeric_limits<double>::infinity());
}

double zenith_column_km(const HeightProfile& profile, Length ground_radius, Length top_radius) {
  const Medium alone{ground_radius, top_radius, {}, {{"", profile, {}, {}, {}}}, {}};
  const Vec3 zenith(0.0, 0.0, 1.0);
  return columns_to_space(alone, ground_radius.to(kilometre) * zenith, zenith).km.front();
}

double OpticalDepth::transmittance() const { return std::exp(-value); }

OpticalDepth optical_depth(const Medium& medium, const AirColumns& columns, double wavelength_nm) {
  if (columns.blocked) {
    return {std::numeric_limits<double>::infinity(), 0.0};
  }
  OpticalDepth depth;
  for (std::size_t i = 0; i < medium.components.size(); ++i) {
    const double extinction = medium.components[i].extinction_per_km(wavelength_nm);
    depth.value += extinction * columns.km[i];
    depth.error += extinction * columns.error_km[i];
  }
  return depth;
}

double zenith_extinction_v_mag(const Medium& medium, Length height, const Spectrum& light) {
  const Vec3 zenith(0.0, 0.0, 1.0);
  const AirColumns air = columns_to_space(medium, (medium.ground_radius + height).to(kilometre) * zenith, zenith);
  // Every nanometre of the band, as integrate_v_band takes it.
  std::vector<double> wavelengths;
  std::vector<double> above;
  std::vector<double> below;
  const std::vector<double>& band = v_band().wavelengths_nm();
  const auto steps = static_cast<int>(band.back() - band.front());
  for (int i = 0; i <= steps; ++i) {
    const double nm = band.front() + i;
    wavelengths.push_back(nm);
    above.push_back(light(nm));
    below.push_back(light(nm) * optical_depth(medium, air, nm).transmittance());
  }
  const double outside = integrate_v_band({wavelengths, above});
  if (!(outside > 0.0)) {
    throw Error(ErrorKind::argument, "light without any in V", {"", "", "Give a spectrum that covers 470 to 700 nm"});
  }
  return -2.5 * std::log10(integrate_v_band({wavelengths, below}) / outside);
}

} // namespace vesper
