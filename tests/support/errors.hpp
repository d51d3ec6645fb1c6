// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tetrarch/core/error.hpp"

#include <string>

namespace tetrarch::support {

/// The message of the InputError that `job` throws; empty if it throws none.
template <class Job>
std::string error_of(Job job) {
  try {
    job();
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

} // namespace tetrarch::support
