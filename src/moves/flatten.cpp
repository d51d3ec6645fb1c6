// SPDX-License-Identifier: GPL-2.0-or-later
#include "flatten.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>

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

/// Chains of flat tetrahedra: enter one by a face of a pair, leave it by the other face, and so on until
/// outside.
class Chains {
public:
  Chains(const Complex& complex, const Flattening& flat) : complex_(complex), flat_(flat) {
    pair_at_.assign(4 * flat.tets.size(), 0);
    for (int k = 0; k < static_cast<int>(flat.tets.size()); ++k) complex.set_mark(flat.tets[k], k + 1);
    for (int i = 0; i < static_cast<int>(flat.faces.size()); ++i) {
      pair_at_[place(flat.faces[i].a)] = i + 1;
      pair_at_[place(flat.faces[i].b)] = -(i + 1);
    }
  }
  ~Chains() {
    for (const int t : flat_.tets) complex_.set_mark(t, 0);
  }
  Chains(const Chains&) = delete;
  Chains& operator=(const Chains&) = delete;

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
      if (complex_.mark(g.tet) == 0) return {false, there, map};
      const int entry = pair_at_[place(there)];
      const int i = std::abs(entry) - 1;
      if (i == first) return {true, {-1, 0}, map};
      visit(i);
      const Flattening::FacePair& pair = flat_.faces[static_cast<std::size_t>(i)];
      map = (entry > 0 ? pair.map : pair.map.inverse()) * map;
      face = entry > 0 ? pair.b : pair.a;
    }
  }

private:
  std::size_t place(TetFace f) const {
    return 4 * static_cast<std::size_t>(complex_.mark(f.tet) - 1) + static_cast<std::size_t>(f.face);
  }
  const Complex& complex_;
  const Flattening& flat_;
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
