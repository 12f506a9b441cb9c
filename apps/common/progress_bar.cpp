#include "common/progress_bar.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace vesper {
namespace {

constexpr double patience_s = 1.0;
constexpr auto between_draws = std::chrono::milliseconds(100);
constexpr std::size_t width = 30; // characters

} // namespace

ProgressBar::ProgressBar(std::string label, std::size_t total)
    : label_(std::move(label)), total_(std::max<std::size_t>(total, 1)),
      visible_(isatty(STDERR_FILENO) == 1 && spdlog::should_log(spdlog::level::info)) {}

ProgressBar::~ProgressBar() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr); // back to the start of the line, and wipe it
  }
}

void ProgressBar::advance(std::size_t units) {
  const std::size_t done = done_ += units;
  if (!visible_) {
    return;
  }
  const std::unique_lock lock(drawing_, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (lock.owns_lock() && seconds >= patience_s && now - last_draw_ >= between_draws) {
    draw(done, seconds);
    last_draw_ = now;
    drawn_ = true;
  }
}

void ProgressBar::draw(std::size_t done, double seconds) const {
  const double fraction = std::min(static_cast<double>(done) / static_cast<double>(total_), 1.0);
  const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(width));
  const double left_s = seconds * (1.0 - fraction) / std::max(fraction, 1e-9);
  fmt::print(stderr, "\r{} [{}{}] {:3.0f} %, {:.0f} s left \033[K", label_, std::string(filled, '='),
             std::string(width - filled, ' '), 100.0 * fraction, left_s);
  std::fflush(stderr);
}

} // namespace vesper
