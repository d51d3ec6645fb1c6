// SPDX-License-Identifier: GPL-2.0-or-later
#include "exact.hpp"

#include <array>
#include <vector>

namespace tetrarch::canonical {
namespace {

using hyperbolic::VertexType;
using numeric::Algebraic;
using numeric::Ball;
using Vector = std::array<Algebraic, 4>;

/// Fields of degrees 5 and 9 were seen in cells, up to 14 in cusped manifolds of five tetrahedra. The longest
/// step of a search, which nothing interrupts, takes 0.1 s for degree 16, 0.5 s for 24 and 1.4 s for 30
/// (measured on x^d - 2).
constexpr int most_degree = 16;
/// What `recognize` asks for, and room for the rounding on the way.
constexpr int bits_to_see = 100 * most_degree + 400;
/// Values of exact numbers, for signs and angles.
constexpr int bits_to_compare = 212;

Algebraic exact_product(const Vector& x, const Gram<Algebraic>& w, const Vector& y) {
  Algebraic sum;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) sum += x[i] * w[i][j] * y[j];
  return sum;
}

/// One side of each face.
std::vector<TetFace> first_sides(const Triangulation& tri) {
  std::vector<TetFace> list;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (TetFace{t, f} < TetFace{g.tet, g.perm[f]}) list.push_back({t, f});
    }
  return list;
}

/// Inner products that were guessed, and the proof that they are those of the hyperbolic structure.
class ExactStructure {
public:
  ExactStructure(const Triangulation& tri, const Skeleton& skeleton,
                 const std::function<void()>& still_wanted)
      : tri_(tri), skeleton_(skeleton), still_wanted_(still_wanted),
        types_(hyperbolic::vertex_types(skeleton)), across_(static_cast<std::size_t>(tri.size())) {}

  /// Whether the numbers, taken for what `products_to_guess` lists, make a structure.
  bool is_made_of(const std::vector<Algebraic>& numbers) {
    fill_gram(numbers);
    return has_tetrahedra() && place_neighbors(numbers) && closes_around_edges() && has_equal_cusps();
  }

  /// The far vertex lies in the affine hyperplane of the four near ones.
  bool is_flat(TetFace f) const {
    const Vector& a = across_[f.tet][f.face];
    return a[0] + a[1] + a[2] + a[3] == Algebraic(1);
  }

private:
  void ask() const {
    if (still_wanted_) still_wanted_();
  }

  void fill_gram(const std::vector<Algebraic>& numbers) {
    gram_.resize(static_cast<std::size_t>(tri_.size()));
    for (int t = 0; t < tri_.size(); ++t)
      for (int v = 0; v < 4; ++v)
        for (int w = 0; w < 4; ++w)
          gram_[t][v][w] = v == w ? Algebraic(norm(types_[skeleton_.vertex({t, v})]))
                                  : numbers[skeleton_.edge({t, edge_number[v][w]}).value];
  }

  /// The tetrahedra exist, and their angles around each edge add up to a number near 2 pi.
  bool has_tetrahedra() const {
    hyperbolic::Metric<Ball> lengths(skeleton_.edge_count(), Ball(0));
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      const Walk& w = skeleton_.around(e).front();
      const Ball c = -gram_[w.tet][w.from()][w.to()].value();
      const auto [p, q] = skeleton_.ends(e);
      if (types_[p] == VertexType::hyperideal && types_[q] == VertexType::hyperideal)
        lengths[e] = log(c + sqrt(c * c - 1));
      else
        lengths[e] = log(types_[p] == types_[q] ? Ball(c / 2) : c);
      if (!(c > 0) || !is_finite(lengths[e])) return false;
    }
    hyperbolic::Metric<Ball> sum(skeleton_.edge_count(), Ball(0));
    for (int t = 0; t < tri_.size(); ++t) {
      const auto angles = hyperbolic::dihedral_angles(hyperbolic::lengths_at(skeleton_, lengths, t),
                                                      hyperbolic::types_at(skeleton_, types_, t));
      if (!angles) return false;
      for (int e = 0; e < 6; ++e) sum[skeleton_.edge({t, e})] += (*angles)[e];
    }
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count()))
      if (!(abs(sum[e] - 2 * numeric::pi<Ball>()) < 1)) return false;
    return true;
  }

  /// a of every face, from the inner products of the far vertex with the four near ones.
  bool place_neighbors(const std::vector<Algebraic>& numbers) {
    std::size_t next = static_cast<std::size_t>(skeleton_.edge_count());
    for (const TetFace f : first_sides(tri_)) {
      ask();
      const Gluing g = tri_.gluing(f);
      const TetFace there{g.tet, g.perm[f.face]};
      const Algebraic& far = numbers[next++];
      if (!place_neighbor(f, far) || !place_neighbor(there, far)) return false;
    }
    return true;
  }

  bool place_neighbor(TetFace f, const Algebraic& far) {
    const Gluing g = tri_.gluing(f);
    const int vertex = g.perm[f.face];
    Vector products;
    for (int j = 0; j < 4; ++j) products[j] = j == f.face ? far : gram_[g.tet][g.perm[j]][vertex];
    const auto a = far_vertex(gram_[f.tet], products, gram_[g.tet][vertex][vertex], f.face);
    if (!a) return false;
    across_[f.tet][f.face] = *a;
    return true;
  }

  /// Coordinates in the neighbor's basis become coordinates in this one's.
  Vector carried(TetFace f, const Vector& x) const {
    const Gluing g = tri_.gluing(f);
    Vector y;
    for (int j = 0; j < 4; ++j) {
      const Algebraic& part = x[g.perm[j]];
      if (j != f.face) {
        y[j] += part;
        continue;
      }
      for (int k = 0; k < 4; ++k) y[k] += part * across_[f.tet][f.face][k];
    }
    return y;
  }

  /// Tetrahedra laid out around an edge come back to the first one: the angle is a multiple of 2 pi.
  bool closes_around_edges() const {
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      ask();
      const auto& around = skeleton_.around(e);
      for (int v = 0; v < 4; ++v) {
        Vector start;
        start[v] = Algebraic(1);
        Vector x = start;
        for (auto w = around.rbegin(); w != around.rend(); ++w) x = carried(w->left_face(), x);
        if (x != start) return false;
      }
    }
    return true;
  }

  /// Cross-sections of all cusps have one area. The area at a corner is sqrt(D) / (2 |w_ij w_ik w_il|), and
  /// the sqrt(D) of neighbors are as 1 to |a_f|.
  bool has_equal_cusps() const {
    std::vector<Algebraic> root(static_cast<std::size_t>(tri_.size()));
    root[0] = Algebraic(1);
    std::vector<bool> known(root.size(), false);
    known[0] = true;
    std::vector<int> queue{0};
    for (std::size_t head = 0; head < queue.size(); ++head)
      for (int f = 0; f < 4; ++f) {
        const int t = queue[head];
        const int next = tri_.gluing({t, f}).tet;
        if (known[next]) continue;
        known[next] = true;
        root[next] = -across_[t][f][f] * root[t];
        queue.push_back(next);
      }
    Table<VertexId, Algebraic> area(skeleton_.vertex_count());
    for (int t = 0; t < tri_.size(); ++t)
      for (int v = 0; v < 4; ++v) {
        if (gram_[t][v][v] == Algebraic(1)) continue;
        Algebraic products(-1);
        for (const int w : face_vertex[v]) products *= gram_[t][v][w];
        const auto inverse = products.inverse();
        if (!inverse) return false;
        area[skeleton_.vertex({t, v})] += root[t] * *inverse;
      }
    const Algebraic* first = nullptr;
    for (const VertexId v : all<VertexId>(skeleton_.vertex_count())) {
      if (types_[v] != VertexType::ideal) continue;
      if (first == nullptr) first = &area[v];
      if (!(area[v] == *first)) return false;
    }
    return true;
  }

  const Triangulation& tri_;
  const Skeleton& skeleton_;
  const std::function<void()>& still_wanted_;
  Table<VertexId, VertexType> types_;
  std::vector<Gram<Algebraic>> gram_;
  std::vector<std::array<Vector, 4>> across_; ///< of each face
};

/// Cusps alone: their cross-sections may be scaled alike, such that the first inner product is -1.
void scale(Decorated<Ball>& m, const Skeleton& skeleton) {
  const Walk& w = skeleton.around(EdgeId(0)).front();
  const Ball first = abs(m.gram[w.tet][w.from()][w.to()]);
  for (auto& gram : m.gram)
    for (auto& row : gram)
      for (Ball& x : row) x /= first;
}

} // namespace

std::optional<Vector> far_vertex(const Gram<Algebraic>& near, const Vector& products, const Algebraic& norm,
                                 int face) {
  const numeric::Minors<Algebraic> minors(near);
  const auto over_determinant = minors.determinant().inverse();
  if (!over_determinant) return std::nullopt;
  const Gram<Algebraic> adjugate = numeric::adjugate(near, minors);
  Vector a;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) a[i] += adjugate[i][j] * products[j];
    a[i] *= *over_determinant;
  }
  if (exact_product(a, near, a) != norm || !(a[face].value() < 0)) return std::nullopt;
  return a;
}

std::vector<Ball> products_to_guess(const Decorated<Ball>& m, const Skeleton& skeleton) {
  std::vector<Ball> list;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const Walk& w = skeleton.around(e).front();
    list.push_back(m.gram[w.tet][w.from()][w.to()]);
  }
  for (const TetFace f : first_sides(m.tri)) list.push_back(product_across(m, f, look_across(m, f)));
  return list;
}

bool are_of_flat_structure(const Triangulation& tri, const Skeleton& skeleton, const FlatFaces& flat,
                           const std::vector<Algebraic>& products,
                           const std::function<void()>& still_wanted) {
  const numeric::WorkingPrecision enough(bits_to_compare);
  ExactStructure exact(tri, skeleton, still_wanted);
  if (!exact.is_made_of(products)) return false;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (flat[t][f] && !exact.is_flat({t, f})) return false;
  return true;
}

std::optional<std::string> prove_flat_exactly(const Triangulation& tri, const Skeleton& skeleton,
                                              const FlatFaces& flat, const PreciseSolver& solver,
                                              const std::function<void()>& still_wanted) {
  bool any_cusp = false;
  bool any_boundary = false;
  for (const VertexType type : hyperbolic::vertex_types(skeleton)) {
    any_cusp |= type == VertexType::ideal;
    any_boundary |= type != VertexType::ideal;
    if (type == VertexType::finite) return std::nullopt;
  }
  if (any_cusp && any_boundary) return std::nullopt;
  const numeric::WorkingPrecision precise(bits_to_see);
  const auto balls = solver(bits_to_see);
  if (!balls) return std::nullopt;
  Decorated<Ball> m = decorate(tri, skeleton, *balls);
  if (any_cusp) scale(m, skeleton);
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (flat[t][f] && abs(look_across(m, {t, f}).tilt) > 0) return std::nullopt;
  const auto seen = numeric::recognize(products_to_guess(m, skeleton), most_degree, still_wanted);
  if (!seen || !are_of_flat_structure(tri, skeleton, flat, seen->numbers, still_wanted)) return std::nullopt;
  return seen->polynomial;
}

} // namespace tetrarch::canonical
