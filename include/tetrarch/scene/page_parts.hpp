// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What pages are made with: how their data become JSON, and how that gets into a bundled viewer.

#include "tetrarch/scene/page.hpp"

#include <cstring>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetrarch::scene {

/// In base 64, with padding.
std::string base64(std::string bytes);

/// The numbers as they lie in memory: little-endian, which is what the page reads.
template <class Number>
std::string base64(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return base64(std::move(bytes));
}

/// A list of objects with "heading", "rows" and perhaps "columns".
nlohmann::ordered_json as_json(const std::vector<InfoTable>& tables);

/// The text of a script element: "<" could end it.
std::string as_script(const nlohmann::ordered_json& data);

/// A bundled viewer with the data in the place for the scene. Throws PreconditionError if it has none.
std::string filled(std::string_view viewer, std::string_view data);

} // namespace tetrarch::scene
