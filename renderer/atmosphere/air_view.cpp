#include "vesper/atmosphere/air_view.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

double altitude_of(const Vec3& direction, const Vec3& up) {
  const double rise = glm::dot(direction, up);
  return std::atan2(rise, glm::length(direction - rise * up));
}

} // namespace

std::optional<AirView> view_in_air(const SkyQuery& query, double ground_km, double top_km) {
  validate(query);
  const Vec3& view = query.view_direction;
  const Vec3& light = query.light_direction;
  const double observer_km = query.height.to(kilometre);
  Vec3 place{0.0, 0.0, ground_km + observer_km};
  double height = observer_km;
  double distance = 0.0;
  if (place.z > top_km) {
    const double along = place.z * view.z;
    const double outside = (place.z - top_km) * (place.z + top_km);
    const double under_root = along * along - outside;
    if (along >= 0.0 || under_root <= 0.0) {
      return std::nullopt;
    }
    distance = outside / (std::sqrt(under_root) - along);
    place += view * distance;
    height = top_km - ground_km;
  }
  const Vec3 up = glm::normalize(place);
  const Vec3 view_level = view - glm::dot(view, up) * up;
  const Vec3 light_level = light - glm::dot(light, up) * up;
  const double level = glm::length(view_level) * glm::length(light_level);
  AirView result{height,  altitude_of(view, up), altitude_of(light, up), 1.0, glm::dot(view, light), false, 0.0,
                 distance};
  if (level > 1.0e-9) {
    result.cos_azimuth = std::clamp(glm::dot(view_level, light_level) / level, -1.0, 1.0);
  }
  const double over_ground = height * (2.0 * ground_km + height);
  const double rise = glm::dot(place, view);
  result.meets_ground = rise < 0.0 && rise * rise > over_ground;
  if (result.meets_ground) {
    const double length_km = over_ground / (std::sqrt(rise * rise - over_ground) - rise);
    result.ground_light_rad = altitude_of(light, glm::normalize(place + view * length_km));
  }
  return result;
}

} // namespace vesper
