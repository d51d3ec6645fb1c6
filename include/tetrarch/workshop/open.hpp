// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Whatever may stand for a manifold, opened: the one way from a text to data.
///
///     open_triangulation("m004")              the name of a manifold of the tables
///     open_triangulation("cPcbbbihq")         an isomorphism signature, decorated or not
///     open_triangulation("body.mesh")         a file (its format found from its content): a mesh of
///                                             tetrahedra, a closed surface, which TetGen fills, or gluings
///     open_triangulation("knots.rga#3")       one of several in a file (element.hpp)
///     open_triangulation("braid 1 -2 1 -2")   the code of a diagram, whose exterior it becomes,
///                                             or a file of such a code
///     open_triangulation("4_1")               a knot of Rolfsen's table
///     open_triangulation("-")                 standard input
///     open_triangulation("{ ... }")           JSON spelled out
///
/// What a read passed over and what else it has to say stands in `passed_over` and `warnings` of the result.

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/workshop/doctor.hpp"
#include "tetrarch/workshop/element.hpp"

#include <string>
#include <variant>

namespace tetrarch::workshop {

/// A triangulation (with its metric, if it has one), a mesh or surface (with its fields), a group.
using Content = std::variant<format::Document, format::MeshDocument, format::GroupDocument>;

struct OpenOptions {
  Doctor doctor; ///< mends a mesh first
  Samples samples = std::nullopt;
};

/// A mesh stays a mesh; any other text is a triangulation or a group ("< a, b | abAB >"). Throws InputError
/// that says what was tried and which names are near.
Content open(const std::string& what, const OpenOptions& options = {});

/// The triangulation that this is or becomes. Throws InputError also of a bad mesh: what is wrong, and where.
format::Document open_triangulation(const std::string& what, const OpenOptions& options = {},
                                    const Progress& progress = {});
/// The same of what is open; `name` is what errors call it.
format::Document triangulation_of(const std::string& name, const Content& content, const Doctor& doctor = {},
                                  const Progress& progress = {});

/// The mesh or surface in a file, as it stands there, or in JSON spelled out.
format::Soup open_mesh(const std::string& what, const OpenOptions& options = {});

/// A group as a file keeps it.
format::GroupDocument document_of(algebra::Presentation group, std::string name = {});

/// "triangulation", "mesh", "surface" or "group".
std::string kind_of(const Content& content);

/// Whether a word that begins with a dash is no option but a signature: those of 63 and more tetrahedra do.
/// O(length).
bool is_signature_with_dash(const std::string& word);

/// Throws InputError that names the first defect unless the triangulation is a manifold (with ideal vertices)
/// of at least one tetrahedron.
void require_manifolds(const Triangulation& tri, const std::string& source);
/// The same, and unless it is connected.
void require_manifold(const Triangulation& tri, const std::string& source);
/// Throws InputError unless there is one component. O(n), without the classes that the above needs.
void require_connected(const Triangulation& tri, const std::string& source);

} // namespace tetrarch::workshop
