// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/proof.hpp"

#include "tetrarch/core/check.hpp"

#include <algorithm>
#include <optional>

namespace tetrarch::bundle {
namespace {

using surface::SideEnd;

/// What is found wrong, thrown inside this file only.
struct Failure {
  std::string text;
};

std::string over(int triangle) {
  return " over triangle " + std::to_string(triangle);
}

/// The tetrahedron above two of whose vertices lies one corner: its two, and the two others.
struct Shape {
  std::array<int, 2> doubled{-1, -1};   ///< vertices over the same corner
  std::array<int, 3> above{-1, -1, -1}; ///< of each corner, a vertex over it; over the doubled one the first
};

class Prover {
public:
  Prover(const CircleBundle& bundle, const Skeleton& skeleton)
      : bundle_(bundle), skeleton_(skeleton), tets_(bundle.total.size()) {}

  Proof run(const Progress& progress) && {
    try {
      progress.step("proving");
      check_projection();
      check_manifold();
      orient();
      progress.step("proving");
      follow_rings();
      follow_fibers();
      progress.step("proving");
      find_references();
      count_euler_number();
    } catch (const Failure& failure) {
      proof_ = Proof();
      proof_.failure = failure.text;
    }
    return std::move(proof_);
  }

private:
  int corner(int tet, int v) const { return bundle_.corner({tet, v}); }

  Shape shape(int tet) const {
    Shape out;
    for (int v = 0; v < 4; ++v) {
      int& seen = out.above[corner(tet, v)];
      if (seen < 0)
        seen = v;
      else if (out.doubled[0] < 0)
        out.doubled = {seen, v};
      else
        throw Failure{"tetrahedron " + std::to_string(tet) + " does not lie over a whole triangle"};
    }
    return out;
  }

  /// The corner of the triangle that face f is not over, or none if it is over the whole.
  std::optional<int> side_below(TetFace f) const {
    std::array<int, 3> seen{};
    for (int v = 0; v < 4; ++v)
      if (v != f.face) ++seen[corner(f.tet, v)];
    for (int c = 0; c < 3; ++c)
      if (seen[c] == 0) return c;
    return std::nullopt;
  }

  void check_projection() const {
    for (int t = 0; t < tets_; ++t) {
      shape(t);
      for (int f = 0; f < 4; ++f) check_face({t, f});
    }
  }

  void check_face(TetFace f) const {
    const int below = bundle_.triangle(f.tet);
    const auto missing = side_below(f);
    const Gluing g = bundle_.total.gluing(f);
    const auto fail = [&] {
      throw Failure{"face " + std::to_string(f.face) + " of tetrahedron " + std::to_string(f.tet) +
                    " is not glued as the surface is"};
    };
    if (!missing) {
      if (g.tet < 0 || bundle_.triangle(g.tet) != below) fail();
      for (int v = 0; v < 4; ++v)
        if (v != f.face && corner(g.tet, g.perm[v]) != corner(f.tet, v)) fail();
      return;
    }
    const Side s(below, *missing);
    if (bundle_.base.is_boundary(s) != (g.tet < 0)) fail();
    if (g.tet < 0) return;
    if (bundle_.triangle(g.tet) != bundle_.base.mate(s).triangle()) fail();
    for (int v = 0; v < 4; ++v) {
      if (v == f.face) continue;
      const SideEnd end{s, corner(f.tet, v) == s.next().corner()};
      if (corner(g.tet, g.perm[v]) != bundle_.base.across(end).corner()) fail();
    }
    if (side_below({g.tet, g.perm[f.face]}) != bundle_.base.mate(s).corner()) fail();
  }

  void check_manifold() const {
    const auto defects = check(skeleton_);
    if (!defects.empty()) throw Failure{"no manifold: " + describe(defects.front(), skeleton_)};
    for (const VertexId v : all<VertexId>(skeleton_.vertex_count()))
      if (!skeleton_.link(v).is_sphere() && !skeleton_.link(v).is_disk())
        throw Failure{"a vertex link is a surface of type " + skeleton_.link(v).str()};
  }

  /// The total space of a bundle whose fibres turn round where the surface does is orientable.
  void orient() {
    const auto sign = orientation(bundle_.total);
    if (!sign) throw Failure{"the total space is not orientable"};
    sign_ = *sign;
    // Of the two orientations, the one by which levels over the first triangle rise.
    const Shape first = shape(0);
    const auto& [a, b] = first.doubled;
    if (!is_lower(0, first, bundle_.level({0, a}) < bundle_.level({0, b}) ? a : b))
      for (int& s : sign_) s = -s;
  }

  /// Whether `low` is the lower of the doubled vertices: fibre upwards after the base counterclockwise is the
  /// orientation of the total space.
  bool is_lower(int tet, const Shape& s, int low) const {
    const int c = corner(tet, low);
    const int high = s.doubled[0] + s.doubled[1] - low;
    const Perm4 frame(low, s.above[(c + 1) % 3], s.above[(c + 2) % 3], high);
    return frame.sign() * sign_[tet] > 0;
  }

  /// Walks upwards from the first tetrahedron over each triangle until home; gives heights on the way.
  void follow_rings() {
    height_.resize(static_cast<std::size_t>(tets_));
    for (int t = 0; t < tets_; t += 3 * bundle_.fiber) follow_ring(t);
  }

  void follow_ring(int first) {
    const int below = bundle_.triangle(first);
    std::array<int, 3> passed{};
    int tet = first;
    Shape s = shape(tet);
    int low = is_lower(tet, s, s.doubled[0]) ? s.doubled[0] : s.doubled[1];
    std::array<int, 4> height{};
    height[s.doubled[0] + s.doubled[1] - low] = 1;
    int count = 0;
    do {
      height_[tet] = height;
      ++count;
      ++passed[corner(tet, low)];
      const Gluing up = bundle_.total.gluing({tet, low});
      std::array<int, 4> next{};
      for (int v = 0; v < 4; ++v)
        if (v != low) next[up.perm[v]] = height[v];
      const int added = up.perm[low];
      tet = up.tet;
      s = shape(tet);
      // What is new stands above the vertex over the same corner. The lower one is told by orientation, so a
      // ring that turned back would be found by its count.
      const int c = corner(tet, added);
      if (corner(tet, s.doubled[0]) != c) throw Failure{"the ring" + over(below) + " turns back"};
      low = s.doubled[0] + s.doubled[1] - added;
      next[added] = next[low] + 1;
      if (!is_lower(tet, s, low)) throw Failure{"the ring" + over(below) + " turns back"};
      height = next;
    } while (tet != first && count <= 3 * bundle_.fiber);
    if (count != 3 * bundle_.fiber ||
        passed != std::array<int, 3>{bundle_.fiber, bundle_.fiber, bundle_.fiber})
      throw Failure{"the tetrahedra" + over(below) + " do not form a single ring of " +
                    std::to_string(bundle_.fiber) + " levels"};
  }

  /// The edges over vertices, and the circles that they form.
  void follow_fibers() {
    struct Ends {
      std::array<EdgeId, 2> edge;
      int count = 0;
    };
    Fibers& fibers = proof_.fibers;
    fibers.direction = Table<EdgeId, signed char>(skeleton_.edge_count(), 0);
    fibers.place = Table<VertexId, int>(skeleton_.vertex_count(), -1);
    Table<VertexId, Ends> ends(skeleton_.vertex_count());
    for (int t = 0; t < tets_; ++t) {
      const Shape s = shape(t);
      const EdgeId e = skeleton_.edge({t, edge_number[s.doubled[0]][s.doubled[1]]});
      if (fibers.direction[e] != 0) continue;
      fibers.direction[e] = 1;
      for (const int v : s.doubled) {
        Ends& here = ends[skeleton_.vertex({t, v})];
        if (here.count == 2) throw Failure{"a fiber branches" + over(bundle_.triangle(t))};
        here.edge[here.count++] = e;
      }
    }
    std::vector<char> done(static_cast<std::size_t>(bundle_.base.vertex_count()), 0);
    for (int t = 0; t < tets_; ++t)
      for (int v = 0; v < 4; ++v) {
        const VertexId start = skeleton_.vertex({t, v});
        if (fibers.place[start] >= 0) continue;
        const int below = bundle_.base.corners(bundle_.triangle(t))[corner(t, v)];
        const std::string name = "the fiber over vertex " + std::to_string(below);
        if (done[below]) throw Failure{name + " is several circles"};
        done[below] = 1;
        VertexId at = start;
        EdgeId edge = ends[start].edge[0];
        int length = 0;
        do {
          if (ends[at].count != 2) throw Failure{name + " is no circle"};
          fibers.place[at] = length++;
          const auto [from, to] = skeleton_.ends(edge);
          fibers.direction[edge] = from == at ? 1 : -1;
          at = from == at ? to : from;
          edge = ends[at].edge[ends[at].edge[0] == edge ? 1 : 0];
        } while (at != start);
        if (length != bundle_.fiber)
          throw Failure{name + " has length " + std::to_string(length) + ", expected " +
                        std::to_string(bundle_.fiber)};
      }
  }

  void find_references() {
    Fibers& fibers = proof_.fibers;
    fibers.up.resize(static_cast<std::size_t>(bundle_.base.side_count()));
    fibers.reference.resize(fibers.up.size());
    const std::vector<EdgeId> least = least_edges();
    for (int t = 0; t < tets_; ++t) {
      const int below = bundle_.triangle(t);
      for (const auto& [a, b] : edge_vertex) {
        const bool ascends = height_[t][a] < height_[t][b];
        const EdgeId e = skeleton_.edge({t, edge_number[a][b]});
        const int ca = corner(t, a);
        const int cb = corner(t, b);
        if (ca == cb) {
          const int from = ascends ? a : b;
          const bool along = skeleton_.runs_along({t, from, a + b - from});
          fibers.up[3 * below + ca] =
              static_cast<signed char>(along ? fibers.direction[e] : -fibers.direction[e]);
          continue;
        }
        const Side s(below, 3 - ca - cb);
        if (least[s.value] != e) continue;
        const int from = ca == s.next().corner() ? a : b;
        const int to = a + b - from;
        fibers.reference[s.value] = {height_[t][to] - height_[t][from],
                                     fibers.place[skeleton_.vertex({t, from})],
                                     fibers.place[skeleton_.vertex({t, to})]};
      }
    }
  }

  /// The least edge over each side, the same for mates.
  std::vector<EdgeId> least_edges() const {
    std::vector<EdgeId> least(static_cast<std::size_t>(bundle_.base.side_count()));
    for (int t = 0; t < tets_; ++t)
      for (const auto& [a, b] : edge_vertex) {
        const int ca = corner(t, a);
        const int cb = corner(t, b);
        if (ca == cb) continue;
        const EdgeId e = skeleton_.edge({t, edge_number[a][b]});
        EdgeId& best = least[Side(bundle_.triangle(t), 3 - ca - cb).value];
        if (best.value < 0 || e < best) best = e;
      }
    return least;
  }

  void count_euler_number() {
    for (int k = 0; k < bundle_.base.side_count(); ++k)
      if (bundle_.base.is_boundary(Side(k))) return;
    proof_.has_euler_number = true;
    for (int t = 0; t < bundle_.base.triangle_count(); ++t) {
      const int rise = turning(proof_.fibers, t);
      if (rise % bundle_.fiber != 0) throw Failure{"the section" + over(t) + " does not close"};
      proof_.euler_number += rise / bundle_.fiber;
    }
  }

  /// Once around the triangle along the section that is place 0 on every fibre.
  static int turning(const Fibers& fibers, int t) {
    int rise = 0;
    for (const Side s : sides_of(t)) {
      const Fibers::Reference& r = fibers.reference[s.value];
      const int from = fibers.up[3 * t + s.next().corner()];
      const int to = fibers.up[3 * t + s.previous().corner()];
      rise += from * r.start + r.rise - to * r.stop;
    }
    return rise;
  }

  const CircleBundle& bundle_;
  const Skeleton& skeleton_;
  int tets_;
  std::vector<int> sign_;
  std::vector<std::array<int, 4>> height_; ///< of each tetrahedron's vertices, in its triangle's ring
  Proof proof_;
};

} // namespace

Proof prove(const CircleBundle& bundle, const Skeleton& skeleton, const Progress& progress) {
  skeleton.require_current(bundle.total);
  return Prover(bundle, skeleton).run(progress);
}

} // namespace tetrarch::bundle
