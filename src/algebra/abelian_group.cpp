// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/torsion.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>

namespace tetrarch::algebra {

AbelianGroup::AbelianGroup(int rank) : rank_(rank) {
  if (rank < 0) throw PreconditionError("an abelian group cannot have rank " + std::to_string(rank));
}

AbelianGroup::AbelianGroup(int rank, Torsion orders) : AbelianGroup(rank) {
  for (const Integer& order : orders)
    if (order < 1) throw PreconditionError("a finite cyclic group cannot have order " + order.str());
  Torsion factors = invariant_factors(std::move(orders));
  if (!factors.empty()) torsion_ = std::make_shared<const Torsion>(std::move(factors));
}

const Torsion& AbelianGroup::torsion() const {
  static const Torsion none;
  return torsion_ == nullptr ? none : *torsion_;
}

bool AbelianGroup::has_torsion() const {
  return torsion_ != nullptr;
}

bool operator==(const AbelianGroup& a, const AbelianGroup& b) {
  return a.rank() == b.rank() && a.torsion() == b.torsion();
}

std::string AbelianGroup::str() const {
  std::string text;
  if (rank_ > 0) text = rank_ == 1 ? "Z" : "Z^" + std::to_string(rank_);
  for (const Integer& factor : torsion()) text += (text.empty() ? "Z/" : " + Z/") + factor.str();
  return text.empty() ? "0" : text;
}

Torsion invariant_factors(Torsion orders) {
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
