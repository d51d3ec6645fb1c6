// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Diagrams of links and spatial graphs: what they are, and their exteriors.

#include "tetrarch/diagram/marked.hpp"
#include "tetrarch/diagram/wirtinger.hpp"
#include "tetrarch/workshop/info.hpp"
#include "tetrarch/workshop/open.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

/// The diagram that this is: a file, "-", or a code spelled out ("braid 1 -2 1 -2"). A file may also hold the
/// points of a curve in space, or lines of OBJ: it is reduced and projected. Of an Orb file, the drawing.
/// Throws InputError that says what was tried.
diagram::Diagram open_diagram(const std::string& what, const OpenOptions& options = {},
                              std::uint64_t seed = 1, const Progress& progress = {});

/// The same, and which edges stay in space with what order: those that an Orb file says; none of others.
diagram::MarkedDiagram open_marked_diagram(const std::string& what, const OpenOptions& options = {},
                                           std::uint64_t seed = 1, const Progress& progress = {});

/// What a diagram shows.
struct DiagramFacts {
  std::string code; ///< planar diagram code
  int crossings = 0;
  int vertices = 0; ///< of valence other than 2
  int edges = 0;
  int components = 0;
  int parts = 0;
  int regions = 0;
  bool alternating = false;
};
/// O(darts).
DiagramFacts facts(const diagram::Diagram& diagram);
Rows rows_of(const DiagramFacts& facts);

/// Components of the graph without cycles: a neighborhood of one is a ball.
int tree_count(const diagram::Diagram& diagram);
/// Those of which all edges are drilled.
int tree_count(const diagram::MarkedDiagram& marked);

/// The exterior of a diagram.
struct Exterior {
  Triangulation triangulation = Triangulation();
  Info info; ///< of the triangulation
  DiagramFacts diagram;
  diagram::Wirtinger wirtinger;
  /// Of the structure whose meridians are parabolic; filled in on demand.
  struct Parabolic {
    bool found = false;
    double volume = 0;
    std::string how; ///< a sentence: where it was found, or what was tried
  };
  std::optional<Parabolic> parabolic;
  int filled_spheres = 0;           ///< trees among the components: the ball round each is there again
  std::vector<diagram::Fate> fates; ///< of each edge of the graph; empty: all are drilled
  Marks marks;                      ///< of the edges that stay, on the triangulation
  bool is_double = false;           ///< the triangulation is that of diagram::doubled_exterior
};

struct ExteriorOptions {
  std::uint64_t seed = 1;
  std::string name;       ///< of the result
  bool parabolic = false; ///< look for the structure with parabolic meridians, too
  bool doubled = false;   ///< the double instead of the exterior
};
/// Throws InputError if a double is asked for of a graph without vertices of valence 3 or more, or it or the
/// parabolic structure of a graph with edges that stay.
Exterior exterior(const diagram::MarkedDiagram& marked, const ExteriorOptions& options = {},
                  const Progress& progress = {});
/// All edges are drilled.
Exterior exterior(const diagram::Diagram& diagram, const ExteriorOptions& options = {},
                  const Progress& progress = {});
/// `signature` as of an Info.
Rows rows_of(const Exterior& exterior, const std::string& signature);

template <>
const FieldList<DiagramFacts>& fields_of<DiagramFacts>();
/// What an exterior has besides the fields of its `info`.
template <>
const FieldList<Exterior>& fields_of<Exterior>();
/// The fields of `info`, and these.
template <>
Tree tree_of<Exterior>(const Exterior& exterior);
template <>
std::vector<FieldNote> notes_of<Exterior>();

} // namespace tetrarch::workshop
