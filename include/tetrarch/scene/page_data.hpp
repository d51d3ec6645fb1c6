// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the pages share: how their data become JSON, and how that gets into a bundled viewer.

#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/page.hpp"

#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::scene {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the page's numbers are little-endian");

template <class Number>
std::string base64(const std::vector<Number>& numbers) {
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0'); // the digits come in groups of four for three bytes
  std::string text(Digits(bytes.cbegin()), Digits(bytes.cend()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

inline Json as_json(const std::vector<InfoTable>& tables) {
  Json list = Json::array();
  for (const InfoTable& table : tables) {
    Json entry{{"heading", table.heading}, {"rows", table.rows}};
    if (!table.columns.empty()) entry["columns"] = table.columns;
    list.push_back(std::move(entry));
  }
  return list;
}

/// The text of a script element: "<" could end it.
inline std::string as_script(const Json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

/// A bundled viewer with what `data` returns in its place for the scene.
template <class MakeData>
std::string filled(std::string_view viewer, MakeData data) {
  constexpr std::string_view slot = "TETRARCH_SCENE";
  const std::size_t at = viewer.find(slot);
  if (at == std::string_view::npos)
    throw PreconditionError("write_page: the viewer has no place for the scene");
  std::string text(viewer.substr(0, at));
  text += data();
  text += viewer.substr(at + slot.size());
  return text;
}

} // namespace tetrarch::scene
