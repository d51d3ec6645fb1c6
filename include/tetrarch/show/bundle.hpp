// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Circle bundles to look at: the surface with its cut, the solid tori over its covering disks, the bands.
///
/// The total space over a closed surface does not fit into space. Cut open over the covering disks it does,
/// as solid tori: each disk, laid flat, goes round an axis once, with N stops on the way. On its boundary lie
/// the bands to be glued, whose cycles have the colors of the cycles they are glued to: fiber edges gray,
/// base edges of the first bank red and its diagonals blue, and the same on the other bank under the gluing
/// map. Source: Yin, figures 5.1, 6.3, 6.4, 7.2 to 7.6.

#include "tetrarch/bundle/plan.hpp"
#include "tetrarch/scene/drawing.hpp"
#include "tetrarch/scene/scene.hpp"

namespace tetrarch::show {

/// The tetrahedra in space, solid torus beside solid torus, as cells with the data `triangle` (of the refined
/// surface), `origin` (of the original surface), `level`, `disk`, and the texture coordinates (x, y) of the
/// disk laid flat in the unit disk and w = level / N. All tetrahedra are positive. Where bending would invert
/// some, as it does if N is 1 or 2, the tori are left upright, cut open at level 0.
/// O(tetrahedra) and one factorization for each disk.
scene::Scene solid_tori(const bundle::Plan& plan, const bundle::CircleBundle& bundle);

/// The boundary of the solid tori: a surface for each band, its cycles as tubes.
scene::Scene gluable_tori(const bundle::Plan& plan);

/// The surface with the curves of its cut as tubes of different colors. `index`, if not empty, has a number
/// for each triangle; triangles whose number is not 0 stand out. The surface must have points:
/// `PreconditionError`.
scene::Scene cut_surface(const bundle::Plan& plan, const std::vector<int>& index = {});

/// The bands laid flat, pair by pair from above, i to the right and j upwards; one base path of each first
/// band and one diagonal path are drawn thick, with their images. At most `pairs` pairs. O(N * edges of the
/// cut).
scene::Drawing gluable_bands(const bundle::Plan& plan, int pairs = 8);

} // namespace tetrarch::show
