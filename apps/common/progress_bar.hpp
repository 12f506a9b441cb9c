#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace vesper {

/// How far long work has come, as a line on standard error that it draws over and takes away at the end. Silent where
/// standard error is no terminal, under --quiet, and for work that ends within a second. Any thread may advance it.
class ProgressBar {
public:
  /// \param total of units of work, at least 1
  ProgressBar(std::string label, std::size_t total);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void advance(std::size_t units);

private:
  using Clock = std::chrono::steady_clock;
  void draw(std::size_t done, double seconds) const;

  std::string label_;
  std::size_t total_;
  bool visible_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::size_t> done_{0};
  std::mutex drawing_;
  Clock::time_point last_draw_ = start_;
  bool drawn_ = false;
};

} // namespace vesper
