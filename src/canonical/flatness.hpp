// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Proofs that the vertex vectors of a cell lie in one affine hyperplane (certify.hpp).

#include "cell_shapes.hpp"
#include "tetrarch/canonical/certify.hpp"
#include "tetrarch/canonical/decorated.hpp"

#include <optional>
#include <vector>

namespace tetrarch::canonical {

/// Square.
using BallMatrix = std::vector<std::vector<numeric::Ball>>;
/// The inner products of a cell's corners, in balls.
BallMatrix gram_of_cell(const Decorated<numeric::Ball>& m, const FlatFaces& flat, const CellShapes& shapes,
                        int cell);

/// Of a square matrix: every pivot of elimination is certainly not 0.
bool is_regular(BallMatrix m);

/// The criterion that proves cell number `cell` flat; nothing where none does. L is tried if that is allowed.
std::optional<Criterion> prove_flat(const Decorated<numeric::Ball>& m, const FlatFaces& flat,
                                    const CellShapes& shapes, int cell, bool relations = false);

} // namespace tetrarch::canonical
