// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the program says of a triangulation, wherever it gives one back.

#include "command.hpp"

#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/workshop/info.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::program {

/// The fields of `info`, as JSON and as rows of text. O(n) but for the signature and the group, which are
/// left out of a brief one (null in JSON). In a session a long signature is cut in the rows.
struct Info {
  Json json;
  std::vector<std::pair<std::string, std::string>> rows;
};
Info info_of(const Triangulation& tri, const std::string& name, const Context& context, bool brief = false);

/// The signature as rows show it: in a session the beginning of a long one.
std::string shown_signature(const workshop::Info& info, const Context& context);

} // namespace tetrarch::program
