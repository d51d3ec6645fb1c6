// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The symmetric Dirichlet energy of one triangle: its value, slope and two positive quadratic models.
///
/// A linear map of the plane is z -> a z + b conj(z); its singular values are |a| + |b| and |a| - |b|. In the
/// frame of the map, where a and b are real, the four numbers that change it are the parts of da and db:
/// scaling by Re(da) + Re(db) and Re(da) - Re(db), a twist Im(da), a flip Im(db).

#include "tetrarch/unfold/relax.hpp"

namespace tetrarch::unfold {

enum class Model : std::uint8_t { reweighted, newton };

/// How a and b depend on the places of the three corners: a is the sum of conformal[k] z_k, b that of
/// anticonformal[k] z_k. From the wanted edges.
struct FlatDerivative {
  explicit FlatDerivative(const FlatEdges& wanted);
  std::array<std::complex<double>, 3> conformal{};
  std::array<std::complex<double>, 3> anticonformal{};
};

/// Infinite unless the triangle is counterclockwise.
double flat_energy(const FlatDerivative& derivative, const FlatEdges& now);

/// By the six coordinates x0, y0, x1, ... of the corners.
struct FlatQuadratic {
  std::array<double, 6> gradient{};
  std::array<std::array<double, 6>, 6> hessian{}; ///< positive semidefinite
};
FlatQuadratic flat_quadratic(const FlatDerivative& derivative, const FlatEdges& now, Model model);

/// The least t > 0 at which the triangle with edges now + t step is flat; infinite if there is none.
double first_flat(const FlatEdges& now, const FlatEdges& step);

} // namespace tetrarch::unfold
