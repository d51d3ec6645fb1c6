// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The conjugates *eta of the harmonic one-forms, by two routes, and the holomorphic one-forms eta + i *eta.
///
///     *eta(k) = sum of a_i eta(i) + b_i tau(i) over the loops i > 0
///
///     by periods   b_i = flux(i, k), a = 0. The closed form with the periods that *eta(k) must have and with
///                  natural boundary conditions. No rotated form is integrated.
///     by wedges    eta(k) is turned by a right angle in each triangle, and a, b are such that the result has
///                  the same integral of its wedge product with every eta(j) and tau(j).
///
/// On this basis the wedge system gives the same b, and an a that is 0 for two loops; for more loops it is a
/// discretization error, as tau(i) ^ tau(j) has integral 0 on smooth surfaces only. So the first route is
/// used for maps, and the second one tells how far it can be trusted. Source: Yin, section 2.3.1.

#include "tetrarch/slit/one_forms.hpp"

#include <vector>

namespace tetrarch::slit {

/// Coefficients of a harmonic one-form: of eta(i) and of tau(i), those of loop 0 being 0.
struct Coefficients {
  std::vector<double> eta;
  std::vector<double> tau;
};

Coefficients conjugate_by_periods(const OneForms& forms, int loop);

/// Of all loops, as the matrix of the system is the same. O(n (loops)^2) and a dense solve.
std::vector<Coefficients> conjugates_by_wedges(const OneForms& forms);

/// The form with these coefficients. O(n loops).
OneForm combination(const OneForms& forms, const Coefficients& coefficients);

struct HolomorphicOneForm {
  OneForm real;
  OneForm imaginary;
};

/// eta(k) + i *eta(k), the conjugate by periods.
HolomorphicOneForm holomorphic_one_form(const OneForms& forms, int loop);

/// |form.imaginary - *form.real| in L^2, the star now the true rotation in each triangle: 0 for what is
/// holomorphic exactly, of order h on smooth surfaces. O(n).
double distance_from_holomorphic(const OneForms& forms, const HolomorphicOneForm& form);

} // namespace tetrarch::slit
