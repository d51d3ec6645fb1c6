// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Newton's method where F is not convex: with finite vertices, or tetrahedra turned over.
///
/// The Jacobian is symmetric, but has negative eigenvalues (one for each finite vertex at a structure) and
/// near a structure small ones: one for each cusp and three for each finite vertex that no mark meets, since
/// moving the horosphere or the point changes no angle. The step is the shortest that solves the equations on
/// the other eigenvectors; a line search lets |K| fall.

#include "solvers.hpp"

namespace tetrarch::hyperbolic {

Run<double> least_norm_newton(const Problem& problem, std::vector<double> start, const Goals<double>& goals,
                              const Progress& progress);

} // namespace tetrarch::hyperbolic
