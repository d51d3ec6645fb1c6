// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Memory that is bounded, and what happens when there is no more: one line, a status, and no abort.

namespace tetrarch::program {

/// Called first. Where the address space is bounded (ulimit -v), OpenBLAS's threads would wait for their
/// buffers for ever; then the program starts itself again with one of them. What else would abort the program
/// when memory is wanting throws std::bad_alloc from now on, and reserves are kept to tidy up and to
/// complain.
void prepare_for_want(char** arguments);

/// What a job may take where nobody said how much, in gigabytes: nine tenths of what the machine has, or its
/// control group.
double usual_memory();

/// From now on allocations beyond so many gigabytes, besides what the program holds now, throw
/// std::bad_alloc. Without effect under AddressSanitizer, whose shadow is counted as well.
void bound_memory(double gigabytes);

/// Fills the reserves again, once there is something to fill them with.
void restore_reserves();

} // namespace tetrarch::program
