// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A gluing with some faces still open, and all that is decided about it so far.
///
/// Each open face carries three *slots*, one for each of its edges. The t-edges that are identified so far
/// form chains; a chain runs from one slot to another, and gluing two faces ties their slots together three
/// times: two chains become one, or, where the slots are the two ends of one chain, an edge class is complete
/// and its valence and direction are known. The links of the vertices grow alongside: triangles are joined by
/// union-find, and a link whose last open arc goes has its type decided.
/// Nothing is ever undone: a search keeps one such value for each depth and copies (64 bytes a tetrahedron).

#include "tetrarch/enumeration/gluings.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetrarch::enumeration {

/// The options in the form in which the search asks for them.
struct GluingRules {
  explicit GluingRules(const GluingOptions& options);

  /// Whether a vertex may have this closed link; `euler_genus` is 2 - chi.
  bool allows_link(int euler_genus, bool link_orientable) const {
    return ((link_orientable ? orientable_links : nonorientable_links) >> euler_genus & 1U) != 0;
  }

  int tetrahedra;
  bool orientable_only;
  bool nonorientable_only;
  bool ideal;
  int min_valence;
  bool allow_invalid;
  bool links_limited;
  int max_euler_genus = 0;               ///< of the allowed links, where they are limited
  std::uint64_t orientable_links = 0;    ///< bit 2 - chi
  std::uint64_t nonorientable_links = 0; ///< bit 2 - chi
};

class PartialGluing {
public:
  static constexpr int max_tets = max_gluing_tetrahedra;
  /// T-faces are numbered 4 * tetrahedron + face.
  static constexpr std::uint8_t open = 255;

  int size() const { return tets_; }
  /// Pairs of faces glued so far.
  int glued() const { return glued_; }
  bool is_open(int face) const { return target(face) == open; }
  /// The face it is glued to, or `open`.
  std::uint8_t target(int face) const { return part_[face >> 2].target[face & 3]; }
  Perm4 perm(int face) const { return part_[face >> 2].perm[face & 3]; }
  /// +1 or -1, as the tetrahedra were handed when they were added.
  int handedness(int tet) const { return part_[tet].handedness; }
  bool is_orientable() const { return orientable_; }
  bool has_ideal_vertex() const { return has_ideal_vertex_; }

  void add_tetrahedron(int handedness);
  /// Glues an open face to an open face of `other`. False if that breaks a rule for good: then this value is
  /// of no more use.
  bool glue(int face, int other, Perm4 p, const GluingRules& rules);
  void copy_from(const PartialGluing& source);
  Triangulation triangulation() const;

private:
  /// One end of a chain of t-edges. T-edges are directed from their smaller vertex to the larger.
  struct ChainEnd {
    std::uint8_t other = 0; ///< the slot at the other end
    std::uint8_t length =
        0; ///< 2 * t-edges in the chain + (1 if the first and the last run against each other)
  };
  /// Of one link triangle; the counts are those of the whole piece, and kept at its root only.
  struct LinkTriangle {
    std::uint8_t parent = 0;
    std::uint8_t against_parent = 0; ///< 1 if it is oriented against its parent
    std::uint8_t triangles = 1;
    std::uint8_t open_arcs = 3;
    std::uint8_t inner_vertices = 0;
    std::uint8_t nonorientable = 0;
  };
  struct TetPart {
    std::array<std::uint8_t, 4> target;
    std::array<Perm4, 4> perm;
    std::array<ChainEnd, 16> chain; ///< slot 4 * face + the vertex of the face that is off the edge
    std::array<LinkTriangle, 4> link;
    std::int8_t handedness;
  };
  struct Root {
    int triangle;
    int against;
  };

  ChainEnd& chain(int slot) { return part_[slot >> 4].chain[slot & 15]; }
  const ChainEnd& chain(int slot) const { return part_[slot >> 4].chain[slot & 15]; }
  LinkTriangle& link(int vertex) { return part_[vertex >> 2].link[vertex & 3]; }
  const LinkTriangle& link(int vertex) const { return part_[vertex >> 2].link[vertex & 3]; }
  Root root(int vertex) const;
  void join_links(int a, int b, int against);
  bool tie(int slot, int other_slot, int against, const GluingRules& rules);
  bool links_are_allowed(int tet, int face, const GluingRules& rules);
  bool open_links_are_allowed(const GluingRules& rules) const;

  int tets_ = 0;
  int glued_ = 0;
  bool orientable_ = true;
  bool has_ideal_vertex_ = false;
  std::array<TetPart, max_tets> part_;
};

} // namespace tetrarch::enumeration
