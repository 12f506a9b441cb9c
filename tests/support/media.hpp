// Media to try methods on.
#pragma once

#include "vesper/atmosphere/medium.hpp"

namespace vesper::test {

/// The medium with all its coefficients times a factor.
inline Medium scaled(Medium medium, double factor) {
  for (MediumComponent& part : medium.components) {
    for (WavelengthLaw* law : {&part.scattering_per_km, &part.absorption_per_km}) {
      *law = [old = *law, factor](double nm) { return factor * old(nm); };
    }
  }
  return medium;
}

} // namespace vesper::test
