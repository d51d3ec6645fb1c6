// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Handlebody-knots and links compared: not their exteriors alone, but the pairs of the 3-sphere and what was
/// drilled out of it.

#include "tetrarch/diagram/diagram.hpp"
#include "tetrarch/workshop/canonical.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

/// One of the two: a neighborhood of the graph that a diagram shows.
struct PairSide {
  std::string name;
  bool found = false; ///< cells with meridians; what follows is of these
  double volume = 0;
  std::string isometry_signature;
  std::size_t exterior_group_order = 0;
  std::string exterior_group; ///< empty: none of the names known
  bool exterior_amphichiral = false;
  std::size_t group_order = 0; ///< of those isometries that extend over the neighborhood
  std::string group;
  bool amphichiral = false; ///< one that extends reverses the orientation of space
};

/// Whether there is a homeomorphism of space that takes the one neighborhood to the other.
struct PairComparison {
  enum class Proof {
    none,        ///< undecided
    isometry,    ///< one that extends
    boundary,    ///< the exteriors have different boundaries
    homology,    ///< or different first homology
    volume,      ///< or certified volumes in disjoint intervals
    cells,       ///< or different canonical cells, both proved
    meridians,   ///< all isometries of the exteriors are known, the cells being proved, and none extends
    isomorphism, ///< triangulations of the exteriors, without a structure: an isomorphism that extends
    images       ///< in finite groups, of exterior, boundary and meridians: other orders
  };
  Verdict verdict = Verdict::undecided;
  Proof proof = Proof::none;
  std::string reason;
  std::optional<bool> exteriors;     ///< whether the exteriors are homeomorphic; nothing: undecided
  std::size_t isometries = 0;        ///< between the exteriors
  std::size_t extending = 0;         ///< of these
  bool keeps_orientation = false;    ///< one that extends does
  bool reverses_orientation = false; ///< one that extends does
  PairSide x, y;
};
const char* to_string(PairComparison::Proof proof);

struct PairOptions {
  std::uint64_t seed = 1;
  int attempts = 200; ///< triangulations on which a structure is sought
};

/// Two diagrams, with what the answer calls them. Throws InputError if one has a tree among its components.
PairComparison compare_pairs(const diagram::Diagram& x, const std::string& name_x, const diagram::Diagram& y,
                             const std::string& name_y, const PairOptions& options = {},
                             const Progress& progress = {});

/// Some lines for people.
std::string text_of(const PairComparison& found);

/// The fields of an Isometry, and those that a PairComparison has besides.
std::vector<FieldNote> notes_with_pairs();

template <>
const FieldList<PairSide>& fields_of<PairSide>();
template <>
const FieldList<PairComparison>& fields_of<PairComparison>();

} // namespace tetrarch::workshop
