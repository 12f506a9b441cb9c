// What benchmarks of passes measure by.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"

#include <algorithm>
#include <ctime>
#include <functional>
#include <string_view>
#include <vector>

namespace vesper::bench {

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Wall-clock milliseconds of a pass as the frame graph timed it; 0 where it was not drawn.
inline double pass_ms(const gpu::Frame& frame, std::string_view pass) {
  for (const gpu::PassTiming& timing : frame.timings) {
    if (timing.name == pass) {
      return timing.milliseconds;
    }
  }
  return 0.0;
}

/// Milliseconds of all processors together, which is what a software driver costs; on a GPU they say nothing.
inline double processor_ms(const std::function<void()>& work) {
  gpu::finish();
  const std::clock_t start = std::clock();
  work();
  gpu::finish();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

} // namespace vesper::bench
