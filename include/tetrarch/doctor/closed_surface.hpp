// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A surface that bounds: what can be filled.

#include "tetrarch/format/soup.hpp"

namespace tetrarch::doctor {

/// Throws InputError with the first triangle or vertex at fault, unless the triangles of `surface` form one
/// closed surface: each edge runs once in either direction, and the triangles around each vertex form one
/// disk. O(n log n).
void require_closed_surface(const format::Soup& surface);

} // namespace tetrarch::doctor
