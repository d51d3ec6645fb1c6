// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A number that two presentations of one group share, and others rarely.

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/perm4.hpp"

#include <array>
#include <vector>

namespace tetrarch::support {

/// How many homomorphisms lead to the symmetric group on four letters: an invariant of the group. By trying
/// all images of the generators; 24^generators, so up to four of them.
inline long long homomorphisms_to_s4(const algebra::Presentation& group) {
  const auto maps_to_one = [](const algebra::Word& word, const std::vector<Perm4>& image) {
    Perm4 p;
    for (const int letter : word) {
      const Perm4 g = image[static_cast<std::size_t>(letter > 0 ? letter - 1 : -letter - 1)];
      p = p * (letter > 0 ? g : g.inverse());
    }
    return p == Perm4();
  };
  long long tuples = 1;
  for (int g = 0; g < group.generators; ++g) tuples *= Perm4::count;
  long long count = 0;
  std::vector<Perm4> image(static_cast<std::size_t>(group.generators));
  for (long long tuple = 0; tuple < tuples; ++tuple) {
    long long rest = tuple;
    for (Perm4& p : image) {
      p = Perm4::from_rank(static_cast<int>(rest % Perm4::count));
      rest /= Perm4::count;
    }
    bool all = true;
    for (const algebra::Word& relator : group.relators) all = all && maps_to_one(relator, image);
    count += all ? 1 : 0;
  }
  return count;
}

} // namespace tetrarch::support
