// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `embed` and `view` begin with: a manifold with its structure, put into hyperbolic space.

#include "command.hpp"

#include "tetrarch/embed/cover.hpp"
#include "tetrarch/workshop/embed.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

struct PlacedInput {
  workshop::Placement placement; ///< called by the name of the document, or the input itself
  std::vector<std::string> warnings;
};

/// The structure is searched for as `hyperbolize` does; where another triangulation carries it, that one is
/// placed. Throws InputError where none is found.
PlacedInput placed(const std::string& input, double cusp_area, const Context& context);

/// Throws InputError if `what` needs more bytes than so many gigabytes.
void require_memory(const std::string& what, double bytes, double gigabytes);

/// The bounds that the user gave, with the number of copies that memory allows where that was left open.
/// Throws InputError if more copies are wanted than it allows.
embed::PieceBounds allowed_bounds(const embed::PieceBounds& wanted, double gigabytes);

/// Throws InputError where the piece was cut off by memory and not by the user's bounds.
void require_complete(const embed::Piece& piece, const embed::PieceBounds& wanted, double gigabytes);

} // namespace tetrarch::program
