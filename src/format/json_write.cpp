// SPDX-License-Identifier: GPL-2.0-or-later
// The canonical text. Arrays that follow the tetrahedra have one of them a line; all else is indented by two.
#include "tetrarch/format/json.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace tetrarch::format {
namespace {

/// A member and its value as text; no text: the document has no such member.
struct Member {
  std::string key;
  std::optional<std::string> text;
};

std::string indent(int depth) {
  return std::string(static_cast<std::size_t>(2 * depth), ' ');
}

/// Strings of a document are UTF-8; what is not becomes U+FFFD rather than an exception in the midst of
/// saving.
std::string dumped(const Json& value, int depth) {
  const std::string flat = value.dump(2, ' ', false, Json::error_handler_t::replace);
  std::string text;
  for (const char c : flat) { // a line break stands between tokens only: in strings it is escaped
    text += c;
    if (c == '\n') text += indent(depth);
  }
  return text;
}

/// The members of `read` in their order, known ones with their new text, then the known ones that are new.
std::string object_text(const Json& read, std::vector<Member> known, int depth) {
  std::string text;
  const auto add = [&](const std::string& key, const std::string& value) {
    text += (text.empty() ? "{\n" : ",\n") + indent(depth + 1) + dumped(Json(key), 0) + ": " + value;
  };
  if (read.is_object()) {
    for (const auto& [key, value] : read.items()) {
      const auto at =
          std::find_if(known.begin(), known.end(), [&k = key](const Member& m) { return m.key == k; });
      if (at == known.end()) {
        add(key, dumped(value, depth + 1));
      } else if (at->text) {
        add(key, *at->text);
        at->text.reset();
      }
    }
  }
  for (const Member& m : known)
    if (m.text) add(m.key, *m.text);
  return text.empty() ? "{}" : text + "\n" + indent(depth) + "}";
}

/// `lines` as an array with one entry a line.
std::string array_text(const std::vector<std::string>& lines, int depth) {
  if (lines.empty()) return "[]";
  std::string text = "[\n";
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += indent(depth + 1) + lines[i] + (i + 1 < lines.size() ? ",\n" : "\n");
  return text + indent(depth) + "]";
}

std::string gluings_text(const Triangulation& tri) {
  std::vector<std::string> lines;
  lines.reserve(static_cast<std::size_t>(tri.size()));
  for (int t = 0; t < tri.size(); ++t) {
    std::string line = "[";
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (f > 0) line += ", ";
      line += g.tet < 0 ? "null" : "[" + std::to_string(g.tet) + ", \"" + g.perm.str() + "\"]";
    }
    lines.push_back(line + "]");
  }
  return array_text(lines, 1);
}

std::string number_text(const Number& number) {
  return number.is_text() ? "\"" + number.text() + "\"" : number.text();
}

std::string number_text(const std::optional<Number>& number) {
  return number ? number_text(*number) : "null";
}

template <class T>
std::optional<std::string> per_edge_text(const std::vector<PerEdge<T>>& list, int tetrahedra) {
  if (list.empty()) return std::nullopt;
  if (list.size() != static_cast<std::size_t>(tetrahedra))
    throw PreconditionError("a metric of " + std::to_string(list.size()) +
                            " tetrahedra on a triangulation of " + std::to_string(tetrahedra));
  std::vector<std::string> lines;
  lines.reserve(list.size());
  for (const PerEdge<T>& six : list) {
    std::string line;
    for (const T& entry : six) line += (line.empty() ? "[" : ", ") + number_text(entry);
    lines.push_back(line + "]");
  }
  return array_text(lines, 2);
}

std::optional<std::string> metric_text(const Document& document) {
  if (!document.metric) return std::nullopt;
  const Metric& metric = *document.metric;
  const int tetrahedra = document.triangulation.size();
  std::optional<std::string> volume;
  if (metric.volume) volume = number_text(*metric.volume);
  return object_text(metric.members,
                     {{"edge_lengths", per_edge_text(metric.edge_lengths, tetrahedra)},
                      {"dihedral_angles", per_edge_text(metric.dihedral_angles, tetrahedra)},
                      {"volume", volume}},
                     1);
}

} // namespace

std::string write_json(const Document& document) {
  std::optional<std::string> name;
  if (!document.name.empty()) name = dumped(Json(document.name), 0);
  std::optional<std::string> provenance;
  if (!document.provenance.is_null()) {
    if (!document.provenance.is_object())
      throw PreconditionError("the provenance of a document must be an object");
    provenance = dumped(document.provenance, 1);
  }
  return object_text(document.members,
                     {{"format", dumped(Json(std::string(json_format_tag)), 0)},
                      {"version", std::to_string(json_format_version)},
                      {"name", name},
                      {"tetrahedra", std::to_string(document.triangulation.size())},
                      {"gluings", gluings_text(document.triangulation)},
                      {"metric", metric_text(document)},
                      {"provenance", provenance}},
                     0) +
         "\n";
}

} // namespace tetrarch::format
