// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What may stand where a triangulation is expected: a file (its format found from its content), `-` for
/// standard input, the name of a census manifold, or an isomorphism signature.

#include "tetrarch/format/document.hpp"

#include <string>

namespace tetrarch::program {

/// Tried in this order: `-`, an existing file, a census name, a signature. Throws InputError that says what
/// was tried.
format::Document read_triangulation(const std::string& argument);

} // namespace tetrarch::program
