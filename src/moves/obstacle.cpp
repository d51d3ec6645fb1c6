// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/obstacle.hpp"

namespace tetrarch::moves {

const char* to_string(Obstacle obstacle) {
  switch (obstacle) {
  case Obstacle::boundary_face:
    return "on the boundary";
  case Obstacle::no_boundary_face:
    return "not on the boundary";
  case Obstacle::wrong_valence:
    return "another number of tetrahedra meets there";
  case Obstacle::repeated_tetrahedron:
    return "a tetrahedron would be needed twice";
  case Obstacle::reversed_edge:
    return "the edge is identified with itself backwards";
  case Obstacle::same_ends:
    return "both ends of the edge are one vertex";
  case Obstacle::both_ends_on_boundary:
    return "neither end is an interior vertex";
  case Obstacle::bad_vertex:
    return "the link of a vertex is not what the move needs";
  case Obstacle::edges_form_cycle:
    return "edges to be identified would close a circle";
  case Obstacle::faces_form_cycle:
    return "faces to be identified would close a circle";
  case Obstacle::same_face:
    return "two faces that must differ are one";
  case Obstacle::small_boundary_component:
    return "a boundary sphere of two triangles would be crushed";
  }
  return "";
}

} // namespace tetrarch::moves
