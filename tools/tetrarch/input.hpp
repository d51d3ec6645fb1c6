// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What may stand where a triangulation is expected: a file (its format found from its content), `-` for
/// standard input, one of several in a file (element.hpp), the name of a manifold, an isomorphism signature,
/// decorated or not; or a mesh: of tetrahedra, or a closed surface, which TetGen fills.

#include "command.hpp"
#include "doctor.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/soup.hpp"
#include "tetrarch/workshop/open.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

/// Tried in this order: the name of a value, `-`, an existing file, an element of one, JSON spelled out, the
/// name of a manifold, a signature. `doctor` mends a mesh first. What is passed over is noted
/// in `context.reads`. Throws InputError that says what was tried and what names are near; of a bad mesh,
/// what is wrong and where.
format::Document read_triangulation(const std::string& argument, const Context& context,
                                    const Doctor& doctor = {});

/// The same with the marks of its edges. The function above notes them in `context.reads`: what it gives is
/// the underlying manifold.
format::Document read_marked_triangulation(const std::string& argument, const Context& context);

/// The triangulation that a value is or becomes; `name` is what errors call it.
format::Document triangulation_of(const std::string& name, const Value& value, const Context& context,
                                  const Doctor& doctor = {});

/// The same where a mesh or a surface is expected, as it stands in its file.
format::Soup read_soup(const std::string& argument, const Context& context);

/// A group, and where the loops of its generators are.
struct LocatedGroup {
  format::GroupDocument group;
  /// Of each generator the face that its loop crosses once, out of this tetrahedron; the rest of the loop
  /// runs through faces that no generator crosses or that generators now gone did. Empty: of no
  /// triangulation.
  std::vector<TetFace> faces;
};

/// A group value, a presentation spelled out ("< a, b | abAB >"), or the fundamental group of each component
/// of a manifold, in the order of their first tetrahedra. A group as it is given keeps all that its file
/// says; simplified it keeps its name only.
std::vector<LocatedGroup> read_groups(const std::string& argument, const Context& context, bool as_given);

/// The fundamental group of each component of a valid triangulation, simplified unless as_read is true.
std::vector<LocatedGroup> fundamental_groups(const Triangulation& tri, bool as_read,
                                             const Progress& progress);

/// The group without what its file says besides.
algebra::Presentation presentation_of(const format::GroupDocument& group);

/// Whatever it is: a mesh stays a mesh, any other text is a triangulation or a group ("< a, b | abAB >").
ValuePointer read_value(const std::string& argument, const Context& context);

using workshop::is_signature_with_dash;
/// The word so that no option parser takes it for an option: a blank is put before the dash of a
/// signature, and of the "-#3" that is an element of standard input. The functions above take it away again.
std::string shielded(const std::string& word);

using workshop::require_manifold;
using workshop::require_manifolds;

} // namespace tetrarch::program
