// SPDX-License-Identifier: GPL-2.0-or-later
#include "tiling.hpp"

#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace tetrarch::canonical {
namespace {

using numeric::Matrix4;

constexpr double near_enough = 1e-9;
constexpr int longest_walk = 20'000; ///< tiles on the way to a point; a hundred are usual for large ones

template <class Scalar>
Matrix4<Scalar> inverse(const Matrix4<Scalar>& m) {
  const numeric::Minors<Scalar> minors(m);
  Matrix4<Scalar> a = numeric::adjugate(m, minors);
  const Scalar scale = 1 / minors.determinant();
  for (auto& row : a)
    for (Scalar& x : row) x *= scale;
  return a;
}

template <class Scalar>
Vector4<Scalar> values_on(const Tile<Scalar>& tile, const Vector4<Scalar>& phi) {
  Vector4<Scalar> values;
  for (int v = 0; v < 4; ++v) values[v] = dot<Scalar>(phi, tile.vertex[v]);
  return values;
}

template <class Scalar>
int least_index(const Vector4<Scalar>& x) {
  return static_cast<int>(std::min_element(x.begin(), x.end()) - x.begin());
}

/// Vectors or tiles that were met, sorted by one of their numbers so that equal ones are found quickly.
template <class Scalar>
class Met {
public:
  /// True if it was not met before.
  bool insert(int kind, const Vector4<Scalar>& x, const Scalar& number) {
    const auto key = static_cast<double>(number);
    const double slack = 1e-5 * (1 + std::abs(key));
    for (auto at = met_.lower_bound(key - slack); at != met_.end() && at->first <= key + slack; ++at)
      if (at->second.first == kind && same_vector<Scalar>(at->second.second, x)) return false;
    met_.emplace(key, std::pair{kind, x});
    return true;
  }

private:
  std::multimap<double, std::pair<int, Vector4<Scalar>>> met_;
};

template <class Scalar>
Vector4<Scalar> vertex_sum(const Tile<Scalar>& tile) {
  Vector4<Scalar> sum{Scalar(0), Scalar(0), Scalar(0), Scalar(0)};
  for (const Vector4<Scalar>& v : tile.vertex)
    for (int i = 0; i < 4; ++i) sum[i] += v[i];
  return sum;
}

} // namespace

template <class Scalar>
Tiling<Scalar>::Tiling(const Decorated<Scalar>& m) : m_(m) {
  for (int t = 0; t < m.tri.size(); ++t) {
    across_.emplace_back();
    for (int f = 0; f < 4; ++f) across_.back()[f] = look_across(m, {t, f});
    inverse_.push_back(inverse<Scalar>(m.gram[t]));
    for (int v = 0; v < 4; ++v) some_hyperideal_ |= m.gram[t][v][v] > 0;
  }
}

template <class Scalar>
Scalar Tiling<Scalar>::product(int tet, const Vector4<Scalar>& phi, const Vector4<Scalar>& psi) const {
  Scalar sum(0);
  for (int i = 0; i < 4; ++i) sum += phi[i] * dot<Scalar>(inverse_[tet][i], psi);
  return sum;
}

template <class Scalar>
Tile<Scalar> Tiling<Scalar>::frame(int tet) const {
  Tile<Scalar> tile{tet, {}};
  for (int v = 0; v < 4; ++v)
    for (int i = 0; i < 4; ++i) tile.vertex[v][i] = Scalar(i == v ? 1 : 0);
  return tile;
}

template <class Scalar>
Tile<Scalar> Tiling<Scalar>::across(const Tile<Scalar>& tile, int face) const {
  const Gluing g = m_.tri.gluing({tile.tet, face});
  const auto& a = across_[tile.tet][face].a;
  Tile<Scalar> next{g.tet, {}};
  for (const int v : face_vertex[face]) next.vertex[g.perm[v]] = tile.vertex[v];
  for (int i = 0; i < 4; ++i) {
    Scalar x(0);
    for (int v = 0; v < 4; ++v) x += a[v] * tile.vertex[v][i];
    next.vertex[g.perm[face]][i] = x;
  }
  return next;
}

template <class Scalar>
Matrix4<Scalar> Tiling<Scalar>::into_basis(const Tile<Scalar>& tile) {
  Matrix4<Scalar> columns;
  for (int v = 0; v < 4; ++v)
    for (int i = 0; i < 4; ++i) columns[i][v] = tile.vertex[v][i];
  return inverse<Scalar>(columns);
}

/// The largest value that phi = 1 on a vector leaves to phi on the way from its pole n to the vector's plane
/// (|n| sinh d = 1 at distance d, phi is |n| cosh d there) or horosphere (|n| exp d = 1). One of the larger
/// `area` belongs to a shorter vector.
template <class Scalar>
double Tiling<Scalar>::reach(int frame_tet, const Vector4<Scalar>& phi, double area) const {
  const double square = -static_cast<double>(product(frame_tet, phi, phi));
  if (!(square > 0 && area > 0)) return std::numeric_limits<double>::infinity(); // no point has no distances
  if (some_hyperideal_) return std::sqrt(1 + square);
  const double shrink = std::sqrt(cusp_area / area);
  return (shrink + square / shrink) / 2;
}

/// About how near the pole of phi comes to a face: the least value of phi on its points of norm -1. It is
/// exact where the pole is a point: beyond one side of the face, the nearest point lies on that side.
template <class Scalar>
Scalar Tiling<Scalar>::least_on_face(const Tile<Scalar>& tile, int face,
                                     const Vector4<Scalar>& values) const {
  using std::sqrt;
  const Gram<Scalar>& w = m_.gram[tile.tet];
  const auto& s = face_vertex[face];
  // The pole's projection to the plane of the face, by Cramer's rule: w_S c = -phi_S.
  std::array<Scalar, 3> c;
  Scalar det(0);
  for (int i = 0; i < 3; ++i) {
    c[i] = Scalar(0);
    for (int j = 0; j < 3; ++j) {
      const int i1 = s[(i + 1) % 3];
      const int i2 = s[(i + 2) % 3];
      const int j1 = s[(j + 1) % 3];
      const int j2 = s[(j + 2) % 3];
      const Scalar cofactor = w[i1][j1] * w[i2][j2] - w[i1][j2] * w[i2][j1];
      c[i] -= cofactor * values[s[j]];
      if (i == 0) det += w[s[0]][s[j]] * cofactor;
    }
  }
  Scalar norm(0);
  bool inside = true;
  for (int i = 0; i < 3; ++i) {
    c[i] /= det;
    norm -= c[i] * values[s[i]];
    inside &= c[i] >= 0;
  }
  if (inside && norm < 0) return sqrt(Scalar(-norm));
  const int drop = static_cast<int>(std::min_element(c.begin(), c.end()) - c.begin());
  const int p = s[(drop + 1) % 3];
  const int q = s[(drop + 2) % 3];
  const Scalar edge_det = w[p][p] * w[q][q] - w[p][q] * w[p][q];
  const Scalar cp = -(w[q][q] * values[p] - w[p][q] * values[q]) / edge_det;
  const Scalar cq = -(w[p][p] * values[q] - w[p][q] * values[p]) / edge_det;
  norm = -(cp * values[p] + cq * values[q]);
  if (cp >= 0 && cq >= 0 && norm < 0) return sqrt(Scalar(-norm));
  Scalar square(0);
  for (const int i : s)
    for (const int j : s) square -= w[i][j];
  return (values[s[0]] + values[s[1]] + values[s[2]]) / sqrt(square);
}

/// Coordinates of a vector in the basis of the tile across a face, from those in this tile's.
template <class Scalar>
Vector4<Scalar> Tiling<Scalar>::coordinates_across(int tet, int face, const Vector4<Scalar>& c) const {
  const Gluing g = m_.tri.gluing({tet, face});
  const auto& a = across_[tet][face].a;
  const Scalar far = c[face] / a[face];
  Vector4<Scalar> next;
  next[g.perm[face]] = far;
  for (const int v : face_vertex[face]) next[g.perm[v]] = c[v] - far * a[v];
  return next;
}

template <class Scalar>
Tile<Scalar> Tiling<Scalar>::tile_at_pole(int frame_tet, const Vector4<Scalar>& phi) const {
  Tile<Scalar> tile = frame(frame_tet);
  if (!(product(frame_tet, phi, phi) < 0)) return tile; // the pole is no point of hyperbolic space
  for (int step = 0; step < longest_walk; ++step) {
    const Vector4<Scalar> values = values_on(tile, phi);
    Vector4<Scalar> c;
    for (int i = 0; i < 4; ++i) c[i] = -dot<Scalar>(inverse_[tile.tet][i], values);
    const int face = least_index<Scalar>(c);
    if (c[face] >= -near_enough) return tile; // on its boundary rounding might send us to and fro for ever
    tile = across(tile, face);
  }
  return frame(frame_tet);
}

template <class Scalar>
bool Tiling<Scalar>::explore(int frame_tet, const Vector4<Scalar>& phi, const HullBudget& budget,
                             const std::function<bool(const Sighting<Scalar>&)>& visit) const {
  struct Entry {
    Scalar key;
    std::size_t tile;
    bool operator<(const Entry& other) const { return key > other.key; } // the least comes out first
  };
  std::vector<Tile<Scalar>> tiles;
  std::priority_queue<Entry> queue;
  Met<Scalar> met_tiles;
  Met<Scalar> met_vectors;
  const auto show = [&](const Vector4<Scalar>& vector) {
    const Sighting<Scalar> seen{vector, dot<Scalar>(phi, vector)};
    return met_vectors.insert(0, vector, seen.value) && visit(seen);
  };
  tiles.push_back(tile_at_pole(frame_tet, phi));
  queue.push({Scalar(0), 0});
  const Vector4<Scalar> first_sum = vertex_sum(tiles[0]);
  met_tiles.insert(tiles[0].tet, first_sum, dot<Scalar>(phi, first_sum));
  for (const Vector4<Scalar>& v : tiles[0].vertex)
    if (show(v)) return true;
  const double farthest = reach(frame_tet, phi, budget.cusp_area) * (1 + 1e-6);
  for (int looked_at = 0; looked_at < budget.tiles && !queue.empty(); ++looked_at) {
    if (queue.top().key > farthest) break;
    const Tile<Scalar> tile = tiles[queue.top().tile];
    queue.pop();
    const Vector4<Scalar> values = values_on(tile, phi);
    for (int f = 0; f < 4; ++f) {
      Tile<Scalar> next = across(tile, f);
      const Vector4<Scalar> sum = vertex_sum(next);
      if (!met_tiles.insert(next.tet, sum, dot<Scalar>(phi, sum))) continue;
      if (show(next.vertex[m_.tri.gluing({tile.tet, f}).perm[f]])) return true;
      queue.push({least_on_face(tile, f, values), tiles.size()});
      tiles.push_back(std::move(next));
    }
  }
  return false;
}

template <class Scalar>
std::vector<typename Tiling<Scalar>::Place>
Tiling<Scalar>::locate(int frame_tet, const Vector4<Scalar>& vector, double margin) const {
  Place place{frame(frame_tet), vector};
  for (int step = 0;; ++step) {
    const int face = least_index<Scalar>(place.coordinates);
    if (place.coordinates[face] >= -margin) break;
    if (step == longest_walk) return {};
    place.coordinates = coordinates_across(place.tile.tet, face, place.coordinates);
    place.tile = across(place.tile, face);
  }
  std::vector<Place> places{place};
  for (std::size_t k = 0; k < places.size() && places.size() < 1000; ++k)
    for (int f = 0; f < 4; ++f) {
      if (places[k].coordinates[f] > margin) continue;
      Place next{across(places[k].tile, f), coordinates_across(places[k].tile.tet, f, places[k].coordinates)};
      const bool known = std::any_of(places.begin(), places.end(), [&next](const Place& other) {
        return other.tile.tet == next.tile.tet &&
               same_vector<Scalar>(vertex_sum(other.tile), vertex_sum(next.tile));
      });
      if (!known) places.push_back(std::move(next));
    }
  return places;
}

#define TETRARCH_INSTANTIATE(Scalar) template class Tiling<Scalar>;
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::canonical
