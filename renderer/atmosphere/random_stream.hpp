// Random numbers that depend on a seed and a place in a numbering, and on nothing else.
#pragma once

#include <cstdint>

namespace vesper {

/// The generator SplitMix64 (Steele, Lea and Flood 2014, OOPSLA, fig. 13) from a start that its own mixing spreads.
class RandomStream {
public:
  RandomStream(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
      : state_(mix(mix(mix(seed + step) ^ stream) + step) ^ index) {
    state_ = mix(state_ + step);
  }

  /// Uniform in [0, 1).
  double operator()() {
    state_ += step;
    return static_cast<double>(mix(state_) >> 11U) * 0x1.0p-53;
  }

  /// Spreads the bits of a number over all others.
  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;
  std::uint64_t state_;
};

} // namespace vesper
