#include "vesper/atmosphere/city_glow.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr double lamp_nm = 550.0;
constexpr double depth_step_km = 0.25;
constexpr double glowing_top_km = 50.0; ///< higher air scatters nothing that shows
constexpr double city_radius_km = 2.0;
constexpr double longest_view_km = 400.0;

/// Garstang's upward light in a direction, to a scale: 0.554 makes the whole of the second term F, as 2 does that of
/// the first G (1 - F).
double upward_light(double sin_elevation) {
  constexpr double reflectance = 0.15;
  constexpr double upward_share = 0.15;
  const double from_zenith = std::acos(std::clamp(sin_elevation, 0.0, 1.0));
  return 2.0 * reflectance * (1.0 - upward_share) * sin_elevation + 0.554 * upward_share * std::pow(from_zenith, 4);
}

} // namespace

void validate(const CityGlow& glow) {
  const double luminance = glow.zenith.to(candela_per_m2);
  const double distance_km = glow.distance.to(kilometre);
  if (!(luminance >= 0.0) || !std::isfinite(luminance)) {
    throw Error(ErrorKind::argument, "a sky glow of " + std::to_string(luminance) + " cd/m2",
                {"", "", "Give 0 or more"});
  }
  if (!(distance_km >= nearest_city_km && distance_km <= farthest_city_km)) {
    throw Error(ErrorKind::argument, "a city " + std::to_string(distance_km) + " km away",
                {"", "", "Give 1 to 300 km"});
  }
  if (glow.azimuth && !std::isfinite(glow.azimuth->to(deg))) {
    throw Error(ErrorKind::argument, "a city's azimuth that is no number", {"", "", "Give degrees"});
  }
}

CityGlowPattern::CityGlowPattern(const Medium& medium, Length height, Length distance)
    : height_km_(std::max(height.to(kilometre), 0.0)), distance_km_(distance.to(kilometre)),
      radius_km_(medium.ground_radius.to(kilometre)) {
  for (const MediumComponent& part : medium.components) {
    air_.push_back({part.scattering_per_km(lamp_nm), part.extinction_per_km(lamp_nm), part.phase.kind,
                    part.phase.parameter(lamp_nm), part.profile});
  }
  double depth = 0.0;
  constexpr auto steps = static_cast<int>(glowing_top_km / depth_step_km);
  for (int i = 0; i <= steps; ++i) {
    const double low = i * depth_step_km;
    depths_.push_back(depth);
    for (const Air& part : air_) {
      depth += depth_step_km * part.extinction_per_km * part.profile.at(low + 0.5 * depth_step_km);
    }
  }
  zenith_ = scattered(1.0, 0.0);
}

double CityGlowPattern::depth_below(double height_km) const {
  const double place = std::clamp(height_km / depth_step_km, 0.0, static_cast<double>(depths_.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(place), depths_.size() - 2);
  return depths_[i] + (place - static_cast<double>(i)) * (depths_[i + 1] - depths_[i]);
}

double CityGlowPattern::scattered(double sin_altitude, double cos_azimuth) const {
  if (!(sin_altitude >= 0.0) || height_km_ >= glowing_top_km) {
    return 0.0;
  }
  static const std::vector<QuadratureNode> rule = gauss_legendre(48);
  const double cos_altitude = std::sqrt((1.0 - sin_altitude) * (1.0 + sin_altitude));
  const Vec3 view(cos_altitude * cos_azimuth,
                  cos_altitude * std::sqrt(std::max(0.0, (1.0 - cos_azimuth) * (1.0 + cos_azimuth))), sin_altitude);
  const double own_depth = depth_below(height_km_);
  // To where the air ends: with s the way, s sin(a) + s^2 cos^2(a) / (2 R) = what is left of the height.
  const double left_km = glowing_top_km - height_km_;
  const double bend = cos_altitude * cos_altitude / (2.0 * radius_km_);
  const double end_km = std::min(
      2.0 * left_km / (sin_altitude + std::sqrt(sin_altitude * sin_altitude + 4.0 * bend * left_km)), longest_view_km);
  double sum = 0.0;
  for (const QuadratureNode& node : rule) {
    const double way = end_km * node.place * node.place;
    const Vec3 place = way * view;
    const double rise_km = way * sin_altitude + bend * way * way;
    const double height_km = height_km_ + rise_km;
    const Vec3 from_city(place.x - distance_km_, place.y, height_km);
    const double from_city_km = std::sqrt(glm::dot(from_city, from_city) + city_radius_km * city_radius_km);
    const double up = std::max(height_km, 1.0e-3);
    const double depth = depth_below(height_km);
    const double slant = depth * from_city_km / up +
                         (rise_km > 1.0e-6 ? (depth - own_depth) * way / rise_km : depth_below(1.0e-3) * 1.0e3 * way);
    const double cos_angle = -glm::dot(from_city, view) / from_city_km;
    double source = 0.0;
    for (const Air& part : air_) {
      source +=
          part.scattering_per_km * part.profile.at(height_km) * phase_function(part.kind, cos_angle, part.parameter);
    }
    sum += 2.0 * end_km * node.place * node.weight * source * std::exp(-slant) *
           upward_light(height_km / from_city_km) / (from_city_km * from_city_km);
  }
  return sum;
}

double CityGlowPattern::toward(double sin_altitude, Angle azimuth) const {
  return zenith_ > 0.0 ? scattered(sin_altitude, std::cos(azimuth.to(rad))) / zenith_ : 0.0;
}

double CityGlowPattern::around(double sin_altitude) const {
  constexpr int azimuths = 24;
  double sum = 0.0;
  for (int k = 0; k < azimuths; ++k) {
    sum += toward(sin_altitude, pi * (k + 0.5) / azimuths * rad);
  }
  return sum / azimuths;
}

} // namespace vesper
