#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vesper {

void parallel_for(std::size_t count, std::size_t chunk_size,
                  const std::function<void(std::size_t begin, std::size_t end)>& work, unsigned threads) {
  const std::size_t size = std::max<std::size_t>(chunk_size, 1);
  const std::size_t chunks = count / size + (count % size != 0 ? 1 : 0);
  if (threads == 0) {
    threads = std::max(1U, std::thread::hardware_concurrency());
  }
  const std::size_t workers = std::min<std::size_t>(threads, chunks);

  std::atomic<std::size_t> next{0};
  std::mutex failure_mutex;
  std::exception_ptr failure;
  // Chunks are handed out in order, and those before the first failure still run: the exception that a caller sees is
  // the one that a single thread would have met.
  std::atomic<std::size_t> first_failed{chunks};
  const auto run = [&] {
    for (std::size_t chunk = next++; chunk < first_failed; chunk = next++) {
      try {
        const std::size_t begin = chunk * size;
        work(begin, begin + std::min(size, count - begin));
      } catch (...) {
        const std::scoped_lock lock(failure_mutex);
        if (chunk < first_failed) {
          first_failed = chunk;
          failure = std::current_exception();
        }
      }
    }
  };
  std::vector<std::jthread> pool;
  for (std::size_t i = 1; i < workers; ++i) {
    pool.emplace_back(run);
  }
  run();
  pool.clear();
  if (failure) {
    std::rethrow_exception(failure);
  }
}

} // namespace vesper
