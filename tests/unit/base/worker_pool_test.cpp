#include "vesper/base/worker_pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace vesper {
namespace {

constexpr unsigned thread_counts[] = {0, 1, 2, 3, 8, 33};

// A sum whose result depends on the order of addition: terms of both signs over twelve decades.
double sum_by_chunks(std::size_t count, std::size_t chunk_size, unsigned threads) {
  std::vector<double> partial((count + chunk_size - 1) / chunk_size);
  parallel_for(
      count, chunk_size,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
          const auto x = static_cast<double>(i);
          sum += std::sin(x) * std::pow(10.0, std::fmod(x, 12.0));
        }
        partial[begin / chunk_size] = sum;
      },
      threads);
  double total = 0.0;
  for (const double sum : partial) {
    total += sum;
  }
  return total;
}

TEST(WorkerPool, ReductionIsTheSameToTheLastBitForAnyNumberOfThreads) {
  const double one_thread = sum_by_chunks(100'003, 97, 1);
  for (const unsigned threads : thread_counts) {
    for (int repeat = 0; repeat < 5; ++repeat) {
      EXPECT_EQ(sum_by_chunks(100'003, 97, threads), one_thread) << threads << " threads";
    }
  }
}

TEST(WorkerPool, CallsEachIndexOnceInChunksOfTheGivenSize) {
  for (const unsigned threads : thread_counts) {
    for (const std::size_t count : {1U, 9U, 10U, 11U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      std::mutex mutex;
      std::set<std::pair<std::size_t, std::size_t>> chunks;
      parallel_for(
          count, 10,
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
              ++calls[i];
            }
            const std::scoped_lock lock(mutex);
            chunks.emplace(begin, end);
          },
          threads);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(calls[i], 1) << "index " << i << " of " << count << ", " << threads << " threads";
      }
      ASSERT_EQ(chunks.size(), (count + 9) / 10);
      std::size_t expected_begin = 0;
      for (const auto& [begin, end] : chunks) {
        EXPECT_EQ(begin, expected_begin);
        EXPECT_EQ(end, std::min(begin + 10, count));
        expected_begin = end;
      }
    }
  }
}

TEST(WorkerPool, AChunkLargerThanTheRangeIsOneCall) {
  for (const std::size_t chunk_size : {std::size_t{11}, std::numeric_limits<std::size_t>::max()}) {
    int calls = 0;
    parallel_for(10, chunk_size, [&](std::size_t begin, std::size_t end) {
      ++calls;
      EXPECT_EQ(begin, 0U);
      EXPECT_EQ(end, 10U);
    });
    EXPECT_EQ(calls, 1);
  }
}

TEST(WorkerPool, NothingToDoMakesNoCall) {
  parallel_for(0, 10, [](std::size_t, std::size_t) { FAIL() << "called for an empty range"; });
}

TEST(WorkerPool, WorksInSeveralThreads) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  parallel_for(
      64, 1,
      [&](std::size_t, std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        const std::scoped_lock lock(mutex);
        ids.insert(std::this_thread::get_id());
      },
      4);
  EXPECT_GT(ids.size(), 1U);
  EXPECT_LE(ids.size(), 4U);
}

TEST(WorkerPool, RethrowsTheExceptionThatOneThreadWouldHaveMet) {
  for (const unsigned threads : thread_counts) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      try {
        // Later chunks fail at once, the first failing one late: order of arrival and order of chunks differ.
        parallel_for(
            40, 10,
            [](std::size_t begin, std::size_t) {
              if (begin == 10) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
              }
              if (begin >= 10) {
                throw std::runtime_error("chunk at " + std::to_string(begin));
              }
            },
            threads);
        FAIL() << "no exception";
      } catch (const std::runtime_error& error) {
        ASSERT_STREQ(error.what(), "chunk at 10") << threads << " threads";
      }
    }
  }
}

TEST(WorkerPool, StopsHandingOutWorkAfterAFailure) {
  std::atomic<int> calls = 0;
  const auto work = [&](std::size_t, std::size_t) {
    ++calls;
    throw std::runtime_error("at once");
  };
  EXPECT_THROW(parallel_for(100'000, 1, work, 2), std::runtime_error);
  EXPECT_LE(calls, 2);
}

} // namespace
} // namespace vesper
