// SPDX-License-Identifier: GPL-2.0-or-later
#include "flatten.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <utility>

namespace tetrarch::moves {
namespace {

template <class T>
using Small = boost::container::small_vector<T, Flattening::usual>;

/// A graph whose nodes are any integers, known beforehand; finds out whether a new arc closes a cycle.
class Forest {
public:
  void add_node(int node) { nodes_.push_back(node); }
  void close() {
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (int k = 0; k < static_cast<int>(nodes_.size()); ++k) parent_.push_back(k);
  }
  /// False if a and b were connected already.
  bool join(int a, int b) {
    const int p = find(a);
    const int q = find(b);
    parent_[p] = q;
    return p != q;
  }

private:
  int find(int node) {
    int k = static_cast<int>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  Small<int> nodes_;
  Small<int> parent_;
};

/// The places of some numbers in a list. Most that are looked for are not in it, which a word of bits tells.
class Places {
public:
  explicit Places(const Small<int>& list) : list_(list) {
    for (const int number : list) bits_ |= last_bits(number);
    if (list.size() <= few) return;
    for (int k = 0; k < static_cast<int>(list.size()); ++k)
      sorted_.emplace_back(list[static_cast<std::size_t>(k)], k);
    std::sort(sorted_.begin(), sorted_.end());
  }
  /// -1: it is not in the list.
  int of(int number) const {
    if ((bits_ & last_bits(number)) == 0) return -1;
    if (sorted_.empty()) {
      const auto at = std::find(list_.begin(), list_.end(), number);
      return at == list_.end() ? -1 : static_cast<int>(at - list_.begin());
    }
    const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{number, 0});
    return at == sorted_.end() || at->first != number ? -1 : at->second;
  }

private:
  static constexpr std::size_t few = 16; // so many are searched one by one
  const Small<int>& list_;
  std::uint64_t bits_ = 0;
  boost::container::small_vector<std::pair<int, int>, 1> sorted_; ///< of more than a few
};

/// Chains of flat tetrahedra: enter one by a face of a pair, leave it by the other face, and so on until
/// outside.
class Chains {
public:
  Chains(const Complex& complex, const Flattening& flat)
      : complex_(complex), flat_(flat), places_(flat.tets), pair_at_(4 * flat.tets.size(), 0) {
    for (int i = 0; i < static_cast<int>(flat.faces.size()); ++i) {
      pair_at_[place(flat.faces[i].a, i)] = i + 1;
      pair_at_[place(flat.faces[i].b, i)] = -(i + 1);
    }
  }

  struct End {
    bool closed = false; ///< the chain came back to where it began
    TetFace face{-1, 0}; ///< outside; tet -1: the chain ends at a boundary face
    Perm4 map;           ///< from the tetrahedron where the chain began
  };
  /// Leaves through `face`, one of pair `first`, and goes on; `visit(i)` is told every further pair i.
  template <class Visit>
  End follow(TetFace face, int first, Visit visit) const {
    Perm4 map;
    while (true) {
      const Gluing g = complex_.gluing(face);
      if (g.tet < 0) return {false, {-1, 0}, map};
      const TetFace there{g.tet, g.perm[face.face]};
      map = g.perm * map;
      const int k = places_.of(g.tet);
      if (k < 0) return {false, there, map};
      const int entry = pair_at_[place(k, there.face)];
      const int i = std::abs(entry) - 1;
      if (i == first) return {true, {-1, 0}, map};
      visit(i);
      const Flattening::FacePair& pair = flat_.faces[static_cast<std::size_t>(i)];
      map = (entry > 0 ? pair.map : pair.map.inverse()) * map;
      face = entry > 0 ? pair.b : pair.a;
    }
  }

private:
  static std::size_t place(int k, int face) {
    return 4 * static_cast<std::size_t>(k) + static_cast<std::size_t>(face);
  }
  /// Where the i-th pair has its faces on the i-th tetrahedron, none need be looked for.
  std::size_t place(TetFace f, int i) const {
    const auto k = static_cast<std::size_t>(i);
    const bool is_there = k < flat_.tets.size() && flat_.tets[k] == f.tet;
    return place(is_there ? i : places_.of(f.tet), f.face);
  }

  const Complex& complex_;
  const Flattening& flat_;
  Places places_; ///< of the flat tetrahedra
  boost::container::small_vector<int, 4 * Flattening::usual>
      pair_at_; ///< 1 + pair at its face a, -(1 + pair) at b
};

bool edges_form_cycle(const Complex& complex, const Flattening& flat) {
  constexpr int one_for_all = -1;
  const auto node = [&](EdgeId e) {
    return complex.is_boundary(e) || complex.is_reversed(e) ? one_for_all : e.value;
  };
  Forest forest;
  for (const auto& [a, b] : flat.edges) {
    forest.add_node(node(a));
    forest.add_node(node(b));
  }
  forest.close();
  for (const auto& [a, b] : flat.edges)
    if (!forest.join(node(a), node(b))) return true;
  return false;
}

/// Calls `told(i, forth, back)` with the two ends of every chain, pair i being one of it, until `told`
/// returns false. Every face has two sides at most, so the pairs lie on paths and circles; of a circle `back`
/// is empty.
template <class Told>
void for_each_chain(const Complex& complex, const Flattening& flat, Told told) {
  const Chains chains(complex, flat);
  Small<char> seen(flat.faces.size(), 0);
  const auto visit = [&seen](int i) { seen[static_cast<std::size_t>(i)] = 1; };
  for (int i = 0; i < static_cast<int>(flat.faces.size()); ++i) {
    if (seen[static_cast<std::size_t>(i)] != 0) continue;
    const Chains::End forth = chains.follow(flat.faces[i].b, i, visit);
    const Chains::End back = forth.closed ? Chains::End() : chains.follow(flat.faces[i].a, i, visit);
    if (!told(i, forth, back)) return;
  }
}

bool faces_form_cycle(const Complex& complex, const Flattening& flat) {
  bool cycle = false;
  for_each_chain(complex, flat, [&cycle](int, const Chains::End& forth, const Chains::End& back) {
    cycle = forth.closed || (forth.face.tet < 0 && back.face.tet < 0);
    return !cycle;
  });
  return cycle;
}

} // namespace

MaybeObstacle why_not_flatten(const Complex& complex, const Flattening& flat) {
  if (edges_form_cycle(complex, flat)) return Obstacle::edges_form_cycle;
  if (faces_form_cycle(complex, flat)) return Obstacle::faces_form_cycle;
  return std::nullopt;
}

void flatten(Complex& complex, const Flattening& flat) {
  struct Seam {
    TetFace face;
    int other;
    Perm4 map;
  };
  Small<Seam> seams;
  for_each_chain(complex, flat, [&](int i, const Chains::End& forth, const Chains::End& back) {
    if (forth.face.tet >= 0 && back.face.tet >= 0)
      seams.push_back({back.face, forth.face.tet, forth.map * flat.faces[i].map * back.map.inverse()});
    return true;
  });
  for (const int t : flat.tets) complex.remove_tet(t);
  for (const Seam& seam : seams) complex.glue(seam.face, seam.other, seam.map);
  for (const auto& [a, b] : flat.edges) complex.merge_edges(a, b);
}

} // namespace tetrarch::moves
