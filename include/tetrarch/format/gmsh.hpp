// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Gmsh's mesh files (`.msh`), versions 2.x and 4.1, as text or binary.
///
///     $MeshFormat
///     4.1 0 8                  version, 0 for text or 1 for binary, bytes in a real number
///     $EndMeshFormat
///     $Nodes
///     1 4 1 4                  blocks, nodes, least and greatest tag
///     3 1 0 4                  of a block: dimension and tag of its entity, parametric?, nodes
///     1 2 3 4                  their tags, any positive numbers
///     0 0 0 ...                their coordinates
///     $EndNodes
///     $Elements
///     1 1 1 1                  blocks, elements, least and greatest tag
///     3 1 4 1                  of a block: dimension and tag of its entity, type of element, elements
///     1 1 2 3 4                tag and nodes of an element
///     $EndElements
///
/// Points and lines are passed over, surfaces other than triangles with a warning; volume elements other than
/// tetrahedra of four nodes are refused, since the rest would be another solid. Of $Entities the physical
/// groups of surfaces are taken, for the tags of triangles; other sections are passed over. The short-lived
/// version 4.0 is refused. Nodes are points in the order of the file. Source: Gmsh reference manual, "MSH
/// file format" and "Legacy formats".

#include "tetrarch/format/soup.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throws InputError; among the reasons is an element that names a node that is not there. O(n), and a factor
/// of log n where the tags of the nodes are in no order.
Soup read_gmsh(std::string_view text, const std::string& source);
/// Version 4.1, text, with node and element tags from 1 (triangles first). O(size).
std::string write_gmsh(const Soup& soup);

} // namespace tetrarch::format
