// The light field's solution, by orders of scattering.
#pragma once

#include "vesper/atmosphere/light_gatherer.hpp"

#include <functional>

namespace vesper {

struct LightFieldSolution {
  LightFieldTables tables;
  int orders = 1;    ///< that were followed
  double rest = 1.0; ///< share of the light at a node by which the estimate of the later ones may be wrong
};

/// Iterates until the rest is small enough.
[[nodiscard]] LightFieldSolution solve_light_field(const LightFieldModel& model, LightGatherer& gatherer,
                                                   unsigned threads);

/// Any way to a model's solution: on the processor's cores, or on a GPU.
using LightFieldSolver = std::function<LightFieldSolution(const LightFieldModel& model)>;

} // namespace vesper
