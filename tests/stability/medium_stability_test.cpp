// Media and paths at the ends of their ranges.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/star_extinction.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/shader_math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vesper {
namespace {

const Vec3 zenith(0.0, 0.0, 1.0);
const Vec3 level(1.0, 0.0, 0.0);

Medium single(const HeightProfile& profile, double per_km) {
  return {6360.0 * kilometre,
          6460.0 * kilometre,
          constant_law(0.0),
          {{"one", profile, constant_law(per_km), constant_law(0.0), {PhaseKind::rayleigh, constant_law(0.0)}}},
          {550.0}};
}

double depth_to_space(const Medium& medium, const Vec3& from, const Vec3& direction) {
  return optical_depth(medium, columns_to_space(medium, from, direction), 550.0).value;
}

TEST(PhaseStability, FiniteAndPositiveEverywhere) {
  for (const float g : {-0.99F, -0.9F, -1.0e-20F, 0.0F, 1.0e-20F, 0.9F, 0.99F}) {
    for (const float c : {-1.0F, -0.9999999F, 0.0F, 0.9999999F, 1.0F}) {
      for (const float p :
           {f32::henyey_greenstein_phase(c, g), f32::cornette_shanks_phase(c, g), f32::schlick_phase(c, g)}) {
        EXPECT_TRUE(std::isfinite(p) && p > 0.0F) << g << " " << c;
      }
    }
  }
}

TEST(TransmittanceStability, DepthGoesWithDensity) {
  const Vec3 eye(0.0, 0.0, 6360.0);
  for (const Vec3& direction : {zenith, level}) {
    const double one = depth_to_space(single(HeightProfile::exponential(8.0), 0.0136), eye, direction);
    EXPECT_EQ(depth_to_space(single(HeightProfile::exponential(8.0), 0.0), eye, direction), 0.0);
    EXPECT_NEAR(depth_to_space(single(HeightProfile::exponential(8.0), 1.36), eye, direction), 100.0 * one,
                1.0e-9 * one);
  }
  // 100-fold air at the horizon lets nothing through and is still a number.
  const Medium dense = single(HeightProfile::exponential(8.0), 1.36);
  const OpticalDepth depth = optical_depth(dense, columns_to_space(dense, eye, level), 550.0);
  EXPECT_GE(depth.transmittance(), 0.0);
  EXPECT_LT(depth.transmittance(), 1.0e-100);
}

TEST(TransmittanceStability, LayersWithoutThicknessHoldNothing) {
  const Vec3 eye(0.0, 0.0, 6360.0);
  EXPECT_EQ(depth_to_space(single(HeightProfile::tent(20.0, 20.0, 20.0), 1.0), eye, zenith), 0.0);
  EXPECT_EQ(depth_to_space(single(HeightProfile::tent(0.0, 0.0, 0.0), 1.0), eye, level), 0.0);
}

TEST(TransmittanceStability, ThinLayersAreNotMissed) {
  const Vec3 eye(0.0, 0.0, 6360.0);
  for (const double thickness_km : {1.0e-3, 0.1, 3.0}) {
    const double slab = depth_to_space(single(HeightProfile::exponential(thickness_km), 1.0), eye, zenith);
    EXPECT_NEAR(slab / thickness_km, 1.0, 1.0e-7);
    const HeightProfile box =
        HeightProfile::table({50.0, 50.0 + thickness_km}, {1.0, 1.0}, HeightProfile::Between::linear);
    EXPECT_NEAR(depth_to_space(single(box, 1.0), eye, zenith) / thickness_km, 1.0, 1.0e-7);
  }
}

TEST(TransmittanceStability, OverlappingLayersAdd) {
  const Vec3 eye(0.0, 0.0, 6360.0);
  Medium both = single(HeightProfile::tent(10.0, 20.0, 30.0), 0.1);
  both.components.push_back(single(HeightProfile::tent(15.0, 18.0, 50.0), 0.2).components[0]);
  EXPECT_NEAR(depth_to_space(both, eye, zenith), 0.1 * 10.0 + 0.2 * 17.5, 1.0e-9);
}

TEST(TransmittanceStability, GrazingRaysMeetTheGroundOrNot) {
  const Medium air = published_medium();
  const Vec3 eye(0.0, 0.0, 6360.0);
  EXPECT_FALSE(columns_to_space(air, eye, level).blocked);
  EXPECT_TRUE(columns_to_space(air, eye, {std::cos(0.001), 0.0, -std::sin(0.001)}).blocked);
  EXPECT_TRUE(columns_to_space(air, eye, -zenith).blocked);
  EXPECT_EQ(optical_depth(air, columns_to_space(air, eye, -zenith), 550.0).transmittance(), 0.0);
  EXPECT_FALSE(columns_to_space(air, {-9000.0, 0.0, 6360.0}, level).blocked);
  EXPECT_TRUE(columns_to_space(air, {-9000.0, 0.0, 6359.99}, level).blocked);
  EXPECT_FALSE(columns_between(air, {-9000.0, 0.0, 100.0}, {-6400.0, 0.0, 100.0}).blocked);
  // Just above the ground the depth is that on the ground.
  EXPECT_NEAR(depth_to_space(air, {-9000.0, 0.0, 6360.0}, level) / (2.0 * depth_to_space(air, eye, level)), 1.0,
              1.0e-8);
}

TEST(TransmittanceStability, AtTheTopAndOutside) {
  const Medium air = published_medium();
  const Vec3 top(0.0, 0.0, 6460.0);
  EXPECT_EQ(depth_to_space(air, top, zenith), 0.0);
  EXPECT_EQ(depth_to_space(air, top, level), 0.0);
  EXPECT_EQ(depth_to_space(air, {0.0, 0.0, 400000.0}, zenith), 0.0);
  EXPECT_EQ(depth_to_space(air, {-400000.0, 0.0, 6460.0}, level), 0.0);
  const double down = optical_depth(air, columns_between(air, {0.0, 0.0, 400000.0}, {0.0, 0.0, 6360.0}), 550.0).value;
  EXPECT_NEAR(down, depth_to_space(air, {0.0, 0.0, 6360.0}, zenith), 1.0e-9);
  EXPECT_EQ(optical_depth(air, columns_between(air, top, top), 550.0).value, 0.0);
}

TEST(TransmittanceStability, EveryAltitudeFromEveryHeight) {
  const Medium air = clear_medium({10.0, 1.0, 4.0, 1000.0, 1.0});
  for (const double height : {0.0, 1.0e-9, 0.5, 12.0, 119.999999, 120.0, 121.0, 1.0e6}) {
    for (int i = -90; i <= 90; ++i) {
      const double altitude = i * std::numbers::pi / 180.0;
      const AirColumns columns = columns_to_space(air, {0.0, 0.0, 6371.0 + height},
                                                  glm::normalize(Vec3(std::cos(altitude), 0.0, std::sin(altitude))));
      const double through = optical_depth(air, columns, 360.0).transmittance();
      EXPECT_TRUE(through >= 0.0 && through <= 1.0) << height << " " << i;
    }
  }
}

TEST(StarExtinctionStability, TheZenithIsTheMediumsFromEveryHeight) {
  for (const Medium& air : {clear_medium(), published_medium(), clear_medium({0.0, 0.0, 1.3, 0.0, 0.0})}) {
    for (const double height_km : {0.0, 1.0e-9, 2.4, 12.0, 50.0, 100.0, 120.0, 1.0e4}) {
      const Vec4 depth = star_optical_depth_xyzs(air, height_km * kilometre);
      for (int channel = 0; channel < 4; ++channel) {
        const double exact =
            optical_depth(air, columns_to_space(air, (air.ground_radius.to(kilometre) + height_km) * zenith, zenith),
                          star_wavelengths_nm[channel])
                .value;
        EXPECT_TRUE(std::isfinite(depth[channel])) << height_km;
        EXPECT_NEAR(depth[channel] * f64::optical_path(1.0, height_km), exact, 1.0e-12 * exact) << height_km;
      }
    }
    // Below the sea the column goes on without a step.
    EXPECT_EQ(star_optical_depth_xyzs(air, -400.0 * metre), star_optical_depth_xyzs(air, 0.0 * metre));
  }
}

TEST(MediumStability, AirWithoutAerosolOrOzone) {
  const Medium air = clear_medium({0.0, 0.005, 1.3, 0.0, 0.0});
  const AirColumns columns = columns_to_space(air, {0.0, 0.0, 6371.0}, zenith);
  EXPECT_EQ(optical_depth(air, columns, 550.0).value, air.components[0].scattering_per_km(550.0) * columns.km[0]);
}

TEST(MediumStability, ASpectrumThatIsZeroSomewhere) {
  // Outside its samples the published medium is empty, and that is valid.
  const Medium air = published_medium();
  EXPECT_NO_THROW(validate(air, 900.0));
  EXPECT_EQ(depth_to_space(air, {0.0, 0.0, 6360.0}, zenith) > 0.0, true);
  EXPECT_EQ(optical_depth(air, columns_to_space(air, {0.0, 0.0, 6360.0}, zenith), 900.0).value, 0.0);
  const Spectrum dark({400.0, 450.0}, {1.0, 1.0});
  EXPECT_THROW((void)zenith_extinction_v_mag(air, 0.0 * metre, dark), Error);
}

TEST(MediumBadInput, IsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Between = HeightProfile::Between;
  EXPECT_THROW((void)HeightProfile::exponential(0.0), Error);
  EXPECT_THROW((void)HeightProfile::exponential(nan), Error);
  EXPECT_THROW((void)HeightProfile::tent(10.0, 5.0, 40.0), Error);
  EXPECT_THROW((void)HeightProfile::tent(-1.0, 5.0, 40.0), Error);
  EXPECT_THROW((void)HeightProfile::table({0.0, 1.0}, {1.0, -1.0}, Between::linear), Error);
  EXPECT_THROW((void)HeightProfile::table({0.0, 1.0}, {1.0, 0.0}, Between::logarithmic), Error);
  EXPECT_THROW((void)HeightProfile::table({0.0}, {1.0}, Between::linear), Error);
  EXPECT_THROW((void)HeightProfile::table({0.0, nan}, {1.0, 1.0}, Between::linear), Error);
  EXPECT_THROW((void)clear_medium({-0.1, 0.005, 1.3, 300.0, 0.1}), Error);
  EXPECT_THROW((void)clear_medium({0.1, 2.0, 1.3, 300.0, 0.1}), Error);
  EXPECT_THROW((void)clear_medium({0.1, 0.005, nan, 300.0, 0.1}), Error);
  EXPECT_THROW((void)clear_medium({0.1, 0.005, 1.3, 300.0, 1.1}), Error);
  EXPECT_THROW(validate(single(HeightProfile::exponential(8.0), -1.0), 550.0), Error);
  Medium wrong = published_medium();
  wrong.components[1].phase.parameter = constant_law(1.0);
  EXPECT_THROW(validate(wrong, 550.0), Error);
  wrong = published_medium();
  wrong.top_radius = wrong.ground_radius;
  EXPECT_THROW(validate(wrong, 550.0), Error);
  EXPECT_THROW((void)columns_to_space(wrong, {0.0, 0.0, 6360.0}, zenith), Error);
  EXPECT_THROW((void)columns_to_space(published_medium(), {0.0, 0.0, 6360.0}, 2.0 * zenith), Error);
  EXPECT_THROW((void)columns_to_space(published_medium(), {0.0, 0.0, nan}, zenith), Error);
  EXPECT_THROW((void)columns_between(published_medium(), {0.0, 0.0, 6360.0}, {nan, 0.0, 0.0}), Error);
}

} // namespace
} // namespace vesper
