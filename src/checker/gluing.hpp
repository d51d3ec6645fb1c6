// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a certificate says, and the gluing's classes found anew.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::checker {

/// Edges of a tetrahedron by their ends.
constexpr std::array<std::array<int, 2>, 6> ends_of_edge{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Face f of a tetrahedron goes to face images[f] of tetrahedron `tet`, vertex v to images[v].
struct FaceGluing {
  int tet = 0;
  std::array<int, 4> images{};
};

/// Which faces are walls between canonical cells, and which are only drawn inside one.
struct CellClaims {
  std::string cusp_area; ///< of each cusp's cross-section; empty: there are no cusps
  struct Face {
    int tet = 0;
    int face = 0;
    std::string flat; ///< the criterion by which it was proved flat; empty: it is a wall, strictly convex
  };
  std::vector<Face> faces;
};

struct Certificate {
  std::vector<std::array<FaceGluing, 4>> gluings;
  int bits = 0;
  std::string radius;
  struct Edge {
    int tet = 0;
    int edge = 0;
    std::string length;
    bool fixed = false;
  };
  std::vector<Edge> edges;
  bool orientable = false;
  std::vector<int> links;
  std::array<std::string, 2> volume;
  std::optional<CellClaims> cells;
};

/// Throws InputError for what is none.
Certificate read(std::string_view text, const std::string& source);

/// Edges and vertices of the glued space.
struct Classes {
  std::vector<std::array<int, 6>> edge;   ///< of each tetrahedron's edges, the class
  std::vector<std::array<int, 4>> vertex; ///< of each tetrahedron's vertices, the class
  std::vector<std::array<int, 2>> ends;   ///< of each class of edges, the classes of its vertices
  /// end[t][v][w]: a number for that end at v of the edge to w, the same wherever edges are glued.
  std::vector<std::array<std::array<int, 4>, 4>> end;
  std::vector<int> link; ///< of each class of vertices, the Euler characteristic of its link
  bool orientable = true;
  std::string fault; ///< why this is no closed connected space that could be hyperbolic; empty if it may be
};

Classes classes_of(const std::vector<std::array<FaceGluing, 4>>& gluings);

} // namespace tetrarch::checker
