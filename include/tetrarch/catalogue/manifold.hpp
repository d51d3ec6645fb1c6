// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The classified manifolds: one record each, and the tables of them.
///
/// Hyperbolic 3-manifolds of finite volume with non-empty compact geodesic boundary (and perhaps cusps), by
/// the smallest number of tetrahedra that glue up to them, those that are orientable and those that are not
/// in tables of their own. Numbers are kept as decimal texts of 30
/// significant digits. Source: Frigerio, Martelli, Petronio, "Small hyperbolic 3-manifolds with geodesic
/// boundary", Experimental Math. 13 (2004): 8 orientable manifolds of two tetrahedra, 151 of three, 5,033 of
/// four.

#include "tetrarch/core/triangulation.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::catalogue {

/// Which table: of how many tetrahedra, and whether of orientable manifolds. A number is a table of these.
struct TableKey {
  int tetrahedra = 0;
  bool orientable = true;

  // NOLINTNEXTLINE(google-explicit-constructor): nearly all that is asked for is orientable
  constexpr TableKey(int number = 0, bool are_orientable = true)
      : tetrahedra(number), orientable(are_orientable) {}
  friend bool operator==(const TableKey&, const TableKey&) = default;
};

/// A hyperbolic manifold of the census, with its invariants.
struct Manifold {
  std::string name; ///< "fmp3_17"; empty where no table gives one
  int tetrahedra = 0;
  bool orientable = true;
  std::string signature; ///< of the smallest geometric gluing, by ASCII order
  std::string volume;
  std::vector<std::array<std::string, 6>>
      dihedral_angles; ///< of from_signature(signature); edges 01,02,03,12,13,23; none where a table leaves
                       ///< them out
  std::vector<int> boundary; ///< genera of the geodesic boundary components, decreasing; of one that is not
                             ///< orientable, -k for the sphere with k crosscaps
  int cusps = 0;
  int klein_cusps = 0; ///< those of them whose sections are Klein bottles
  int edges = 0;       ///< edge classes of the gluing
  std::string homology;
  std::vector<std::string> cells;  ///< of the canonical decomposition
  std::string canonical_signature; ///< of the canonical triangulation: the isometry signature
  int symmetries = 0;              ///< order of the isometry group

  TableKey table() const { return {tetrahedra, orientable}; }
  /// "genus 3 + 1 cusp", "3 crosscaps": the boundary as people say it.
  std::string boundary_text() const;
  friend bool operator==(const Manifold&, const Manifold&) = default;
};

/// One entry of a table, as JSON in one line, without the number of tetrahedra; no "name" member where there
/// is no name.
std::string json_text(const Manifold& m);
/// Reads it back. Throws InputError that says what is wrong.
Manifold read_manifold(std::string_view text, TableKey table);

/// The isometries of a manifold. Those of the manifold are the automorphisms of its canonical triangulation
/// (canonical/canonize.hpp), so that a table need not hold them.
struct Symmetry {
  int order = 0;                   ///< isometries that reverse orientation included
  std::string group;               ///< its name (canonical/isometries.hpp); empty: none of those known
  std::optional<bool> amphichiral; ///< one of them reverses orientation; nothing: there is no orientation
};
/// Read off `m.canonical_signature`, in some 20 microseconds. Throws InputError if that is no signature.
Symmetry symmetry_of(const Manifold& m);

/// What names of a table begin with: "fmp4_" up to four, which Frigerio, Martelli and Petronio counted,
/// "tet5_" from five on; "tetn3_" where manifolds are not orientable. Then comes the place in the table, from
/// 1.
std::string name_prefix(TableKey table);

/// The order of names: by volume, boundary, canonical signature. Volumes that agree to 25 digits are equal.
void sort_by_volume(std::vector<Manifold>& manifolds);

/// The different volumes of manifolds that are sorted by volume, each with its multiplicity.
struct VolumeCount {
  std::string volume;
  int manifolds = 0;
};
std::vector<VolumeCount> count_volumes(const std::vector<Manifold>& sorted);

/// The same without dihedral angles, which are nine tenths of a table.
std::vector<Manifold> without_angles(std::vector<Manifold> manifolds);
/// A table as the text of census/fmpN.json, one manifold a line. `read_table(write_table(t)) == t`.
std::string write_table(TableKey table, const std::vector<Manifold>& manifolds);
/// The same for long tables, a line of JSON each without a name, which its place gives; a line before all
/// says what it is. Angles are left out. `read_table` reads it, too.
std::string write_table_lines(TableKey table, const std::vector<Manifold>& manifolds);
/// Throws InputError that names `source` and what is wrong.
std::vector<Manifold> read_table(std::string_view text, const std::string& source);

/// The text of this compiled-in table; empty if there is none.
std::string_view stored_table_text(TableKey table);
/// The compiled-in table; empty if there is none. Parsed at the first call, which other threads wait for.
const std::vector<Manifold>& stored_table(TableKey table);
/// The same, but throws InputError that says which tables are stored if there is none.
const std::vector<Manifold>& require_table(TableKey table);
/// The tables that there are, the orientable ones first, by increasing numbers of tetrahedra.
std::vector<TableKey> stored_tables();
/// Number of manifolds in the compiled-in table; 0 if there is none.
int stored_count(TableKey table);
/// All names of the compiled-in tables, in their order.
std::vector<std::string> stored_names();
/// Looks a name up in the compiled-in tables, then in `installed_database()`. Parses one line; a tenth of a
/// millisecond.
std::optional<Manifold> find_by_name(std::string_view name);
/// The same by the signature of the canonical triangulation. By an index, which the first call makes in some
/// milliseconds.
std::optional<Manifold> find_by_isometry_signature(std::string_view signature);

} // namespace tetrarch::catalogue
