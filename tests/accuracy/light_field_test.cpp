// The light field that tables are to be filled from, against the reference transport.
#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/base/gauss_legendre.hpp"

#include "support/thorough.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace vesper {
namespace {

const std::vector<double> field_wavelengths_nm{440.0, 505.0, 565.0, 630.0};

struct FieldSpan {
  std::vector<double> altitudes_deg; ///< of the Sun
  double reference_error;
  double radiance_limit;   ///< RMS over the sky, %
  double irradiance_limit; ///< %
  std::string name;
};

/// The limits are those that the tables have to hold.
const std::vector<FieldSpan> field_spans{{{45.0, 10.0, 1.0}, 0.008, 2.0, 2.0, "above 0 degrees"},
                                         {{-2.0, -4.0, -6.0}, 0.02, 5.0, 5.0, "0 to -6 degrees"},
                                         {{-9.0, -12.0}, 0.03, 10.0, 15.0, "-6 to -12 degrees"},
                                         {{-15.0, -18.0}, 0.05, 25.0, 25.0, "-12 to -18 degrees"}};

void compare_field(const Medium& medium, const std::string& name) {
  const SampledAir air(medium);
  const SpectralAir optics(medium, field_wavelengths_nm);
  const LightField field(air, optics);
  const ReferenceTransport reference(medium, field_wavelengths_nm);
  const bool full = test::thorough();
  for (const FieldSpan& span : field_spans) {
    test::ErrorSum irradiance;
    double squares = 0.0;
    std::size_t count = 0;
    PathBudget budget;
    budget.relative_error = span.reference_error;
    budget.least_paths = 2048;
    for (const double sun : span.altitudes_deg) {
      SkyQuery query{0.0 * kilometre, test::toward(0.0, sun), 0.2666 * deg, {}};
      for (const double altitude : full ? std::vector{90.0, 45.0, 15.0, 5.0, 1.0} : std::vector{90.0, 15.0, 1.0}) {
        for (const double azimuth : full ? std::vector{0.0, 60.0, 180.0} : std::vector{0.0, 180.0}) {
          if (altitude == 90.0 && azimuth > 0.0) {
            continue;
          }
          query.view_direction = test::toward(azimuth, altitude);
          ++budget.stream;
          const TransportResult expected = reference.radiance(query, {}, budget);
          const std::vector<double> radiance = field.radiance(query);
          for (std::size_t i = 0; i < field_wavelengths_nm.size(); ++i) {
            const double error = radiance[i] / expected.spectrum[i].mean - 1.0;
            squares += error * error;
            ++count;
          }
        }
      }
      query.view_direction = {0.0, 0.0, 1.0};
      const TransportResult expected = reference.diffuse_irradiance(query, {}, budget);
      const std::vector<double> level = field.diffuse_irradiance(query.light_direction.z);
      for (std::size_t i = 0; i < field_wavelengths_nm.size(); ++i) {
        irradiance.add(100.0 * (level[i] / expected.spectrum[i].mean - 1.0));
      }
    }
    test::ErrorSum radiance;
    radiance.add(100.0 * std::sqrt(squares / static_cast<double>(count)));
    radiance.hold(name + ", Sun " + span.name + ": RMS of the radiance over the sky", span.radiance_limit, "%");
    irradiance.hold(name + ", Sun " + span.name + ": diffuse irradiance", span.irradiance_limit, "%");
  }
}

TEST(LightField, PublishedMediumAgainstTheReference) { compare_field(published_medium(), "published"); }

TEST(LightField, ClearAirAgainstTheReference) { compare_field(clear_medium(), "clear"); }

TEST(LightField, DoesNotDependOnTheNumberOfThreads) {
  const SampledAir air(published_medium());
  const SpectralAir optics(published_medium(), {550.0});
  const LightFieldSize small{8, 6, 3, 6, 3, 0.3, 1.0, 0.1, 3};
  const LightField one(air, optics, small, 1);
  const LightField three(air, optics, small, 3);
  const SkyQuery query{1.0 * kilometre, test::toward(0.0, -3.0), 0.0 * deg, test::toward(40.0, 20.0)};
  EXPECT_EQ(one.radiance(query), three.radiance(query));
}

TEST(LightField, TransmittanceTowardTheLight) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  test::ErrorSum errors;
  for (const Medium& medium : {published_medium(), clear_medium()}) {
    const SampledAir air(medium);
    const SpectralAir optics(medium, {440.0, 550.0, 680.0});
    const LightFieldModel model(air, optics, {}, 0);
    for (int i = 0; i < 20000; ++i) {
      const double share = uniform(random);
      const double height_km = (air.top_km() - air.ground_km()) * share * share;
      // From the zenith to the deepest horizon, most of them near it.
      const double cos_zenith = i % 2 == 0 ? uniform(random) : 0.2 * (uniform(random) - 0.95);
      const AirRay ray = air.ray(air.ground_km() + height_km, cos_zenith);
      f32::LightStep at{};
      at.height_km = static_cast<float>(height_km);
      at.depth_place = static_cast<float>(model.depth_place(height_km));
      const auto cosine = static_cast<float>(cos_zenith);
      // Within half a metre of grazing the ground, single precision may err.
      if (ray.meets_ground || ray.perigee_km > air.ground_km() + 5.0e-4) {
        ASSERT_EQ(f32::visible_light(cosine, at.height_km, model.shell().ground_km, 0.0F),
                  ray.meets_ground ? 0.0F : 1.0F);
      }
      if (ray.meets_ground) {
        continue;
      }
      const Lanes transmittance =
          f32::light_transmittance(f32::depth_place(at, cosine, model.shell()), {model.depths().data(), 1});
      const SampledAir::PerComponent expected = air.columns_to_space(ray, [](const auto&) { return false; });
      for (std::size_t l = 0; l < 3; ++l) {
        errors.add(static_cast<double>(transmittance[l]) - std::exp(-optics.optical_depth(expected, l)));
      }
    }
  }
  errors.hold("looked-up transmittance to space at 440, 550 and 680 nm", 2.0e-3, "");
}

TEST(GaussLegendre, IntegratesPolynomials) {
  for (const std::size_t count : {1U, 2U, 5U, 20U, 64U}) {
    const std::vector<QuadratureNode> rule = gauss_legendre(count);
    for (std::size_t degree = 0; degree < 2 * count; ++degree) {
      double sum = 0.0;
      for (const QuadratureNode& node : rule) {
        sum += node.weight * std::pow(node.place, static_cast<double>(degree));
      }
      EXPECT_NEAR(sum, 1.0 / (static_cast<double>(degree) + 1.0), 1.0e-13);
    }
  }
}

} // namespace
} // namespace vesper
