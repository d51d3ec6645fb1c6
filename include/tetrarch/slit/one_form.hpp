// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Closed one-forms on a triangulated surface: a number for each side, its integral along the side.
///
///            2            On a triangle the three add up to 0, so there the form is the differential of a
///       b   / \           linear function; mates have opposite numbers. That is all a closed form is:
///          /   \          locally df, globally perhaps not, as going round a loop may not bring f back.
///         0-----1         wedge: (a b' - b a') / 2 on this triangle, for two forms with a along 01, b
///            a            along 02; the inner product weighs each side by half the cotangent opposite.
///
/// The surface is oriented: no mates are turned.

#include "tetrarch/surface/boundary_loops.hpp"

#include <vector>

namespace tetrarch::slit {

/// Of each side, the integral from its start to its end.
using OneForm = std::vector<double>;

/// df, of a function with a value at each vertex. O(n).
OneForm differential(const surface::Surface& surface, const std::vector<double>& f);

/// The integral of a ^ b; exact for forms that are linear on triangles, so that Stokes' theorem holds: for
/// exact a = df it is the integral of f b along the boundary. O(n).
double wedge(const surface::Surface& surface, const OneForm& a, const OneForm& b);

/// The integral of a ^ *b, with the weights of `surface::half_cotangents`. O(n).
double inner_product(const std::vector<double>& weight, const OneForm& a, const OneForm& b);

/// The integral along a boundary loop, with the surface to the left. O(length of the loop).
double period(const OneForm& form, const surface::BoundaryLoop& loop);

} // namespace tetrarch::slit
