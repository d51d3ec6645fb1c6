// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How results are written for people: the helpers of the room workshop, by their short names.

#include "tetrarch/workshop/text.hpp"

namespace tetrarch::program {

using workshop::block;
using workshop::counted;
using workshop::fixed;
using workshop::in_bytes;
using workshop::joined;
using workshop::rounded;
using workshop::scientific;

} // namespace tetrarch::program
