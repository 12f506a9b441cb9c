// Work on the CPU in parallel, with results that do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace vesper {

/// Calls `work(begin, end)` for consecutive chunks of [0, count), from several threads, each index once. Chunk borders
/// depend on `count` and `chunk_size` only, so a reduction per chunk, joined in chunk order, is the same on any
/// machine. The first exception by chunk order is rethrown after all threads have stopped.
///
/// \param chunk_size indices a call gets, at least 1
/// \param threads    0 for one per core
void parallel_for(std::size_t count, std::size_t chunk_size,
                  const std::function<void(std::size_t begin, std::size_t end)>& work, unsigned threads = 0);

} // namespace vesper
