// SPDX-License-Identifier: GPL-2.0-or-later
#include "input.hpp"

#include "samples.hpp"

#include "tetrarch/algebra/group_text.hpp"
#include "tetrarch/census/manifold.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/mesh/fill.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/tet_mesh.hpp"

#include <filesystem>
#include <optional>

namespace tetrarch::program {
namespace {

constexpr const char* given_json = "the JSON given";
constexpr const char* given_group = "the group given";

/// What a valid mesh is better known to have, as sentences.
void add_remarks(const format::Soup& soup, const mesh::Report& report, std::vector<std::string>& warnings) {
  for (const mesh::Finding& f : report.findings) {
    if (mesh::severity_of(f.kind) == mesh::Severity::fatal) continue;
    const std::int64_t others = report.count(f.kind) - 1;
    warnings.push_back(soup.source + ": " + f.text +
                       (others > 0 ? ", and " + std::to_string(others) + " more of this kind" : ""));
  }
}

format::Document triangulation_of(format::Soup soup, const Context& context, bool repair) {
  std::vector<std::string> warnings = std::move(soup.warnings);
  if (repair) {
    mesh::Repaired repaired = mesh::repair(std::move(soup));
    soup = std::move(repaired.soup);
    warnings.insert(warnings.end(), repaired.done.begin(), repaired.done.end());
  }
  if (soup.tetrahedra.empty() && !soup.triangles.empty()) {
    soup = mesh::fill(soup, context.progress);
    warnings.push_back("a surface: filled with " + std::to_string(soup.tetrahedra.size()) +
                       " tetrahedra by TetGen");
  }
  const mesh::Report report = mesh::validate(soup, 1);
  add_remarks(soup, report, warnings);
  format::Document document =
      format::document_of(mesh::triangulation_of(mesh::build(std::move(soup), report)));
  document.warnings = std::move(warnings);
  return document;
}

const Value* value_named(const std::string& name, const Context& context) {
  if (context.values == nullptr) return nullptr;
  const auto found = context.values->find(name);
  return found == context.values->end() ? nullptr : found->second.get();
}

[[noreturn]] void refuse(const std::string& name, const Value& value, const std::string& expected) {
  throw InputError(name + " is a " + kind_of(value) + " (expected " + expected + ")");
}

bool is_file(const std::string& argument) {
  std::error_code ignored;
  return argument == "-" || std::filesystem::exists(located(argument), ignored);
}

bool is_json(const std::string& argument) {
  return argument.starts_with('{');
}

bool is_group(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '<' && text.find('|') != std::string::npos &&
         text.substr(first, 2) != "<?";
}

format::GroupDocument group_document(algebra::Presentation group, std::string name = {}) {
  return {group.generators, std::move(group.relators), std::move(name), {}, {}};
}

/// A triangulation that is written out in the argument itself.
format::Document spelled_out(const std::string& argument) {
  if (is_json(argument)) return format::read_any(argument, given_json);
  if (argument.starts_with("fmp")) {
    if (const auto manifold = census::find_by_name(argument))
      return format::document_of(from_signature(manifold->signature), manifold->name);
    throw InputError("no census manifold is called " + in_quotes(argument) +
                     " (expected fmp2_1 ... fmp2_8 or fmp3_1 ... fmp3_151)");
  }
  try {
    if (looks_like_signature(argument)) return format::document_of(from_signature(argument));
  } catch (const InputError& e) {
    throw InputError(in_quotes(argument) + " is no file and no census name; as a signature: " + e.what());
  }
  throw InputError(in_quotes(argument) +
                   " is no file, and neither a census name nor an isomorphism signature");
}

/// The mesh in a file, or nothing if something else is in it, which is then `text`.
std::optional<format::MeshDocument> mesh_in(const std::string& path, std::string& text) {
  const std::string source = format::source_name(path);
  text = format::read_file(located(path));
  const auto format = format::recognise_mesh(text, source);
  if (!format) return std::nullopt;
  if (*format == format::MeshFormat::json) return format::read_mesh_json(text, source);
  if (*format == format::MeshFormat::tetgen) return format::mesh_document_of(format::read_soup_file(path));
  return format::mesh_document_of(format::read_soup(text, source));
}

/// A mesh, a group or a triangulation, whatever the text is.
Value value_in(const std::string& text, const std::string& source) {
  if (is_group(text)) return group_document(algebra::parse_presentation(text, source));
  if (format::looks_like_group_json(text)) return format::read_group_json(text, source);
  if (format::looks_like_mesh_json(text)) return format::read_mesh_json(text, source);
  return format::read_any(text, source);
}

} // namespace

format::Document triangulation_of(const std::string& name, const Value& value, const Context& context,
                                  bool repair) {
  if (const auto* document = std::get_if<format::Document>(&value)) return *document;
  if (const auto* mesh = std::get_if<format::MeshDocument>(&value))
    return triangulation_of(mesh->soup, context, repair);
  refuse(name, value, "a triangulation");
}

format::Document read_triangulation(const std::string& argument, const Context& context, bool repair) {
  if (const Value* value = value_named(argument, context))
    return triangulation_of(argument, *value, context, repair);
  if (!is_file(argument)) return spelled_out(argument);
  std::string text;
  std::optional<format::MeshDocument> mesh = mesh_in(argument, text);
  if (!mesh) return format::read_any(text, format::source_name(argument));
  text = std::string();
  return triangulation_of(std::move(mesh->soup), context, repair);
}

format::Soup read_soup(const std::string& argument, const Context& context) {
  if (const Value* value = value_named(argument, context)) {
    if (const auto* mesh = std::get_if<format::MeshDocument>(value)) return mesh->soup;
    refuse(argument, *value, "a mesh: it has no coordinates");
  }
  if (is_json(argument)) return format::read_mesh_json(argument, given_json).soup;
  if (!is_file(argument))
    throw InputError({argument, 0},
                     "no such file (expected a mesh: other triangulations have no coordinates)");
  const std::string path = located(argument);
  format::Soup soup = format::read_soup_file(path);
  if (path != argument) soup.source = argument;
  return soup;
}

format::GroupDocument read_group(const std::string& argument, const Context& context, bool as_given) {
  const ValuePointer value = read_value(argument, context);
  format::GroupDocument group;
  if (const auto* held = std::get_if<format::GroupDocument>(value.get())) {
    group = *held;
  } else {
    const format::Document document = triangulation_of(argument, *value, context);
    require_manifold(document.triangulation, argument);
    const Skeleton skeleton(document.triangulation);
    group = group_document(algebra::dual_presentation(document.triangulation, skeleton).presentation);
  }
  return as_given ? group
                  : group_document(simplified(presentation_of(group), {}, context.progress), group.name);
}

algebra::Presentation presentation_of(const format::GroupDocument& group) {
  return {group.generators, group.relators};
}

ValuePointer read_value(const std::string& argument, const Context& context) {
  if (context.values != nullptr)
    if (const auto found = context.values->find(argument); found != context.values->end())
      return found->second;
  if (is_group(argument)) return std::make_shared<Value>(value_in(argument, given_group));
  if (is_json(argument)) return std::make_shared<Value>(value_in(argument, given_json));
  if (!is_file(argument)) return std::make_shared<Value>(spelled_out(argument));
  std::string text;
  if (std::optional<format::MeshDocument> mesh = mesh_in(argument, text))
    return std::make_shared<Value>(std::move(*mesh));
  return std::make_shared<Value>(value_in(text, format::source_name(argument)));
}

void require_manifold(const Triangulation& tri, const std::string& source) {
  if (tri.size() == 0) throw InputError({source, 0}, "there are no tetrahedra");
  const Skeleton skeleton(tri);
  const auto defects = check(skeleton);
  if (!defects.empty()) throw InputError({source, 0}, describe(defects.front(), skeleton));
  if (!skeleton.is_connected())
    throw InputError({source, 0}, "there are " + std::to_string(skeleton.component_count()) +
                                      " components (expected one)");
}

} // namespace tetrarch::program
