// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Why a move cannot be made. One vocabulary for all moves; asking and doing give the same answer.

#include <optional>

namespace tetrarch::moves {

enum class Obstacle {
  boundary_face,         ///< a face or an edge that must be interior lies on the boundary
  no_boundary_face,      ///< a face or an edge that must lie on the boundary is interior
  wrong_valence,         ///< the edge or vertex does not have the valence that the move needs
  repeated_tetrahedron,  ///< one tetrahedron would be needed twice
  reversed_edge,         ///< the edge is identified with itself backwards
  same_ends,             ///< both ends of the edge are one vertex: a sphere or a circle would be pinched
  both_ends_on_boundary, ///< neither end is an interior vertex, and the edge is no edge of the real boundary
  bad_vertex,            ///< a vertex link is not the sphere or disk that the move needs
  edges_form_cycle,      ///< edges to be identified would close up: a sphere or disk would be pinched
  faces_form_cycle,      ///< faces to be identified would close up: a component would be crushed
  same_face,             ///< two faces that must differ are one
  small_boundary_component ///< a boundary sphere of two triangles would be crushed
};

/// A few words: "both ends are one vertex".
const char* to_string(Obstacle obstacle);

/// Nothing: the move is legal, or was made.
using MaybeObstacle = std::optional<Obstacle>;

} // namespace tetrarch::moves
