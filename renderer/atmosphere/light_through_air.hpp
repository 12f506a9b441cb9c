// One light behind columns of air.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/spectrum.hpp"

#include <vector>

namespace vesper {

/// What extinction leaves of a light, integrated over its spectrum.
class LightThroughAir {
public:
  /// Throws Error(argument) for a light that is dark in one of X, Y, Z and S.
  LightThroughAir(const Medium& medium, const Spectrum& light);

  /// Shares of X, Y, Z and S that are left. \param columns_km of each component, as RefractedColumns gives them
  [[nodiscard]] Vec4 share(const std::vector<double>& columns_km) const;

private:
  std::vector<Vec4> weights_;                          ///< by nanometre; they sum to 1
  std::vector<std::vector<double>> extinction_per_km_; ///< by nanometre and component
};

} // namespace vesper
