// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Exponents of words over a finite field.

#include "tetrarch/algebra/group.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace tetrarch::reasons {

/// Vectors over the field of `prime` elements, a prime below 40,000, and the space they span, by elimination.
class Span {
public:
  Span(int dimension, int prime) : dimension_(static_cast<std::size_t>(dimension)), prime_(prime) {}

  /// The exponents of a word.
  std::vector<int> vector_of(const algebra::Word& word) const {
    std::vector<int> v(dimension_, 0);
    for (const int letter : word) v[static_cast<std::size_t>(std::abs(letter) - 1)] += letter > 0 ? 1 : -1;
    for (int& x : v) x = (x % prime_ + prime_) % prime_;
    return v;
  }

  /// False if it lies in the span already.
  bool add(std::vector<int> v) {
    for (const auto& [pivot, row] : rows_) {
      const int times = v[pivot];
      for (std::size_t k = 0; k < dimension_; ++k)
        v[k] = ((v[k] - times * row[k]) % prime_ + prime_) % prime_;
    }
    const auto lead = std::find_if(v.begin(), v.end(), [](int x) { return x != 0; });
    if (lead == v.end()) return false;
    int inverse = 1;
    while (inverse * *lead % prime_ != 1) ++inverse;
    const auto pivot = static_cast<std::size_t>(lead - v.begin());
    for (int& x : v) x = x * inverse % prime_;
    rows_.emplace_back(pivot, std::move(v));
    return true;
  }

private:
  std::size_t dimension_;
  int prime_;
  std::vector<std::pair<std::size_t, std::vector<int>>> rows_;
};

} // namespace tetrarch::reasons
