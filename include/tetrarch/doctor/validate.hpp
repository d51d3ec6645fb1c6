// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Every fault of a soup of tetrahedra, by the numbers that the file uses. Kinds that only surfaces have are
/// explained in doctor/validate_surface.hpp.
///
/// | kind                | severity   | what was seen                                                |
/// | ------------------- | ---------- | ------------------------------------------------------------ |
/// | no_tetrahedra       | fatal      | the soup holds none                                          |
/// | not_finite          | fatal      | a coordinate is infinite or no number                        |
/// | index_out_of_range  | fatal      | a tetrahedron names a point that is not there                |
/// | repeated_vertex     | fatal      | a tetrahedron names a point twice                            |
/// | duplicate           | repairable | a tetrahedron names the same four points as an earlier one   |
/// | face_shared         | fatal      | three or more different tetrahedra lie on one face           |
/// | non_manifold_edge   | fatal      | the tetrahedra around an edge fall apart into several fans   |
/// | non_manifold_vertex | fatal      | the link of a vertex on no such edge is neither sphere nor   |
/// |                     |            | disk                                                         |
/// | inverted            | repairable | the volume is negative, decided exactly, and exchanging two  |
/// |                     |            | vertices fits the tetrahedron to its component               |
/// | folded              | remark     | it is inverted against its component, which no exchange      |
/// |                     |            | mends: it lies over its neighbors                            |
/// | flat                | remark     | the volume is zero, decided exactly                          |
/// | unused_vertex       | repairable | a point is in no tetrahedron                                 |
/// | coincident_vertex   | remark     | a used point has the coordinates of an earlier one           |
/// | stray_triangle      | remark     | a triangle is no face of a tetrahedron                       |
/// | several_components  | remark     | the tetrahedra are not all connected through faces           |
///
/// A component is oriented as its gluings say, with the sign by which its volume is positive. So a mesh whose
/// tetrahedra are all negative is inverted, and one of a few negative tetrahedra among others that are not
/// is folded there.
///
/// A soup with fatal findings is no mesh. Duplicates, which are repairable, also break the promise of
/// `TetMesh`; other findings are only reported. The checks of faces, edges and vertices leave out tetrahedra
/// with a fault of their own (out of range, a vertex repeated, duplicates). If three or more tetrahedra share
/// a face, nothing can be glued there; edges and vertices are then not checked, because every one near this
/// face would be reported.

#include "tetrarch/format/soup.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::doctor {

enum class Kind : std::uint8_t {
  no_tetrahedra,
  no_triangles,
  not_finite,
  index_out_of_range,
  repeated_vertex,
  degenerate,
  duplicate,
  face_shared,
  non_manifold_edge,
  non_manifold_vertex,
  inverted,
  folded,
  turned,
  flat,
  thin,
  not_orientable,
  unused_vertex,
  coincident_vertex,
  stray_triangle,
  inside_out,
  several_components,
};
inline constexpr int kind_count = 21;

enum class Severity : std::uint8_t { fatal, repairable, remark };

/// "index_out_of_range" and so on, as JSON shows it.
std::string_view name_of(Kind kind);
Severity severity_of(Kind kind);

/// One thing that is wrong or remarkable, and where.
struct Finding {
  Kind kind;
  long long number = 0; ///< of the element or vertex, as the file counts; 0 for the mesh as a whole
  int line = 0;         ///< 0: not known
  std::string text;     ///< a sentence without place: "tetrahedron 7 names vertex 12, but there are 8"
};

/// Where the file says what the finding is about.
Place place_of(const Finding& finding, const format::Soup& soup);

/// All findings in a soup.
struct Report {
  /// By kind in the order of `Kind`, then by element; at most the requested number of each kind.
  std::vector<Finding> findings;
  /// The number of findings of each kind, listed or not.
  std::array<std::int64_t, kind_count> counts{};

  std::int64_t count(Kind kind) const { return counts[static_cast<std::size_t>(kind)]; }
  std::int64_t count(Severity severity) const;
};

/// Every fault of the tetrahedra of `soup`; the first `listed` findings of each kind in full. Throws nothing.
/// O(n log n) in the worst case, in practice linear; about 250 bytes a tetrahedron.
Report validate(const format::Soup& soup, int listed = 10);

} // namespace tetrarch::doctor
