// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a command says for programs: the tree of results, which the program prints as JSON.

#include "tetrarch/workshop/tree.hpp"

namespace tetrarch::program {

using Json = workshop::Tree;

} // namespace tetrarch::program
