// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/scene/page_parts.hpp"

#include "tetrarch/core/error.hpp"

#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>

namespace tetrarch::scene {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the page's numbers are little-endian");

std::string base64(std::string bytes) {
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0'); // the digits come in groups of four for three bytes
  std::string text(Digits(bytes.cbegin()), Digits(bytes.cend()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

Json as_json(const std::vector<InfoTable>& tables) {
  Json list = Json::array();
  for (const InfoTable& table : tables) {
    Json entry{{"heading", table.heading}, {"rows", table.rows}};
    if (!table.columns.empty()) entry["columns"] = table.columns;
    list.push_back(std::move(entry));
  }
  return list;
}

std::string as_script(const Json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

std::string filled(std::string_view viewer, std::string_view data) {
  constexpr std::string_view slot = "TETRARCH_SCENE";
  const std::size_t at = viewer.find(slot);
  if (at == std::string_view::npos)
    throw PreconditionError("write_page: the viewer has no place for the scene");
  std::string text(viewer.substr(0, at));
  text += data;
  text += viewer.substr(at + slot.size());
  return text;
}

} // namespace tetrarch::scene
