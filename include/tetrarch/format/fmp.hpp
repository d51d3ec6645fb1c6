// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The files of the census of Frigerio, Martelli and Petronio ("Small hyperbolic 3-manifolds with geodesic
/// boundary", Experimental Mathematics 13, 2004): one record per manifold, each closed by a line of dashes.
///
/// Written, for a record of n tetrahedra:
///
///     2                                            n
///        1    1    1    1                          2n lines: neighbours and permutations, as SnapPea's
///      0123 1203 1032 3021
///        0    0    0    0
///      0123 1320 2013 1032
///     Dihedral angles:                             n+1 lines, or none
///     N. 0  a01 a02 a03 a12 a13 a23
///     N. 1  a01 a02 a03 a12 a13 a23
///     Volume: 6.451990270835                       each of the following lines only if it is known
///     Volumes of tetrahedra: 3.22 3.22
///     Boundary: T^(2)                              T^(g) for each component; T^(1) is a cusp
///     Fundamental group: < a,b | >
///     Homology: Z^2
///     -------------------                          nineteen dashes
///
/// Read: the numbers and gluings with any white space; then, line by line, "N. i" (also "N.i", "N. i:") with
/// six angles; a line that begins with "Vol" (any case) and holds one number, or n numbers, after its colon;
/// a line of nothing but T^(g)s after its colon, if any; a line whose part before the colon speaks of a
/// fundamental group or pi1, or of homology or H1. A line that ends with its colon is a heading: it labels
/// the line after it. Blank lines are passed over, a second value for the same thing and whatever else stands
/// there is kept as a line in `other`. Three dashes or more close a record; only one that ends with its
/// gluings may do without.
///
/// Known from the authors' page on the format (Petronio, "Geo_Bd/format.html", 2014): the integer, the 2n
/// lines, the n+1 lines with the label "N. i", the order of what follows, T^(g), the line of dashes; from an
/// excerpt of the files: "Volume: 9.1344754117" and "Boundary: T^(1) T^(2) T^(1)". Not verified, as the files
/// were not at hand: the wording of the other labels, and the order of the six angles, which the page shows
/// in a picture only. Here it is 01,02,03,12,13,23; whoever reads angles of the original files should check
/// that they sum to 2 pi around each edge.

#include "tetrarch/format/document.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

struct FmpRecord {
  Triangulation triangulation = Triangulation();
  std::vector<PerEdge<double>> dihedral_angles; ///< per tetrahedron, in radians; empty: not known
  std::optional<double> volume;
  std::vector<double> tetrahedron_volumes; ///< empty: not known
  std::vector<int> boundary_genera;        ///< 1 for a cusp; empty: not known
  std::string fundamental_group;           ///< as text; empty: not known
  std::string homology;
  std::vector<std::string> other; ///< lines that were not understood
  friend bool operator==(const FmpRecord&, const FmpRecord&) = default;
};

/// All records; at least one. Throws InputError with the line where a record ends too early, a number or
/// permutation is none, the gluings contradict each other or the angles are not numbered 0 to n-1. O(length).
std::vector<FmpRecord> read_fmp(std::string_view text, const std::string& source);

/// Law: `read_fmp(write_fmp(records)) == records` for records that came from `read_fmp`. Texts with line
/// breaks are put on one line. Throws InputError where there is a boundary face or no tetrahedron. O(size).
std::string write_fmp(const std::vector<FmpRecord>& records);

/// A record as a document: angles and volume become its metric, the rest a member "fmp"; and back. What is in
/// no document is not known; digits beyond a double and lengths are dropped.
Document document_of(const FmpRecord& record);
FmpRecord fmp_record_of(const Document& document);

} // namespace tetrarch::format
