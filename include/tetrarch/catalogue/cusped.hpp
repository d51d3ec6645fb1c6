// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The cusped census: the hyperbolic manifolds of finite volume, without boundary and not compact, that have
/// an ideal triangulation of at most seven tetrahedra, by the names that topologists give them:
///
///     m000 to m414    of up to five tetrahedra, orientable and not
///     s000 to s961    of six, orientable        x000 to x258    of six, non-orientable
///     v0000 to v3551  of seven, orientable      y000 to y886    of seven, non-orientable
///
/// Source: Hildebrand and Weeks (1989) and Callahan, Hildebrand, Weeks, "A census of cusped hyperbolic
/// 3-manifolds", Math. Comp. 68 (1999). Names and triangulations are theirs, the isometry signatures are
/// ours.

#include <optional>
#include <string_view>

namespace tetrarch::catalogue {

struct Cusped {
  std::string_view name;
  std::string_view signature;          ///< of a smallest ideal triangulation
  std::string_view isometry_signature; ///< of the canonical triangulation
};

/// The manifold of that name, "m125"; nothing if the census has none. Constant time.
std::optional<Cusped> find_cusped(std::string_view name);
/// The same by the signature of the canonical triangulation.
std::optional<Cusped> find_cusped_by_isometry_signature(std::string_view signature);

/// How many the census has.
int cusped_count();
/// The one at this place, 0 <= index < cusped_count(). Throws PreconditionError for another index.
Cusped cusped_at(int index);

} // namespace tetrarch::catalogue
