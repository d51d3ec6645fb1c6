// SPDX-License-Identifier: GPL-2.0-or-later
#include "input.hpp"

#include "element.hpp"
#include "nearest.hpp"
#include "samples.hpp"

#include "tetrarch/algebra/group_text.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/signature_text.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/identify/names.hpp"
#include "tetrarch/mesh/fill.hpp"
#include "tetrarch/mesh/tet_mesh.hpp"
#include "tetrarch/workshop/info.hpp"

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

format::Document triangulation_of(format::Soup soup, const Context& context, const Doctor& doctor) {
  std::vector<std::string> warnings = mend(soup, doctor);
  if (soup.tetrahedra.empty() && !soup.triangles.empty()) {
    soup = mesh::fill(soup, context.progress);
    warnings.push_back("the surface was filled with " + std::to_string(soup.tetrahedra.size()) +
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

/// Notes what the read of an input passed over.
format::Document noted(format::Document document, const Context& context) {
  context.reads->passed_over.add(document.passed_over);
  return document;
}

format::Soup noted(format::Soup soup, const Context& context) {
  context.reads->passed_over.add(soup.passed_over);
  return soup;
}

/// The manifold of a name, "m004", or of a name with Dehn fillings, "m004(1,2)", which are passed over.
std::optional<format::Document> named_manifold(const std::string& argument) {
  std::optional<identify::Named> named = identify::find_named(argument);
  format::Ledger fillings;
  if (!named) named = identify::find_named(std::string(format::without_fillings(argument, fillings)));
  if (!named) return std::nullopt;
  format::Document document = format::document_of(std::move(named->triangulation), named->name);
  document.passed_over = fillings;
  return document;
}

/// Whether what is wrong with the argument should be told as of a signature. Short words of letters are names
/// that are not known.
bool is_meant_as_signature(const std::string& argument) {
  constexpr std::size_t shortest = 7; // of two tetrahedra and no boundary: nine letters
  return argument.size() >= shortest &&
         looks_like_signature(argument.substr(0, argument.find_first_of("_(")));
}

/// A triangulation that is written out in the argument itself.
format::Document spelled_out(const std::string& argument) {
  if (is_json(argument)) return format::read_any(argument, given_json);
  if (std::optional<format::Document> named = named_manifold(argument)) return std::move(*named);
  const std::string near = near_names(argument, identify::listed_names());
  std::string why;
  try {
    return format::read_signature_text(argument);
  } catch (const InputError& e) {
    if (near.empty() && is_meant_as_signature(argument)) why = std::string("; as a signature: ") + e.what();
  }
  throw InputError(in_quotes(argument) + " is no file, no name of a manifold and no isomorphism signature" +
                   near + why);
}

/// The triangulation that stands in the argument, or that it chooses in a file; not a file as a whole.
format::Document given_document(const std::string& argument) {
  if (const std::optional<FileElement> found = file_element(argument))
    return chosen(read_collection(found->path), found->element, argument);
  return spelled_out(argument);
}

/// The argument as it was typed: `shielded` put a blank before it.
std::string bared(const std::string& argument) {
  return argument.starts_with(" -") ? argument.substr(1) : argument;
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
                                  const Doctor& doctor) {
  if (const auto* document = std::get_if<format::Document>(&value)) return *document;
  if (const auto* mesh = std::get_if<format::MeshDocument>(&value))
    return triangulation_of(mesh->soup, context, doctor);
  refuse(name, value, "a triangulation");
}

format::Document read_triangulation(const std::string& argument, const Context& context,
                                    const Doctor& doctor) {
  const std::string given = bared(argument);
  context.reads->any = true;
  if (const Value* value = value_named(given, context))
    return triangulation_of(given, *value, context, doctor);
  if (!is_file(given)) return noted(given_document(given), context);
  std::string text;
  std::optional<format::MeshDocument> mesh = mesh_in(given, text);
  if (!mesh) return noted(format::read_any(text, format::source_name(given)), context);
  text = std::string();
  return triangulation_of(noted(std::move(mesh->soup), context), context, doctor);
}

format::Soup read_soup(const std::string& argument, const Context& context) {
  context.reads->any = true;
  if (const Value* value = value_named(argument, context)) {
    if (const auto* mesh = std::get_if<format::MeshDocument>(value)) return mesh->soup;
    refuse(argument, *value, "a mesh: it has no coordinates");
  }
  if (is_json(argument)) return format::read_mesh_json(argument, given_json).soup;
  if (!is_file(argument))
    throw InputError(
        {argument, 0},
        "there is no such file (expected a mesh, because other triangulations have no coordinates)");
  const std::string path = located(argument);
  format::Soup soup = format::read_soup_file(path);
  if (path != argument) soup.source = argument;
  return noted(std::move(soup), context);
}

std::vector<LocatedGroup> read_groups(const std::string& argument, const Context& context, bool as_given) {
  const ValuePointer value = read_value(argument, context);
  if (const auto* held = std::get_if<format::GroupDocument>(value.get())) {
    if (as_given) return {{*held, {}}};
    return {{group_document(simplified(presentation_of(*held), {}, context.progress), held->name), {}}};
  }
  const format::Document document = triangulation_of(argument, *value, context);
  require_manifolds(document.triangulation, argument);
  return fundamental_groups(document.triangulation, as_given, context.progress);
}

std::vector<LocatedGroup> fundamental_groups(const Triangulation& tri, bool as_read,
                                             const Progress& progress) {
  std::vector<LocatedGroup> groups;
  for (workshop::ComponentGroup& found : workshop::fundamental_groups(tri, as_read, progress))
    groups.push_back({group_document(std::move(found.group)), std::move(found.faces)});
  return groups;
}

algebra::Presentation presentation_of(const format::GroupDocument& group) {
  return {group.generators, group.relators};
}

ValuePointer read_value(const std::string& argument, const Context& context) {
  const std::string given = bared(argument);
  context.reads->any = true;
  if (context.values != nullptr)
    if (const auto found = context.values->find(given); found != context.values->end()) return found->second;
  const auto made = [&context](Value value) {
    if (const auto* document = std::get_if<format::Document>(&value))
      context.reads->passed_over.add(document->passed_over);
    else if (const auto* mesh = std::get_if<format::MeshDocument>(&value))
      context.reads->passed_over.add(mesh->soup.passed_over);
    return std::make_shared<Value>(std::move(value));
  };
  if (is_group(given)) return made(value_in(given, given_group));
  if (is_json(given)) return made(value_in(given, given_json));
  if (!is_file(given)) return made(given_document(given));
  std::string text;
  if (std::optional<format::MeshDocument> mesh = mesh_in(given, text)) return made(std::move(*mesh));
  return made(value_in(text, format::source_name(given)));
}

bool is_signature_with_dash(const std::string& word) {
  constexpr int least = 63; // "-ba" says that there are none
  if (!word.starts_with('-')) return false;
  try {
    return format::read_signature_text(word).triangulation.size() >= least;
  } catch (const InputError&) {
    return false;
  }
}

std::string shielded(const std::string& word) {
  return is_signature_with_dash(word) || word.starts_with("-#") ? " " + word : word;
}

void require_manifolds(const Triangulation& tri, const std::string& source) {
  if (tri.size() == 0) throw InputError({source, 0}, "there are no tetrahedra");
  const Skeleton skeleton(tri);
  const auto defects = check(skeleton);
  if (!defects.empty()) throw InputError({source, 0}, describe(defects.front(), skeleton));
}

void require_connected(const Triangulation& tri, const std::string& source) {
  if (const int parts = components(tri).count; parts != 1)
    throw InputError({source, 0}, "there are " + std::to_string(parts) + " components (expected one)");
}

void require_manifold(const Triangulation& tri, const std::string& source) {
  require_manifolds(tri, source);
  require_connected(tri, source);
}

} // namespace tetrarch::program
