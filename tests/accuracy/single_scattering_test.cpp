// Light scattered or reflected once against a quadrature made elsewhere and against what is known in closed form.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/single_scattering.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {
namespace {

Vec3 toward(double altitude_deg, double azimuth_deg = 0.0) {
  return test::direction(azimuth_deg * deg, altitude_deg * deg);
}

TEST(SingleScattering, ZenithOfThePublishedMedium) {
  const std::string path = std::string(VESPER_TEST_DATA) + "/atmosphere/sky_zenith_radiance.csv";
  const CsvTable table(read_file(path), path);
  const Medium air = published_medium();
  test::ErrorSum error;
  test::ErrorSum bound;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    const double azimuth = row.number("view_azimuth_from_sun_deg");
    const SkyQuery query{row.number("height_km") * kilometre, toward(row.number("sun_elevation_deg")), 0.0 * deg,
                         toward(row.number("view_elevation_deg"), azimuth)};
    const SingleScattering ours = single_scattering(air, query, {row.number("channel_nm")});
    const double theirs = row.number("order1");
    if (theirs == 0.0) {
      EXPECT_EQ(ours.radiance[0], 0.0) << "line " << table.line(i);
      EXPECT_EQ(ours.error[0], 0.0);
    } else {
      error.add(ours.radiance[0] / theirs - 1.0);
      bound.add(ours.error[0] / ours.radiance[0]);
    }
  }
  error.hold("single scattering at the zenith, relative", 1.0e-5, "");
  bound.hold("own bound of single scattering at the zenith, relative", 1.0e-6, "");
}

/// Steps of equal length along the view ray and, from each, towards the light. For places that are all in the light.
double by_midpoints(const Medium& air, const SkyQuery& query, double nm) {
  constexpr int steps = 3000;
  const double ground = air.ground_radius.to(kilometre);
  const double top = air.top_radius.to(kilometre);
  const auto extinction = [&](const Vec3& place) {
    double sum = 0.0;
    for (const MediumComponent& part : air.components) {
      sum += part.extinction_per_km(nm) * part.profile.at(glm::length(place) - ground);
    }
    return sum;
  };
  const auto far_crossing = [](const Vec3& from, const Vec3& direction, double radius) {
    const double along = glm::dot(from, direction);
    return -along + std::sqrt(along * along - glm::dot(from, from) + radius * radius);
  };
  const auto depth = [&](const Vec3& from, const Vec3& direction, double length) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      sum += extinction(from + length * (i + 0.5) / steps * direction);
    }
    return sum * length / steps;
  };
  const auto depth_to_light = [&](const Vec3& from) {
    return depth(from, query.light_direction, far_crossing(from, query.light_direction, top));
  };
  const Vec3 eye(0.0, 0.0, ground + query.height.to(kilometre));
  const double cos_angle = glm::dot(query.light_direction, query.view_direction);
  const double along = glm::dot(eye, query.view_direction);
  const double perigee2 = glm::dot(eye, eye) - along * along;
  const bool hits = along < 0.0 && perigee2 < ground * ground;
  const double begin = std::max(0.0, -along - std::sqrt(top * top - perigee2));
  const double end =
      hits ? -along - std::sqrt(ground * ground - perigee2) : far_crossing(eye, query.view_direction, top);
  const double step = (end - begin) / steps;
  double radiance = 0.0;
  double passed = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Vec3 place = eye + (begin + (i + 0.5) * step) * query.view_direction;
    const double here = extinction(place) * step;
    double source = 0.0;
    for (const MediumComponent& part : air.components) {
      source += part.scattering_per_km(nm) * part.phase(cos_angle, nm) * part.profile.at(glm::length(place) - ground);
    }
    radiance += source * step * std::exp(-passed - 0.5 * here - depth_to_light(place));
    passed += here;
  }
  if (hits) {
    const Vec3 place = eye + end * query.view_direction;
    radiance += air.ground_albedo(nm) * std::numbers::inv_pi * glm::dot(place, query.light_direction) / ground *
                std::exp(-passed - depth_to_light(place));
  }
  return radiance;
}

TEST(SingleScattering, AgreesWithMidpoints) {
  const Medium air = published_medium();
  test::ErrorSum error;
  const auto add = [&](double height_km, double altitude_deg, double azimuth_deg, double sun_deg) {
    const SkyQuery query{height_km * kilometre, toward(sun_deg), 0.0 * deg, toward(altitude_deg, azimuth_deg)};
    error.add(single_scattering(air, query, {550.0}).radiance[0] / by_midpoints(air, query, 550.0) - 1.0);
  };
  add(0.0, 90.0, 0.0, 90.0);
  add(0.0, 0.0, 30.0, 20.0);
  add(0.0, 20.0, 0.0, 20.0);
  add(10.0, -0.5, 90.0, 30.0);
  add(10.0, -30.0, 180.0, 60.0);
  add(100.0, -9.0, 20.0, 40.0);
  add(100.0, -90.0, 0.0, 5.0);
  add(1000.0, -29.0, 0.0, 60.0);
  add(1000.0, -50.0, 120.0, 40.0);
  error.hold("single scattering against midpoints, relative", 1.0e-4, "");
}

Medium shell(double per_km, double asymmetry, double albedo) {
  const auto always = [](double value) { return [value](double) { return value; }; };
  return {6360.0 * kilometre,
          6460.0 * kilometre,
          always(albedo),
          {{"one",
            HeightProfile::table({0.0, 100.0}, {1.0, 1.0}, HeightProfile::Between::linear),
            always(per_km),
            always(0.0),
            {PhaseKind::henyey_greenstein, always(asymmetry)}}},
          {550.0}};
}

TEST(SingleScattering, EvenAirUnderTheSunInTheZenith) {
  test::ErrorSum error;
  constexpr double deep_km = 100.0;
  for (const double g : {-0.99, -0.5, 0.0, 0.8, 0.99}) {
    for (const double per_km : {1.0e-6, 1.0e-3, 0.03, 0.5}) {
      const Medium air = shell(per_km, g, 0.6);
      const double forward = (1.0 + g) / (4.0 * std::numbers::pi * (1.0 - g) * (1.0 - g));
      const double backward = (1.0 - g) / (4.0 * std::numbers::pi * (1.0 + g) * (1.0 + g));
      const double depth = per_km * deep_km;
      const SkyQuery up{0.0 * kilometre, toward(90.0), 0.0 * deg, Vec3(0.0, 0.0, 1.0)};
      error.add(single_scattering(air, up, {550.0}).radiance[0] / (forward * depth * std::exp(-depth)) - 1.0);
      for (const double height_km : {deep_km, 5000.0}) {
        const SkyQuery down{height_km * kilometre, toward(90.0), 0.0 * deg, Vec3(0.0, 0.0, -1.0)};
        const double expected =
            -backward * 0.5 * std::expm1(-2.0 * depth) + 0.6 * std::numbers::inv_pi * std::exp(-2.0 * depth);
        error.add(single_scattering(air, down, {550.0}).radiance[0] / expected - 1.0);
      }
    }
  }
  error.hold("single scattering of even air in closed form, relative", 1.0e-6, "");
}

} // namespace
} // namespace vesper
