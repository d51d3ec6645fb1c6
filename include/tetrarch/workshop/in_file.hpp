// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tetrarch/core/error.hpp"

#include <string>

namespace tetrarch::workshop {

/// What `job` returns. What it finds wrong with a triangle or a solid is wrong in a file: InputError names
/// the file then.
template <class Job>
auto in_file(const std::string& path, const Job& job) {
  try {
    return job();
  } catch (const InputError& e) {
    throw InputError({path, 0}, e.what());
  }
}

} // namespace tetrarch::workshop
