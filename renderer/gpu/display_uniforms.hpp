// The display for the stages that write its code values.
#pragma once

#include "vesper/gpu/objects.hpp"
#include "vesper/plan/display.hpp"

namespace vesper::gpu {

/// Sets `layout(location = first_location) uniform DisplayModel display;`, which takes eight locations.
void set_display(const ProgramHandle& program, int first_location, const f64::DisplayModel& display);

} // namespace vesper::gpu
