// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/hull.hpp"

#include "polytope.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/union_find.hpp"
#include "tiling.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace tetrarch::canonical {
namespace {

constexpr int most_pivots = 1000; ///< of the simplex method; ten are usual
constexpr int most_cells = 100'000;

/// A cell in the basis of the tile `tet` that contains the sum of its corners.
template <class Scalar>
struct DevelopedCell {
  int tet = -1;
  Vector4<Scalar> phi;
  std::vector<Vector4<Scalar>> corners;
  Vector4<Scalar> sum;
  std::vector<PolytopeWall<Scalar>> walls;
  HullCell combinatorial;
};

/// One try with one budget. What goes wrong (a missed vector, mostly) ends in an empty optional.
template <class Scalar>
class HullBuilder {
public:
  HullBuilder(const Tiling<Scalar>& tiling, const HullBudget& budget, double margin, const Progress& progress)
      : tiling_(tiling), budget_(budget), margin_(margin), progress_(progress) {}

  std::optional<std::vector<HullCell>> run(int first_tile) {
    if (!add_first(first_tile)) return std::nullopt;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      progress_.step("convex hull");
      if (!cross_walls(static_cast<int>(c))) return std::nullopt;
    }
    if (!edges_close_up()) return std::nullopt;
    std::vector<HullCell> out;
    out.reserve(cells_.size());
    for (DevelopedCell<Scalar>& cell : cells_) out.push_back(std::move(cell.combinatorial));
    return out;
  }

private:
  using Vectors = std::vector<Vector4<Scalar>>;

  static Vector4<Scalar> apply(const numeric::Matrix4<Scalar>& m, const Vector4<Scalar>& x) {
    return {dot<Scalar>(m[0], x), dot<Scalar>(m[1], x), dot<Scalar>(m[2], x), dot<Scalar>(m[3], x)};
  }

  /// The simplex method: of the four vectors that span a generic x one is exchanged for a vector below 1,
  /// until there is none.
  bool add_first(int tet) {
    const Vector4<Scalar> x{Scalar(0.31), Scalar(0.27), Scalar(0.23), Scalar(0.19)};
    Tile<Scalar> basis = tiling_.frame(tet);
    for (int pivot = 0; pivot < most_pivots; ++pivot) {
      progress_.step("convex hull");
      const auto to_basis = Tiling<Scalar>::into_basis(basis);
      Vector4<Scalar> phi;
      for (int i = 0; i < 4; ++i) phi[i] = to_basis[0][i] + to_basis[1][i] + to_basis[2][i] + to_basis[3][i];
      Vector4<Scalar> lower;
      const Vectors known(basis.vertex.begin(), basis.vertex.end());
      const auto corners = corners_on(tet, phi, known, [&lower](const Vector4<Scalar>& v) {
        lower = v;
        return true;
      });
      if (corners) return find_or_add(tet, phi, *corners).has_value();
      const Vector4<Scalar> c = apply(to_basis, x);
      const Vector4<Scalar> a = apply(to_basis, lower);
      int leaves = -1;
      for (int j = 0; j < 4; ++j)
        if (a[j] > 0 && (leaves < 0 || c[j] * a[leaves] < c[leaves] * a[j])) leaves = j;
      if (leaves < 0) return false;
      basis.vertex[leaves] = lower;
    }
    return false;
  }

  /// The vectors on the hyperplane of phi, `known` ones first; nothing if one below it was seen and `below`,
  /// to which it is shown, returned true.
  template <class Function>
  std::optional<Vectors> corners_on(int frame_tet, const Vector4<Scalar>& phi, const Vectors& known,
                                    Function&& below) const {
    Vectors corners = known;
    const bool lower = tiling_.explore(frame_tet, phi, budget_, [&](const Sighting<Scalar>& seen) {
      const bool is_known = std::any_of(
          known.begin(), known.end(), [&seen](const auto& v) { return same_vector<Scalar>(v, seen.vector); });
      const Scalar height = seen.value - 1; // 1 + margin_ would be 1 in double precision
      if (is_known || height > margin_) return false;
      if (height < -margin_) return below(seen.vector);
      corners.push_back(seen.vector);
      return false;
    });
    if (lower) return std::nullopt;
    return corners;
  }

  /// The cell with these corners: its number and how coordinates in the frame become the cell's.
  struct Found {
    int cell;
    numeric::Matrix4<Scalar> to_cell;
  };
  std::optional<Found> find_or_add(int frame_tet, const Vector4<Scalar>& phi, const Vectors& corners) {
    if (corners.size() < 4) return std::nullopt;
    Vector4<Scalar> sum{Scalar(0), Scalar(0), Scalar(0), Scalar(0)};
    for (const Vector4<Scalar>& v : corners)
      for (int i = 0; i < 4; ++i) sum[i] += v[i];
    const auto places = tiling_.locate(frame_tet, sum, margin_);
    if (places.empty()) return std::nullopt;
    for (const auto& place : places)
      for (std::size_t k = 0; k < cells_.size(); ++k)
        if (cells_[k].tet == place.tile.tet && same_vector<Scalar>(cells_[k].sum, place.coordinates))
          return Found{static_cast<int>(k), Tiling<Scalar>::into_basis(place.tile)};
    if (cells_.size() >= most_cells) return std::nullopt;
    const auto to_cell = Tiling<Scalar>::into_basis(places[0].tile);
    if (!add(places[0], to_cell, phi, corners)) return std::nullopt;
    return Found{static_cast<int>(cells_.size()) - 1, to_cell};
  }

  bool add(const typename Tiling<Scalar>::Place& place, const numeric::Matrix4<Scalar>& to_cell,
           const Vector4<Scalar>& phi, const Vectors& corners) {
    DevelopedCell<Scalar> cell;
    cell.tet = place.tile.tet;
    cell.sum = place.coordinates;
    for (int v = 0; v < 4; ++v) cell.phi[v] = dot<Scalar>(phi, place.tile.vertex[v]);
    for (const Vector4<Scalar>& v : corners) cell.corners.push_back(apply(to_cell, v));
    auto walls = polytope_walls<Scalar>(cell.corners, margin_);
    if (!walls) return false;
    cell.walls = std::move(*walls);
    cell.combinatorial.corner_count = static_cast<int>(corners.size());
    for (const auto& wall : cell.walls) cell.combinatorial.walls.push_back({wall.corners, -1, -1, {}});
    cells_.push_back(std::move(cell));
    return true;
  }

  bool cross_walls(int c) {
    std::vector<Sighting<Scalar>> seen;
    tiling_.explore(cells_[c].tet, cells_[c].phi, budget_, [&seen](const Sighting<Scalar>& sighting) {
      seen.push_back(sighting);
      return false;
    });
    for (int w = 0; w < static_cast<int>(cells_[c].walls.size()); ++w)
      if (cells_[c].combinatorial.walls[w].other_cell < 0 && !cross_wall(c, w, seen)) return false;
    return true;
  }

  /// A hyperplane that turns about a wall until it meets a vector beyond: phi + lambda psi.
  struct Turning {
    Vector4<Scalar> phi;
    Vector4<Scalar> psi;
    double margin;
    std::optional<Scalar> lambda;
    Vector4<Scalar> vector; ///< the one that it meets

    /// True if v is met earlier than what was known.
    bool meets(const Vector4<Scalar>& v) {
      const Scalar side = dot<Scalar>(psi, v);
      if (side >= -margin) return false;
      const Scalar ratio = (dot<Scalar>(phi, v) - 1) / -side;
      if (lambda && ratio >= *lambda) return false;
      lambda = ratio;
      vector = v;
      return true;
    }
    Vector4<Scalar> turned() const {
      Vector4<Scalar> next;
      for (int i = 0; i < 4; ++i) next[i] = phi[i] + *lambda * psi[i];
      return next;
    }
  };

  bool cross_wall(int c, int w, const std::vector<Sighting<Scalar>>& seen) {
    const int tet = cells_[c].tet;
    const Vector4<Scalar> phi = cells_[c].phi;
    Turning turning{phi, cells_[c].walls[w].psi, margin_, std::nullopt, {}};
    for (const Sighting<Scalar>& s : seen) turning.meets(s.vector);
    if (!turning.lambda) // all that was seen lies on this side: look farther, for any vector beyond
      tiling_.explore(tet, phi, {budget_.tiles, 0},
                      [&turning](const Sighting<Scalar>& s) { return turning.meets(s.vector); });
    Vectors known;
    for (const int corner : cells_[c].walls[w].corners) known.push_back(cells_[c].corners[corner]);
    for (int pivot = 0; turning.lambda && pivot < most_pivots; ++pivot) {
      progress_.step("convex hull");
      if (!(*turning.lambda > margin_)) return false; // the next cell lies strictly above this hyperplane
      const Vector4<Scalar> next = turning.turned();
      Vectors with_new = known;
      with_new.push_back(turning.vector);
      const auto corners =
          corners_on(tet, next, with_new, [&turning](const Vector4<Scalar>& v) { return turning.meets(v); });
      if (!corners) continue;
      const auto found = find_or_add(tet, next, *corners);
      return found && glue(c, w, *found);
    }
    return false;
  }

  /// Finds the wall of the cell across on the same corners, and glues both to each other.
  bool glue(int c, int w, const Found& found) {
    const DevelopedCell<Scalar>& other = cells_[found.cell];
    const std::vector<int>& corners = cells_[c].walls[w].corners;
    std::vector<int> images;
    for (const int corner : corners) {
      const Vector4<Scalar> image = apply(found.to_cell, cells_[c].corners[corner]);
      const auto at = std::find_if(other.corners.begin(), other.corners.end(),
                                   [&image](const auto& v) { return same_vector<Scalar>(v, image); });
      if (at == other.corners.end()) return false;
      images.push_back(static_cast<int>(at - other.corners.begin()));
    }
    for (int k = 0; k < static_cast<int>(other.walls.size()); ++k) {
      if (!std::is_permutation(images.begin(), images.end(), other.walls[k].corners.begin(),
                               other.walls[k].corners.end()))
        continue;
      HullWall& there = cells_[found.cell].combinatorial.walls[k];
      if (there.other_cell >= 0) return false; // it is glued already, to another one
      std::vector<int> back;
      for (const int corner : other.walls[k].corners)
        back.push_back(corners[std::find(images.begin(), images.end(), corner) - images.begin()]);
      there = {other.walls[k].corners, c, w, std::move(back)};
      cells_[c].combinatorial.walls[w] = {corners, found.cell, k, std::move(images)};
      return true;
    }
    return false;
  }

  /// The angle of cell c at the edge between two walls; rounding at 0 and pi does not matter here.
  double angle(int c, int w1, int w2) const {
    const DevelopedCell<Scalar>& cell = cells_[c];
    const auto& p = cell.walls[w1].psi;
    const auto& q = cell.walls[w2].psi;
    const auto pq = static_cast<double>(tiling_.product(cell.tet, p, q));
    const auto pp = static_cast<double>(tiling_.product(cell.tet, p, p));
    const auto qq = static_cast<double>(tiling_.product(cell.tet, q, q));
    return std::acos(std::clamp(-pq / std::sqrt(pp * qq), -1.0, 1.0));
  }

  /// The angles around every edge class add up to 2 pi.
  bool edges_close_up() const {
    std::map<std::array<int, 3>, int> number; // (cell, smaller corner, larger corner)
    std::map<std::array<int, 3>, std::vector<int>> walls_at;
    for (int c = 0; c < static_cast<int>(cells_.size()); ++c)
      for (int w = 0; w < static_cast<int>(cells_[c].walls.size()); ++w)
        for_each_side(c, w, [&](const std::array<int, 3>& edge, const std::array<int, 3>&) {
          number.emplace(edge, static_cast<int>(number.size()));
          walls_at[edge].push_back(w);
        });
    std::vector<int> root(number.size());
    std::iota(root.begin(), root.end(), 0);
    for (int c = 0; c < static_cast<int>(cells_.size()); ++c)
      for (int w = 0; w < static_cast<int>(cells_[c].walls.size()); ++w)
        for_each_side(c, w, [&](const std::array<int, 3>& edge, const std::array<int, 3>& image) {
          root[numeric::find_root(root, number.at(edge))] = numeric::find_root(root, number.at(image));
        });
    std::vector<double> sum(root.size(), 0);
    for (const auto& [edge, walls] : walls_at)
      sum[numeric::find_root(root, number.at(edge))] += angle(edge[0], walls.at(0), walls.at(1));
    constexpr double tolerance = 1e-5; // a missing or doubled cell changes a sum by much more
    for (std::size_t k = 0; k < root.size(); ++k)
      if (root[k] == static_cast<int>(k) && !(std::abs(sum[k] - 2 * numeric::pi<double>()) < tolerance))
        return false;
    return true;
  }

  template <class Function>
  void for_each_side(int c, int w, Function&& function) const {
    const HullWall& wall = cells_[c].combinatorial.walls[w];
    for (std::size_t k = 0; k < wall.corners.size(); ++k) {
      const std::size_t next = (k + 1) % wall.corners.size();
      const auto [a, b] = std::minmax(wall.corners[k], wall.corners[next]);
      const auto [p, q] = std::minmax(wall.images[k], wall.images[next]);
      function(std::array{c, a, b}, std::array{wall.other_cell, p, q});
    }
  }

  const Tiling<Scalar>& tiling_;
  HullBudget budget_;
  double margin_;
  const Progress& progress_;
  std::vector<DevelopedCell<Scalar>> cells_;
};

/// Tetrahedra by the height of their own functional: a low one is near the hull.
template <class Scalar>
std::vector<int> first_tiles(const Tiling<Scalar>& tiling) {
  std::vector<std::pair<double, int>> order;
  order.reserve(static_cast<std::size_t>(tiling.decorated().tri.size()));
  const Vector4<Scalar> one{Scalar(1), Scalar(1), Scalar(1), Scalar(1)};
  for (int t = 0; t < tiling.decorated().tri.size(); ++t)
    order.emplace_back(static_cast<double>(tiling.product(t, one, one)), t);
  std::sort(order.begin(), order.end());
  std::vector<int> tiles;
  tiles.reserve(order.size());
  for (const auto& [height, t] : order) tiles.push_back(t);
  return tiles;
}

} // namespace

template <class Scalar>
std::optional<std::vector<HullCell>> direct_hull(const Decorated<Scalar>& m, const HullOptions& options,
                                                 const Progress& progress) {
  const Tiling<Scalar> tiling(m);
  const std::vector<int> first = first_tiles(tiling);
  for (const HullBudget& budget : options.budgets)
    for (int k = 0; k < std::min(options.starts, static_cast<int>(first.size())); ++k)
      if (auto cells = HullBuilder<Scalar>(tiling, budget, options.margin, progress).run(first[k]))
        return cells;
  return std::nullopt;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template std::optional<std::vector<HullCell>> direct_hull(const Decorated<Scalar>&, const HullOptions&,    \
                                                            const Progress&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::canonical
