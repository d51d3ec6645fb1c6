// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Diagrams of links and graphs, drawn with gaps where a strand passes below.

#include "tetrarch/diagram/layout.hpp"
#include "tetrarch/scene/drawing.hpp"

namespace tetrarch::show {

/// Each edge of the graph (each component of a link) has its color; vertices are dots. O(points).
scene::Drawing drawing(const diagram::Layout& layout, const std::string& title);

} // namespace tetrarch::show
