// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/in_model.hpp"

#include "tessellate.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/palette.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tetrarch::show {

using namespace scene;

namespace {

using embed::Model;
using embed::operator*; // NOLINT(misc-unused-using-decls): clang-tidy 14 misses operators
using embed::to_model;

constexpr Color white{255, 255, 255};
constexpr Color dark{40, 44, 52};

void require(const ModelOptions& options) {
  if (!(options.chord_error > 0)) throw PreconditionError("in_model: the chord error must be positive");
  if (!(options.tube_radius >= 0)) throw PreconditionError("in_model: the radius of tubes is negative");
}

/// The distance of the middle of the curve from its chord.
TooCoarse chords_of(Model model, double error) {
  return [model, error](const Vector4& a, const Vector4& m, const Vector4& b) {
    return sagitta(to_model(model, a), to_model(model, m), to_model(model, b)) > error;
  };
}

/// How much smaller than in hyperbolic space a short length looks at p; of the Klein model, the smaller one.
double scale_at(Model model, const Point& p) {
  if (model == Model::half_space) return p[2];
  const double rest = std::max(0.0, 1 - p[0] * p[0] - p[1] * p[1] - p[2] * p[2]);
  return model == Model::ball ? rest / 2 : rest;
}

Color color_of(const Patch& patch, int length, ModelOptions::Colors colors) {
  if (patch.kind != Patch::Kind::face)
    return mixed(qualitative(patch.number + 4), white, 1 - std::pow(0.85, length));
  switch (colors) {
  case ModelOptions::Colors::tetrahedron:
    return qualitative(patch.tet);
  case ModelOptions::Colors::face:
    return qualitative(patch.number);
  case ModelOptions::Colors::word_length:
    break;
  }
  return by_word_length(length);
}

/// The data that every triangle and every polyline has.
std::vector<Data> data_lists() {
  return {{"tetrahedron", {}}, {"copy", {}}, {"word_length", {}}, {"face", {}}, {"vertex", {}}};
}

void append_data(std::vector<Data>& data, const std::array<int, 5>& values, std::size_t count) {
  for (std::size_t k = 0; k < values.size(); ++k)
    data[k].values.insert(data[k].values.end(), count, values[k]);
}

/// A patch that has been moved to its copy.
void append_patch(Surface& surface, const Patch& patch, int copy, int length, const ModelOptions& options) {
  const Tessellation mesh = tessellated(patch, chords_of(options.model, options.chord_error));
  const int first = static_cast<int>(surface.points.size());
  for (const Vector4& x : mesh.points) {
    const Point p = to_model(options.model, x);
    surface.points.push_back(p);
    surface.normals.push_back(patch.kind == Patch::Kind::cusp
                                  ? embed::horosphere_normal(options.model, patch.normal, p)
                                  : embed::plane_normal(options.model, patch.normal, p));
  }
  for (const auto& t : mesh.triangles)
    surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  surface.colors.insert(surface.colors.end(), mesh.triangles.size(), color_of(patch, length, options.colors));
  const bool face = patch.kind == Patch::Kind::face;
  append_data(surface.data, {patch.tet, copy, length, face ? patch.number : -1, face ? -1 : patch.number},
              mesh.triangles.size());
}

void append_patch(Tubes& tubes, const Arc& arc, int copy, int length, const ModelOptions& options) {
  const double radius = options.tube_radius * (arc.edge ? 1 : 0.6);
  for (const Vector4& x : subdivided(arc, chords_of(options.model, options.chord_error))) {
    const Point p = to_model(options.model, x);
    tubes.points.push_back(p);
    tubes.radii.push_back(radius * scale_at(options.model, p));
  }
  tubes.starts.push_back(static_cast<int>(tubes.points.size()));
  append_data(tubes.data, {arc.tet, copy, length, -1, arc.edge ? -1 : arc.number}, 1);
  tubes.colors.push_back(arc.edge ? dark : mixed(dark, white, 0.3));
}

/// Which surface of the scene a patch belongs to: the faces, then one for each vertex class.
std::string surface_name(const Patch& patch) {
  if (patch.kind == Patch::Kind::face) return "faces";
  return (patch.kind == Patch::Kind::cusp ? "cusp " : "boundary ") + std::to_string(patch.number);
}

/// Where a point of a flat body is drawn.
std::array<double, 2> flat(const Body& body, Model model, const Vector4& x) {
  if (body.view == View::horizontal) {
    const Point p = to_model(Model::half_space, x);
    return {p[0], p[1]};
  }
  const Point p = to_model(model, x);
  return {p[0], p[2]};
}

Outline outline_of(const Body& body, const Patch& patch, int length, const ModelOptions& options) {
  const Model model = body.view == View::horizontal ? Model::half_space : options.model;
  Outline outline;
  outline.closed = true;
  const Color base = length == 0 ? qualitative(patch.tet) : mixed(qualitative(patch.tet), white, 0.35);
  outline.ink = {base, dark, length == 0 ? 1.0 : 0.5};
  const std::size_t n = patch.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Arc side{patch.corners[k], patch.corners[(k + 1) % n], patch.cusps[k]};
    const auto points = subdivided(side, chords_of(model, options.chord_error));
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      outline.points.push_back(flat(body, model, points[i]));
  }
  return outline;
}

/// Circles that are the same within rounding are one. Cells of 1e-6, with a probe of the neighbours that
/// rounding may have chosen: circles of distinct planes that differ by less are not told apart in a picture.
class CircleSet {
public:
  /// Whether it is new.
  bool insert(const Point& circle) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      Point moved = circle;
      for (unsigned k = 0; k < 3; ++k) moved[k] += ((corner >> k) & 1U) != 0 ? rounding : -rounding;
      if (known_.count(cell(moved)) > 0) return false;
    }
    known_.insert(cell(circle));
    return true;
  }

private:
  static constexpr double rounding = 1e-8;
  static std::array<std::int64_t, 3> cell(const Point& p) {
    return {std::llround(p[0] * 1e6), std::llround(p[1] * 1e6), std::llround(p[2] * 1e6)};
  }
  std::set<std::array<std::int64_t, 3>> known_;
};

/// A line at infinity, as far as any picture goes.
Outline long_line(const embed::CircleAtInfinity& line, const Ink& ink) {
  constexpr double far = 1e4;
  const auto [x, y] = line.center;
  const std::array<double, 2> foot{line.radius * x, line.radius * y};
  return {{{foot[0] - far * y, foot[1] + far * x}, {foot[0] + far * y, foot[1] - far * x}}, false, ink};
}

/// The window around points, a little larger; for the half plane it ends just below the real axis.
void fit(Drawing& drawing, const std::vector<std::array<double, 2>>& points, double margin) {
  drawing.lower = drawing.upper = points.front();
  for (const auto& p : points)
    for (int k = 0; k < 2; ++k) {
      drawing.lower[k] = std::min(drawing.lower[k], p[k]);
      drawing.upper[k] = std::max(drawing.upper[k], p[k]);
    }
  const double wider =
      margin * std::max(drawing.upper[0] - drawing.lower[0], drawing.upper[1] - drawing.lower[1]);
  for (int k = 0; k < 2; ++k) {
    drawing.lower[k] -= wider;
    drawing.upper[k] += wider;
  }
}

} // namespace

Matrix4 model_frame(const Body& body, Model model) {
  return model == Model::half_space ? body.half_space : embed::identity<double>();
}

double extent(const Body& body, Model model) {
  const Matrix4 frame = model_frame(body, model);
  Point lower{};
  Point upper{};
  bool first = true;
  for (const Patch& patch : body.patches)
    for (const Vector4& x : patch.corners) {
      const Point p = to_model(model, frame * x);
      for (int k = 0; k < 3; ++k) {
        lower[k] = first ? p[k] : std::min(lower[k], p[k]);
        upper[k] = first ? p[k] : std::max(upper[k], p[k]);
      }
      first = false;
    }
  return std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
}

Scene in_model(const Body& body, const ModelOptions& options, const Progress& progress) {
  require(options);
  Scene scene;
  scene.title = body.name;
  std::map<std::string, std::size_t> index;
  for (const Patch& patch : body.patches)
    if (index.try_emplace(surface_name(patch), scene.surfaces.size()).second) {
      scene.surfaces.emplace_back().name = surface_name(patch);
      scene.surfaces.back().data = data_lists();
    }
  Tubes edges;
  edges.name = "edges";
  edges.data = data_lists();
  const Matrix4 frame = model_frame(body, options.model);
  for (std::size_t c = 0; c < body.copies.size(); ++c) {
    if (c % 256 == 0)
      progress.step("model", static_cast<double>(c) / static_cast<double>(body.copies.size()));
    const Matrix4 place = frame * body.copies[c];
    const int copy = static_cast<int>(c);
    for (const Patch& patch : body.patches)
      if (options.inner || !patch.inner)
        append_patch(scene.surfaces[index.at(surface_name(patch))], moved(place, patch), copy, body.length[c],
                     options);
    if (options.tube_radius == 0) continue;
    for (const Arc& arc : body.arcs)
      if (!arc.inner) append_patch(edges, moved(place, arc), copy, body.length[c], options);
  }
  if (options.tube_radius > 0) scene.tubes.push_back(std::move(edges));
  return scene;
}

double scene_bytes(const Body& body, const ModelOptions& options) {
  constexpr std::size_t most_samples = 32;
  Body some = body;
  const std::size_t step = 1 + (body.copies.size() - 1) / most_samples;
  some.copies.clear();
  some.length.clear();
  for (std::size_t c = 0; c < body.copies.size(); c += step) {
    some.copies.push_back(body.copies[c]);
    some.length.push_back(body.length[c]);
  }
  // Of a triangle: indices, a colour, five numbers; of a point: itself and its normal. Tubes are swept by
  // writers, eight corners and sixteen triangles for a point. Half as much again for the file, and room to
  // grow in.
  double bytes = 0;
  const Scene scene = in_model(some, options);
  for (const Surface& s : scene.surfaces)
    bytes += 48.0 * static_cast<double>(s.points.size()) + 36.0 * static_cast<double>(s.triangles.size());
  for (const Tubes& t : scene.tubes)
    bytes += (32.0 + 8 * 48 + 16 * 36) * static_cast<double>(t.points.size());
  return 2 * bytes * static_cast<double>(body.copies.size()) / static_cast<double>(some.copies.size());
}

Drawing drawing_of(const Body& body, const ModelOptions& options) {
  require(options);
  Drawing drawing;
  drawing.title = body.name;
  std::vector<std::array<double, 2>> seen;
  for (std::size_t c = 0; c < body.copies.size(); ++c)
    for (const Patch& patch : body.patches) {
      drawing.outlines.push_back(outline_of(body, moved(body.copies[c], patch), body.length[c], options));
      if (body.length[c] <= 1)
        seen.insert(seen.end(), drawing.outlines.back().points.begin(), drawing.outlines.back().points.end());
    }
  if (body.view == View::vertical && options.model != Model::half_space) {
    drawing.lower = {-1.03, -1.03};
    drawing.upper = {1.03, 1.03};
    drawing.circles.push_back({{0, 0}, 1, {std::nullopt, dark, 1.5}});
    return drawing;
  }
  fit(drawing, seen, 0.05);
  if (body.view == View::vertical) {
    const double below = 0.03 * (drawing.upper[1] - drawing.lower[1]);
    drawing.lower[1] = -below;
    drawing.outlines.push_back(
        {{{drawing.lower[0], 0}, {drawing.upper[0], 0}}, false, {std::nullopt, dark, 1.5}});
  }
  return drawing;
}

Drawing circles_at_infinity(const Body& body) {
  constexpr Color grey{150, 155, 165};
  Drawing drawing;
  drawing.title = "circles at infinity of the geodesic boundary";
  std::vector<std::array<double, 2>> seen;
  CircleSet known;
  for (std::size_t c = 0; c < body.copies.size(); ++c) {
    const Matrix4 place = body.half_space * body.copies[c];
    for (const Patch& patch : body.patches) {
      const bool face = patch.kind == Patch::Kind::face;
      if (patch.kind == Patch::Kind::cusp || (face && body.copies.size() > 1)) continue;
      const auto circle = embed::circle_at_infinity(place * patch.normal);
      const Ink ink{std::nullopt, face ? grey : qualitative(patch.number + 4), 0.7};
      if (circle.line) {
        drawing.outlines.push_back(long_line(circle, ink));
        continue;
      }
      if (!known.insert({circle.center[0], circle.center[1], circle.radius})) continue;
      drawing.circles.push_back({circle.center, circle.radius, ink});
      if (c > 0 || face) continue;
      seen.push_back({circle.center[0] - circle.radius, circle.center[1] - circle.radius});
      seen.push_back({circle.center[0] + circle.radius, circle.center[1] + circle.radius});
    }
  }
  if (!seen.empty()) fit(drawing, seen, 0.02);
  return drawing;
}

} // namespace tetrarch::show
