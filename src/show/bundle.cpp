// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/bundle.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/bundle/gluable.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/palette.hpp"
#include "tetrarch/surface/planar.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace tetrarch::show {

using namespace scene;

namespace {

using bundle::Band;
using bundle::GridVertex;
using bundle::Plan;
using bundle::Side;

constexpr Color grey{150, 150, 150};
constexpr Color red{200, 40, 40};
constexpr Color blue{40, 80, 200};

/// The covering disks laid flat and set round their axes.
class Tori {
public:
  explicit Tori(const Plan& plan)
      : open_(surface::cut_open(plan.cut)), parts_(surface::parts(open_)), fiber_(plan.recipe.fiber),
        place_(static_cast<std::size_t>(open_.vertex_count())), part_of_(place_.size()) {
    int number = 0;
    for (const surface::Part& part : surface::split(open_, parts_)) lay_flat(part, number++);
  }

  const surface::Surface& open() const { return open_; }
  int part(int triangle) const { return parts_.of[static_cast<std::size_t>(triangle)]; }
  const std::array<double, 2>& flat(int vertex) const { return place_[static_cast<std::size_t>(vertex)]; }

  /// Level j, whole or not, of the fibre over a vertex of the surface cut open. The discs lie half way
  /// between the axis and the outside.
  Point at(int vertex, double j) const {
    constexpr double center = 2.2;
    constexpr double apart = 7;
    const double angle = 2 * std::numbers::pi * j / fiber_;
    const auto [x, y] = flat(vertex);
    return {(center + x) * std::cos(angle) + apart * part_of_[vertex], (center + x) * std::sin(angle), y};
  }

  /// The same level above the disk itself, which is no torus then.
  Point upright(int vertex, double j) const {
    constexpr double height = 3;
    constexpr double apart = 3;
    return {flat(vertex)[0] + apart * part_of_[vertex], flat(vertex)[1], height * j / fiber_};
  }

private:
  void lay_flat(const surface::Part& part, int number) {
    const auto points = surface::tutte_embedding(part.surface);
    for (int t = 0; t < part.surface.triangle_count(); ++t)
      for (int c = 0; c < 3; ++c) {
        const int v = open_.corners(part.triangles[t])[c];
        place_[v] = points[part.surface.corners(t)[c]];
        part_of_[v] = number;
      }
  }

  surface::Surface open_;
  surface::Parts parts_;
  int fiber_;
  std::vector<std::array<double, 2>> place_;
  std::vector<int> part_of_;
};

} // namespace

namespace {

/// Tetrahedra over the covering disks, each by vertices of the surface cut open and levels.
struct Pile {
  struct Corner {
    int vertex;
    int level; ///< 0 to the fibre's edges
  };
  std::vector<std::array<Corner, 4>> tetrahedra;
};

double volume(const std::array<Point, 4>& p) {
  std::array<Point, 3> e{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) e[k][axis] = p[k + 1][axis] - p[0][axis];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
         e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

template <class Place>
double volume(const std::array<Pile::Corner, 4>& tetrahedron, Place place) {
  std::array<Point, 4> p{};
  for (std::size_t c = 0; c < 4; ++c) p[c] = place(tetrahedron[c]);
  return volume(p);
}

/// The pile as it stands on its disks, where every tetrahedron is positive: prisms are straight there.
Pile upright_pile(const Tori& tori, const bundle::CircleBundle& bundle) {
  Pile pile;
  for (int tet = 0; tet < bundle.total.size(); ++tet) {
    auto& corners = pile.tetrahedra.emplace_back();
    for (int v = 0; v < 4; ++v)
      corners[static_cast<std::size_t>(v)] = {
          tori.open().corners(bundle.triangle(tet))[bundle.corner({tet, v})], bundle.level({tet, v})};
    if (volume(corners, [&](const Pile::Corner& c) { return tori.upright(c.vertex, c.level); }) < 0)
      std::swap(corners[2], corners[3]);
  }
  return pile;
}

/// Whether the pile stays free of inverted tetrahedra when it is bent round to solid tori; if all are
/// inverted then, they are turned round. A fibre of one or two edges cannot be bent: its edges would be
/// points and its prisms flat.
bool can_be_bent(Pile& pile, const Tori& tori, int fiber) {
  if (fiber < 3) return false;
  int positive = 0;
  int negative = 0;
  for (const auto& tetrahedron : pile.tetrahedra) {
    const double v = volume(tetrahedron, [&](const Pile::Corner& c) { return tori.at(c.vertex, c.level); });
    positive += v > 0;
    negative += v < 0;
  }
  const auto all = static_cast<int>(pile.tetrahedra.size());
  if (negative == all)
    for (auto& tetrahedron : pile.tetrahedra) std::swap(tetrahedron[2], tetrahedron[3]);
  return positive == all || negative == all;
}

} // namespace

Scene solid_tori(const Plan& plan, const bundle::CircleBundle& bundle) {
  const Tori tori(plan);
  const int n = bundle.fiber;
  Pile pile = upright_pile(tori, bundle);
  const bool bent = can_be_bent(pile, tori, n);
  const int levels = bent ? n : n + 1; // upright, the last level is not the first again
  Cells cells;
  cells.name = "bundle";
  for (int v = 0; v < tori.open().vertex_count(); ++v)
    for (int j = 0; j < levels; ++j) {
      cells.points.push_back(bent ? tori.at(v, j) : tori.upright(v, j));
      cells.textures.push_back({tori.flat(v)[0], tori.flat(v)[1], static_cast<double>(j) / n});
    }
  std::array<Data, 4> data{{{"triangle", {}}, {"origin", {}}, {"level", {}}, {"disk", {}}}};
  for (int tet = 0; tet < bundle.total.size(); ++tet) {
    const int t = bundle.triangle(tet);
    std::array<int, 4> corners{};
    for (int v = 0; v < 4; ++v) {
      const Pile::Corner& c = pile.tetrahedra[static_cast<std::size_t>(tet)][static_cast<std::size_t>(v)];
      corners[v] = c.vertex * levels + c.level % levels;
    }
    cells.tetrahedra.push_back(corners);
    const std::array<int, 4> values{t, plan.cut.origin[t], tet / 3 % n, tori.part(t)};
    for (std::size_t k = 0; k < data.size(); ++k) data[k].values.push_back(values[k]);
  }
  cells.data.assign(data.begin(), data.end());
  Scene scene;
  scene.title = "circle bundle";
  scene.cells.push_back(std::move(cells));
  return scene;
}

namespace {

/// An edge of a band and its colour.
struct BandEdge {
  GridVertex from;
  GridVertex to;
  Color color;
};

/// The fibre and base edges and the diagonals of a band. Where the curve is twisted, base edges and diagonals
/// of the second bank change roles.
std::vector<BandEdge> band_edges(const Band& band, const bundle::Recipe& recipe, bool first) {
  std::vector<BandEdge> edges;
  const int length = static_cast<int>(band.sides.size());
  for (int i = 0; i <= length; ++i)
    for (int j = 0; j < recipe.fiber; ++j) {
      edges.push_back({{i, j}, {i, j + 1}, grey});
      if (i == length) continue;
      const Side s = band.sides[i];
      const bool swapped = !first && recipe.shift[s.value].twist() != 0;
      edges.push_back({{i, j}, {i + 1, j}, swapped ? blue : red});
      const bool up = recipe.value[s.value] > 0;
      edges.push_back({{i, up ? j : j + 1}, {i + 1, up ? j + 1 : j}, swapped ? red : blue});
    }
  return edges;
}

void add_tube(Tubes& tubes, const Point& a, const Point& b, Color color, double radius) {
  tubes.points.insert(tubes.points.end(), {a, b});
  tubes.radii.insert(tubes.radii.end(), {radius, radius});
  tubes.starts.push_back(static_cast<int>(tubes.points.size()));
  tubes.colors.push_back(color);
}

} // namespace

Scene gluable_tori(const Plan& plan) {
  const Tori tori(plan);
  Scene scene;
  scene.title = "gluable triangulations";
  Tubes tubes;
  tubes.name = "cycles";
  int number = 0;
  for (const auto& pair : bundle::bands(plan.cut)) {
    for (const Band& band : pair) {
      // The points of a wall: where the open surface has the ends of its sides.
      const auto at = [&](GridVertex v) {
        const int length = static_cast<int>(band.sides.size());
        const int vertex =
            v.i < length ? tori.open().from(band.sides[v.i]) : tori.open().to(band.sides.back());
        return tori.at(vertex, v.j);
      };
      Surface wall;
      wall.name = "band " + std::to_string(band.mark);
      for (const auto& triangle : bundle::band_triangles(band, plan.recipe)) {
        const int base = static_cast<int>(wall.points.size());
        for (const GridVertex& v : triangle) wall.points.push_back(at(v));
        wall.triangles.push_back({base, base + 1, base + 2});
      }
      wall.colors = {mixed(qualitative(number), Color{255, 255, 255}, 0.55)};
      scene.surfaces.push_back(std::move(wall));
      for (const BandEdge& e : band_edges(band, plan.recipe, band.mark > 0))
        add_tube(tubes, at(e.from), at(e.to), e.color, 0.012);
    }
    ++number;
  }
  if (!tubes.points.empty()) scene.tubes.push_back(std::move(tubes));
  return scene;
}

Scene cut_surface(const Plan& plan, const std::vector<int>& index) {
  const surface::Surface& surface = plan.cut.surface;
  if (plan.cut.points.empty()) throw PreconditionError("the surface has no points");
  Surface shown;
  shown.name = "surface";
  shown.points = plan.cut.points;
  Data origin{"origin", {}};
  Data indices{"index", {}};
  for (int t = 0; t < surface.triangle_count(); ++t) {
    shown.triangles.push_back(surface.corners(t));
    origin.values.push_back(plan.cut.origin[t]);
    const int here = index.empty() ? 0 : index[t];
    indices.values.push_back(here);
    shown.colors.push_back(here > 0 ? red : here < 0 ? blue : Color{225, 225, 220});
  }
  shown.data.push_back(std::move(origin));
  if (!index.empty()) shown.data.push_back(std::move(indices));
  Scene scene;
  scene.title = "surface and its cut";
  scene.surfaces.push_back(std::move(shown));
  const double size = numeric::extent(plan.cut.points);
  Tubes tubes;
  tubes.name = "cut";
  Data curve{"curve", {}};
  for (int k = 0; k < surface.side_count(); ++k)
    if (const Side s(k); plan.cut[s] > 0) {
      add_tube(tubes, plan.cut.points[surface.from(s)], plan.cut.points[surface.to(s)],
               qualitative(plan.cut[s] - 1), size / 250);
      curve.values.push_back(plan.cut[s]);
    }
  tubes.data.push_back(std::move(curve));
  if (!tubes.points.empty()) scene.tubes.push_back(std::move(tubes));
  return scene;
}

namespace {

/// Where a pair of bands is drawn: the first to the left, the second to the right.
struct Frame {
  double x;
  double y;
  std::array<double, 2> at(GridVertex v) const { return {x + v.i, y + v.j}; }
};

/// The edge, cut at the upper and lower border if it is the image of one that crossed it.
void add_edges(Drawing& drawing, const Band& band, const bundle::Recipe& recipe, const Frame& frame) {
  for (const BandEdge& e : band_edges(band, recipe, band.mark > 0))
    drawing.outlines.push_back({{frame.at(e.from), frame.at(e.to)}, false, {{}, e.color, 0.8}});
  // The top row again, which is the bottom row.
  for (int i = 0; i < static_cast<int>(band.sides.size()); ++i)
    drawing.outlines.push_back({{frame.at({i, recipe.fiber}), frame.at({i + 1, recipe.fiber})},
                                false,
                                {{}, Color{60, 60, 60}, 0.8}});
}

/// A path of the first band, thick, and its image on the second; levels wrap round.
void add_path(Drawing& drawing, const std::array<Band, 2>& pair, const bundle::Recipe& recipe,
              const std::array<Frame, 2>& frames, bool diagonal) {
  const int length = static_cast<int>(pair[0].sides.size());
  const auto wrapped = [&](GridVertex a, GridVertex b) {
    const int low = std::min(a.j, b.j);
    const int up = (low % recipe.fiber + recipe.fiber) % recipe.fiber - low;
    return std::array{GridVertex{a.i, a.j + up}, GridVertex{b.i, b.j + up}};
  };
  GridVertex at{0, 0};
  for (int i = 0; i < length; ++i) {
    const int value = recipe.value[pair[0].sides[i].value] > 0 ? 1 : -1;
    const GridVertex next{i + 1, diagonal ? at.j + value : at.j};
    const std::array<GridVertex, 2> images{bundle::gluing_map(pair[0], recipe, at),
                                           bundle::gluing_map(pair[0], recipe, next)};
    const Ink ink{{}, diagonal ? blue : red, 3};
    const auto [a, b] = wrapped(at, next);
    drawing.outlines.push_back({{frames[0].at(a), frames[0].at(b)}, false, ink});
    const auto [c, d] = wrapped(images[0], images[1]);
    drawing.outlines.push_back({{frames[1].at(c), frames[1].at(d)}, false, ink});
    at = next;
  }
}

} // namespace

Drawing gluable_bands(const Plan& plan, int pairs) {
  Drawing drawing;
  drawing.title = "gluable triangulations";
  auto all = bundle::bands(plan.cut);
  if (static_cast<int>(all.size()) > pairs) all.resize(static_cast<std::size_t>(pairs));
  const double gap = 1.5;
  double width = 1;
  double y = 0;
  for (const auto& pair : all) {
    const auto length = static_cast<double>(pair[0].sides.size());
    y -= plan.recipe.fiber + gap;
    const std::array<Frame, 2> frames{Frame{0, y}, Frame{length + gap, y}};
    for (std::size_t k = 0; k < 2; ++k) add_edges(drawing, pair[k], plan.recipe, frames[k]);
    for (const bool diagonal : {false, true}) add_path(drawing, pair, plan.recipe, frames, diagonal);
    width = std::max(width, 2 * length + gap);
  }
  drawing.lower = {-gap / 2, std::min(y, -1.0) - gap / 2};
  drawing.upper = {width + gap / 2, gap / 2 - gap};
  return drawing;
}

} // namespace tetrarch::show
