// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Finite quotients in which claims come true.

#include "patterns.hpp"

#include <optional>
#include <vector>

namespace tetrarch::reasons {

/// Whether what the claim asks for besides its pattern is seen in this quotient.
bool shows(const Quotient& quotient, const algebra::Presentation& group, const Claim& claim);

/// The first claim that is a proof, with its quotient; those of small primes come first, then the covers.
struct Proved {
  Claim claim;
  std::optional<Quotient> quotient;
};
std::optional<Proved> first_proved(const std::vector<Claim>& claims, const algebra::Presentation& group,
                                   int degree, long long cover_steps, const Progress& progress);

} // namespace tetrarch::reasons
