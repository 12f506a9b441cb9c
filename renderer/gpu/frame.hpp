// A rendered frame on the CPU.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vesper::gpu {

/// Wall-clock time of one pass, all strips together.
struct PassTiming {
  std::string name;
  double milliseconds = 0.0;
};

/// The frame in absolute units and the pixels a display mapping made of it. Row 0 is on top.
struct Frame {
  int width = 0;
  int height = 0;
  /// X, Y, Z (CIE 1931, Y in cd/m2) and S (scotopic cd/m2) of each pixel; empty unless asked for.
  std::vector<float> xyzs;
  /// The display's code values, alpha at its largest; empty unless asked for in this depth.
  std::vector<std::uint8_t> rgba;
  std::vector<std::uint16_t> rgba16;
  std::vector<PassTiming> timings;

  /// The four values of a pixel. Unchecked.
  [[nodiscard]] const float* pixel(int column, int row) const {
    return &xyzs[4 *
                 (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column))];
  }
};

/// The rows of a picture that the framebuffer holds at a time.
struct Strip {
  int first_row = 0;
  int rows = 0;
};

} // namespace vesper::gpu
