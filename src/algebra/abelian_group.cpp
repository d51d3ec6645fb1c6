// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/abelian_group.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>

namespace tetrarch::algebra {

AbelianGroup::AbelianGroup(int rank, std::vector<Integer> orders) : rank_(rank) {
  if (rank < 0) throw PreconditionError("an abelian group cannot have rank " + std::to_string(rank));
  for (const Integer& order : orders)
    if (order < 1) throw PreconditionError("a finite cyclic group cannot have order " + order.str());
  torsion_ = invariant_factors(std::move(orders));
}

std::string AbelianGroup::str() const {
  std::string text;
  if (rank_ > 0) text = rank_ == 1 ? "Z" : "Z^" + std::to_string(rank_);
  for (const Integer& factor : torsion_) text += (text.empty() ? "Z/" : " + Z/") + factor.str();
  return text.empty() ? "0" : text;
}

std::vector<Integer> invariant_factors(std::vector<Integer> orders) {
  std::erase(orders, 1);
  std::sort(orders.begin(), orders.end());
  // Once the gcd of everything from i on stands at i, later rounds keep it there.
  for (std::size_t i = 0; i < orders.size(); ++i) {
    for (std::size_t j = i + 1; j < orders.size(); ++j) {
      if (orders[j] % orders[i] == 0) continue;
      Integer common;
      eval_gcd(common.backend(), orders[i].backend(), orders[j].backend());
      orders[j] = orders[i] / common * orders[j];
      orders[i] = common;
    }
  }
  std::erase(orders, 1);
  return orders;
}

} // namespace tetrarch::algebra
