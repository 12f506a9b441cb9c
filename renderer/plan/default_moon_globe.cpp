#include "vesper/plan/planned_disc.hpp"

namespace vesper {

std::shared_ptr<const MoonGlobe> default_moon_globe() {
  static const std::shared_ptr<const MoonGlobe> globe = make_moon_globe(default_moon_map());
  return globe;
}

} // namespace vesper
