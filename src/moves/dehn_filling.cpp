// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/dehn_filling.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/moves/subdivide.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace tetrarch::moves {
namespace {

using Flow = std::int64_t;

/// One for each step of Euclid's algorithm: (1, 100000) takes so many.
constexpr int most_layers = 100'000;
/// Turns of random edges, where no vertex can be brought to three triangles at once: one or two are usual.
constexpr int random_turns_per_triangle = 100;

/// Corner k + 1 and k + 2 of a triangle.
constexpr int next(int k) {
  return (k + 1) % 3;
}
constexpr int last(int k) {
  return (k + 2) % 3;
}

/// A side of a triangle, as seen from it: opposite its corner `side`, from corner next(side) to last(side).
struct TorusSide {
  int triangle = -1;
  int side = 0;
  friend bool operator==(const TorusSide&, const TorusSide&) = default;
};

/// A triangle of the torus, corners counterclockwise.
struct Triangle {
  int tet = -1;                       ///< -1: there is none any more
  std::array<int, 3> corner{};        ///< vertices of the tetrahedron
  std::array<int, 3> vertex{};        ///< vertices of the torus
  std::array<TorusSide, 3> partner{}; ///< across each side; starts meet ends
  std::array<Flow, 3> flow{};         ///< how often the curve comes in across each side
  TetFace face() const { return {tet, 6 - corner[0] - corner[1] - corner[2]}; }
};

using Torus = std::vector<Triangle>;

/// Glues the face of a new tetrahedron whose vertices are `corners` onto a triangle, one by one.
void glue_onto(Triangulation& tri, int tet, std::array<int, 3> corners, const Triangle& onto,
               std::array<int, 3> order) {
  std::array<int, 4> image{};
  for (int k = 0; k < 3; ++k) image[corners[k]] = onto.corner[order[k]];
  const int face = 6 - corners[0] - corners[1] - corners[2];
  image[face] = onto.face().face;
  tri.glue({tet, face}, onto.tet, Perm4(image[0], image[1], image[2], image[3]));
}

/// The truncated manifold with one of its boundary tori, which shrinks while tetrahedra are layered on it.
class Layering {
public:
  Layering(Triangulation& tri, Torus torus) : tri_(tri), torus_(std::move(torus)) { name_vertices(); }

  void close() {
    while (queue_.size() > 1) remove_a_vertex();
    fold(euclid());
  }

private:
  TorusSide partner(TorusSide s) const { return torus_[s.triangle].partner[s.side]; }
  Flow flow(TorusSide s) const { return torus_[s.triangle].flow[s.side]; }

  /// The next corner around the same vertex: (triangle, corner).
  TorusSide around(TorusSide corner) const {
    const TorusSide across = partner({corner.triangle, next(corner.side)});
    return {across.triangle, next(across.side)};
  }

  void name_vertices() {
    for (Triangle& t : torus_) t.vertex.fill(-1);
    for (int t = 0; t < static_cast<int>(torus_.size()); ++t)
      for (int k = 0; k < 3; ++k) {
        if (torus_[t].vertex[k] >= 0) continue;
        const int name = static_cast<int>(degree_.size());
        int degree = 0;
        TorusSide at{t, k};
        do {
          torus_[at.triangle].vertex[at.side] = name;
          ++degree;
          at = around(at);
        } while (!(at == TorusSide{t, k}));
        degree_.push_back(degree);
        at_.push_back(at);
        queue_.insert({degree, name});
      }
  }

  void change_degree(int vertex, int by) {
    queue_.erase({degree_[vertex], vertex});
    degree_[vertex] += by;
    queue_.insert({degree_[vertex], vertex});
  }

  void put(int number, Triangle triangle) {
    torus_[number] = triangle;
    for (int k = 0; k < 3; ++k) at_[triangle.vertex[k]] = {number, k};
  }

  /// The corners at a vertex.
  std::vector<TorusSide> corners_at(int vertex) const {
    std::vector<TorusSide> corners;
    TorusSide at = at_[vertex];
    for (int k = 0; k < degree_[vertex]; ++k, at = around(at)) corners.push_back(at);
    return corners;
  }

  /// Layers a tetrahedron on the two triangles at a side: (a0, a1, a2) and (b0, a2, a1) become (a0, a1, b0)
  /// and (b0, a2, a0). False, and nothing happens, if they are one.
  bool turn(TorusSide s) {
    const TorusSide across = partner(s);
    if (across.triangle == s.triangle) return false;
    const int ta = s.triangle, tb = across.triangle, i = s.side, j = across.side;
    const Triangle a = torus_[ta], b = torus_[tb];
    const int tet = tri_.add_tetrahedra();
    glue_onto(tri_, tet, {0, 1, 2}, a, {i, next(i), last(i)});
    glue_onto(tri_, tet, {3, 2, 1}, b, {j, next(j), last(j)});
    const int a0 = a.vertex[i], a1 = a.vertex[next(i)], a2 = a.vertex[last(i)], b0 = b.vertex[j];
    const Flow inward = -a.flow[last(i)] - b.flow[next(j)];
    put(ta, {tet, {0, 1, 3}, {a0, a1, b0}, {}, {b.flow[next(j)], inward, a.flow[last(i)]}});
    put(tb, {tet, {3, 2, 0}, {b0, a2, a0}, {}, {a.flow[next(i)], -inward, b.flow[last(j)]}});
    const std::array<std::pair<TorusSide, TorusSide>, 4> moved{{{{tb, next(j)}, {ta, 0}},
                                                                {{ta, last(i)}, {ta, 2}},
                                                                {{ta, next(i)}, {tb, 0}},
                                                                {{tb, last(j)}, {tb, 2}}}};
    const auto now = [&moved](TorusSide old) {
      for (const auto& [from, to] : moved)
        if (old == from) return to;
      return old;
    };
    const auto before = [&](TorusSide old) {
      return old.triangle == ta ? a.partner[old.side] : b.partner[old.side];
    };
    for (const auto& [from, to] : moved) join(to, now(before(from)));
    join({ta, 1}, {tb, 1});
    change_degree(a1, -1);
    change_degree(a2, -1);
    change_degree(a0, 1);
    change_degree(b0, 1);
    return true;
  }

  void join(TorusSide s, TorusSide other) {
    torus_[s.triangle].partner[s.side] = other;
    torus_[other.triangle].partner[other.side] = s;
  }

  /// Layers a tetrahedron on the three triangles at a vertex; false if they are not three.
  bool cap(int vertex) {
    const std::vector<TorusSide> corners = corners_at(vertex);
    if (corners.size() != 3) return false;
    const std::array<TorusSide, 3> c{corners[0], corners[1], corners[2]};
    if (c[0].triangle == c[1].triangle || c[1].triangle == c[2].triangle || c[0].triangle == c[2].triangle)
      return false;
    // Counterclockwise around the vertex, which is number 3 of the tetrahedron, stand 0, 1, 2: corner c[k]
    // lies between k and next(k).
    const int tet = tri_.add_tetrahedra();
    Triangle made{tet, {0, 1, 2}, {}, {}, {}};
    std::array<TorusSide, 3> outer{};
    for (int k = 0; k < 3; ++k) {
      const Triangle& t = torus_[c[k].triangle];
      const int i = c[k].side;
      glue_onto(tri_, tet, {3, k, next(k)}, t, {i, next(i), last(i)});
      made.vertex[k] = t.vertex[next(i)];
      made.flow[last(k)] = t.flow[i];
      outer[last(k)] = c[k];
    }
    for (int k = 0; k < 3; ++k) made.partner[k] = partner(outer[k]);
    const int place = c[0].triangle;
    for (const TorusSide& s : c) torus_[s.triangle].tet = -1;
    queue_.erase({3, vertex});
    for (const int v : made.vertex) change_degree(v, -1);
    put(place, made);
    const auto now = [&](TorusSide old) {
      for (int k = 0; k < 3; ++k)
        if (old == outer[k]) return TorusSide{place, k};
      return old;
    };
    for (int k = 0; k < 3; ++k) join({place, k}, now(made.partner[k]));
    return true;
  }

  /// A turn after which the vertex has one corner less; false if there is none.
  bool lessen(int vertex) {
    for (const TorusSide& c : corners_at(vertex)) {
      const TorusSide s{c.triangle, next(c.side)};
      const Triangle& t = torus_[c.triangle];
      const TorusSide across = partner(s);
      const bool loop = t.vertex[last(c.side)] == vertex;
      if (loop || t.vertex[next(c.side)] == vertex || torus_[across.triangle].vertex[across.side] == vertex)
        continue;
      if (turn(s)) return true;
    }
    return false;
  }

  /// A turn of the edge opposite a corner: the vertex has one corner more. False if there is none.
  bool enlarge(int vertex) {
    for (const TorusSide& c : corners_at(vertex)) {
      const Triangle& t = torus_[c.triangle];
      if (t.vertex[next(c.side)] != vertex && t.vertex[last(c.side)] != vertex && turn(c)) return true;
    }
    return false;
  }

  void remove_a_vertex() {
    const auto [degree, vertex] = *queue_.begin();
    if (degree == 3 && cap(vertex)) return;
    if (degree > 3 && lessen(vertex)) return;
    if (degree < 3 && enlarge(vertex)) return;
    turn_any();
  }

  void turn_any() {
    if (++random_turns_ > random_turns_per_triangle * static_cast<int>(torus_.size()))
      throw PreconditionError("filled: the torus of a cusp was not brought to one vertex");
    for (;;) {
      const TorusSide s{random_.below(static_cast<int>(torus_.size())), random_.below(3)};
      if (torus_[s.triangle].tet >= 0 && turn(s)) return;
    }
  }

  /// Turns edges of the torus of one vertex until the flows are 1, 1 and 2; the side of 2.
  TorusSide euclid() {
    int number = 0;
    while (torus_[number].tet < 0) ++number;
    for (int layers = 0; layers < most_layers; ++layers) {
      const auto size = [&](int k) { return std::abs(flow({number, k})); };
      int largest = 0;
      int least = 0;
      for (int k = 1; k < 3; ++k) {
        if (size(k) > size(largest)) largest = k;
        if (size(k) < size(least)) least = k;
      }
      if (size(largest) == 2) return {number, largest};
      turn({number, size(largest) == 1 ? least : largest});
    }
    throw PreconditionError("filled: the curve takes too many layers");
  }

  void fold(TorusSide s) {
    const TorusSide across = partner(s);
    const Triangle& a = torus_[s.triangle];
    const Triangle& b = torus_[across.triangle];
    const int i = s.side, j = across.side;
    glue_onto(tri_, a.tet, {a.corner[i], a.corner[next(i)], a.corner[last(i)]}, b, {j, last(j), next(j)});
  }

  Triangulation& tri_;
  Torus torus_;
  std::vector<int> degree_;             ///< of each vertex of the torus
  std::vector<TorusSide> at_;           ///< one of its corners
  std::set<std::pair<int, int>> queue_; ///< (degree, vertex)
  SplitMix64 random_{1};
  int random_turns_ = 0;
};

bool is_torus(const SurfaceType& link) {
  return link.is_closed() && link.orientable && link.euler == 0;
}

bool has_curve(const Skeleton& skeleton, const CuspCurves& curves, VertexId v) {
  const auto& corners = skeleton.preimages(v);
  return std::any_of(corners.begin(), corners.end(), [&](const TetVertex& c) {
    const auto& flow = curves[c.tet][c.vertex];
    return std::any_of(flow.begin(), flow.end(), [](Flow x) { return x != 0; });
  });
}

/// The pieces cut (v) of a finite model: where tetrahedron t has them.
std::vector<std::array<int, 4>> cut_pieces(const Triangulation& tri, const Skeleton& skeleton) {
  std::vector<std::array<int, 4>> cuts;
  int pieces = 0;
  for (int t = 0; t < tri.size(); ++t) {
    int truncated = 0;
    for (int v = 0; v < 4; ++v) truncated += skeleton.is_ideal(skeleton.vertex({t, v})) ? 1 : 0;
    pieces += 12 + 3 * truncated;
    auto& cut = cuts.emplace_back();
    for (int v = 0; v < 4; ++v) cut[v] = skeleton.is_ideal(skeleton.vertex({t, v})) ? pieces++ : -1;
  }
  return cuts;
}

/// The truncation triangles at a torus cusp, oriented alike. In piece cut (v), the point on the edge to w is
/// called w, and the side opposite it lies on face w.
Torus torus_at(const Triangulation& tri, const Skeleton& skeleton, VertexId v, const CuspCurves& curves,
               const std::vector<std::array<int, 4>>& cuts) {
  Torus torus;
  std::vector<TetVertex> place;
  std::vector<std::array<int, 4>> number(static_cast<std::size_t>(tri.size()), {-1, -1, -1, -1});
  const auto add = [&](TetVertex c, std::array<int, 3> corners) {
    number[c.tet][c.vertex] = static_cast<int>(torus.size());
    place.push_back(c);
    Triangle& t = torus.emplace_back(Triangle{cuts[c.tet][c.vertex], corners, {}, {}, {}});
    for (int k = 0; k < 3; ++k) t.flow[k] = curves[c.tet][c.vertex][corners[k]];
  };
  const TetVertex first = skeleton.preimages(v).front();
  add(first, face_vertex[first.vertex]);
  for (int t = 0; t < static_cast<int>(torus.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const TetVertex here = place[t];
      const std::array<int, 3> corner = torus[t].corner;
      const Gluing g = tri.gluing({here.tet, corner[k]});
      const TetVertex there{g.tet, g.perm[here.vertex]};
      if (number[there.tet][there.vertex] < 0)
        add(there, {g.perm[corner[k]], g.perm[corner[last(k)]], g.perm[corner[next(k)]]});
      const int other = number[there.tet][there.vertex];
      const auto& corners = torus[other].corner;
      const auto at = std::find(corners.begin(), corners.end(), g.perm[corner[k]]);
      torus[t].partner[k] = {other, static_cast<int>(at - corners.begin())};
    }
  return torus;
}

std::string at_vertex(const std::string& what, TetVertex v) {
  return what + " at vertex " + std::to_string(v.vertex) + " of tetrahedron " + std::to_string(v.tet);
}

std::optional<std::string> why_no_curves(const Triangulation& tri, const CuspCurves& curves) {
  if (static_cast<int>(curves.size()) != tri.size()) return "there are not as many entries as tetrahedra";
  Flow length = 0;
  for (int t = 0; t < tri.size(); ++t)
    for (int v = 0; v < 4; ++v) {
      const auto& flow = curves[t][v];
      for (const Flow x : flow)
        if (x < -most_layers || x > most_layers || (length += std::abs(x)) > most_layers)
          return at_vertex("the curve is too long, more than " + std::to_string(most_layers) + " crossings",
                           {t, v});
      if (flow[v] != 0 || flow[0] + flow[1] + flow[2] + flow[3] != 0)
        return at_vertex("the curve does not leave as often as it enters", {t, v});
      for (const int f : face_vertex[v]) {
        const Gluing g = tri.gluing({t, f});
        if (flow[f] != 0 && (g.tet < 0 || curves[g.tet][g.perm[v]][g.perm[f]] != -flow[f]))
          return at_vertex("the curve breaks off", {t, v});
      }
    }
  return std::nullopt;
}

/// How often the curve runs along one that is no multiple; 0 where it bounds a disk. The flows across the
/// sides, seen as values on directed edges, sum to 0 around each triangle: they come from a potential up to
/// the values on closed paths, whose greatest common divisor this is.
Flow multiplicity(const Torus& torus) {
  std::vector<std::array<std::optional<Flow>, 3>> potential(torus.size()); // of each corner's vertex
  std::vector<TorusSide> queue;
  Flow common = 0;
  const auto reach = [&](TorusSide corner, Flow value) {
    auto& known = potential[corner.triangle][corner.side];
    if (known) {
      common = std::gcd(common, value - *known);
    } else {
      known = value;
      queue.push_back(corner);
    }
  };
  reach({0, 0}, 0);
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const TorusSide c = queue[k];
    const Triangle& t = torus[c.triangle];
    const Flow here = *potential[c.triangle][c.side];
    reach({c.triangle, next(c.side)}, here + t.flow[last(c.side)]);
    const TorusSide across = t.partner[next(c.side)];
    reach({across.triangle, next(across.side)}, here);
  }
  return common;
}

} // namespace

std::optional<std::string> why_not_fill(const Triangulation& tri, const CuspCurves& curves) {
  if (auto why = why_no_curves(tri, curves)) return why;
  const Skeleton skeleton(tri);
  const auto cuts = cut_pieces(tri, skeleton);
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    if (!has_curve(skeleton, curves, v)) continue;
    const TetVertex first = skeleton.preimages(v).front();
    if (!is_torus(skeleton.link(v))) return at_vertex("there is no torus", first);
    const Flow multiple = multiplicity(torus_at(tri, skeleton, v, curves, cuts));
    if (multiple != 1)
      return at_vertex(multiple == 0 ? "a curve bounds a disk"
                                     : "a curve runs " + std::to_string(multiple) + " times along another",
                       first);
  }
  return std::nullopt;
}

Triangulation filled(const Triangulation& tri, const CuspCurves& curves) {
  if (const auto why = why_not_fill(tri, curves)) throw PreconditionError("filled: " + *why);
  const Skeleton skeleton(tri);
  const auto cuts = cut_pieces(tri, skeleton);
  Triangulation out = finite_model(tri).tri;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (has_curve(skeleton, curves, v)) Layering(out, torus_at(tri, skeleton, v, curves, cuts)).close();
  return out;
}

} // namespace tetrarch::moves
