// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The planes of a polycube, one for each chart, and room for a mesh between them.
///
///        v-------.       Each vertex of a chart keeps to the chart's plane: those inside of a chart move in
///       / \  c   |       it, those on a line along a third axis, and corners stay. Charts of one axis that
///      .---w     |       share a vertex share the plane. A tetrahedron whose corners are all in c would be
///       \ / \____|       flat. So edges inside the solid between two vertices of one plane are split, edges
///        '               inside a chart between two vertices of one line, and faces inside between three
///                        vertices of one plane.
///
/// Source: Protais, Reberol, Ray, Corman, Ledoux and Sokolov, "Robust quantization for polycube maps" (2022),
/// for the splitting.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/polycube/charts.hpp"

#include <array>
#include <vector>

namespace tetrarch::polycube {

/// A solid and the labels of its boundary's triangles.
struct LabeledSolid {
  product::Solid solid;
  std::vector<Label> label;
  std::vector<Point>
      image{}; ///< of each vertex, if it has one: new vertices get the mean of those they lie between
};

struct Planes {
  std::vector<int> of_chart;
  std::vector<std::size_t> axis;         ///< of each plane
  std::vector<double> area;              ///< of its charts
  std::vector<std::array<int, 3>> holds; ///< of each vertex of the mesh: its plane of each axis, or -1

  int count() const { return static_cast<int>(axis.size()); }
};

/// O(n).
Planes planes(const product::Solid& solid, const Charts& charts);

/// The same solid and labels, with edges and faces split so that no tetrahedron must be flat on the polycube.
/// Throws InputError where a piece would have no volume in double precision; Stopped. O(n log n) a round of
/// splitting; a few rounds.
LabeledSolid with_room(LabeledSolid labeled, const Progress& progress = {});

/// The same with the edges split of those tetrahedra and of all that share an edge with them, and with room:
/// where tetrahedra are folded and cannot unfold there is more freedom then.
LabeledSolid refined(const LabeledSolid& labeled, const std::vector<int>& tetrahedra,
                     const Progress& progress = {});

} // namespace tetrarch::polycube
