// SPDX-License-Identifier: GPL-2.0-or-later
#include "homology.hpp"

#include "tetrarch/algebra/smith.hpp"

#include "tetrarch/core/skeleton.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tetrarch::product {
namespace {

using Element = FirstHomology::Element;

/// a + sign b.
Element sum(const Element& a, const Element& b, int sign) {
  Element out;
  auto p = a.begin();
  auto q = b.begin();
  while (p != a.end() || q != b.end()) {
    if (q == b.end() || (p != a.end() && p->generator < q->generator)) {
      out.push_back(*p++);
    } else if (p == a.end() || q->generator < p->generator) {
      out.push_back({q->generator, sign * q->coefficient});
      ++q;
    } else {
      const std::int64_t c = p->coefficient + sign * q->coefficient;
      if (c != 0) out.push_back({p->generator, c});
      ++p;
      ++q;
    }
  }
  return out;
}

/// Elements of the edges of a solid, found triangle by triangle.
class Labelling {
public:
  explicit Labelling(const Solid& solid) : solid_(solid), skeleton_(solid.gluings) {
    element_.resize(static_cast<std::size_t>(skeleton_.edge_count()));
    known_.assign(element_.size(), 0);
    grow_tree();
    spread();
    for (int e = 0; e < skeleton_.edge_count(); ++e) {
      if (known_[e]) continue;
      set(e, {{generators_++, 1}});
      spread();
    }
  }

  int generators() const { return generators_; }

  /// From t-vertex `from` to t-vertex `to`.
  Element along(DirectedTetEdge e) const {
    return sum({}, element_[edge(e)], skeleton_.runs_along(e) ? 1 : -1);
  }

  /// What is around triangles and is not 0, each once.
  std::vector<Element> relations() const {
    std::vector<Element> found;
    for (int t = 0; t < solid_.size(); ++t)
      for (const auto& [a, b, c] : face_vertex) {
        Element around = sum(sum(along({t, a, b}), along({t, b, c}), 1), along({t, a, c}), -1);
        if (!around.empty() && std::find(found.begin(), found.end(), around) == found.end())
          found.push_back(std::move(around));
      }
    return found;
  }

private:
  int edge(DirectedTetEdge e) const {
    return skeleton_.edge(TetEdge{e.tet, edge_number[e.from][e.to]}).value;
  }

  void set(int e, Element element) {
    known_[e] = 1;
    element_[e] = std::move(element);
    for (const Walk& walk : skeleton_.around(EdgeId(e))) waiting_.push_back(walk.tet);
  }

  /// Breadth first, so that few edges are far from the tree.
  void grow_tree() {
    std::vector<std::vector<int>> edges_at(static_cast<std::size_t>(skeleton_.vertex_count()));
    for (int e = 0; e < skeleton_.edge_count(); ++e) {
      const auto [from, to] = skeleton_.ends(EdgeId(e));
      edges_at[from.value].push_back(e);
      edges_at[to.value].push_back(e);
    }
    std::vector<char> reached(edges_at.size(), 0);
    std::vector<int> queue{0};
    reached[0] = 1;
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (const int e : edges_at[queue[k]]) {
        const auto [from, to] = skeleton_.ends(EdgeId(e));
        const int other = from.value == queue[k] ? to.value : from.value;
        if (std::exchange(reached[other], 1)) continue;
        queue.push_back(other);
        set(e, {});
      }
  }

  /// Closes all triangles two of whose edges are known.
  void spread() {
    while (!waiting_.empty()) {
      const int t = waiting_.back();
      waiting_.pop_back();
      for (const auto& [a, b, c] : face_vertex)
        for (const auto& [i, j, k] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
          const int last = edge({t, i, k});
          if (known_[last] || !known_[edge({t, i, j})] || !known_[edge({t, j, k})]) continue;
          const Element around = sum(along({t, i, j}), along({t, j, k}), 1);
          set(last, sum({}, around, skeleton_.runs_along({t, i, k}) ? 1 : -1));
        }
    }
  }

  const Solid& solid_;
  Skeleton skeleton_;
  std::vector<Element> element_; ///< of each edge, along its class
  std::vector<char> known_;
  std::vector<int> waiting_; ///< tetrahedra with an edge that has become known
  int generators_ = 0;
};

} // namespace

FirstHomology::FirstHomology(const Solid& solid) {
  const Labelling labelling(solid);
  generators_ = labelling.generators();
  relations_ = labelling.relations();
  rank_of_relations_ = smith_form({}).rank();
  on_side_.reserve(static_cast<std::size_t>(solid.boundary.side_count()));
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    const TetFace face = solid.face[t];
    const auto local = [&](int corner) {
      const auto& corners = solid.corners(face.tet);
      return static_cast<int>(std::find(corners.begin(), corners.end(), solid.corner(t, corner)) -
                              corners.begin());
    };
    for (const surface::Side s : surface::sides_of(t))
      on_side_.push_back(labelling.along({face.tet, local(s.next().corner()), local(s.previous().corner())}));
  }
}

Element FirstHomology::of(const std::vector<surface::SideEnd>& loop) const {
  Element whole;
  for (const surface::SideEnd e : loop) whole = sum(whole, on_side_[e.side.value], e.at_start ? 1 : -1);
  return whole;
}

algebra::SmithForm FirstHomology::smith_form(const std::vector<Element>& elements) const {
  algebra::SparseMatrix rows(static_cast<int>(relations_.size() + elements.size()), generators_);
  int row = 0;
  for (const auto* list : {&relations_, &elements})
    for (const Element& element : *list) {
      for (const Term& term : element) rows.add(row, term.generator, term.coefficient);
      ++row;
    }
  return algebra::smith_normal_form(rows);
}

bool FirstHomology::generated_by(const std::vector<Element>& elements) const {
  return smith_form(elements).units == generators_;
}

bool FirstHomology::is_part_of_basis(const std::vector<Element>& elements) const {
  return smith_form(elements).units == rank_of_relations_ + static_cast<int>(elements.size());
}

} // namespace tetrarch::product
