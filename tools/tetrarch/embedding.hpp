// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `embed` and `view` begin with: a manifold with its structure, put into hyperbolic space.

#include "command.hpp"

#include "tetrarch/embed/boundary.hpp"
#include "tetrarch/embed/cover.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <string>

namespace tetrarch::program {

struct Embedding {
  Triangulation tri;
  Skeleton skeleton;
  std::string name; ///< of the document, or the input itself
  hyperbolic::Hyperbolization<double> structure;
  embed::Domain<double> domain;
  std::vector<std::string> warnings;
};

/// The structure is searched for as `hyperbolize` does; where another triangulation carries it, that one is
/// embedded, and a warning says so. Throws InputError where none is found.
Embedding embedded(const std::string& input, double cusp_area, const Context& context);

/// Throws InputError if `what` needs more bytes than so many gigabytes.
void require_memory(const std::string& what, double bytes, double gigabytes);

/// The bounds that the user gave, with the number of copies that memory allows where that was left open.
/// Throws InputError if more copies are wanted than it allows.
embed::PieceBounds allowed_bounds(const embed::PieceBounds& wanted, double gigabytes);

/// Throws InputError where the piece was cut off by memory and not by the user's bounds.
void require_complete(const embed::Piece& piece, const embed::PieceBounds& wanted, double gigabytes);

} // namespace tetrarch::program
