// shaders/lib on the GPU against the same text compiled as C++ in single precision.
#include "render/render_fixture.hpp"

#include "vesper/gpu/extinction_texture.hpp"
#include "vesper/gpu/refraction_texture.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <unistd.h>

namespace vesper::test {
namespace {

using Inputs = std::vector<glm::vec4>;

/// Evaluates a GLSL expression of `vec4 v` for every input and returns the vec4 results.
/// The expression may read tables: of refraction, a sampler1D named `table`, and of a plan's extinction, a sampler2D
/// named `extinction_table`.
std::vector<glm::vec4> evaluate_on_gpu(const std::string& expression, const Inputs& inputs,
                                       const Refraction& refraction = {}, const FramePlan& plan = {}) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_harness_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "harness.comp") << R"(
#include "prelude.glsl"
#include "lib/hash.glsl"
#include "lib/star_place.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/star_psf.glsl"
#include "lib/refraction.glsl"
#include "lib/extinction.glsl"
#include "lib/scintillation.glsl"
#include "lib/eclipse.glsl"
#include "lib/moon_shadow.glsl"
#include "lib/moon_surface.glsl"
#include "lib/lunar_eclipse.glsl"
#include "lib/visibility.glsl"
#include "lib/mesopic.glsl"
#include "lib/vision.glsl"
#include "lib/display.glsl"
#include "lib/phase.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_to_point.glsl"
#include "lib/sun.glsl"
#include "lib/dark_sky.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler1D table; // of refraction
layout(binding = 1) uniform sampler2D extinction_table;
layout(std430, binding = 0) readonly buffer In { vec4 inputs[]; };
layout(std430, binding = 1) writeonly buffer Out { vec4 outputs[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(inputs.length())) { return; }
  vec4 v = inputs[i];
  outputs[i] = )" << expression << ";\n}\n";
  gpu::ProgramHandle program;
  try {
    program = gpu::build_program(gpu::ShaderLibrary(folder), {"harness.comp"});
  } catch (...) {
    std::filesystem::remove_all(folder);
    throw;
  }
  std::filesystem::remove_all(folder);

  const gpu::Buffer in = gpu::make_static_buffer(std::as_bytes(std::span(inputs)));
  const gpu::Buffer out = gpu::make_dynamic_buffer(inputs.size() * sizeof(glm::vec4));
  gpu::RefractionTexture table;
  table.update(refraction);
  table.bind(0);
  gpu::ExtinctionTexture extinction;
  extinction.update(plan.extinction);
  extinction.bind(1);
  glUseProgram(program.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.name());
  glDispatchCompute(static_cast<GLuint>((inputs.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<glm::vec4> results(inputs.size());
  glGetNamedBufferSubData(out.name(), 0, static_cast<GLsizeiptr>(results.size() * sizeof(glm::vec4)), results.data());
  gpu::require_no_error("evaluating a shader function");
  return results;
}

/// Points of a grid over a box, `steps` along each axis that has an extent.
Inputs grid(const glm::vec4& low, const glm::vec4& high, int steps) {
  Inputs points;
  const auto count = [&](int axis) { return low[axis] == high[axis] ? 1 : steps; };
  const auto at = [&](int axis, int i) {
    return count(axis) == 1
               ? low[axis]
               : low[axis] + (high[axis] - low[axis]) * static_cast<float>(i) / static_cast<float>(steps - 1);
  };
  for (int a = 0; a < count(0); ++a) {
    for (int b = 0; b < count(1); ++b) {
      for (int c = 0; c < count(2); ++c) {
        for (int d = 0; d < count(3); ++d) {
          points.emplace_back(at(0, a), at(1, b), at(2, c), at(3, d));
        }
      }
    }
  }
  return points;
}

/// A function of shaders/lib: its GLSL expression, its C++ twin, where it is compared and how closely.
struct FunctionCase {
  std::string name;
  std::string glsl;
  std::function<glm::vec4(const glm::vec4&)> cpp;
  glm::vec4 low;
  glm::vec4 high;
  int steps;
  float tolerance; ///< relative to the larger of 1e-3 of the largest result and the result
};

glm::vec4 scalar(float x) { return {x, 0.0F, 0.0F, 0.0F}; }

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

std::vector<FunctionCase> function_cases() {
  std::vector<FunctionCase> cases{
      {"moon shadow",
       "vec4(moon_shadow_discs(v.xyz, MoonShadow(vec3(0.0, 0.6, 0.8), vec3(40.0, -8.0, 6.0), 3.6e5, 1738.1, 1.5e8, "
       "6.96e5)), 0)",
       [](const glm::vec4& v) {
         return glm::vec4(
             f32::moon_shadow_discs(glm::vec3(v),
                                    {{0.0F, 0.6F, 0.8F}, {40.0F, -8.0F, 6.0F}, 3.6e5F, 1738.1F, 1.5e8F, 6.96e5F}),
             0.0F);
       },
       {-900, -900, 0, 0},
       {900, 900, 60, 0},
       12,
       1.0e-4F},
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
      {"psf_sigma and psf_cut",
       "vec4(psf_sigma(exp2(v.x)), psf_cut(exp2(v.x)), 0, 0)",
       [](const glm::vec4& v) {
         const float lux = std::exp2(v.x);
         return glm::vec4(f32::psf_sigma(lux), f32::psf_cut(lux), 0, 0);
       },
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
      {"airglow_paths",
       "vec4(airglow_paths(v.x, v.y, 6371.0), 0, 0)",
       [](const glm::vec4& v) { return glm::vec4(f32::airglow_paths(v.x, v.y, 6371.0F), 0, 0); },
       {-1, 0, 0, 0},
       {1, 400, 0, 0},
       81,
       1.0e-3F},
      {"zodiacal light and faint stars",
       "vec4(zodiacal_place(normalize(v.xyz)), log2(dust_law(normalize(v.xyz))), starlight_s10(normalize(v.xyz)))",
       [](const glm::vec4& v) {
         const glm::vec3 at = glm::normalize(glm::vec3(v));
         return glm::vec4(f32::zodiacal_place(at), std::log2(f32::dust_law(at)), f32::starlight_s10(at));
       },
       {-1, -0.9F, -0.8F, 0},
       {1, 1, 1, 0},
       22,
       1.0e-4F},
      {"phase functions",
       "vec4(rayleigh_phase(v.x, v.z), henyey_greenstein_phase(v.x, v.y), cornette_shanks_phase(v.x, v.y), "
       "schlick_phase(v.x, v.y))",
       [](const glm::vec4& v) {
         return glm::vec4(f32::rayleigh_phase(v.x, v.z), f32::henyey_greenstein_phase(v.x, v.y),
                          f32::cornette_shanks_phase(v.x, v.y), f32::schlick_phase(v.x, v.y));
       },
       {-1, -0.99F, 0, 0},
       {1, 0.99F, 0.8F, 0},
       41,
       1.0e-4F},
      {"scintillation",
       "scintillation(uint(v.x), double(v.y), v.z, v.w, 0.007)",
       [](const glm::vec4& v) { return f32::scintillation(static_cast<unsigned>(v.x), v.y, v.z, v.w, 0.007F); },
       {1, 0, 0.02F, 0},
       {9000, 0.9F, 1, 0.1F},
       8,
       2.0e-3F},
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
      {"disc_covered",
       "vec4(disc_covered(1.0, v.x, v.y), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::disc_covered(1.0F, v.x, v.y)); },
       {0.05F, 0, 0, 0},
       {4, 5, 0, 0},
       61,
       2.0e-4F},
      {"lunar laws",
       "vec4(lunar_law(v.x).seeliger, lunar_law(v.x).lambert, cheap_lunar_law(v.x).seeliger, lunar_phase(v.x))",
       [](const glm::vec4& v) {
         const f32::LunarLaw law = f32::lunar_law(v.x);
         return glm::vec4(law.seeliger, law.lambert, f32::cheap_lunar_law(v.x).seeliger, f32::lunar_phase(v.x));
       },
       {0, 0, 0, 0},
       {180, 0, 0, 0},
       721,
       2.0e-4F},
      {"lunar_relief_reflectance",
       "vec4(lunar_relief_reflectance(normalize(vec3(1.0, v.x, v.y)), normalize(vec3(1.0, v.y, v.z)), vec3(1.0, 0.0, "
       "0.0),"
       " normalize(vec3(v.z, 1.0, v.x)), 0.00465, LunarLaw(0.3, 0.2)), 0, 0, 0)",
       [](const glm::vec4& v) {
         return scalar(f32::lunar_relief_reflectance(
             glm::normalize(glm::vec3(1.0F, v.x, v.y)), glm::normalize(glm::vec3(1.0F, v.y, v.z)), {1.0F, 0.0F, 0.0F},
             glm::normalize(glm::vec3(v.z, 1.0F, v.x)), 0.00465F, {0.3F, 0.2F}));
       },
       {-3, -3, -3, 0},
       {3, 3, 3, 0},
       17,
       1.0e-4F},
      // 5e-5 of full sunlight: GLSL's atan and asin are good to some 2e-7 rad of the Sun's 0.0093.
      {"earth_shadow_sunlight",
       "vec4(earth_shadow_sunlight(v.xyz, EarthShadow(vec3(0.0, 0.0, 1.0), 1.496e8, 695990.0, 6441.9)), 0, 0, 0)",
       [](const glm::vec4& v) {
         return scalar(f32::earth_shadow_sunlight(glm::vec3(v),
                                                  f32::EarthShadow{{0.0F, 0.0F, 1.0F}, 1.496e8F, 695990.0F, 6441.9F}));
       },
       {0, 0, 3.6e5F, 0},
       {9000, 2000, 4.1e5F, 0},
       25,
       5.0e-2F},
      {"lunar_eclipse_colors",
       "lunar_eclipse_colors(lunar_eclipse_phase(v.xy, EarthShadow(vec3(0.0, 0.0, 1.0), 1.496e8, 695990.0, 6441.9)))",
       [](const glm::vec4& v) {
         const f32::EarthShadow shadow{{0.0F, 0.0F, 1.0F}, 1.496e8F, 695990.0F, 6441.9F};
         return f32::lunar_eclipse_colors(f32::lunar_eclipse_phase(glm::vec2(v), shadow));
       },
       {0, 3.6e5F, 0, 0},
       {9000, 4.1e5F, 0, 0},
       25,
       1.0e-3F},
      {"lunar_eclipse_texel",
       "vec4(lunar_eclipse_texel(v.xy, EarthShadow(vec3(0.0, 0.0, 1.0), 1.496e8, 695990.0, 6441.9), "
       "LunarEclipseMap(80, 64, 2, 3.8e5, 1.0e-4, 6436.0, 6491.0, 250.0)), 0, 0)",
       [](const glm::vec4& v) {
         const f32::EarthShadow shadow{{0.0F, 0.0F, 1.0F}, 1.496e8F, 695990.0F, 6441.9F};
         const f32::LunarEclipseMap map{80, 64, 2, 3.8e5F, 1.0e-4F, 6436.0F, 6491.0F, 250.0F};
         return glm::vec4(f32::lunar_eclipse_texel(glm::vec2(v), shadow, map), 0, 0);
       },
       {0, 3.6e5F, 0, 0},
       {9000, 4.1e5F, 0, 0},
       25,
       1.0e-3F},
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
      {"plain_exposure",
       "vec4(plain_exposure(v.xyz, 1.0e-3), 0)",
       [](const glm::vec4& v) { return glm::vec4(f32::plain_exposure(glm::vec3(v), 1.0e-3F), 0); },
       {0, 0, 0, 0},
       {2.0e-3F, 2.0e-3F, 2.0e-3F, 0},
       12,
       1.0e-4F},
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
  }
  return cases;
}

using ShaderMathGpu = RenderTest;

TEST_F(ShaderMathGpu, EachFunctionAgreesWithItsTwin) {
  for (const FunctionCase& function : function_cases()) {
    SCOPED_TRACE(function.name);
    const Inputs inputs = grid(function.low, function.high, function.steps);
    const std::vector<glm::vec4> results = evaluate_on_gpu(function.glsl, inputs);
    std::vector<glm::vec4> expected;
    float largest = 0.0F;
    for (const glm::vec4& input : inputs) {
      expected.push_back(function.cpp(input));
      for (int c = 0; c < 4; ++c) {
        largest = std::max(largest, std::abs(expected.back()[c]));
      }
    }
    ASSERT_GT(largest, 0.0F);
    float worst = 0.0F;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (int c = 0; c < 4; ++c) {
        const float scale = std::max(std::abs(expected[i][c]), 1.0e-3F * largest);
        const float error = std::abs(results[i][c] - expected[i][c]) / scale;
        ASSERT_TRUE(std::isfinite(results[i][c])) << "input " << i;
        worst = std::max(worst, error);
      }
    }
    std::printf("%-38s worst relative difference %.1e over %zu points\n", function.name.c_str(),
                static_cast<double>(worst), inputs.size());
    EXPECT_LE(worst, function.tolerance);
  }
}

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

TEST_F(ShaderMathGpu, RefractionAgreesWithItsTwin) {
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

TEST_F(ShaderMathGpu, ExtinctionOfStarsAgreesWithItsTwin) {
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
