// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The second path: whether a certificate proves what it claims.
///
/// The certificate (verified/certificate.hpp) names a gluing, a point and a radius. This room believes
/// nothing else. It shares no formula, no data structure and no arithmetic with the rooms that made it, and
/// the build keeps it so: intervals are MPFI's, classes of edges and vertices are found anew, a tetrahedron
/// is known by the triangles at its truncated corners, and derivatives are computed forward with the values:
///
///        side of the triangle at corner v, in the face v a b (w = minus the inner product, s = -dw/dl):
///          cosh y = (w_ab + w_va w_vb) / (s_va s_vb)                     v hyperideal: law (4.3), extended
///          y^2    = [a] / w_va^2 + [b] / w_vb^2 + 2 w_ab / (w_va w_vb)   v ideal; [a] is 1 if hyperideal,
///                                                                        0 if ideal, -1 if finite
///          cos y  = (w_va w_vb - w_ab) / (s_va s_vb)                     v finite
///        its angles are the dihedral ones: law (4.2), the Euclidean law of cosines, or the spherical one
///
/// If the sides are real and every |cos| < 1, the tetrahedron exists. That the lengths in the box have one
/// zero of all curvatures is Krawczyk's test; that the equations which finite vertices leave out hold, too,
/// is seen in their links (src/checker/links.hpp). Canonical cells, if the certificate claims some, are those
/// of src/checker/cells.hpp. The volume comes from the angles by Ushijima's formula as
/// it is printed (Lobachevsky's where all vertices are ideal), at the midpoint, and from there by
/// Schlaefli's. Sources: Yin, section 4.3; Ushijima 2006; Moore-Kearfott-Cloud 2009, section 8.2.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::checker {

/// What came of it.
struct Report {
  bool accepted = false;
  std::string why_not; ///< the first thing that is not proved; empty where all is
  int tetrahedra = 0;
  int edges = 0;
  int cusps = 0;
  bool orientable = false;
  std::vector<int> links;     ///< Euler characteristics of the vertex links, increasing
  std::string volume[2] = {}; ///< the claimed ends
  std::string radius;         ///< as claimed
  int bits = 0;               ///< as claimed; the check computes with 128 more
  bool has_cells = false;     ///< canonical cells are claimed, and accepted
  int walls = 0;              ///< faces between cells, each proved to be strictly convex
  /// Faces inside cells, by the criterion that is said to prove them flat. That is not checked, but for their
  /// being flat as far as intervals tell. Where there are none, the cells are proved.
  std::map<std::string, int> unchecked;
  std::string cusp_area; ///< of each cusp's cross-section, as claimed; empty: there are none
};

/// Throws InputError that names `source` for a text that is no certificate: broken JSON, a member that is
/// missing, unknown or of a wrong type, a number out of range. Milliseconds for a handful of tetrahedra,
/// seconds for a thousand digits. `still_wanted` is called now and then, and may throw to end the check.
Report check(std::string_view text, const std::string& source,
             const std::function<void()>& still_wanted = {});

} // namespace tetrarch::checker
