// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Matrices of doubles.

#include <optional>
#include <vector>

namespace tetrarch::checker {

/// The inverse by elimination, about right; nothing where a pivot vanishes.
std::optional<std::vector<std::vector<double>>> inverse(std::vector<std::vector<double>> m);

} // namespace tetrarch::checker
