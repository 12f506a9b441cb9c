// The passes of a frame, in the order in which their light adds up.
#pragma once

#include "vesper/gpu/frame.hpp"

#include <functional>
#include <string>
#include <vector>

namespace vesper::gpu {

class FrameGraph {
public:
  /// Appends a pass. It is called once per strip, with the frame's framebuffer bound and its viewport set.
  void add(std::string name, std::function<void(const Strip&)> execute);

  /// Runs all passes on a strip. With `timings`, waits for the GPU after each pass and adds its wall-clock time there.
  void run(const Strip& strip, std::vector<PassTiming>* timings) const;

private:
  struct Pass {
    std::string name;
    std::function<void(const Strip&)> execute;
  };
  std::vector<Pass> passes_;
};

/// Runs `work`; with `timings`, waits for the GPU before and after and adds the time under `name`.
void timed(const std::string& name, std::vector<PassTiming>* timings, const std::function<void()>& work);

} // namespace vesper::gpu
