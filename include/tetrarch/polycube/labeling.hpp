// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Labelings of a solid's boundary that may be those of a polycube.
///
///      .-+z-.---.      The smoother a labeling, the fewer charts and faults it has, and the more faces
///      |  .-+x-.|      turn away from their axes. So several smoothnesses are tried. What is faulty is
///      '--'----''      mended: a chart without enough corners gets a neighbor's label, the triangles
///                      around a faulty corner one of six, if the faults become fewer.
///
/// Source: after Gregson, Sheffer and Zhang (2011), section 5, and Livesu, Vining, Sheffer, Gregson and
/// Scateni, "PolyCut" (2013), section 4.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/polycube/charts.hpp"

#include <vector>

namespace tetrarch::polycube {

struct Labeling {
  std::vector<Label> label; ///< of each triangle of the boundary
  double smoothness = 0;    ///< with which it was made
  double misfit = 0;        ///< mean of 1 - cosine between normals and axes, by area
  int charts = 0;
  int corners = 0;
  std::vector<Fault> faults;
};

/// The labels with fewer faults, or as many. Each trial costs O(n); there are some hundred at most. Throws
/// Stopped.
std::vector<Label> mended(const product::Solid& solid, const Facets& facets, std::vector<Label> label,
                          const Progress& progress = {});

/// One for each smoothness, equal ones once, all of them mended; those of fewest faults first, then those of
/// least misfit, but the smoothest of those first that hardly fit less. Throws Stopped.
std::vector<Labeling> labelings(const product::Solid& solid, const Progress& progress = {});

} // namespace tetrarch::polycube
