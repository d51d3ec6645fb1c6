// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What may stand where a triangulation is expected: a file (its format found from its content), `-` for
/// standard input, the name of a census manifold, an isomorphism signature; or a mesh: of tetrahedra, or a
/// closed surface, which TetGen fills.

#include "command.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/soup.hpp"

#include <string>

namespace tetrarch::program {

/// Tried in this order: the name of a value, `-`, an existing file, JSON spelled out, a census name, a
/// signature. `repair` mends in a mesh what can be mended. Throws InputError that says what was tried; of a
/// bad mesh, what is wrong and where.
format::Document read_triangulation(const std::string& argument, const Context& context, bool repair = false);

/// The triangulation that a value is or becomes; `name` is what errors call it.
format::Document triangulation_of(const std::string& name, const Value& value, const Context& context,
                                  bool repair = false);

/// The same where a mesh or a surface is expected, as it stands in its file.
format::Soup read_soup(const std::string& argument, const Context& context);

/// A group value, a presentation spelled out ("< a, b | abAB >"), or the fundamental group of a manifold. As
/// it is given it keeps all that its file says; simplified it keeps its name only.
format::GroupDocument read_group(const std::string& argument, const Context& context, bool as_given);

/// The group without what its file says besides.
algebra::Presentation presentation_of(const format::GroupDocument& group);

/// Whatever it is: a mesh stays a mesh, any other text is a triangulation or a group ("< a, b | abAB >").
ValuePointer read_value(const std::string& argument, const Context& context);

/// Throws InputError that names the first defect unless the triangulation is a connected manifold (with ideal
/// vertices) of at least one tetrahedron.
void require_manifold(const Triangulation& tri, const std::string& source);

} // namespace tetrarch::program
