// The shape of the corona.
#pragma once

#include "vesper/base/shader_math.hpp"

#include <array>
#include <cstdint>

namespace vesper {

/// Streamers for f64::SunShading: six with feet spread along the equator at a minimum of the Sun's activity and all
/// around it at a maximum, together 0.6 of the electrons' light on every circle about the Sun. Their light is taken
/// from between them, so that they change no circle's.
/// \param activity 0 to 1. Throws Error(argument) otherwise.
/// \param seed another one, others
[[nodiscard]] std::array<f64::vec4, f64::sun_streamers> corona_streamers(double activity, std::uint32_t seed);

} // namespace vesper
