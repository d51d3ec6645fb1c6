// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A manifold cut open along a connected normal surface: the surface itself, and the group of each side.
///
/// The surface parts each tetrahedron into rooms and each face into strips, which are the doors between
/// rooms. The sides of the surface are made of rooms, and the group of a side is read off its doors as that
/// of a triangulation is read off its faces: doors outside a spanning tree generate it, and around each piece
/// of an edge there is a relator. A loop of the surface is pushed to a side by walking through the doors
/// beside its arcs.

#include "normal_pieces.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <vector>

namespace tetrarch::reasons {

/// What a normal surface is.
struct SurfaceShape {
  bool connected = false;
  bool two_sided = false;
  bool separating = false;
  int euler = 0;
};

/// One of the parts into which the surface cuts the manifold.
struct Side {
  algebra::Presentation group;
  std::vector<VertexId> boundary; ///< the vertices at its corners whose links are no spheres
  /// Two loops that generate the group of the surface where it is a torus, pushed to this side.
  std::vector<algebra::Word> loops;
};

/// A triangulation without boundary faces, and a normal surface in it. O(pieces).
class CutOpen {
public:
  CutOpen(const Triangulation& tri, const Skeleton& skeleton, const Coordinates& coordinates);

  const SurfaceShape& shape() const { return shape_; }
  /// One, or two if the surface separates.
  std::vector<Side> sides() const;

private:
  struct Door {
    int from = 0, to = 0; ///< rooms
  };
  struct Arc {
    int tet = 0, face = 0, corner = 0, number = 0;
  };
  struct Passage {
    int door = 0;
    bool forward = true;
  };

  int strips(int tet, int face) const;
  Passage passage(int tet, int face, int strip) const;
  int strip_of(int tet, int face, int corner, int k) const;
  int room_of_strip(int tet, int face, int strip) const;
  int disc(int tet, int corner, int k) const;
  int point(int tet, int corner, int towards, int k) const;
  int strip_at_edge(int tet, int face, int i, int j, int segment) const;
  int next_disc(int arc, bool forward) const;
  void number_pieces();
  void make_doors();
  void make_arcs();
  void find_shape();
  std::vector<std::vector<std::pair<int, bool>>> generating_loops() const;
  algebra::Word push(const std::vector<std::pair<int, bool>>& loop, bool first_side,
                     const std::vector<int>& letter) const;
  int start_room(bool first_side) const;

  const Triangulation& tri_;
  const Skeleton& skeleton_;
  std::vector<Pieces> pieces_;
  std::vector<int> first_room_, first_disc_, first_point_;
  std::vector<std::vector<int>> first_door_; ///< by tetrahedron and face, of its face class
  std::vector<Door> doors_;
  std::vector<Arc> arcs_;
  std::vector<int> side_; ///< of each room
  SurfaceShape shape_;
};

} // namespace tetrarch::reasons
