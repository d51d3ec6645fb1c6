// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Gmsh's mesh files (`.msh`), versions 1 to 4.1, as text or binary.
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
/// Quadrilaterals, pyramids, prisms and hexahedra are cut, elements of higher order read by their corners;
/// the ledger counts these, points and lines. Tags of triangles and tetrahedra are physical groups, the first
/// one where there are several; what is in none gets 0, unless there are no groups at all: then the entities
/// are the tags, if there are several. Parts that a partition made belong to the groups of the whole.
/// Versions 1, 2.x, 4.0 and 4.1 are read; sections other than nodes, elements and entities are passed over.
/// Nodes are points in the order of the file. Source: Gmsh reference manual, "MSH file format" and "Legacy
/// formats".

#include "tetrarch/format/soup.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throws InputError; among the reasons is an element that names a node that is not there. O(n), and a factor
/// of log n where the tags of the nodes are in no order.
Soup read_gmsh(std::string_view text, const std::string& source);
/// Version 4.1, text, with node and element tags from 1: triangles first, and each by their tags. A tag is an
/// entity in the physical group of that number. Gmsh's groups are positive: elements of other tags are in
/// none, and come back with the tag 0. O(size log size).
std::string write_gmsh(const Soup& soup);

} // namespace tetrarch::format
