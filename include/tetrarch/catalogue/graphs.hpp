// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Graphs in space: handlebody-knots, theta curves, handcuff graphs, with what is known of their exteriors.
///
/// The names are those of diagram/names.hpp, which has the codes and their sources. The table is
/// census/graphs.json, made by tools/record_graphs.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::catalogue {

/// A graph in space and its exterior.
struct SpatialGraph {
  std::string name; ///< "hk5_3", "theta3_1", "handcuff4_1"
  std::string kind; ///< "handlebody-knot", "theta curve", "handcuff graph"
  int crossings = 0;
  int genus = 0;                       ///< of the exterior's boundary
  std::string homology;                ///< of the exterior
  std::vector<std::string> signatures; ///< of the smallest triangulations of the exterior that were met
  std::string volume;             ///< of the exterior, 30 digits; empty: it has no structure that was found
  std::string isometry_signature; ///< empty without a structure
  int isometries = 0;             ///< of the exterior; 0 without a structure
  /// Of those isometries the ones that extend over the handlebody; nothing of graphs, or without a structure.
  std::optional<int> symmetries;
  std::optional<bool> amphichiral; ///< one that extends reverses the orientation of space
  /// Of the structure whose meridians are parabolic, to 12 decimals; empty of handlebody-knots, or if none
  /// was found.
  std::string parabolic_volume;
};

/// The table, in the order of its kinds and names. Parsed at the first call, which other threads wait for.
const std::vector<SpatialGraph>& stored_graphs();

/// The names of all graphs with an exterior of this isometry signature.
std::vector<std::string> graphs_with_structure(std::string_view isometry_signature);
/// The names of all graphs whose exterior has this triangulation among those of the table.
std::vector<std::string> graphs_with_triangulation(std::string_view signature);

} // namespace tetrarch::catalogue
