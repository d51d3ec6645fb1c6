// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/hull.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace tetrarch::canonical {
namespace {

/// Corners of the small tetrahedra of the coned triangulation: 0 and 1 the ends of the side, then these.
constexpr int wall_center = 2;
constexpr int cell_center = 3;

int position(const std::vector<int>& list, int x) {
  const auto at = std::find(list.begin(), list.end(), x);
  return at == list.end() ? -1 : static_cast<int>(at - list.begin());
}

class HullConer {
public:
  explicit HullConer(const std::vector<HullCell>& cells) : cells_(cells) {}

  CellDecomposition run() {
    CellDecomposition out;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      Cell cell;
      first_.emplace_back();
      for (const HullWall& wall : cells_[c].walls) {
        const int sides = static_cast<int>(wall.corners.size());
        cell.walls.push_back(sides);
        first_.back().push_back(out.coned.add_tetrahedra(sides));
      }
      std::sort(cell.walls.begin(), cell.walls.end(), std::greater<>());
      out.cells.push_back(std::move(cell));
    }
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (std::size_t w = 0; w < cells_[c].walls.size(); ++w)
        for (std::size_t k = 0; k < cells_[c].walls[w].corners.size(); ++k) glue_small(out.coned, {c, w, k});
    return out;
  }

private:
  struct Side {
    std::size_t cell;
    std::size_t wall;
    std::size_t at; ///< from corners[at] to the next
  };
  int small(const Side& s) const { return first_[s.cell][s.wall] + static_cast<int>(s.at); }
  const std::vector<int>& corners(std::size_t c, std::size_t w) const { return cells_[c].walls[w].corners; }
  int start(const Side& s) const { return corners(s.cell, s.wall)[s.at]; }
  int end(const Side& s) const {
    const auto& all = corners(s.cell, s.wall);
    return all[(s.at + 1) % all.size()];
  }

  /// The side of wall w of cell c with these ends, in whatever direction; at == number of sides if there is
  /// none.
  Side side_between(std::size_t c, std::size_t w, int a, int b) const {
    Side s{c, w, 0};
    for (; s.at < corners(c, w).size(); ++s.at)
      if ((start(s) == a && end(s) == b) || (start(s) == b && end(s) == a)) break;
    return s;
  }

  void glue_side(Triangulation& coned, const Side& s, int face, const Side& other, int start_image) const {
    const Perm4 p = start(other) == start_image ? Perm4() : Perm4::swap(0, 1);
    if (coned.is_boundary({small(s), face})) coned.glue({small(s), face}, small(other), p);
  }

  void glue_small(Triangulation& coned, const Side& s) const {
    const HullWall& wall = cells_[s.cell].walls[s.wall];
    const std::size_t count = wall.corners.size();
    coned.glue({small(s), 0}, small({s.cell, s.wall, (s.at + 1) % count}), Perm4::swap(0, 1));
    const int a = wall.images[s.at];
    const int b = wall.images[(s.at + 1) % count];
    glue_side(coned, s, cell_center, side_between(wall.other_cell, wall.other_wall, a, b), a);
    for (std::size_t w = 0; w < cells_[s.cell].walls.size(); ++w) {
      const Side other = side_between(s.cell, w, start(s), end(s));
      if (w != s.wall && other.at < corners(s.cell, w).size())
        glue_side(coned, s, wall_center, other, start(s));
    }
  }

  const std::vector<HullCell>& cells_;
  std::vector<std::vector<int>> first_; ///< the first small tetrahedron, by cell and wall
};

/// Cells coned from one corner each. A wall on which the corner lies is cut by the diagonals from there, and
/// both cells at a wall must want the same diagonals.
class Subdivider {
public:
  explicit Subdivider(const std::vector<HullCell>& cells) : cells_(cells), apex_(cells.size(), -1) {
    for (const HullCell& cell : cells) fan_.emplace_back(cell.walls.size(), -1);
  }

  std::optional<Triangulation> run() {
    if (!choose(0)) return std::nullopt;
    return build();
  }

private:
  /// The wall seen from the cell that names it, and the position there of corner k of the wall.
  struct Named {
    int cell;
    int wall;
    int at;
  };
  Named name(int c, int w, int k) const {
    const HullWall& wall = cells_[c].walls[w];
    if (std::pair(c, w) <= std::pair(wall.other_cell, wall.other_wall)) return {c, w, k};
    const HullWall& other = cells_[wall.other_cell].walls[wall.other_wall];
    return {wall.other_cell, wall.other_wall, position(other.corners, wall.images[k])};
  }
  bool same_fan(const Named& n, int fan) const {
    const auto sides = cells_[n.cell].walls[n.wall].corners.size();
    return sides == 4 ? (n.at - fan) % 2 == 0 : n.at == fan;
  }

  /// Corners for the cells from c on, by trying.
  bool choose(int c) {
    if (c == static_cast<int>(cells_.size())) return true;
    for (int apex = 0; apex < cells_[c].corner_count; ++apex) {
      if (--tries_left_ < 0) return false;
      std::vector<Named> fixed;
      if (fix_fans(c, apex, fixed)) {
        apex_[c] = apex;
        if (choose(c + 1)) return true;
      }
      for (const Named& n : fixed) fan_[n.cell][n.wall] = -1;
    }
    return false;
  }
  bool fix_fans(int c, int apex, std::vector<Named>& fixed) {
    for (int w = 0; w < static_cast<int>(cells_[c].walls.size()); ++w) {
      const auto& corners = cells_[c].walls[w].corners;
      const int k = position(corners, apex);
      if (k < 0 || corners.size() == 3) continue;
      const Named n = name(c, w, k);
      int& fan = fan_[n.cell][n.wall];
      if (fan >= 0 && !same_fan(n, fan)) return false;
      if (fan >= 0) continue;
      fan = n.at;
      fixed.push_back(n);
    }
    return true;
  }

  /// Where the diagonals of wall w start, as a position among the corners that cell c sees.
  int fan_seen(int c, int w) const {
    const auto& corners = cells_[c].walls[w].corners;
    for (int k = 0; k < static_cast<int>(corners.size()); ++k) {
      const Named n = name(c, w, k);
      if (n.at == std::max(0, fan_[n.cell][n.wall])) return k;
    }
    return 0;
  }

  using Triple = std::array<int, 3>;
  struct Piece {
    int cell;
    std::array<int, 4> corners; ///< the apex first
  };

  std::optional<Triangulation> build() {
    for (int c = 0; c < static_cast<int>(cells_.size()); ++c)
      for (int w = 0; w < static_cast<int>(cells_[c].walls.size()); ++w) {
        const auto& corners = cells_[c].walls[w].corners;
        if (position(corners, apex_[c]) >= 0) continue;
        const int n = static_cast<int>(corners.size());
        const int first = fan_seen(c, w);
        for (int k = 1; k + 1 < n; ++k)
          pieces_.push_back(
              {c, {apex_[c], corners[first], corners[(first + k) % n], corners[(first + k + 1) % n]}});
      }
    std::map<std::pair<int, Triple>, std::vector<TetFace>> faces;
    for (int t = 0; t < static_cast<int>(pieces_.size()); ++t)
      for (int f = 0; f < 4; ++f) faces[{pieces_[t].cell, triple(t, f)}].push_back({t, f});
    Triangulation tri(static_cast<int>(pieces_.size()));
    for (const auto& [key, sides] : faces) {
      if (sides.size() > 2) return std::nullopt;
      if (sides.size() == 2) {
        glue(tri, sides[0], sides[1], nullptr);
        continue;
      }
      const HullWall* wall = wall_with(key.first, key.second);
      if (wall == nullptr) return std::nullopt;
      Triple image{};
      for (int k = 0; k < 3; ++k) image[k] = wall->images[position(wall->corners, key.second[k])];
      std::sort(image.begin(), image.end());
      const auto other = faces.find({wall->other_cell, image});
      if (other == faces.end() || other->second.size() != 1) return std::nullopt;
      if (tri.is_boundary(sides[0])) glue(tri, sides[0], other->second[0], wall);
    }
    return tri;
  }

  Triple triple(int t, int f) const {
    Triple corners{};
    for (int k = 0; k < 3; ++k) corners[k] = pieces_[t].corners[face_vertex[f][k]];
    std::sort(corners.begin(), corners.end());
    return corners;
  }
  const HullWall* wall_with(int c, const Triple& corners) const {
    for (const HullWall& wall : cells_[c].walls)
      if (std::all_of(corners.begin(), corners.end(), [&](int k) { return position(wall.corners, k) >= 0; }))
        return &wall;
    return nullptr;
  }
  /// Corner by corner; through `wall` if that is not null.
  void glue(Triangulation& tri, TetFace f, TetFace g, const HullWall* wall) const {
    std::array<int, 4> image{};
    image[f.face] = g.face;
    for (const int v : face_vertex[f.face]) {
      int corner = pieces_[f.tet].corners[v];
      if (wall != nullptr) corner = wall->images[position(wall->corners, corner)];
      const auto& there = pieces_[g.tet].corners;
      image[v] = static_cast<int>(std::find(there.begin(), there.end(), corner) - there.begin());
    }
    tri.glue(f, g.tet, Perm4(image[0], image[1], image[2], image[3]));
  }

  const std::vector<HullCell>& cells_;
  std::vector<int> apex_;
  std::vector<std::vector<int>> fan_; ///< by cell and wall, of those that name a wall; -1: free
  std::vector<Piece> pieces_;
  int tries_left_ = 100'000;
};

} // namespace

CellDecomposition cell_decomposition(const std::vector<HullCell>& cells) {
  return HullConer(cells).run();
}

std::optional<Triangulation> subdivision(const std::vector<HullCell>& cells) {
  return Subdivider(cells).run();
}

} // namespace tetrarch::canonical
