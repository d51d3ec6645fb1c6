// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Errors get the name of what was read.

#include "tetrarch/core/error.hpp"

#include <string>

namespace tetrarch::workshop {

/// What `job` returns. What it finds wrong with a triangle or a solid is wrong in a file: its InputError is
/// thrown anew with the name `path` before the message; as it is where it names a place, or there is no name.
template <class Job>
auto in_file(const std::string& path, const Job& job) {
  try {
    return job();
  } catch (const InputError& e) {
    if (path.empty() || !e.place.source.empty()) throw;
    throw InputError({path, 0}, e.what());
  }
}

} // namespace tetrarch::workshop
