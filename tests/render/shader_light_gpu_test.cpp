// The same for the light of Moon, shadows and dark sky.
#include "render/shader_harness.hpp"

#include <cmath>
#include <fmt/format.h>

namespace vesper::test {
namespace {

using ShaderLightGpu = RenderTest;

TEST_F(ShaderLightGpu, EachFunctionAgreesWithItsTwin) {
  expect_twins({
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
      {"airglow_paths",
       "vec4(airglow_paths(v.x, v.y, 6371.0), 0, 0)",
       [](const glm::vec4& v) { return glm::vec4(f32::airglow_paths(v.x, v.y, 6371.0F), 0, 0); },
       {-1, 0, 0, 0},
       {1, 400, 0, 0},
       81,
       1.0e-3F},
      {"zodiacal light and the Milky Way's level",
       "vec4(zodiacal_place(normalize(v.xyz)), log2_dust_law(normalize(v.xyz)), cube_level(exp2(v.x), 256.0))",
       [](const glm::vec4& v) {
         const glm::vec3 at = glm::normalize(glm::vec3(v));
         return glm::vec4(f32::zodiacal_place(at), f32::log2_dust_law(at), f32::cube_level(std::exp2(v.x), 256.0F));
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
      {"disc_covered",
       "vec4(disc_covered(1.0, v.x, v.y), 0, 0, 0)",
       [](const glm::vec4& v) { return scalar(f32::disc_covered(1.0F, v.x, v.y)); },
       {0.05F, 0, 0, 0},
       {4, 5, 0, 0},
       61,
       2.0e-4F},
      {"disc_lit_arc",
       fmt::format("vec4({0}.middle + {0}.radius * sin({0}.start), {0}.middle + {0}.radius * sin({0}.end), 0, 0)",
                   "disc_lit_arc(v.xy, vec2(0.11, 0.04), vec3(sin(v.z), 0.0, -cos(v.z)), 0.06)"),
       [](const glm::vec4& v) {
         const f32::DiscArc arc =
             f32::disc_lit_arc(glm::vec2(v), {0.11F, 0.04F}, {std::sin(v.z), 0.0F, -std::cos(v.z)}, 0.06F);
         return glm::vec4(arc.middle + arc.radius * std::sin(arc.start), arc.middle + arc.radius * std::sin(arc.end), 0,
                          0);
       },
       {-1.013F, -0.987F, 1.7123F, 0},
       {0.991F, 1.017F, 3.0917F, 0},
       18,
       5.0e-3F},
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
  });
}

} // namespace
} // namespace vesper::test
