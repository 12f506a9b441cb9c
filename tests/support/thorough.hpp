// How much a test takes on.
#pragma once

#include <cstdlib>

namespace vesper::test {

/// Whether whole grids are asked for (`./run test --full`) in place of the reduced ones that fit into CI's time.
inline bool thorough() { return std::getenv("VESPER_TEST_FULL") != nullptr; }

} // namespace vesper::test
