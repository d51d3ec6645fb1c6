// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The side of a plane on which a point lies, decided exactly.

#include <array>

namespace tetrarch::mesh {

/// The sign of det(b-a, c-a, d-a): +1 if the tetrahedron abcd is positively handed (core/tet.hpp), 0 if it is
/// flat. Exact for all finite coordinates: in doubles where the error bound allows, else in rational numbers.
int volume_sign(const std::array<double, 3>& a, const std::array<double, 3>& b,
                const std::array<double, 3>& c, const std::array<double, 3>& d);

} // namespace tetrarch::mesh
