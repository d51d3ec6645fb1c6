// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A body in one of the models, cut so finely that no chord is farther than a given error from its curve or
/// surface. Neighboring pieces meet without cracks, because the ends of a side alone decide its cuts.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/embed/model.hpp"
#include "tetrarch/scene/drawing.hpp"
#include "tetrarch/scene/scene.hpp"
#include "tetrarch/show/body.hpp"

namespace tetrarch::show {

struct ModelOptions {
  embed::Model model = embed::Model::half_space;
  double chord_error = 0.01;  ///< in the model's units
  double tube_radius = 0.015; ///< hyperbolic; 0: no tubes
  bool inner = true;          ///< also faces inside a copy
  /// The property that colors faces; truncations have their component's color, paler in farther copies.
  enum class Colors : std::uint8_t { tetrahedron, face, word_length };
  Colors colors = Colors::tetrahedron;
};

/// The isometry that comes before the model.
Matrix4 model_frame(const Body& body, embed::Model model);

/// The largest extent of the first copy's corners in the model, along an axis.
double extent(const Body& body, embed::Model model);

/// A surface of all faces, one for each boundary component or cusp, tubes for the edges; with the data
/// "tetrahedron", "copy", "word_length", "face" (face class, -1 on truncations), "vertex" (vertex class, -1
/// on faces). O(size of the result): about 100 triangles for a patch that is large in the model, as many as
/// it has sides for a tiny one. Throws PreconditionError for a chord error or radius that is not positive.
scene::Scene in_model(const Body& body, const ModelOptions& options, const Progress& progress = {});

/// Memory that `in_model` and a file of its result take together, estimated from a sample of copies to within
/// a factor of two. O(1) copies.
double scene_bytes(const Body& body, const ModelOptions& options);

/// A flat body as a drawing: a vertical one in the half plane or (in the ball models) the disk, a horizontal
/// one in the plane z = 1 of the half space.
scene::Drawing drawing_of(const Body& body, const ModelOptions& options);

/// The circles at infinity of all lifts of the geodesic boundary that the copies touch, each once, colored by
/// component: the part that they leave uncovered in the limit is the limit set. In the plane at infinity of
/// the half space.
scene::Drawing circles_at_infinity(const Body& body);

} // namespace tetrarch::show
