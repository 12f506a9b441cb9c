#include "vesper/light/lunar_surface.hpp"

#include "vesper/light/checked_geometry.hpp"

namespace vesper {

f64::LunarLaw lunar_law(Angle phase_angle, LunarSurface surface) {
  const double degrees = checked_phase_degrees("the Moon's", phase_angle);
  return surface == LunarSurface::cheap ? f64::cheap_lunar_law(degrees) : f64::lunar_law(degrees);
}

} // namespace vesper
