// The same for refraction and extinction, which read tables.
#include "render/shader_harness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace vesper::test {
namespace {

using ShaderAirGpu = RenderTest;

/// Single precision's refraction, as the GPU gets it.
struct FloatRefraction {
  explicit FloatRefraction(const Refraction& refraction) {
    const f64::RefractionFrame exact = refraction_frame(refraction);
    frame = {exact.kind,
             static_cast<float>(exact.strength),
             static_cast<float>(exact.horizon_apparent),
             static_cast<float>(exact.horizon_true),
             f32::vec2(exact.scale_apparent),
             f32::vec2(exact.scale_true)};
    if (refraction.table != nullptr) {
      texels.assign(refraction.table->texels.begin(), refraction.table->texels.end());
    }
  }
  [[nodiscard]] f32::sampler1D sampler() const { return {texels.data(), static_cast<int>(texels.size())}; }
  [[nodiscard]] std::string glsl() const {
    return fmt::format("RefractionFrame({}, {:.9e}, {:.9e}, {:.9e}, vec2({:.9e}, {:.9e}), vec2({:.9e}, {:.9e}))",
                       frame.kind, frame.strength, frame.horizon_apparent, frame.horizon_true, frame.scale_apparent.x,
                       frame.scale_apparent.y, frame.scale_true.x, frame.scale_true.y);
  }

  f32::RefractionFrame frame{};
  std::vector<f32::vec4> texels;
};

TEST_F(ShaderAirGpu, RefractionAgreesWithItsTwin) {
  // Crowded towards the horizon, with the poles: x is the sine of the altitude.
  Inputs inputs;
  for (int i = -1000; i <= 1000; ++i) {
    const float t = static_cast<float>(i) * 1.0e-3F;
    inputs.emplace_back(t * t * t, 0.0F, 0.0F, 0.0F);
  }
  for (const RefractionModel model : {RefractionModel::traced, RefractionModel::published, RefractionModel::none}) {
    for (const double height_km : {0.0, 12.0}) {
      const Refraction refraction = with_table({model, standard_conditions(height_km * kilometre), nullptr});
      const FloatRefraction ours(refraction);
      const std::string direction = "dvec3(sqrt(max(1.0lf - double(v.x) * double(v.x), 0.0lf)), 0.0lf, double(v.x))";
      const std::string of = "(" + direction + ", " + ours.glsl() + ", table)";
      // Displacements: the directions themselves would round to 0.01 arcsec.
      const std::vector<glm::vec4> results = evaluate_on_gpu(
          fmt::format("vec4(vec2((apparent_direction{0} - {1}).xz), vec2((true_direction_of{0} - {1}).xz))", of,
                      direction),
          inputs, refraction);
      double worst = 0.0;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto sine = static_cast<double>(inputs[i].x);
        const Vec3 v(std::sqrt(std::max(1.0 - sine * sine, 0.0)), 0.0, sine);
        const f32::vec3 v32(v);
        const auto up = static_cast<double>(f32::refraction_bend(v32, false, ours.frame, ours.sampler()));
        const auto down = static_cast<double>(f32::refraction_bend(v32, true, ours.frame, ours.sampler()));
        const Vec3 raised = f64::raised(v, up) - v;
        const Vec3 lowered = f64::raised(v, -down) - v;
        worst = std::max(worst, glm::length(Vec4(results[i]) - Vec4(raised.x, raised.z, lowered.x, lowered.z)));
      }
      std::printf("refraction model %d from %g km: worst %.1e arcsec\n", static_cast<int>(model), height_km,
                  (worst * rad).to(arcsec));
      // The published formula takes the cotangent of a small angle.
      EXPECT_LT((worst * rad).to(arcsec), model == RefractionModel::published ? 0.05 : 0.01);
    }
  }
}

TEST_F(ShaderAirGpu, ExtinctionOfStarsAgreesWithItsTwin) {
  // Crowded towards the horizon, which lies within; B-V from beyond the bluest to beyond the reddest.
  Inputs inputs;
  for (int i = -300; i <= 300; ++i) {
    const float t = static_cast<float>(i) / 300.0F;
    for (const float z : {0.0F, 1.0e-4F, 0.02F, 0.3F, 1.0F, 1.7F, 9.0F}) {
      inputs.emplace_back(t * t * t, z, 0.0F, 0.0F);
    }
  }
  for (const double height_km : {0.0, 12.0}) {
    SkyState sky = still_sky();
    sky.observer.height = height_km * kilometre;
    sky.refraction = standard_refraction(sky.observer.height, Tier::standard);
    const FramePlan plan = plan_frame(sky, View(), {});
    const StarExtinction& exact = plan.extinction->table;
    const f32::StarExtinctionFrame frame{exact.frame.rows,
                                         exact.frame.columns,
                                         static_cast<float>(exact.frame.sin_horizon),
                                         static_cast<float>(exact.frame.width),
                                         static_cast<float>(exact.frame.rows_per_x),
                                         static_cast<float>(exact.frame.reddest),
                                         static_cast<float>(exact.frame.columns_per_hue)};
    const std::vector<f32::vec4> texels(exact.texels.begin(), exact.texels.end());
    const f32::sampler2D table{texels.data(), frame.columns, frame.rows};
    const std::vector<glm::vec4> results = evaluate_on_gpu(
        fmt::format(
            "star_extinction(v.x, vec4(1.0, 1.0, v.y, 1.0), StarExtinctionFrame({}, {}, {:.9e}, {:.9e}, {:.9e}, "
            "{:.9e}, {:.9e}), extinction_table)",
            frame.rows, frame.columns, frame.sin_horizon, frame.width, frame.rows_per_x, frame.reddest,
            frame.columns_per_hue),
        inputs, {}, plan);
    float worst = 0.0F;
    double from_doubles = 0.0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const glm::vec4 light(1.0F, 1.0F, inputs[i].y, 1.0F);
      const f32::vec4 expected = f32::star_extinction(inputs[i].x, light, frame, table);
      const Vec4 precise = star_extinction(exact, static_cast<double>(inputs[i].x), Vec4(light));
      for (int c = 0; c < 4; ++c) {
        ASSERT_GT(results[i][c], 0.0F) << i;
        ASSERT_LT(results[i][c], 1.0F) << i;
        worst = std::max(worst, std::abs(results[i][c] / expected[c] - 1.0F));
        from_doubles = std::max(from_doubles, std::abs(static_cast<double>(results[i][c]) / precise[c] - 1.0));
      }
    }
    std::printf("extinction of stars from %g km: worst relative difference %.1e, %.1e from double precision\n",
                height_km, static_cast<double>(worst), from_doubles);
    // Logarithms reach 40, so that a float's rounding of them is some 1e-6 of the light.
    EXPECT_LT(worst, 5.0e-5F);
    EXPECT_LT(from_doubles, 1.0e-4);
  }
}

} // namespace
} // namespace vesper::test
