// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Random choices that are the same everywhere: the distributions of `<random>` differ between standard
/// libraries.

#include <cstdint>

namespace tetrarch {

/// Source: Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (2014).
class SplitMix64 {
public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// 0 .. bound-1 for a positive bound; the bias is below bound / 2^32.
  int below(int bound) {
    return static_cast<int>(((next() >> 32U) * static_cast<std::uint64_t>(bound)) >> 32U);
  }
  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

private:
  std::uint64_t state_;
};

} // namespace tetrarch
