// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/fill.hpp"

#include "start.hpp"
#include "tetrarch/hex/fit.hpp"
#include "tetrarch/hex/match.hpp"
#include "tetrarch/product/smooth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tetrarch::hex {
namespace {

using namespace numeric;

/// Solvers are content with a scaled Jacobian above.
constexpr double content = 0.2;
/// What a hexahedron has at least for the sake of which points leave the surface that could stay there.
constexpr double tolerable = 0.05;

/// The box of some points.
std::array<Point, 2> box_of(const std::vector<Point>& points) {
  std::array<Point, 2> box{points.front(), points.front()};
  for (const Point& p : points)
    for (std::size_t a = 0; a < 3; ++a) {
      box[0][a] = std::min(box[0][a], p[a]);
      box[1][a] = std::max(box[1][a], p[a]);
    }
  return box;
}

double area_of(const product::Solid& solid) {
  double area = 0;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    const Point& p = solid.point(solid.corner(t, 0));
    area += norm(cross(solid.point(solid.corner(t, 1)) - p, solid.point(solid.corner(t, 2)) - p)) / 2;
  }
  return area;
}

struct Extent {
  explicit Extent(const product::Solid& solid) : volume(product::volume(solid)), area(area_of(solid)) {}

  double cells(double edge) const { return volume / (edge * edge * edge) + area / (edge * edge); }

  double volume = 0;
  double area = 0;
};

/// A mesh and where its points belong.
struct Fitted {
  SizedHexahedra hexahedra;
  std::vector<Home> home;
  product::HexQuality quality;
  bool has_layer = false;
};

void add_homes(std::vector<Home>& home, const std::vector<int>& origin) {
  home.resize(home.size() + origin.size());
}

/// A layer below all of the surface, then one around each cramped patch.
void add_layers(Fitted& fitted, const Match& match, double edge) {
  SizedHexahedra& hexahedra = fitted.hexahedra;
  constexpr double part = 0.5; // of the edge: the thickness of a layer
  const std::size_t before = hexahedra.lengths.size();
  add_homes(fitted.home, add_layer(hexahedra, std::vector<char>(before, 1), std::vector<char>(6 * before, 0),
                                   part * edge));
  fitted.has_layer = true;
  // The new hexahedra come in the order of the squares, and have them on top.
  constexpr int top = 1;
  for (std::size_t p = 0; p < match.is_cramped.size(); ++p) {
    if (match.is_cramped[p] == 0) continue;
    std::vector<char> shrinks(hexahedra.lengths.size());
    std::vector<char> stays(6 * hexahedra.lengths.size());
    for (std::size_t q = 0; q < match.patch.size(); ++q) {
      if (match.patch[q] != static_cast<int>(p)) continue;
      shrinks[before + q] = 1;
      stays[6 * (before + q) + top] = 1;
    }
    const std::vector<int> origin = add_layer(hexahedra, shrinks, stays, part * edge);
    // Those that came from the rim of the patch lie in the patch.
    add_homes(fitted.home, origin);
    std::vector<char> on_top(hexahedra.mesh.points.size());
    for (std::size_t q = 0; q < match.patch.size(); ++q)
      if (shrinks[before + q] != 0)
        for (const int c : product::outward_sides[top]) on_top[hexahedra.mesh.hexahedra[before + q][c]] = 1;
    const std::size_t first = hexahedra.mesh.points.size() - origin.size();
    for (std::size_t v = first; v < on_top.size(); ++v)
      if (on_top[v] != 0) fitted.home[v] = {Home::Kind::patch, static_cast<int>(p)};
  }
}

/// Points around hexahedra of a scaled Jacobian below `least` may leave the surface, and come back as far as
/// hexahedra stay good.
void release(Fitted& fitted, double least, const Targets& targets, const Progress& progress) {
  constexpr int most_rounds = 3;
  for (int round = 0; round < most_rounds && fitted.quality.minimum < least; ++round) {
    product::HexMesh mesh = fitted.hexahedra.mesh;
    std::vector<char> fixed(mesh.points.size(), 1);
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      if (fitted.quality.scaled_jacobian[h] < least)
        for (const int v : mesh.hexahedra[h]) fixed[v] = 0;
    // Each round one row more around them.
    for (int row = 0; row < round; ++row) {
      const std::vector<char> before = fixed;
      for (const product::Hexahedron& h : mesh.hexahedra)
        if (std::any_of(h.begin(), h.end(), [&](int v) { return before[v] == 0; }))
          for (const int v : h) fixed[v] = 0;
    }
    product::SmoothOptions options;
    options.most_sweeps = 10;
    options.search_below = 0.4;
    product::smooth(mesh, fixed, options, progress);
    land(mesh, fitted.home, targets, progress, least);
    product::HexQuality quality = product::quality(mesh);
    if (!product::is_better(quality, fitted.quality)) continue;
    fitted.hexahedra.mesh = std::move(mesh);
    fitted.quality = std::move(quality);
  }
}

void improve(Fitted& fitted, const Targets& targets, const Progress& progress) {
  product::HexMesh& mesh = fitted.hexahedra.mesh;
  const std::vector<Vector> normals = surface_normals(mesh);
  std::vector<char> fixed = deep_points(mesh, fitted.home);
  for (std::size_t v = 0; v < fixed.size(); ++v)
    if (fitted.home[v].kind == Home::Kind::corner) fixed[v] = 1;
  product::SmoothOptions options;
  options.most_sweeps = 12;
  options.search_below = 0.4;
  options.brought_back = [&](int v, const Point& p) {
    return fitted.home[v].kind == Home::Kind::inside ? p : targets.place(fitted.home[v], p, &normals[v]).at;
  };
  product::smooth(mesh, fixed, options, progress);
  land(mesh, fitted.home, targets, progress);
  fitted.quality = product::quality(mesh);
  release(fitted, tolerable, targets, progress);
}

Fitted fitted(Fitted start, const Match& match, bool with_layers, double edge, const Targets& targets,
              const Progress& progress) {
  start.home = match.home;
  if (with_layers) add_layers(start, match, edge);
  fit(start.hexahedra, start.home, targets, {}, progress);
  improve(start, targets, progress);
  return start;
}

/// Without a layer, with one, and with more around all patches, until one is good enough; the best of them.
Fitted best_fit(const SizedHexahedra& cells, const Match& match, double edge, const Targets& targets,
                const Progress& progress) {
  constexpr double as_good = 0.4; // as layers can make it
  const Fitted start{cells, {}, {}, false};
  const bool is_cramped = std::count(match.is_cramped.begin(), match.is_cramped.end(), 1) > 0;
  std::optional<Fitted> best;
  const auto offer = [&](Fitted found) {
    if (!best || product::is_better(found.quality, best->quality)) best = std::move(found);
  };
  if (match.is_unfolded && !is_cramped) {
    offer(fitted(start, match, false, edge, targets, progress));
    if (best->quality.minimum > as_good) return *std::move(best);
  }
  offer(fitted(start, match, true, edge, targets, progress));
  const bool has_more = std::count(match.is_cramped.begin(), match.is_cramped.end(), 0) > 0;
  if (best->quality.minimum < content && match.is_cramped.size() > 1 && has_more) {
    Match roomy = match;
    std::fill(roomy.is_cramped.begin(), roomy.is_cramped.end(), 1);
    offer(fitted(start, roomy, true, edge, targets, progress));
  }
  return *std::move(best);
}

Filling measured(const product::Solid& solid, Fitted fitted, double edge, const Progress& progress) {
  Filling result;
  result.mesh = std::move(fitted.hexahedra.mesh);
  result.quality = std::move(fitted.quality);
  result.deviation = deviation(solid, result.mesh, progress);
  result.volume = product::volume(result.mesh);
  result.solid_volume = product::volume(solid);
  result.edge = edge;
  result.has_layer = fitted.has_layer;
  return result;
}

/// How many of volume and distance are off by more than is tolerated.
int intolerable(const Filling& filling, const FillOptions& options) {
  int count = 0;
  if (!(std::abs(filling.volume_ratio() - 1) <= options.volume_tolerance)) ++count;
  if (!(filling.deviation.relative() <= options.hausdorff_tolerance)) ++count;
  return count;
}

bool is_preferred(const Filling& a, const Filling& b, const FillOptions& options) {
  if (a.quality.bad.size() != b.quality.bad.size()) return a.quality.bad.size() < b.quality.bad.size();
  const int off_a = intolerable(a, options);
  const int off_b = intolerable(b, options);
  if (off_a != off_b) return off_a < off_b;
  if (off_a > 0 && std::min(a.quality.minimum, b.quality.minimum) > 0)
    return a.deviation.relative() < b.deviation.relative();
  return a.quality.minimum > b.quality.minimum;
}

/// What came of one length of edges.
struct Tried {
  std::optional<Filling> filling; ///< nothing where there is nothing to begin with
  bool has_too_many = false;      ///< cells: they were not fitted
};

/// Without a `start`, cells of a grid.
Tried filled_with(const product::Solid& solid, double edge, const Start& start, double most_cells,
                  const FillOptions& options, const Progress& progress) {
  const Features all = features(solid, {.sharp = options.sharp, .least_extent = edge});
  const Targets targets(solid, all);
  std::optional<SizedHexahedra> cells =
      start ? start(edge, progress) : cells_in(solid, targets, edge, progress);
  if (!cells) return {};
  if (static_cast<double>(cells->mesh.hexahedra.size()) > most_cells) return {std::nullopt, true};
  FitOptions gently;
  gently.rounds = 5;
  gently.weakest = 1;
  gently.strongest = 30;
  gently.iterations = 30;
  gently.ends_there = false;
  fit(*cells, unmatched(cells->mesh).home, targets, gently, progress);
  const auto made = [&](const Match& match, const Targets& on) {
    Fitted best = best_fit(*cells, match, edge, on, progress);
    Filling filling = measured(solid, best, edge, progress);
    // Better hexahedra, if the surface stays near enough.
    if (intolerable(filling, options) == 0 && best.quality.minimum < content) {
      release(best, content, on, progress);
      Filling better = measured(solid, std::move(best), edge, progress);
      if (is_preferred(better, filling, options)) filling = std::move(better);
    }
    filling.ridges_of_solid = static_cast<int>(all.ridges.size());
    filling.ridges = static_cast<int>(on.features().ridges.size());
    return filling;
  };
  std::optional<Filling> kept;
  if (const auto match = matched(cells->mesh, solid, targets, progress)) kept = made(*match, targets);
  // Where not all ridges find their ways the sharper ones may.
  for (const double sharper : {60.0, 80.0}) {
    if (kept) break;
    if (sharper <= options.sharp) continue;
    const Targets fewer(solid, features(solid, {.sharp = sharper, .least_extent = 2 * edge}));
    if (fewer.features().ridges.empty()) break;
    if (const auto match = matched(cells->mesh, solid, fewer, progress)) kept = made(*match, fewer);
  }
  if (kept && kept->quality.bad.empty()) return {std::move(kept)};
  const Targets smooth(solid, features(solid, {.sharp = 180}));
  Filling rounded = made(unmatched(cells->mesh), smooth);
  if (!kept || is_preferred(rounded, *kept, options)) kept = std::move(rounded);
  return {std::move(kept)};
}

/// Of the edges: the step to the next grid is no smaller, and all steps together no larger.
constexpr double coarsest_step = 0.8;
constexpr double finest_step = 0.6;
constexpr double finest_part = 0.35;
/// So many are fitted within seconds, whatever was wished.
constexpr double few_cells = 10000;

/// By what part the next grid's edges are shorter: the distance between surfaces falls at least as they do.
double finer_part(const Filling& found, const FillOptions& options) {
  const double off = found.deviation.relative() / options.hausdorff_tolerance;
  if (!(off > 0)) return coarsest_step; // nor where both are 0
  return std::clamp(1 / std::sqrt(off), finest_step, coarsest_step);
}

} // namespace

bool Filling::is_good(const FillOptions& options) const {
  return quality.minimum >= content && intolerable(*this, options) == 0;
}

double cells_for(const product::Solid& solid, double edge) {
  return Extent(solid).cells(edge);
}

double edge_for(const product::Solid& solid, std::int64_t cells) {
  const Extent extent(solid);
  double low = 0;
  double high = std::cbrt(extent.volume) + std::sqrt(extent.area);
  constexpr int halvings = 200;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (extent.cells(middle) > static_cast<double>(cells) ? low : high) = middle;
  }
  return high;
}

double bytes_for_edge(const product::Solid& solid, double edge) {
  const auto [least, most] = box_of(solid.mesh.points);
  double cells = 1;
  for (std::size_t a = 0; a < 3; ++a) cells *= (most[a] - least[a]) / edge + 3;
  constexpr double for_cell = 48; // while limbs are laid: fractions, distances and ways
  constexpr double for_hexahedron = 3000;
  return for_cell * cells + for_hexahedron * cells_for(solid, edge);
}

Search search(const product::Solid& solid, const FillOptions& options, const Progress& progress) {
  return search(solid, {}, options, progress);
}

Search search(const product::Solid& solid, const Start& start, const FillOptions& options,
              const Progress& progress) {
  double edge = options.edge ? *options.edge : edge_for(solid, options.cells.value_or(usual_cells));
  const double finest = edge * finest_part;
  const double most_cells = options.most_effort * cells_for(solid, edge);
  // Of a needle a grid has many more cells than `cells_for` tells from volume and area.
  const double most_in_grid = std::max(most_cells, few_cells);
  double cells = 0;
  Search result;
  result.genus = product::genus(solid);
  for (;; ++result.grids) {
    if (result.grids > 0) {
      result.ending = Ending::finest;
      if (edge < finest) break;
      result.ending = Ending::memory;
      if (bytes_for_edge(solid, edge) > options.most_bytes) break;
      result.ending = Ending::effort;
      if (cells + cells_for(solid, edge) > most_cells) break;
    }
    cells += cells_for(solid, edge);
    result.finest_edge = edge;
    auto [found, has_too_many] = filled_with(solid, edge, start, most_in_grid, options, progress);
    if (has_too_many) {
      result.ending = Ending::effort;
      ++result.grids;
      break;
    }
    const double finer = found ? finer_part(*found, options) : coarsest_step;
    if (found) {
      found->refinements = result.grids;
      if (!result.best || is_preferred(*found, *result.best, options)) result.best = std::move(found);
      if (result.best->is_good(options)) {
        result.ending = Ending::good;
        ++result.grids;
        break;
      }
    }
    edge *= finer;
  }
  return result;
}

std::optional<Filling> fill(const product::Solid& solid, const FillOptions& options,
                            const Progress& progress) {
  return search(solid, options, progress).best;
}

} // namespace tetrarch::hex
