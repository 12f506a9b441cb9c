#include "vesper/atmosphere/sky_tables_maker.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace vesper {
namespace {

/// Thrown out of a run that is given up.
struct Obsolete {};

SkyTables make_beside_others(const Medium& medium, const Progress& progress) {
  return make_sky_tables(medium, {}, std::max(1U, std::thread::hardware_concurrency() / 2), progress);
}

} // namespace

struct SkyTablesMaker::State {
  Make make;
  mutable std::mutex mutex;
  std::condition_variable asked;
  bool ends = false;
  std::uint64_t request = 0;                 ///< counts up
  std::shared_ptr<const Medium> medium;      ///< of the last request, until its run begins
  std::shared_ptr<const SkyTables> finished; ///< of the last request, until taken
  std::exception_ptr failure;                ///< likewise
  double share = 1.0;
  std::thread thread;

  void run();
};

void SkyTablesMaker::State::run() {
  std::unique_lock lock(mutex);
  for (;;) {
    asked.wait(lock, [this] { return ends || medium; });
    if (ends) {
      return;
    }
    const std::shared_ptr<const Medium> current = std::exchange(medium, nullptr);
    const std::uint64_t number = request;
    lock.unlock();
    std::shared_ptr<const SkyTables> made;
    std::exception_ptr failed;
    try {
      made = std::make_shared<const SkyTables>(make(*current, [this, number](double done) {
        const std::lock_guard reporting(mutex);
        if (ends || request != number) {
          throw Obsolete();
        }
        share = std::clamp(done, 0.0, 1.0);
      }));
    } catch (const Obsolete&) {
      // The next request waits already.
    } catch (...) {
      failed = std::current_exception();
    }
    lock.lock();
    if (request == number) {
      finished = std::move(made);
      failure = failed;
      share = 1.0;
    }
  }
}

SkyTablesMaker::SkyTablesMaker(Make make) : state_(std::make_unique<State>()) {
  state_->make = make ? std::move(make) : make_beside_others;
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

SkyTablesMaker::~SkyTablesMaker() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->ends = true;
  }
  state_->asked.notify_one();
  state_->thread.join();
}

void SkyTablesMaker::request(std::shared_ptr<const Medium> medium) {
  {
    const std::lock_guard lock(state_->mutex);
    ++state_->request;
    state_->medium = std::move(medium);
    state_->finished = nullptr;
    state_->failure = nullptr;
    state_->share = 0.0;
  }
  state_->asked.notify_one();
}

std::shared_ptr<const SkyTables> SkyTablesMaker::take() {
  const std::lock_guard lock(state_->mutex);
  if (state_->failure) {
    std::rethrow_exception(std::exchange(state_->failure, nullptr));
  }
  return std::exchange(state_->finished, nullptr);
}

double SkyTablesMaker::progress() const {
  const std::lock_guard lock(state_->mutex);
  return state_->share;
}

} // namespace vesper
