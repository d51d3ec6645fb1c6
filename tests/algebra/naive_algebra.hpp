// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Second routes for the algebra tests: slow, short, and sharing nothing with the library but its types.

#include "support/random.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/algebra/smith.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace tetrarch::naive {

using algebra::Integer;
using Dense = std::vector<std::vector<Integer>>;

inline algebra::SparseMatrix sparse(const Dense& m) {
  algebra::SparseMatrix out(static_cast<int>(m.size()), m.empty() ? 0 : static_cast<int>(m[0].size()));
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < m[i].size(); ++j)
      if (m[i][j] != 0) out.add(static_cast<int>(i), static_cast<int>(j), m[i][j]);
  return out;
}

/// The determinant by expansion along the first row.
inline Integer determinant(const Dense& m) {
  if (m.empty()) return 1;
  Integer sum = 0;
  for (std::size_t j = 0; j < m.size(); ++j) {
    Dense minor;
    for (std::size_t i = 1; i < m.size(); ++i) {
      minor.push_back(m[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
    }
    sum += (j % 2 == 0 ? 1 : -1) * m[0][j] * determinant(minor);
  }
  return sum;
}

/// All k-element subsets of 0 .. n-1, as masks.
inline std::vector<unsigned> subsets(std::size_t n, int k) {
  std::vector<unsigned> masks;
  for (unsigned mask = 0; mask < (1U << n); ++mask)
    if (__builtin_popcount(mask) == k) masks.push_back(mask);
  return masks;
}

/// The Smith form from its definition by determinantal divisors: the product of the first k invariant factors
/// is the greatest common divisor of all k x k minors.
inline algebra::SmithForm smith_by_minors(const Dense& m) {
  algebra::SmithForm form;
  Integer before = 1;
  const std::size_t width = m[0].size();
  for (int k = 1; k <= static_cast<int>(std::min(m.size(), width)); ++k) {
    Integer divisor = 0;
    for (const unsigned rows : subsets(m.size(), k))
      for (const unsigned columns : subsets(width, k)) {
        Dense minor;
        for (std::size_t i = 0; i < m.size(); ++i) {
          if (((rows >> i) & 1U) == 0) continue;
          minor.emplace_back();
          for (std::size_t j = 0; j < width; ++j)
            if (((columns >> j) & 1U) != 0) minor.back().push_back(m[i][j]);
        }
        divisor = gcd(divisor, determinant(minor));
      }
    if (divisor == 0) break;
    const Integer factor = divisor / before;
    if (factor == 1)
      ++form.units;
    else
      form.factors.push_back(factor);
    before = divisor;
  }
  return form;
}

/// The textbook algorithm on a dense matrix: bring the smallest entry to the corner, reduce its row and
/// column, repeat until the corner divides everything, and go on with the rest.
inline algebra::SmithForm smith_dense(Dense m) {
  algebra::SmithForm form;
  const std::size_t height = m.size();
  const std::size_t width = m.empty() ? 0 : m[0].size();
  for (std::size_t c = 0; c < std::min(height, width); ++c) {
    while (true) {
      std::size_t row = height;
      std::size_t column = 0;
      for (std::size_t i = c; i < height; ++i)
        for (std::size_t j = c; j < width; ++j)
          if (m[i][j] != 0 && (row == height || abs(m[i][j]) < abs(m[row][column]))) row = i, column = j;
      if (row == height) return form;
      std::swap(m[c], m[row]);
      for (auto& line : m) std::swap(line[c], line[column]);
      bool clean = true;
      for (std::size_t i = c + 1; i < height; ++i) {
        const Integer q = m[i][c] / m[c][c];
        for (std::size_t j = c; j < width; ++j) m[i][j] -= q * m[c][j];
        clean = clean && m[i][c] == 0;
      }
      for (std::size_t j = c + 1; j < width; ++j) {
        const Integer q = m[c][j] / m[c][c];
        for (std::size_t i = c; i < height; ++i) m[i][j] -= q * m[i][c];
        clean = clean && m[c][j] == 0;
      }
      if (!clean) continue;
      std::size_t odd = c + 1; // a row with an entry that the corner does not divide
      while (odd < height && std::all_of(m[odd].begin() + static_cast<std::ptrdiff_t>(c), m[odd].end(),
                                         [&](const Integer& x) { return x % m[c][c] == 0; }))
        ++odd;
      if (odd == height) break;
      for (std::size_t j = c; j < width; ++j) m[c][j] += m[odd][j];
    }
    if (abs(m[c][c]) == 1)
      ++form.units;
    else
      form.factors.push_back(abs(m[c][c]));
  }
  return form;
}

/// Arguments that are random themselves are to be drawn one by one beforehand: compilers evaluate arguments
/// in different orders.
inline Dense random_dense(int rows, int columns, int density_percent, const Integer& size,
                          support::Random& random) {
  Dense m(static_cast<std::size_t>(rows), std::vector<Integer>(static_cast<std::size_t>(columns), 0));
  for (auto& row : m)
    for (Integer& x : row)
      if (random.below(100) < density_percent) x = Integer(random.next()) % (2 * size + 1) - size;
  return m;
}

/// Homomorphisms of a group into the symmetric group of 0 .. points-1 (points <= 4).
struct Representations {
  long all = 0;
  long transitive_classes = 0; ///< transitive ones up to conjugation: connected covers with so many sheets
};

inline Perm4 image(const algebra::Word& word, const std::vector<Perm4>& of) {
  Perm4 p;
  for (const int letter : word) p = p * (letter > 0 ? of[letter - 1] : of[-letter - 1].inverse());
  return p;
}

inline Representations representations(const algebra::Presentation& group, int points) {
  std::vector<Perm4> symmetric;
  for (int rank = 0; rank < Perm4::count; ++rank) {
    const Perm4 p = Perm4::from_rank(rank);
    bool inside = true;
    for (int x = points; x < 4; ++x) inside = inside && p[x] == x;
    if (inside) symmetric.push_back(p);
  }
  Representations found;
  long weighted = 0; // an orbit under conjugation has points! / |centraliser| members
  std::vector<std::size_t> choice(static_cast<std::size_t>(group.generators), 0);
  std::vector<Perm4> of(choice.size());
  while (true) {
    for (std::size_t g = 0; g < of.size(); ++g) of[g] = symmetric[choice[g]];
    const bool holds = std::all_of(group.relators.begin(), group.relators.end(),
                                   [&](const algebra::Word& r) { return image(r, of) == Perm4(); });
    if (holds) {
      ++found.all;
      unsigned reached = 1;
      for (int round = 0; round < points; ++round)
        for (int x = 0; x < points; ++x)
          for (const Perm4 p : of)
            if (((reached >> static_cast<unsigned>(x)) & 1U) != 0)
              reached |= 1U << static_cast<unsigned>(p[x]);
      if (reached == (1U << static_cast<unsigned>(points)) - 1)
        weighted += std::count_if(symmetric.begin(), symmetric.end(), [&](Perm4 s) {
          return std::all_of(of.begin(), of.end(), [&](Perm4 p) { return p * s == s * p; });
        });
    }
    std::size_t at = 0;
    while (at < choice.size() && ++choice[at] == symmetric.size()) choice[at++] = 0;
    if (at == choice.size()) break;
  }
  found.transitive_classes = weighted / static_cast<long>(symmetric.size());
  return found;
}

} // namespace tetrarch::naive
