// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/marked_canonize.hpp"

#include "cells_with_marks.hpp"

#include "tetrarch/canonical/flips.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/marked_isomorphism.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/hyperbolic/orbifold_search.hpp"
#include "tetrarch/moves/marked.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tetrarch::canonical {
namespace {

using hyperbolic::OrbifoldStructure;
using hyperbolic::VertexType;

/// Of each tetrahedron the orders of its edges.
using Colors = std::vector<std::array<double, 6>>;

Colors colors_of(const Triangulation& tri, const Marks& marks) {
  const Skeleton skeleton(tri);
  const EdgeOrders orders = edge_orders(skeleton, marks);
  Colors colors(static_cast<std::size_t>(tri.size()));
  for (int t = 0; t < tri.size(); ++t)
    for (int e = 0; e < 6; ++e) colors[t][e] = orders[skeleton.edge({t, e})];
  return colors;
}

Marks marks_of_colors(const Triangulation& tri, const Colors& colors) {
  const Skeleton skeleton(tri);
  EdgeOrders orders(skeleton.edge_count(), 1.0);
  for (int t = 0; t < tri.size(); ++t)
    for (int e = 0; e < 6; ++e)
      if (colors[t][e] != 1) orders[skeleton.edge({t, e})] = colors[t][e];
  return marks_of(skeleton, orders);
}

Marks all_null(Marks marks) {
  for (EdgeMark& mark : marks)
    if (mark.order != 1) mark.order = 0;
  return marks;
}

/// The colors after one move; nothing if a marked edge was removed.
std::optional<Colors> carried(const Colors& colors, const moves::Ball& ball,
                              const moves::Replaced& replaced) {
  constexpr int most_corners = 6;
  std::array<std::array<double, most_corners>, most_corners> known{};
  for (auto& row : known) row.fill(1);
  std::array<std::array<bool, most_corners>, most_corners> lost{};
  for (const moves::Placed& placed : ball.before)
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = edge_vertex[e];
      const int p = std::min(placed.corners[i], placed.corners[j]);
      const int q = std::max(placed.corners[i], placed.corners[j]);
      known[p][q] = colors[placed.tet][e];
      lost[p][q] = known[p][q] != 1;
    }
  Colors out(static_cast<std::size_t>(replaced.tri.size()));
  for (std::size_t t = 0; t < colors.size(); ++t)
    if (replaced.image[t] >= 0) out[replaced.image[t]] = colors[t];
  for (std::size_t k = 0; k < ball.after.size(); ++k)
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = edge_vertex[e];
      const int p = std::min(ball.after[k][i], ball.after[k][j]);
      const int q = std::max(ball.after[k][i], ball.after[k][j]);
      out[replaced.first_new + static_cast<int>(k)][e] = known[p][q];
      lost[p][q] = false;
    }
  for (const auto& row : lost)
    if (std::find(row.begin(), row.end(), true) != row.end()) return std::nullopt;
  return out;
}

/// The inner products of a structure with null edges between hyperideal vertices.
Decorated<double> decorated(const Triangulation& tri, const Skeleton& skeleton, const OrbifoldStructure& s) {
  Decorated<double> m{tri, {}, std::vector<bool>(static_cast<std::size_t>(tri.size()), false)};
  std::vector<int> vertex;
  for (int t = 0; t < tri.size(); ++t) {
    m.gram.push_back(hyperbolic::gram_matrix(hyperbolic::lengths_at(skeleton, s.lengths, t),
                                             hyperbolic::types_at(skeleton, s.types, t)));
    for (int v = 0; v < 4; ++v) vertex.push_back(skeleton.vertex({t, v}).value);
  }
  set_cusp_areas(m, vertex, skeleton.vertex_count(), cusp_area);
  return m;
}

class MarkedCanonizer {
public:
  MarkedCanonizer(const MarkedCanonizeOptions& options, const Progress& progress)
      : options_(options), progress_(progress), random_(options.seed) {}

  MarkedCanonical run(const Triangulation& tri, const Marks& marks) {
    const Skeleton skeleton(tri);
    const moves::MarkedComplex given(tri, skeleton, edge_orders(skeleton, marks));
    moves::MarkedComplex small = given;
    moves::reduce(small, progress_);
    for (int k = 0; k < options_.attempts; ++k) {
      progress_.step("canonical cells with marks", static_cast<double>(k) / options_.attempts);
      moves::MarkedComplex trial = k == 0 ? given : small;
      if (k > 1) moves::shake(trial, 1 + random_.below(2 + k / 2), random_);
      if (k > 1 && random_.below(2) == 0) moves::reduce(trial, progress_.silent());
      const moves::MarkedTriangulation start = trial.compact();
      if (attempt(start)) return std::move(out_);
      if (k == 1 || why_.empty()) why_ = out_.why_not; // of the small one, if there is
      if (hopeless_) break;
    }
    out_.why_not = why_;
    return std::move(out_);
  }

private:
  bool attempt(const moves::MarkedTriangulation& start) {
    const Skeleton skeleton(start.tri);
    const auto s = solve(start.tri, skeleton, start.marks);
    if (!s) return false;
    Decorated<double> m = decorated(start.tri, skeleton, *s);
    const std::uint64_t order =
        random_.below(2) == 0 ? 0 : 1 + static_cast<std::uint64_t>(random_.below(1000));
    const Flips flips = flip_to_hull(m, {options_.sign_margin, most_moves, order}, progress_);
    if (flips.end != Flips::End::convex) {
      out_.why_not = "a face stays concave and no move mends it";
      return false;
    }
    Colors colors = colors_of(start.tri, start.marks);
    Triangulation tri = start.tri;
    for (const moves::Ball& ball : flips.path) {
      moves::Replaced replaced = moves::replace(tri, ball);
      auto next = carried(colors, ball, replaced);
      if (!next) {
        out_.why_not = "a flip would remove a marked edge: rounding has taken over";
        return false;
      }
      colors = *std::move(next);
      tri = std::move(replaced.tri);
    }
    return settle(tri, colors, static_cast<int>(start.marks.size()));
  }

  /// With all marks null; nothing where that is no structure with positive tetrahedra.
  std::optional<OrbifoldStructure> solve(const Triangulation& tri, const Skeleton& skeleton,
                                         const Marks& marks) {
    hyperbolic::OrbifoldOptions how;
    how.use_homotopy = false; // it leads to tetrahedra that are turned over, of no use here
    OrbifoldStructure s =
        solve_orbifold(tri, skeleton, edge_orders(skeleton, all_null(marks)), how, progress_.silent());
    using hyperbolic::OrbifoldOutcome;
    if (s.outcome == OrbifoldOutcome::geometric) {
      if (std::none_of(s.types.begin(), s.types.end(), [](VertexType t) { return t == VertexType::finite; }))
        return s;
      out_.why_not = "a vertex stays finite where all meridians are parabolic";
      return std::nullopt;
    }
    out_.why_not = describe(s, skeleton);
    hopeless_ = s.outcome == OrbifoldOutcome::bad_vertex || s.outcome == OrbifoldOutcome::boundary_faces ||
                s.outcome == OrbifoldOutcome::invalid;
    return std::nullopt;
  }

  /// Solves again and believes these tilts alone.
  bool settle(const Triangulation& tri, const Colors& colors, int marked) {
    const Marks marks = marks_of_colors(tri, colors);
    if (static_cast<int>(marks.size()) != marked) throw PreconditionError("canonize_marked: a mark was lost");
    const Skeleton skeleton(tri);
    const auto s = solve(tri, skeleton, marks);
    if (!s) return false;
    const Decorated<double> m = decorated(tri, skeleton, *s);
    Canonical& out = out_.canonical;
    out.flat.assign(static_cast<std::size_t>(tri.size()), {});
    out.has_flat_faces = false;
    out.smallest_tilt = 1e300;
    for (int t = 0; t < tri.size(); ++t)
      for (int f = 0; f < 4; ++f) {
        const double tilt = look_across(m, {t, f}).tilt;
        if (!(tilt > -options_.sign_margin)) {
          out_.why_not = "a face stays concave";
          return false;
        }
        out.flat[t][f] = tilt <= options_.sign_margin;
        out.has_flat_faces |= out.flat[t][f];
        if (!out.flat[t][f]) out.smallest_tilt = std::min(out.smallest_tilt, tilt);
      }
    out.outcome = Canonical::Outcome::canonical;
    out.triangulation = tri;
    out.marks = marks;
    out_.volume = s->volume;
    name_cells(colors);
    out_.why_not.clear();
    return true;
  }

  void name_cells(const Colors& colors) {
    Canonical& out = out_.canonical;
    out.cells.clear();
    if (!out.has_flat_faces) {
      out.cells.assign(static_cast<std::size_t>(out.triangulation.size()), "tetrahedron");
      out.canonical_triangulation = out.triangulation;
      out.canonical_marks = out.marks;
    } else {
      const Skeleton skeleton(out.triangulation);
      Table<EdgeId, bool> kept(skeleton.edge_count(), false);
      for (const EdgeMark& mark : out.marks) kept[skeleton.edge(mark.edge)] = true;
      CellDecomposition parts = cell_decomposition(out.triangulation, skeleton, out.flat, kept);
      for (const Cell& cell : parts.cells) out.cells.push_back(cell.name());
      Colors coned(static_cast<std::size_t>(parts.coned.size()));
      for (std::size_t t = 0; t < coned.size(); ++t) {
        const auto& [wall, off] = parts.origin[t];
        std::array<int, 2> ends{};
        int count = 0;
        for (const int v : face_vertex[wall.face])
          if (v != off) ends[count++] = v;
        coned[t].fill(1);
        coned[t][edge_number[0][1]] = colors[wall.tet][edge_number[ends[0]][ends[1]]];
      }
      out.canonical_triangulation = std::move(parts.coned);
      out.canonical_marks = marks_of_colors(out.canonical_triangulation, coned);
    }
    out.isometry_signature = marked_signature({out.canonical_triangulation, out.canonical_marks});
    out.proof.certified = false;
    out.proof.why_not = "with marked edges, signs are decided in double precision only";
  }

  static constexpr int most_moves = 2000;
  const MarkedCanonizeOptions& options_;
  const Progress& progress_;
  SplitMix64 random_;
  MarkedCanonical out_;
  std::string why_;
  bool hopeless_ = false;
};

} // namespace

MarkedCanonical canonize_marked(const Triangulation& tri, const Marks& marks,
                                const MarkedCanonizeOptions& options, const Progress& progress) {
  if (marks.empty()) throw PreconditionError("canonize_marked: there are no marks");
  return MarkedCanonizer(options, progress).run(tri, marks);
}

} // namespace tetrarch::canonical
