// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The first homology of a solid, and what loops on its boundary are there.
///
///        tree edges: 0          Each edge gets an element of a free abelian group, such that around every
///          *---*                triangle the sum is 0: those of a tree get 0, an edge that closes a triangle
///         /|  /                 with two known ones what is left over. When no triangle goes on, some edge
///        * | *   x_1            gets a new generator. Sums around triangles that are not 0 after all are
///          *---*                the relations. A good mesh of a handlebody needs about as many generators as
///                               it has handles.

#include "tetrarch/product/partition.hpp"

#include <cstdint>
#include <vector>

namespace tetrarch::algebra {
struct SmithForm;
}

namespace tetrarch::product {

class FirstHomology {
public:
  /// An element of the group: coefficients of generators, in increasing order of them; none is 0.
  struct Term {
    int generator = 0;
    std::int64_t coefficient = 0;
    friend bool operator==(const Term&, const Term&) = default;
  };
  using Element = std::vector<Term>;

  /// Linear but for sums of elements, which have few terms.
  explicit FirstHomology(const Solid& solid);

  /// Of a closed walk along sides of the boundary.
  Element of(const std::vector<surface::SideEnd>& loop) const;
  /// Whether these generate the whole group. Polynomial in the number of generators, which is small.
  bool generated_by(const std::vector<Element>& elements) const;
  /// Whether these are part of a basis: others can be added so that every element is a sum of them in one
  /// way. The group must be free, as that of a handlebody is.
  bool is_part_of_basis(const std::vector<Element>& elements) const;

private:
  /// Of the relations and these elements.
  algebra::SmithForm smith_form(const std::vector<Element>& elements) const;

  std::vector<Element> on_side_; ///< of each side of the boundary, along it
  std::vector<Element> relations_;
  int generators_ = 0;
  int rank_of_relations_ = 0;
};

/// As the public one, for a homology at hand; not checked against it if there is none.
PartitionAttempt try_partition(const Solid& solid, const std::vector<int>& base, int outer,
                               const FirstHomology* homology);

} // namespace tetrarch::product
