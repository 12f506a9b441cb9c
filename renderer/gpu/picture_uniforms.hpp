// What every pass over all pixels tells its fragment stage: locations 0 to 3 of ground.frag and sky.frag.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"

namespace vesper::gpu {

/// horizon_from_view, size and focal length of the picture, and the sine of the horizon's altitude.
void set_picture(const ProgramHandle& program, const View& view, const FramePlan& plan);

/// The rows that the framebuffer holds: location 4.
void set_strip(const ProgramHandle& program, const Strip& strip);

/// Tiles for a stage that includes shaders/tiles.glsl: location 12. Returns their number.
/// \param pixels of a tile's sides, at least
int set_tiles(const ProgramHandle& program, const View& view, int pixels);

} // namespace vesper::gpu
