// Light and transmittance on the way to a point, from the tables, against the solved light of the same medium: its
// radiance from the observer less what the spectral transmittance leaves of its radiance from the point.
#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/sky_to_point.hpp"
#include "vesper/atmosphere/spectral_rule.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace vesper {
namespace {

struct Exact {
  Xyzs light;
  Xyzs whole; ///< from the air along the whole ray
  Xyzs transmittance;
  double way_km = 0.0; ///< not behind the air or the ground
};

/// The light field beside the tables that were made from it.
class SolvedAir {
public:
  explicit SolvedAir(const Medium& medium)
      : medium_(medium), air_(medium), rule_(spectral_rule(medium, solar_irradiance_1au(), 8)),
        optics_(medium, rule_.wavelengths_nm), field_(air_, optics_) {
    sun_ = rule_.weights(std::vector<double>(optics_.size(), 1.0));
  }

  [[nodiscard]] Exact operator()(const SkyQuery& query, double distance_km) const {
    const Vec3 eye(0.0, 0.0, air_.ground_km() + query.height.to(kilometre));
    const Vec3& view = query.view_direction;
    const AirRay ray = air_.ray(eye.z, view.z);
    Exact exact;
    exact.way_km = std::min(distance_km, ray.end_km - ray.begin_km);
    const Vec3 point = eye + exact.way_km * view;
    const AirColumns columns = columns_between(medium_, eye, point);
    const LightField::Spectrum near = radiance(eye, query);
    const LightField::Spectrum far = radiance(point, query);
    std::vector<double> light;
    std::vector<double> whole;
    std::vector<double> left;
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      left.push_back(optical_depth(medium_, columns, optics_.wavelengths_nm()[l]).transmittance());
      whole.push_back(static_cast<double>(near.at(l)));
      light.push_back(whole.back() - (exact.way_km < distance_km ? 0.0 : left.back() * static_cast<double>(far.at(l))));
    }
    exact.light = responses(light, {sun_.y, sun_.y, sun_.y, sun_.y});
    exact.whole = responses(whole, {sun_.y, sun_.y, sun_.y, sun_.y});
    exact.transmittance = responses(left, sun_);
    return exact;
  }

private:
  [[nodiscard]] Xyzs responses(const std::vector<double>& spectrum, const Xyzs& unit) const {
    const Xyzs sum = rule_.weights(spectrum);
    return {sum.x / unit.x, sum.y / unit.y, sum.z / unit.z, sum.s / unit.s};
  }

  [[nodiscard]] LightField::Spectrum radiance(const Vec3& place, const SkyQuery& query) const {
    const Vec3 up = glm::normalize(place);
    const Vec3 view = query.view_direction;
    const Vec3 sun = query.light_direction;
    const Vec3 view_level = view - glm::dot(view, up) * up;
    const Vec3 sun_level = sun - glm::dot(sun, up) * up;
    const double level = glm::length(view_level) * glm::length(sun_level);
    const double cos_azimuth = level > 1.0e-9 ? std::clamp(glm::dot(view_level, sun_level) / level, -1.0, 1.0) : 1.0;
    const LightField::RayLight seen =
        field_.light(field_.view_ray(std::max(glm::length(place), air_.ground_km()), glm::dot(view, up)),
                     glm::dot(sun, up), cos_azimuth, query.light_angular_radius);
    LightField::Spectrum sum{};
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      sum.at(l) = seen.single_aerosol.at(l) + seen.other.at(l);
    }
    return sum;
  }

  Medium medium_;
  SampledAir air_;
  SpectralRule rule_;
  SpectralAir optics_;
  LightField field_;
  Xyzs sun_;
};

SkyQuery query(double height_km, double sun_deg, double altitude_deg, double azimuth_deg) {
  return {height_km * kilometre, test::direction(0.0 * deg, sun_deg * deg), mean_light_radius,
          test::direction(azimuth_deg * deg, altitude_deg * deg)};
}

struct Limits {
  double sun_deg;
  double light;    ///< % of the light on the way; 0 where that is too little beside what comes from behind it
  double of_whole; ///< % of the light from the whole ray
};

/// Way by way, since nearby the air's light is a small difference, and far away much is gone.
void hold(const Medium& medium, const std::string& name, const std::vector<Limits>& all_limits,
          double transmittance_limit) {
  const SolvedAir solved(medium);
  const SkyTables tables = make_sky_tables(medium);
  test::ErrorSum passed;
  for (const Limits& limits : all_limits) {
    for (const double distance_km : {0.1, 1.0, 10.0, 50.0, 200.0}) {
      test::ErrorSum light;
      test::ErrorSum of_whole;
      for (const double height_km : {0.01, 2.0, 11.0}) {
        for (const double altitude_deg : {60.0, 10.0, 2.0, 0.0, -2.0, -5.0, -30.0}) {
          for (const double azimuth_deg : {20.0, 100.0, 180.0}) {
            const SkyQuery asked = query(height_km, limits.sun_deg, altitude_deg, azimuth_deg);
            const Exact exact = solved(asked, distance_km);
            const SkyWay found = sky_way(tables, asked, distance_km * kilometre);
            for (const auto channel : {&Xyzs::x, &Xyzs::y, &Xyzs::z, &Xyzs::s}) {
              passed.add(found.transmittance.*channel - exact.transmittance.*channel);
              // Whole rays are held where the tables are.
              if (exact.way_km == distance_km) {
                light.add(100.0 * (found.light.*channel / (exact.light.*channel) - 1.0));
                of_whole.add(100.0 * (found.light.*channel - exact.light.*channel) / (exact.whole.*channel));
              }
            }
          }
        }
      }
      char what[96];
      std::snprintf(what, sizeof what, "%s, Sun at %g degrees, light on %g km", name.c_str(), limits.sun_deg,
                    distance_km);
      if (limits.light > 0.0) {
        light.hold(what, limits.light, "%");
      } else {
        light.print(what, "%");
      }
      of_whole.hold(std::string(what) + " against all of the ray's", limits.of_whole, "%");
    }
  }
  passed.hold(name + ", transmittance of X, Y, Z and S", transmittance_limit, "");
}

TEST(SkyToPoint, PublishedMediumAgainstItsLightField) {
  hold(published_medium(), "published", {{45.0, 12.0, 3.0}, {5.0, 40.0, 6.0}, {-4.0, 0.0, 30.0}}, 0.04);
}

TEST(SkyToPoint, ClearAirAgainstItsLightField) {
  hold(clear_medium(), "clear", {{45.0, 15.0, 2.0}, {5.0, 45.0, 7.0}, {-4.0, 0.0, 25.0}}, 0.04);
}

} // namespace
} // namespace vesper
