// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a command says of its result, as JSON and as text.

#include "command.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::program {

/// The same facts twice.
struct Report {
  Json json = Json::object();
  std::vector<std::pair<std::string, std::string>> rows; ///< for `block`
  std::vector<std::string> warnings;

  void add(Report other);
};

} // namespace tetrarch::program
