// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/json.hpp"

#include "json_tree.hpp"

#include "tetrarch/format/text.hpp"

namespace tetrarch::format {
namespace {

[[noreturn]] void fail(JsonPath path, std::string what) {
  throw JsonFault{std::move(path), std::move(what), 1};
}

[[noreturn]] void fail_found(JsonPath path, const Json& found, const std::string& expected) {
  fail(std::move(path), "found " + describe(found) + ", expected " + expected);
}

JsonPath below(JsonPath path, std::size_t index) {
  path.emplace_back(index);
  return path;
}

/// A member, or null if there is none.
Json* member(Json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

Json& required(Json& root, const char* key) {
  Json* const found = member(root, key);
  if (found == nullptr) fail({}, "the member \"" + std::string(key) + "\" is missing");
  return *found;
}

Number read_number(const Json& value, const JsonPath& path) {
  const std::string expected = "a number or a string of digits";
  if (value.is_number_float()) return Number(value.get<double>());
  if (value.is_number()) {
    // 2^53: every integer up to there is a double.
    constexpr std::int64_t last_exact = std::int64_t{1} << 53;
    const bool exact = value.is_number_unsigned() ? value.get<std::uint64_t>() <= std::uint64_t{last_exact}
                                                  : value.get<std::int64_t>() >= -last_exact;
    if (exact) return Number(value.get<double>());
    if (to_text(value.get<double>()) == value.dump()) return Number(value.get<double>());
    fail_found(path, value, "a string of digits, as a double would lose some");
  }
  if (value.is_string() && is_decimal(value.get_ref<const std::string&>()))
    return Number(value.get<std::string>());
  fail_found(path, value, expected);
}

void read_entry(const Json& value, const JsonPath& path, Number& out) {
  out = read_number(value, path);
}

void read_entry(const Json& value, const JsonPath& path, std::optional<Number>& out) {
  if (!value.is_null()) out = read_number(value, path);
}

/// A list with one array of six entries per tetrahedron; empty if there is no such member. The member becomes
/// null: what was read need not be kept twice.
template <class T>
std::vector<PerEdge<T>> read_per_edge(Json& metric, const char* key, std::size_t tetrahedra) {
  std::vector<PerEdge<T>> out;
  Json* const list = member(metric, key);
  if (list == nullptr) return out;
  const JsonPath path{JsonStep("metric"), JsonStep(key)};
  const std::string count = std::to_string(tetrahedra) + " entries, one per tetrahedron";
  if (!list->is_array()) fail_found(path, *list, "an array of " + count);
  if (list->size() != tetrahedra)
    fail(path, "found " + std::to_string(list->size()) + " entries, expected " + count);
  out.resize(tetrahedra);
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    const Json& six = (*list)[t];
    if (!six.is_array() || six.size() != 6)
      fail(below(path, t), "expected an array of six numbers, for the edges 01,02,03,12,13,23");
    for (std::size_t e = 0; e < 6; ++e) read_entry(six[e], below(below(path, t), e), out[t][e]);
  }
  *list = nullptr;
  return out;
}

std::optional<Metric> read_metric(Json& root, std::size_t tetrahedra) {
  Json* const value = member(root, "metric");
  if (value == nullptr) return std::nullopt;
  if (!value->is_object()) fail_found({JsonStep("metric")}, *value, "an object");
  Metric metric;
  metric.edge_lengths = read_per_edge<std::optional<Number>>(*value, "edge_lengths", tetrahedra);
  metric.dihedral_angles = read_per_edge<Number>(*value, "dihedral_angles", tetrahedra);
  if (const Json* const volume = member(*value, "volume"))
    metric.volume = read_number(*volume, {JsonStep("metric"), JsonStep("volume")});
  metric.members = std::move(*value);
  *value = nullptr;
  return metric;
}

void check_count(const Json& count, std::size_t tetrahedra) {
  if (!count.is_number_unsigned()) fail_found({JsonStep("tetrahedra")}, count, "the number of tetrahedra");
  if (count.get<std::uint64_t>() != tetrahedra)
    fail_found({JsonStep("tetrahedra")}, count,
               std::to_string(tetrahedra) + ", the number of entries of \"gluings\"");
}

Document to_document(JsonTree tree) {
  Document document;
  required(tree.root, "format");
  required(tree.root, "version");
  const Json& count = required(tree.root, "tetrahedra");
  required(tree.root, "gluings");
  const std::size_t tetrahedra = tree.gluings.size();
  check_count(count, tetrahedra);
  if (const std::optional<GluingFault> fault = find_fault(tree.gluings))
    fail({JsonStep("gluings"), JsonStep(static_cast<std::size_t>(fault->at.tet)),
          JsonStep(static_cast<std::size_t>(fault->at.face))},
         fault->what);
  document.triangulation = build(tree.gluings);
  if (const Json* const name = member(tree.root, "name")) {
    if (!name->is_string()) fail_found({JsonStep("name")}, *name, "a string");
    document.name = name->get<std::string>();
  }
  document.metric = read_metric(tree.root, tetrahedra);
  if (Json* const provenance = member(tree.root, "provenance")) {
    if (!provenance->is_object()) fail_found({JsonStep("provenance")}, *provenance, "an object");
    document.provenance = std::move(*provenance);
    *provenance = nullptr;
  }
  document.members = std::move(tree.root);
  return document;
}

} // namespace

Document read_json(std::string_view text, const std::string& source) {
  if (trimmed(text).empty()) throw InputError(Place{source, 0}, "the text is empty, expected a JSON object");
  try {
    return to_document(parse_tree(text, source));
  } catch (const JsonFault& fault) {
    const std::string path = path_text(fault.path);
    throw InputError(Place{source, line_of(text, fault)},
                     path.empty() ? fault.what : path + ": " + fault.what);
  }
}

} // namespace tetrarch::format
