#include "vesper/atmosphere/earth_shadow_load.hpp"

#include <cmath>

namespace vesper {

double share_past_clouds(const EarthShadowLoad& load, double height_km) {
  constexpr double width_km = 1.5;
  return 1.0 / (1.0 + std::exp((load.cloud_height_km - height_km) / width_km));
}

Medium with_stratospheric_dust(Medium medium) {
  // At the heights of clear air's; droplets of sulphuric acid as in OPAC (Hess et al. 1998, Bull. Am. Meteorol. Soc.
  // 79, 831).
  constexpr double from_km = 12.0;
  constexpr double peak_km = 20.0;
  constexpr double to_km = 35.0;
  constexpr double exponent = 0.95;
  constexpr double asymmetry = 0.72;
  medium.components.push_back({"dust of the stratosphere",
                               HeightProfile::tent(from_km, peak_km, to_km),
                               [](double nm) { return 2.0 / (to_km - from_km) * std::pow(nm / 550.0, -exponent); },
                               constant_law(0.0),
                               {PhaseKind::henyey_greenstein, constant_law(asymmetry)}});
  return medium;
}

} // namespace vesper
