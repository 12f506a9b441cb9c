// The Moon's surface as a reflector; the laws themselves stand in shaders/lib/moon_surface.glsl.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"

namespace vesper {

/// Geometric albedo of the Moon in V without the opposition surge, and the projected mean over the near side of the
/// normal albedo that maps hold: 10^(-0.4 (-12.73 + 26.75)) (384400 / 1737.4)^2, from the magnitudes of full Moon and
/// Sun at mean distances.
inline constexpr double lunar_geometric_albedo = 0.1207;

/// How the surface shares out light: cheap is Hapke, Lommel and Seeliger's law with the B and S of Jensen et al. 2001,
/// standard McEwen's lunar-Lambert law with the measured phase law for its gain.
enum class LunarSurface { cheap, standard };

/// The law at a phase angle. For an even sphere of albedo 1 the standard one has the light of the phase law
/// (moon_v_magnitude) to 150 degrees; beyond it stays as it is there and the sphere darkens to 0 at 180.
/// \param phase_angle light-surface-observer, 0 to 180 degrees. Throws Error(argument) otherwise.
[[nodiscard]] f64::LunarLaw lunar_law(Angle phase_angle, LunarSurface surface = LunarSurface::standard);

} // namespace vesper
