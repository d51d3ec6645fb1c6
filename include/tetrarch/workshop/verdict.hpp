// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How an answer came out: a mathematical no is a value, and "not found" is not "there is none".

namespace tetrarch::workshop {

enum class Verdict { yes, proved_no, undecided };

} // namespace tetrarch::workshop
