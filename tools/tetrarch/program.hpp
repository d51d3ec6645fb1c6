// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace tetrarch::program {

/// The program as it is typed: what the words behind `argv[0]` ask for is done, printed and written. Messages
/// and usage lines begin with `name`. The exit status; throws nothing.
int run_program(const char* name, char** argv);

} // namespace tetrarch::program
