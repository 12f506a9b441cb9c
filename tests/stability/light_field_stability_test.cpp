// The light field where methods fail.
#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/error.hpp"

#include "support/media.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace vesper {
namespace {

constexpr LightFieldSize small_field{10, 10, 4, 10, 4, 0.3, 1.0, 0.1, 4};

void expect_possible_everywhere(const Medium& medium, const std::string& name) {
  const std::vector<double> wavelengths{440.0, 550.0, 680.0};
  const SampledAir air(medium);
  const SpectralAir optics(medium, wavelengths);
  const LightField field(air, optics, small_field);
  for (const double height : {0.0, 1.0e-9, 0.5, 20.0, 99.999, 100.0, 130.0, 40000.0}) {
    for (const double light : {90.0, 45.0, 0.0, -1.0e-9, -0.2, -5.0, -30.0, -90.0}) {
      for (const double view : {90.0, 30.0, 0.0, -1.0e-9, -0.5, -10.0, -90.0}) {
        for (const double azimuth : {0.0, 90.0, 180.0}) {
          const SkyQuery query{height * kilometre, test::toward(0.0, light), 0.2666 * deg, test::toward(azimuth, view)};
          for (const double radiance : field.radiance(query)) {
            EXPECT_TRUE(std::isfinite(radiance) && radiance >= 0.0)
                << name << ", height " << height << " km, light " << light << ", view " << view << ": " << radiance;
          }
        }
      }
      for (const double irradiance : field.diffuse_irradiance(test::toward(0.0, light).z)) {
        EXPECT_TRUE(std::isfinite(irradiance) && irradiance >= 0.0) << name;
      }
    }
  }
}

TEST(LightFieldStability, BothPresets) {
  expect_possible_everywhere(published_medium(), "published");
  expect_possible_everywhere(clear_medium(), "clear");
}

TEST(LightFieldStability, AsymmetriesFromMinus099To099) {
  for (const double g : {-0.99, 0.0, 0.99}) {
    Medium medium = published_medium();
    medium.components[1].phase = {PhaseKind::henyey_greenstein, [g](double) { return g; }};
    expect_possible_everywhere(medium, "g = " + std::to_string(g));
  }
}

TEST(LightFieldStability, NoAirAndAHundredTimesTheAir) {
  expect_possible_everywhere(test::scaled(published_medium(), 0.0), "no air");
  expect_possible_everywhere(test::scaled(published_medium(), 100.0), "a hundredfold");
}

TEST(LightFieldStability, AlbedoZeroAndOne) {
  for (const double albedo : {0.0, 1.0}) {
    Medium medium = published_medium();
    medium.ground_albedo = [albedo](double) { return albedo; };
    expect_possible_everywhere(medium, "albedo " + std::to_string(albedo));
  }
}

f64::LightStep in_double(const f32::LightStep& step) {
  return {step.from_vertical, step.from_level,   step.view_z,      step.height_km,
          step.height_place,  step.zenith_place, step.depth_place, step.unused};
}

std::vector<f64::Light> in_double(const std::vector<Lanes>& lights) {
  std::vector<f64::Light> result;
  result.reserve(lights.size());
  for (const Lanes& light : lights) {
    result.emplace_back(light[0], light[1], light[2], light[3]);
  }
  return result;
}

TEST(LightFieldStability, SinglePrecisionAgainstDouble) {
  const SampledAir air(clear_medium());
  const SpectralAir optics(clear_medium(), {440.0, 500.0, 550.0, 680.0});
  const LightFieldModel model(air, optics, small_field, 0);
  ThreadedLightGatherer gatherer(model, 0);
  const LightFieldTables tables = solve_light_field(model, gatherer, 0).tables;
  const std::vector<f64::Light> field = in_double(tables.field);
  const std::vector<f64::Light> sources = in_double(tables.sources);
  const std::vector<f64::Light> depths = in_double(model.depths());
  const std::vector<double> places(model.angle_places().begin(), model.angle_places().end());
  const f32::LightShell shell = model.shell();
  const f64::LightShell shell64{shell.ground_km, shell.top_km, shell.angles};
  const f64::Light moment64 = in_double(model.second_moment())[0];
  constexpr float radius_rad = LightFieldModel::light_radius_rad;
  test::ErrorSum scattered;
  test::ErrorSum direct;
  for (const double height_km : {0.0, 1.0e-3, 2.0, 50.0, 400.0}) {
    for (const double cos_zenith : {1.0, 0.3, 1.0e-6, 0.0, -1.0e-6, -0.3, -1.0}) {
      const LightRay ray = model.ray(air.ground_km() + height_km, cos_zenith, 0.15, 0.3);
      for (const double sun : {90.0, 30.0, 0.2, 0.0, -1.0, -8.0, -18.0, -89.9}) {
        for (const double cos_azimuth : {1.0, 0.0, -1.0}) {
          const f32::LightPlace light = light_place(ray, test::toward(0.0, sun).z, cos_azimuth);
          const f64::LightPlace light64{light.vertical, light.level, light.cos_angle};
          for (const f32::LightStep& step : ray.steps) {
            const f64::LightStep step64 = in_double(step);
            const float cosine = f32::light_cosine(step, light);
            const double cosine64 = f64::light_cosine(step64, light64);
            const Lanes arriving =
                f32::visible_light(cosine, step.height_km, shell.ground_km, radius_rad) *
                f32::light_transmittance(f32::depth_place(step, cosine, shell), {model.depths().data(), 1});
            const f64::Light arriving64 =
                f64::visible_light(cosine64, step64.height_km, shell64.ground_km, radius_rad) *
                f64::light_transmittance(f64::depth_place(step64, cosine64, shell64), {depths.data(), 1});
            direct.add(static_cast<double>(arriving[0]) - arriving64.x);
            const f32::FieldPlace place = f32::field_place(step, cosine, light, shell, {model.angle_places().data()});
            const f64::FieldPlace place64 = f64::field_place(step64, cosine64, light64, shell64, {places.data()});
            ASSERT_EQ(place.source < 0, place64.source < 0);
            const auto add = [&](const Lanes& one, const f64::Light& other) {
              ASSERT_TRUE(other.x > 0.0);
              scattered.add(other.x > 1.0e-11 ? static_cast<double>(one[0]) / other.x - 1.0 : 0.0);
            };
            add(f32::scattered_by_molecules(place, model.second_moment()[0], {tables.field.data(), 1}, shell.angles),
                f64::scattered_by_molecules(place64, moment64, {field.data(), 1}, shell.angles));
            if (place.source >= 0) {
              add(f32::scattered_by_aerosol(place, {tables.sources.data(), 1}, shell.angles),
                  f64::scattered_by_aerosol(place64, {sources.data(), 1}, shell.angles));
            }
          }
        }
      }
    }
  }
  scattered.hold("scattered light in single precision, relative", 1.0e-3, "");
  direct.hold("light straight from its source in single precision", 1.0e-3, "");
}

TEST(LightFieldStability, RefusesMoreWavelengthsThanItHolds) {
  std::vector<double> wavelengths(65);
  std::iota(wavelengths.begin(), wavelengths.end(), 450.0);
  const SampledAir air(published_medium());
  const SpectralAir optics(published_medium(), wavelengths);
  EXPECT_THROW(LightField(air, optics, small_field), Error);
}

TEST(LightFieldStability, RefusesSizesThatHoldNothing) {
  const SampledAir air(published_medium());
  const SpectralAir optics(published_medium(), {550.0});
  LightFieldSize size = small_field;
  size.heights = 1;
  EXPECT_THROW(LightField(air, optics, size), Error);
  size = small_field;
  size.later_zeniths = 2;
  EXPECT_THROW(LightField(air, optics, size), Error);
  size = small_field;
  size.least_step_km = 0.0;
  EXPECT_THROW(LightField(air, optics, size), Error);
}

} // namespace
} // namespace vesper
