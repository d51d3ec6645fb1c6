// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Flat cells by exact algebra (certify.hpp, E).

#include "tetrarch/canonical/certify.hpp"
#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/numeric/algebraic.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::canonical {

/// The polynomial of the field in which all faces marked `flat` are proved to be so; nothing where no field
/// is seen, where there are cusps beside geodesic boundary, or where the proof fails. `still_wanted` is
/// called now and then, and may throw to end the search.
std::optional<std::string> prove_flat_exactly(const Triangulation& tri, const Skeleton& skeleton,
                                              const FlatFaces& flat, const PreciseSolver& solver,
                                              const std::function<void()>& still_wanted = {});

/// Its two halves. What is guessed: inner products of the ends of edges, edge by edge, then those of the
/// vertices off a face on both sides, in the order of each face's first side.
std::vector<numeric::Ball> products_to_guess(const Decorated<numeric::Ball>& m, const Skeleton& skeleton);

/// The vertex beyond face `face` in the basis of the four near ones, from its inner products with them.
/// Nothing unless its norm comes out as this, and it lies on the other side of the face. (Without the norm,
/// tetrahedra that close up around edges make a projective structure, which need not be hyperbolic.)
std::optional<std::array<numeric::Algebraic, 4>> far_vertex(const Gram<numeric::Algebraic>& near,
                                                            const std::array<numeric::Algebraic, 4>& products,
                                                            const numeric::Algebraic& norm, int face);

/// What is proved: these numbers, taken for what `products_to_guess` lists, make the hyperbolic structure
/// with cusps of one area, in which all faces marked `flat` are so. O(n) products in the field;
/// `still_wanted` is called for each face and each edge.
bool are_of_flat_structure(const Triangulation& tri, const Skeleton& skeleton, const FlatFaces& flat,
                           const std::vector<numeric::Algebraic>& products,
                           const std::function<void()>& still_wanted = {});

} // namespace tetrarch::canonical
