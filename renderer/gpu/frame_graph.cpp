#include "vesper/gpu/frame_graph.hpp"

#include "vesper/gpu/objects.hpp"

#include <algorithm>
#include <chrono>

namespace vesper::gpu {

void FrameGraph::add(std::string name, std::function<void(const Strip&)> execute) {
  passes_.push_back({std::move(name), std::move(execute)});
}

void FrameGraph::run(const Strip& strip, std::vector<PassTiming>* timings) const {
  for (const Pass& pass : passes_) {
    timed(pass.name, timings, [&] { pass.execute(strip); });
    require_no_error(pass.name.c_str());
  }
}

void timed(const std::string& name, std::vector<PassTiming>* timings, const std::function<void()>& work) {
  if (timings == nullptr) {
    work();
    return;
  }
  finish();
  const auto start = std::chrono::steady_clock::now();
  work();
  finish();
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  const auto found =
      std::find_if(timings->begin(), timings->end(), [&](const PassTiming& timing) { return timing.name == name; });
  if (found == timings->end()) {
    timings->push_back({name, elapsed.count()});
  } else {
    found->milliseconds += elapsed.count();
  }
}

} // namespace vesper::gpu
