// What the air takes from starlight, in the form that the cheap tier draws with.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// The wavelengths whose optical depths stand for X (its red lobe), Y, Z and S when starlight is dimmed
/// (modulate_xyzs in shaders/lib/extinction.glsl).
inline constexpr Vec4 star_wavelengths_nm{600.0, 555.0, 450.0, 507.0};

/// Optical depths of one zenith column of sea level, at `star_wavelengths_nm`, in the shell of 8 km scale height that
/// stands for the medium in shaders/lib/extinction.glsl (optical_path): they are scaled so that at the observer's
/// zenith the shell is as thick as the medium above the observer. Away from it the shell is within 0.005 magnitudes of
/// straight rays through clear air above 20 degrees, 0.03 above 10, 0.2 above 5; at the horizon it lacks 3 of 12.
/// \param height of the observer above the ground, to 1000 km within the air and any outside; below the ground the
/// shell goes on as its scale height tells
[[nodiscard]] Vec4 star_optical_depth_xyzs(const Medium& medium, Length height);

} // namespace vesper
