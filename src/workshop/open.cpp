// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/open.hpp"

#include "tetrarch/algebra/group_text.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/names.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/signature_text.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/identify/names.hpp"
#include "tetrarch/tetgen/fill.hpp"
#include "tetrarch/workshop/collection.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"
#include "tetrarch/workshop/nearest.hpp"

#include <optional>

namespace tetrarch::workshop {
namespace {

constexpr const char* given_json = "the JSON given";
constexpr const char* given_group = "the group given";
constexpr const char* given_diagram = "the code given";

/// What a valid mesh is better known to have, as sentences.
void add_remarks(const format::Soup& soup, const doctor::Report& report, std::vector<std::string>& warnings) {
  for (const doctor::Finding& f : report.findings) {
    if (doctor::severity_of(f.kind) == doctor::Severity::fatal) continue;
    const std::int64_t others = report.count(f.kind) - 1;
    warnings.push_back(soup.source + ": " + f.text +
                       (others > 0 ? ", and " + std::to_string(others) + " more of this kind" : ""));
  }
}

/// From a mesh file's content to gluings: mended, filled if it is a surface, validated, built.
format::Document triangulation_of(format::Soup soup, const Doctor& doctor, const Progress& progress) {
  const format::Ledger passed_over = soup.passed_over;
  std::vector<std::string> warnings = mend(soup, doctor);
  if (soup.tetrahedra.empty() && !soup.triangles.empty()) {
    soup = tetgen::fill(soup, progress);
    warnings.push_back("the surface was filled with " + std::to_string(soup.tetrahedra.size()) +
                       " tetrahedra by TetGen");
  }
  const doctor::Report report = doctor::validate(soup, 1);
  add_remarks(soup, report, warnings);
  format::Document document =
      format::document_of(solid::triangulation_of(doctor::build(std::move(soup), report)));
  document.warnings = std::move(warnings);
  document.passed_over = passed_over;
  return document;
}

[[noreturn]] void refuse(const std::string& name, const Content& content, const std::string& expected) {
  throw InputError(name + " is a " + kind_of(content) + " (expected " + expected + ")", Cause::kind);
}

bool is_json(const std::string& argument) {
  return argument.starts_with('{');
}

bool is_group(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '<' && text.find('|') != std::string::npos &&
         text.substr(first, 2) != "<?";
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
  std::string near; // looked for only where it is needed: it takes ten times as long as to read a signature
  std::string why;
  try {
    return format::read_signature_text(argument);
  } catch (const InputError& e) {
    near = near_names(argument, identify::listed_names());
    if (near.empty() && is_meant_as_signature(argument)) why = std::string("; as a signature: ") + e.what();
  }
  throw InputError(in_quotes(argument) + " is no file, no name of a manifold and no isomorphism signature" +
                       near + why,
                   Cause::name);
}

/// The exterior of the diagram that the text is, or the triangulation.
format::Document gluings_of(std::string_view text, const std::string& source, const Progress& progress = {}) {
  if (!diagram::looks_like_diagram(text))
    return with_fillings(format::the_only(collection_in(text, source), source), text, source, progress);
  return format::document_of(diagram::exterior(diagram::read_diagram(text, source), {}, progress));
}

/// The triangulation that stands in the argument, or that it chooses in a file; not a file as a whole.
format::Document given_document(const std::string& argument, const Samples& samples) {
  if (const std::optional<FileElement> found = file_element(argument, samples))
    return chosen(read_collection(found->path, samples), found->element, argument);
  if (diagram::looks_like_diagram(argument)) return gluings_of(argument, given_diagram);
  if (const std::optional<diagram::Diagram> knot = diagram::named_diagram(argument))
    return format::document_of(diagram::exterior(*knot), argument);
  return spelled_out(argument);
}

/// The mesh in a file, or nothing if something else is in it, which is then `text`.
std::optional<format::MeshDocument> mesh_in(const std::string& path, const Samples& samples,
                                            std::string& text) {
  const std::string source = format::source_name(path);
  text = format::read_file(located(path, samples));
  const auto format = format::recognise_mesh(text, source);
  if (!format) return std::nullopt;
  if (*format == format::MeshFormat::json) return format::read_mesh_json(text, source);
  if (*format == format::MeshFormat::tetgen) return format::mesh_document_of(format::read_soup_file(path));
  return format::mesh_document_of(format::read_soup(text, source));
}

/// A mesh, a group or a triangulation, whatever the text is.
Content content_of(const std::string& text, const std::string& source) {
  if (is_group(text)) return document_of(algebra::parse_presentation(text, source));
  if (format::looks_like_group_json(text)) return format::read_group_json(text, source);
  if (format::looks_like_mesh_json(text)) return format::read_mesh_json(text, source);
  return gluings_of(text, source);
}

} // namespace

format::GroupDocument document_of(algebra::Presentation group, std::string name) {
  return {group.generators, std::move(group.relators), std::move(name), {}, {}};
}

std::string kind_of(const Content& content) {
  if (std::holds_alternative<format::Document>(content)) return "triangulation";
  if (std::holds_alternative<format::GroupDocument>(content)) return "group";
  const auto& mesh = std::get<format::MeshDocument>(content);
  return mesh.soup.tetrahedra.empty() && mesh.hexahedra.empty() ? "surface" : "mesh";
}

Content open(const std::string& what, const OpenOptions& options) {
  if (is_group(what)) return content_of(what, given_group);
  if (is_json(what)) return content_of(what, given_json);
  if (!is_file(what, options.samples)) return given_document(what, options.samples);
  std::string text;
  if (std::optional<format::MeshDocument> mesh = mesh_in(what, options.samples, text))
    return std::move(*mesh);
  return content_of(text, format::source_name(what));
}

format::Document triangulation_of(const std::string& name, const Content& content, const Doctor& doctor,
                                  const Progress& progress) {
  if (const auto* document = std::get_if<format::Document>(&content)) return *document;
  if (const auto* mesh = std::get_if<format::MeshDocument>(&content))
    return triangulation_of(mesh->soup, doctor, progress);
  refuse(name, content, "a triangulation");
}

format::Document open_triangulation(const std::string& what, const OpenOptions& options,
                                    const Progress& progress) {
  if (!is_file(what, options.samples)) return given_document(what, options.samples);
  std::string text;
  std::optional<format::MeshDocument> mesh = mesh_in(what, options.samples, text);
  if (!mesh) return gluings_of(text, format::source_name(what), progress);
  text = std::string();
  return triangulation_of(std::move(mesh->soup), options.doctor, progress);
}

format::Soup open_mesh(const std::string& what, const OpenOptions& options) {
  if (is_json(what)) return format::read_mesh_json(what, given_json).soup;
  if (!is_file(what, options.samples))
    throw InputError(
        {what, 0},
        "there is no such file (expected a mesh, because other triangulations have no coordinates)",
        Cause::file);
  const std::string path = located(what, options.samples);
  format::Soup soup = format::read_soup_file(path);
  if (path != what) soup.source = what;
  return soup;
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

} // namespace tetrarch::workshop
