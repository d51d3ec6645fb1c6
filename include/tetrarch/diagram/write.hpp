// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A diagram as text.

#include "tetrarch/diagram/diagram.hpp"

#include <string>

namespace tetrarch::diagram {

/// The planar diagram code that `read_diagram` reads: "PD[X[1, 4, 2, 5], V[3, 6, 7], ...]". Arcs are numbered
/// from 1 along the edges of the graph, points of valence 2 are left out where that is possible ("Loop[1]" is
/// a circle without crossings). The lists of a crossing begin with an end of the lower strand, in the
/// direction of the walk. Law: reading it gives the diagram again, up to numbering and such points. O(darts).
std::string planar_diagram_code(const Diagram& diagram);

} // namespace tetrarch::diagram
