#include "vesper/gpu/sun_pass.hpp"

#include <array>
#include <cstddef>
#include <epoxy/gl.h>
#include <span>
#include <string>
#include <vector>

namespace vesper::gpu {
namespace {

/// shaders/sun_block.glsl in std140, which SunShading keeps to.
struct SunBlock {
  f32::SunShading shading;
  f32::vec4 moon;
  f32::vec4 turn;
};
static_assert(offsetof(SunBlock, moon) == sizeof(f32::SunShading) && sizeof(f32::SunShading) % 16 == 0 &&
              sizeof(SunBlock) == sizeof(f32::SunShading) + 32);

} // namespace

SunPass::SunPass(const ShaderLibrary& library)
    : disc_(library, "sun.frag"), uniforms_(make_dynamic_buffer(sizeof(SunBlock))) {}

void SunPass::prepare(const SkyState& sky, const View& view, const FramePlan& plan) {
  const PlannedSun& sun = *plan.sun;
  disc_.prepare(sun.picture, sky, view, plan,
                sun.corona ? std::vector<std::string>{"CORONA"} : std::vector<std::string>{});
  const SunBlock block{in_single(sun.disc.shading), f32::vec4(sun.moon), f32::vec4(sun.turn)};
  update_buffer(uniforms_, std::as_bytes(std::span(&block, 1)));
}

void SunPass::draw(const Strip& strip) {
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms_.name());
  disc_.draw(strip);
}

void SunPass::hide(const Strip& strip) {
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms_.name());
  disc_.hide(strip);
}

} // namespace vesper::gpu
