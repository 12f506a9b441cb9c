// Functions of shaders/lib on the GPU, for tests that compare them with the same text compiled as C++.
#pragma once

#include "render/render_fixture.hpp"

#include <functional>
#include <string>
#include <vector>

namespace vesper::test {

using Inputs = std::vector<glm::vec4>;

/// Evaluates a GLSL expression of `vec4 v` for every input and returns the vec4 results.
/// The expression may read tables: of refraction, a sampler1D named `table`, and of a plan's extinction, a sampler2D
/// named `extinction_table`.
std::vector<glm::vec4> evaluate_on_gpu(const std::string& expression, const Inputs& inputs,
                                       const Refraction& refraction = {}, const FramePlan& plan = {});

/// Points of a grid over a box, `steps` along each axis that has an extent.
Inputs grid(const glm::vec4& low, const glm::vec4& high, int steps);

/// A function of shaders/lib: its GLSL expression, its C++ twin, where it is compared and how closely.
struct FunctionCase {
  std::string name;
  std::string glsl;
  std::function<glm::vec4(const glm::vec4&)> cpp;
  glm::vec4 low;
  glm::vec4 high;
  int steps;
  float tolerance; ///< relative to the larger of 1e-3 of the largest result and the result
};

inline glm::vec4 scalar(float x) { return {x, 0.0F, 0.0F, 0.0F}; }

/// Compares them and prints how far they differ.
void expect_twins(const std::vector<FunctionCase>& functions);

} // namespace vesper::test
