// SPDX-License-Identifier: GPL-2.0-or-later
#include "cell_shapes.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace tetrarch::canonical {
namespace {

/// Steps of a search for symmetries; some thousand are usual.
constexpr long most_steps = 2'000'000;

std::vector<int> singletons(int count) {
  std::vector<int> root(static_cast<std::size_t>(count));
  std::iota(root.begin(), root.end(), 0);
  return root;
}

void join(std::vector<int>& root, int a, int b) {
  a = numeric::find_root(root, a);
  b = numeric::find_root(root, b);
  root[std::max(a, b)] = std::min(a, b);
}

/// Builds the shapes of one decomposition.
class ShapeBuilder {
public:
  ShapeBuilder(const Triangulation& tri, const Skeleton& skeleton, const FlatFaces& flat)
      : tri_(tri), skeleton_(skeleton), flat_(flat), walls_around_(skeleton.edge_count(), 0),
        triangle_(singletons(4 * tri.size())) {
    for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
      for (const Walk& w : skeleton.around(e)) walls_around_[e] += is_wall(w.left_face()) ? 1 : 0;
  }

  CellShapes run() {
    find_cells();
    find_corners();
    find_edges();
    find_walls();
    return std::move(out_);
  }

private:
  bool is_wall(TetFace f) const { return !flat_[f.tet][f.face]; }
  bool is_diagonal(EdgeId e) const { return walls_around_[e] == 2; }
  static int slot(TetFace f) { return 4 * f.tet + f.face; }

  void find_cells() {
    std::vector<int> root = singletons(tri_.size());
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f)
        if (!is_wall({t, f})) join(root, t, tri_.gluing({t, f}).tet);
    std::vector<int> number(root.size(), -1);
    for (int t = 0; t < tri_.size(); ++t) {
      int& cell = number[numeric::find_root(root, t)];
      if (cell < 0) {
        cell = static_cast<int>(out_.cells.size());
        out_.cells.emplace_back();
      }
      out_.cells[cell].tets.push_back(t);
      out_.cell_of.push_back(cell);
    }
  }

  void find_corners() {
    std::vector<int> root = singletons(4 * tri_.size());
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f) {
        if (is_wall({t, f})) continue;
        const Gluing g = tri_.gluing({t, f});
        for (const int v : face_vertex[f]) join(root, 4 * t + v, 4 * g.tet + g.perm[v]);
      }
    std::vector<int> number(root.size(), -1);
    out_.corner.resize(static_cast<std::size_t>(tri_.size()));
    for (int t = 0; t < tri_.size(); ++t)
      for (int v = 0; v < 4; ++v) {
        CellShape& cell = out_.cells[out_.cell_of[t]];
        int& corner = number[numeric::find_root(root, 4 * t + v)];
        if (corner < 0) {
          corner = cell.corners++;
          cell.vertex.push_back(skeleton_.vertex({t, v}));
        }
        out_.corner[t][v] = corner;
      }
  }

  std::array<int, 2> pair(int t, int a, int b) const {
    const int p = out_.corner[t][a];
    const int q = out_.corner[t][b];
    return {std::min(p, q), std::max(p, q)};
  }

  void find_edges() {
    for (CellShape& cell : out_.cells)
      cell.edge_class.assign(static_cast<std::size_t>(cell.corners),
                             std::vector<int>(static_cast<std::size_t>(cell.corners), -1));
    for (int t = 0; t < tri_.size(); ++t)
      for (int e = 0; e < 6; ++e) {
        const EdgeId edge = skeleton_.edge({t, e});
        if (walls_around_[edge] == 0 || is_diagonal(edge)) continue;
        const auto [p, q] = pair(t, edge_vertex[e][0], edge_vertex[e][1]);
        CellShape& cell = out_.cells[out_.cell_of[t]];
        cell.edge_class[p][q] = cell.edge_class[q][p] = edge.value;
      }
  }

  /// From a wall triangle across its side, inside the cell, to the next one.
  TetFace across(TetFace f, int k) const {
    std::array<int, 2> ends{};
    int count = 0;
    for (const int v : face_vertex[f.face])
      if (v != k) ends[count++] = v;
    Walk w{f.tet, Perm4(ends[0], ends[1], f.face, k)}; // f to the right
    while (!is_wall(w.left_face())) w.step_left(tri_);
    return w.left_face();
  }

  void find_walls() {
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f)
        for (const int k : face_vertex[f])
          if (is_wall({t, f}) && is_diagonal(side({t, f}, k)))
            join(triangle_, slot({t, f}), slot(across({t, f}, k)));
    std::map<int, int> number; // of a wall in its cell, by its first triangle
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f)
        if (is_wall({t, f})) add_triangle({t, f}, number);
    for (CellShape& cell : out_.cells) {
      tidy(cell);
      cell.partner.resize(cell.walls.size());
    }
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f) {
        if (!is_wall({t, f})) continue;
        const Gluing g = tri_.gluing({t, f});
        const TetFace there{g.tet, g.perm[f]};
        out_.cells[out_.cell_of[t]].partner[number[wall({t, f})]] = {out_.cell_of[g.tet],
                                                                     number[wall(there)]};
      }
  }

  EdgeId side(TetFace f, int k) const {
    std::array<int, 2> ends{};
    int count = 0;
    for (const int v : face_vertex[f.face])
      if (v != k) ends[count++] = v;
    return skeleton_.edge({f.tet, edge_number[ends[0]][ends[1]]});
  }

  int wall(TetFace f) { return numeric::find_root(triangle_, slot(f)); }

  void add_triangle(TetFace f, std::map<int, int>& number) {
    CellShape& cell = out_.cells[out_.cell_of[f.tet]];
    const auto [at, is_new] = number.try_emplace(wall(f), static_cast<int>(cell.walls.size()));
    if (is_new) {
      cell.walls.emplace_back();
      cell.drawn.emplace_back();
    }
    for (const int k : face_vertex[f.face]) {
      cell.walls[at->second].push_back(out_.corner[f.tet][k]);
      if (!is_diagonal(side(f, k))) continue;
      std::array<int, 2> ends{};
      int count = 0;
      for (const int v : face_vertex[f.face])
        if (v != k) ends[count++] = v;
      cell.drawn[at->second].push_back(pair(f.tet, ends[0], ends[1]));
    }
  }

  static void tidy(CellShape& cell) {
    const auto sort_out = [](auto& list) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    for (auto& wall : cell.walls) sort_out(wall);
    for (auto& diagonals : cell.drawn) sort_out(diagonals);
  }

  const Triangulation& tri_;
  const Skeleton& skeleton_;
  const FlatFaces& flat_;
  Table<EdgeId, int> walls_around_;
  std::vector<int> triangle_; ///< union-find over faces of tetrahedra: parts of one wall
  CellShapes out_;
};

/// A growing bijection of whole numbers.
class Bijection {
public:
  explicit Bijection(int count) : to_(static_cast<std::size_t>(count), -1), from_(to_) {}
  /// Notes a -> b; false if that contradicts what is known.
  bool note(int a, int b) {
    if (to_[a] == b) return true;
    if (to_[a] >= 0 || from_[b] >= 0) return false;
    to_[a] = b;
    from_[b] = a;
    return true;
  }
  int operator()(int a) const { return to_[a]; }

private:
  std::vector<int> to_, from_;
};

/// What is known of a symmetry so far. Copied at each choice; cells are few.
struct Partial {
  Symmetry image;
  std::vector<bool> taken;
  Bijection edges;
  Bijection vertices;
};

/// Searches for symmetries cell by cell, corner by corner.
class Search {
public:
  Search(const CellShapes& shapes, bool classes_of_vertices)
      : shapes_(shapes), classes_of_vertices_(classes_of_vertices) {
    for (const CellShape& cell : shapes.cells) {
      for (const auto& row : cell.edge_class)
        for (const int e : row) edges_ = std::max(edges_, e + 1);
      for (const VertexId v : cell.vertex) vertices_ = std::max(vertices_, v.value + 1);
    }
  }

  std::optional<std::vector<Symmetry>> run(int cell) {
    std::vector<Symmetry> found;
    const Partial start{Symmetry(shapes_.cells.size()), std::vector<bool>(shapes_.cells.size(), false),
                        Bijection(edges_), Bijection(vertices_)};
    // Every map of the cell itself that some symmetry extends.
    place(start, cell, cell, [&](const Partial& partial) {
      if (extends(partial)) found.push_back(complete_);
      return false;
    });
    if (steps_ > most_steps) return std::nullopt;
    return found;
  }

private:
  /// Calls `done` for each way to put cell a onto cell b, until it says true; whether it did.
  template <class Done>
  bool place(const Partial& partial, int a, int b, const Done& done) {
    const CellShape& from = shapes_.cells[a];
    const CellShape& to = shapes_.cells[b];
    if (from.corners != to.corners || from.walls.size() != to.walls.size()) return false;
    CornerMap corners;
    return place_corners(partial, a, b, corners, done);
  }

  template <class Done>
  bool place_corners(const Partial& partial, int a, int b, CornerMap& corners, const Done& done) {
    if (++steps_ > most_steps) return false;
    const CellShape& from = shapes_.cells[a];
    const CellShape& to = shapes_.cells[b];
    const int next = static_cast<int>(corners.size());
    if (next == from.corners) {
      Partial more = partial;
      more.image[a] = {b, corners};
      more.taken[b] = true;
      return walls_fit(more, a) && done(more);
    }
    for (int image = 0; image < to.corners; ++image) {
      if (std::find(corners.begin(), corners.end(), image) != corners.end()) continue;
      Partial more = partial;
      bool fits =
          !classes_of_vertices_ || more.vertices.note(from.vertex[next].value, to.vertex[image].value);
      for (int k = 0; k < next && fits; ++k) {
        const int here = from.edge_class[k][next];
        const int there = to.edge_class[corners[k]][image];
        fits = (here < 0) == (there < 0) && (here < 0 || more.edges.note(here, there));
      }
      if (!fits) continue;
      corners.push_back(image);
      const bool end = place_corners(more, a, b, corners, done);
      corners.pop_back();
      if (end) return true;
    }
    return false;
  }

  bool extends(const Partial& partial) {
    int next = 0;
    while (next < static_cast<int>(partial.image.size()) && partial.image[next].cell >= 0) ++next;
    if (next == static_cast<int>(partial.image.size())) {
      complete_ = partial.image;
      return true;
    }
    for (int b = 0; b < static_cast<int>(partial.image.size()); ++b)
      if (!partial.taken[b] && place(partial, next, b, [&](const Partial& more) { return extends(more); }))
        return true;
    return false;
  }

  /// The wall of the image of a's cell that wall w goes to, or -1.
  int image_of_wall(const Partial& partial, int a, int w) const {
    const PlacedCell& placed = partial.image[a];
    std::vector<int> image;
    for (const int c : shapes_.cells[a].walls[w]) image.push_back(placed.corners[c]);
    std::sort(image.begin(), image.end());
    const auto& walls = shapes_.cells[placed.cell].walls;
    const auto at = std::find(walls.begin(), walls.end(), image);
    return at == walls.end() ? -1 : static_cast<int>(at - walls.begin());
  }

  /// 1: the diagonals of a quadrilateral go to those drawn; 0: to the others; 2: there are none.
  int keeps_diagonals(const Partial& partial, int a, int w, int image) const {
    const PlacedCell& placed = partial.image[a];
    const auto& diagonals = shapes_.cells[a].drawn[w];
    if (diagonals.empty()) return 2;
    std::vector<std::array<int, 2>> images;
    for (const auto& [p, q] : diagonals) {
      const auto [x, y] = std::minmax(placed.corners[p], placed.corners[q]);
      images.push_back({x, y});
    }
    std::sort(images.begin(), images.end());
    return images == shapes_.cells[placed.cell].drawn[image] ? 1 : 0;
  }

  /// Walls go to walls; where the partner is placed, to partners, with diagonals alike on both sides.
  bool walls_fit(const Partial& partial, int a) const {
    const CellShape& cell = shapes_.cells[a];
    for (int w = 0; w < static_cast<int>(cell.walls.size()); ++w) {
      const int image = image_of_wall(partial, a, w);
      if (image < 0) return false;
      const int kept = keeps_diagonals(partial, a, w, image);
      if (kept == 2) continue;
      // Of larger walls both sides would have to agree diagonal by diagonal.
      if (cell.walls[w].size() != 4) return false;
      const auto [other, other_wall] = cell.partner[w];
      if (partial.image[other].cell < 0) continue;
      const int other_image = image_of_wall(partial, other, other_wall);
      if (other_image < 0 || keeps_diagonals(partial, other, other_wall, other_image) != kept) return false;
      const std::pair<int, int> expected{partial.image[other].cell, other_image};
      if (shapes_.cells[partial.image[a].cell].partner[image] != expected) return false;
    }
    return true;
  }

  const CellShapes& shapes_;
  bool classes_of_vertices_;
  int edges_ = 0;
  int vertices_ = 0;
  long steps_ = 0;
  Symmetry complete_;
};

} // namespace

CellShapes cell_shapes(const Triangulation& tri, const Skeleton& skeleton, const FlatFaces& flat) {
  return ShapeBuilder(tri, skeleton, flat).run();
}

std::optional<std::vector<Symmetry>> symmetries_of_cell(const CellShapes& shapes, int cell,
                                                        bool classes_of_vertices) {
  return Search(shapes, classes_of_vertices).run(cell);
}

} // namespace tetrarch::canonical
