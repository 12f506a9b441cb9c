// shaders/lib on the GPU against the same text compiled as C++ in single precision: places, stars and air.
#include "render/shader_harness.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace vesper::test {
namespace {

f32::PixelFrame test_frame(int kind) { return {kind, glm::vec2(1024.0F, kind == 4 ? 6144.0F : 768.0F), 512.0F}; }

glm::vec4 unprojected(const glm::vec4& v, int kind) {
  glm::vec3 direction;
  f32::unproject(glm::vec2(v), test_frame(kind), direction);
  return {direction, 0.0F};
}

/// An expression needs a function to receive an output parameter; GLSL has no lambdas.
std::string unproject_glsl(int kind) {
  return "vec4(0.0);\n  vec3 d;\n  unproject(v.xy, PixelFrame(" + std::to_string(kind) + ", vec2(1024.0, " +
         (kind == 4 ? "6144.0" : "768.0") + "), 512.0), d);\n  outputs[i] = vec4(d, 0.0)";
}

/// A display of each transfer, with primaries of its number.
f32::DisplayModel test_display(int transfer) {
  return {glm::inverse(f32::xyz_from_rgb(f32::chromaticities_of(transfer))),
          transfer,
          2.4F,
          0.2F,
          199.8F,
          0.5F,
          0.1F,
          2.0e-7F};
}

std::string display_glsl(const std::string& expression) {
  return "vec4(0.0);\n  DisplayModel display = DisplayModel(inverse(xyz_from_rgb(chromaticities_of(int(v.w)))), "
         "int(v.w), 2.4, 0.2, 199.8, 0.5, 0.1, 2.0e-7);\n  outputs[i] = vec4(" +
         expression + ", 0.0)";
}

using ShaderMathGpu = RenderTest;

TEST_F(ShaderMathGpu, EachFunctionAgreesWithItsTwin) {
  std::vector<FunctionCase> cases{
      {"threshold_of_a_point, in its logarithm",
       "vec4(log(threshold_illuminance_lux(exp(v.x), v.y)), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(std::log(f32::threshold_illuminance_lux(std::exp(v.x), v.y))); },
       {-14, 1, 0, 0},
       {21, 2.4F, 0, 0},
       97,
       1.0e-4F},
      {"seen_color",
       "vec4(seen_color(v.x * vec4(0.9, 1.0, v.y, v.z), mesopic_cone_share(v.x, v.x * v.z)), 0)",
       [](const glm::vec4& v) {
         return glm::vec4(
             f32::seen_color(v.x * glm::vec4(0.9F, 1.0F, v.y, v.z), f32::mesopic_cone_share(v.x, v.x * v.z)), 0.0F);
       },
       {0.001F, 0.3F, 0.5F, 0},
       {6, 2, 4, 0},
       17,
       1.0e-3F},
      {"thompson_night",
       "vec4(thompson_night(v.xyz, 0.01, 0.1, 0.5), 0)",
       [](const glm::vec4& v) { return glm::vec4(f32::thompson_night(glm::vec3(v), 0.01F, 0.1F, 0.5F), 0.0F); },
       {0, 0, 0, 0},
       {1, 1, 1, 0},
       9,
       1.0e-5F},
      {"thresholds, acuity and adaptation",
       "vec4(log(just_noticeable_cd_m2(exp(v.x))), acuity_cycles_per_degree(exp(v.x)), "
       "log(adapted(vec2(exp(v.x), exp(v.y)), vec2(1.0, 0.1), 20.0)))",
       [](const glm::vec4& v) {
         const f32::vec2 adapted = f32::adapted({std::exp(v.x), std::exp(v.y)}, {1.0F, 0.1F}, 20.0F);
         return glm::vec4(std::log(f32::just_noticeable_cd_m2(std::exp(v.x))),
                          f32::acuity_cycles_per_degree(std::exp(v.x)), std::log(adapted.x), std::log(adapted.y));
       },
       {-14, -14, 0, 0},
       {14, 14, 0, 0},
       41,
       1.0e-4F},
      {"tone: bins, cones and the camera's white",
       "vec4(tone_bin(exp(v.x)), local_cone_share(exp(v.x), v.y * exp(v.x)), "
       "metered_exposure_value(exp(v.x)), photographic_white_cd_m2(v.y))",
       [](const glm::vec4& v) {
         const float luminance = std::exp(v.x);
         return glm::vec4(f32::tone_bin(luminance), f32::local_cone_share(luminance, v.y * luminance),
                          f32::metered_exposure_value(luminance), f32::photographic_white_cd_m2(v.y));
       },
       {-16, 0.3F, 0, 0},
       {23, 4, 0, 0},
       41,
       2.0e-4F},
      {"tone: bright light of a colour",
       "vec4(scale_with_color(v.x, v.y, v.z, exp(v.w), kept_color), "
       "towards_grey(vec3(v.x, 0.5 * v.z, v.z), v.x, v.z))",
       [](const glm::vec4& v) {
         const f32::vec3 inside = f32::towards_grey({v.x, 0.5F * v.z, v.z}, v.x, v.z);
         return glm::vec4(f32::scale_with_color(v.x, v.y, v.z, std::exp(v.w), f32::kept_color), inside);
       },
       {0.01F, 0.5F, 1, -5},
       {0.99F, 2, 4, 18},
       7,
       1.0e-5F},
      {"tone: a bin's luminance and a key, in their logarithms; points over a ceiling",
       "vec4(log(tone_bin_luminance(v.x)), log(automatic_key(v.z)), log(point_boost(v.y)), "
       "under_ceiling(v.z, v.y, 90.0))",
       [](const glm::vec4& v) {
         return glm::vec4(std::log(f32::tone_bin_luminance(v.x)), std::log(f32::automatic_key(v.z)),
                          std::log(f32::point_boost(v.y)), f32::under_ceiling(v.z, v.y, 90.0F));
       },
       {0, 0.01F, 0.1F, 0},
       {231, 300, 80, 0},
       13,
       1.0e-4F},
      {"tone: Reinhard's and Hable's curves",
       "vec4(reinhard_extended(v.x, 8.0), hable_curve(v.x), 0, 0)",
       [](const glm::vec4& v) { return glm::vec4(f32::reinhard_extended(v.x, 8.0F), f32::hable_curve(v.x), 0, 0); },
       {0, 0, 0, 0},
       {12, 0, 0, 0},
       97,
       1.0e-4F},
      {"quick_srgb_encode",
       "vec4(quick_srgb_encode(v.x), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::quick_srgb_encode(v.x)); },
       {0, 0, 0, 0},
       {1, 0, 0, 0},
       997,
       1.0e-5F},
      {"hash",
       "vec4(hash_unit(hash_pair(uint(v.x), uint(v.y))), 0, 0, 0)",
       [](const glm::vec4& v) {
         return scalar(f32::hash_unit(f32::hash_pair(static_cast<unsigned>(v.x), static_cast<unsigned>(v.y))));
       },
       {0, 0, 0, 0},
       {9000, 1000, 0, 0},
       40,
       0.0F},
      {"arc_tangent",
       "vec4(float(signed_arc_tangent(double(v.x), double(v.y))), 0, 0, 0)",
       [](const glm::vec4& v) {
         return scalar(static_cast<float>(f64::signed_arc_tangent(static_cast<double>(v.x), static_cast<double>(v.y))));
       },
       {-1, -1, 0, 0},
       {1, 1, 0, 0},
       41,
       1.0e-6F},
      {"psf_profile",
       "vec4(psf_profile(v.xy), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::psf_profile(glm::vec2(v))); },
       {-4, -4, 0, 0},
       {4, 4, 0, 0},
       33,
       1.0e-5F},
      {"psf_axis_sum",
       "vec4(psf_axis_sum(v.x, -8.0, 8.0, v.y), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::psf_axis_sum(v.x, -8.0F, 8.0F, v.y)); },
       {-1, 0.8F, 0, 0},
       {1, 2.5F, 0, 0},
       33,
       1.0e-5F},
      {"psf_cut",
       "vec4(psf_cut(exp2(v.x)), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::psf_cut(std::exp2(v.x))); },
       {-40, 0, 0, 0},
       {-10, 0, 0, 0},
       301,
       2.0e-5F},
      {"mueller psf",
       "vec4(mueller_intensity_psf(v.x), mueller_glare_psf(v.x), mueller_day_fade(v.y), "
       "mueller_glare_intensity(v.z, 4.0))",
       [](const glm::vec4& v) {
         return glm::vec4(f32::mueller_intensity_psf(v.x), f32::mueller_glare_psf(v.x), f32::mueller_day_fade(v.y),
                          f32::mueller_glare_intensity(v.z, 4.0F));
       },
       {0, -1, -2, 0},
       {1, 1, 6, 0},
       17,
       2.0e-4F},
      {"optical_path",
       "vec4(optical_path(v.x, v.y), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::optical_path(v.x, v.y)); },
       {-1, 0, 0, 0},
       {1, 12, 0, 0},
       121,
       2.0e-4F},
      {"modulate_xyzs",
       "modulate_xyzs(v, extinction(vec4(0.2, 0.23, 0.35, 0.26), 3.0))",
       [](const glm::vec4& v) {
         return f32::modulate_xyzs(v, f32::extinction(glm::vec4(0.2F, 0.23F, 0.35F, 0.26F), 3.0F));
       },
       {0, 0, 0, 0},
       {2, 2, 2, 2},
       6,
       1.0e-5F},
      {"scintillation",
       "scintillation(uint(v.x), double(v.y), v.z, v.w, 0.007)",
       [](const glm::vec4& v) { return f32::scintillation(static_cast<unsigned>(v.x), v.y, v.z, v.w, 0.007F); },
       {1, 0, 0.02F, 0},
       {9000, 0.9F, 1, 0.1F},
       8,
       2.0e-3F},
      {"disc_pupil",
       "vec4(disc_pupil(v.x, v.y, v.z), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::disc_pupil(v.x, v.y, v.z)); },
       {0, 0, 0, 0},
       {0.01F, 3.0e-4F, 1, 0},
       8,
       2.0e-4F},
      {"display_signal",
       display_glsl("display_signal(v.xyz, display, 20.0)"),
       [](const glm::vec4& v) {
         return glm::vec4(f32::display_signal(glm::vec3(v), test_display(static_cast<int>(v.w)), 20.0F), 0);
       },
       {-20, 0, -20, 0},
       {300, 300, 300, 2},
       9,
       1.0e-3F}, // of a thousandth: components at the gamut's border are differences
      {"display_codes",
       display_glsl("display_codes(inverse(display.rgb_from_xyz) * v.xyz, display, 20.0)"),
       [](const glm::vec4& v) {
         const f32::DisplayModel display = test_display(static_cast<int>(v.w));
         return glm::vec4(f32::display_codes(glm::inverse(display.rgb_from_xyz) * glm::vec3(v), display, 20.0F), 0);
       },
       {5, 5, 5, 0},
       {200, 200, 200, 2},
       9,
       1.0e-4F},
      {"display_light",
       display_glsl("display_light(v.xyz, display, 20.0)"),
       [](const glm::vec4& v) {
         return glm::vec4(f32::display_light(glm::vec3(v), test_display(static_cast<int>(v.w)), 20.0F), 0);
       },
       {0, 0, 0, 0},
       {1, 1, 1, 2},
       9,
       2.0e-3F}, // PQ's decoding takes the difference of numbers near one
      {"dithered",
       "vec4(dithered(vec3(v.z), uint(v.x), uint(v.y), uint(v.w), 255.0), 0)",
       [](const glm::vec4& v) {
         return glm::vec4(f32::dithered(glm::vec3(v.z), static_cast<unsigned>(v.x), static_cast<unsigned>(v.y),
                                        static_cast<unsigned>(v.w), 255.0F),
                          0);
       },
       {0, 0, 0, 0},
       {9000, 90000, 1, 70},
       11,
       1.0e-6F},
  };
  const std::array<const char*, 5> names{"perspective", "fisheye", "stereographic", "equirectangular", "cubemap"};
  for (int kind = 0; kind < 5; ++kind) {
    const float height = kind == 4 ? 6144.0F : 768.0F;
    cases.push_back({std::string("unproject ") + names.at(static_cast<std::size_t>(kind)),
                     unproject_glsl(kind),
                     [kind](const glm::vec4& v) { return unprojected(v, kind); },
                     {0.5F, 0.5F, 0, 0},
                     {1023.5F, height - 0.5F, 0, 0},
                     37,
                     1.0e-4F});
    cases.push_back(
        {std::string("pixels_per_steradian ") + names.at(static_cast<std::size_t>(kind)),
         "vec4(pixels_per_steradian(v.xy, PixelFrame(" + std::to_string(kind) + ", vec2(1024.0, " +
             (kind == 4 ? "6144.0" : "768.0") + "), 512.0)), 0, 0, 0)",
         [kind](const glm::vec4& v) { return scalar(f32::pixels_per_steradian(glm::vec2(v), test_frame(kind))); },
         {0.5F, 0.5F, 0, 0},
         {1023.5F, height - 0.5F, 0, 0},
         37,
         1.0e-4F});
    cases.push_back(
        {std::string("share_in_circle ") + names.at(static_cast<std::size_t>(kind)),
         "vec4(share_in_circle(v.xy, 40.0, PixelFrame(" + std::to_string(kind) + ", vec2(1024.0, " +
             (kind == 4 ? "6144.0" : "768.0") + "), 512.0)), 0, 0, 0)",
         [kind](const glm::vec4& v) { return scalar(f32::share_in_circle(glm::vec2(v), 40.0F, test_frame(kind))); },
         {0.5F, 0.5F, 0, 0},
         {1023.5F, height - 0.5F, 0, 0},
         37,
         1.0e-4F});
  }
  expect_twins(cases);
}

TEST_F(ShaderMathGpu, PlacesInDoublePrecision) {
  // star_place and project for a view half a degree wide: 1e-9 rad is 2e-4 arcsec.
  const std::string expression = R"(vec4(0.0);
  StarPlaceFrame frame = StarPlaceFrame(61.5lf, dvec3(0.31lf, -0.87lf, 0.4lf), dvec3(0.9e-4lf, 0.3e-4lf, -0.2e-4lf),
                                        0.99999999lf, dvec3(0.6lf, 0.0lf, 0.8lf), 1.97e-8lf);
  dvec3 place = star_place(normalize(dvec3(v.xyz)), dvec3(1.0e-5, -2.0e-5, 0.5e-5), 3.0e-6lf, 40.0lf, frame);
  outputs[i] = vec4(vec3((place - normalize(dvec3(v.xyz))) * 1.0e4lf), 0.0))";
  const Inputs inputs = grid({-1, -1, -0.9F, 0}, {1, 1, 1, 0}, 8);
  const std::vector<glm::vec4> results = evaluate_on_gpu(expression, inputs);
  const f64::StarPlaceFrame frame{61.5,       {0.31, -0.87, 0.4}, {0.9e-4, 0.3e-4, -0.2e-4},
                                  0.99999999, {0.6, 0.0, 0.8},    1.97e-8};
  double worst = 0.0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Vec3 position = glm::normalize(Vec3(inputs[i]));
    const Vec3 pm(static_cast<double>(1.0e-5F), static_cast<double>(-2.0e-5F), static_cast<double>(0.5e-5F));
    const Vec3 place = f64::star_place(position, pm, 3.0e-6, 40.0, frame);
    worst = std::max(worst, glm::length(Vec3(results[i]) - (place - position) * 1.0e4) * 1.0e-4);
  }
  std::printf("star_place: worst %.1e rad\n", worst);
  EXPECT_LT(worst, 1.0e-9);
}

} // namespace
} // namespace vesper::test
