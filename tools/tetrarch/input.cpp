// SPDX-License-Identifier: GPL-2.0-or-later
#include "input.hpp"

#include "tetrarch/census/manifold.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/mesh/fill.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/tet_mesh.hpp"

#include <filesystem>

namespace tetrarch::program {
namespace {

/// What a valid mesh is better known to have, as sentences.
void add_remarks(const format::Soup& soup, const mesh::Report& report, std::vector<std::string>& warnings) {
  for (const mesh::Finding& f : report.findings) {
    if (mesh::severity_of(f.kind) == mesh::Severity::fatal) continue;
    const std::int64_t others = report.count(f.kind) - 1;
    warnings.push_back(soup.source + ": " + f.text +
                       (others > 0 ? ", and " + std::to_string(others) + " more of this kind" : ""));
  }
}

format::Document triangulation_of(format::Soup soup, const ReadOptions& options) {
  std::vector<std::string> warnings = std::move(soup.warnings);
  if (options.repair) {
    mesh::Repaired repaired = mesh::repair(std::move(soup));
    soup = std::move(repaired.soup);
    warnings.insert(warnings.end(), repaired.done.begin(), repaired.done.end());
  }
  if (soup.tetrahedra.empty() && !soup.triangles.empty()) {
    soup = mesh::fill(soup, options.progress);
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

} // namespace

format::Document read_triangulation(const std::string& argument, const ReadOptions& options) {
  std::error_code ignored;
  if (argument == "-" || std::filesystem::exists(argument, ignored)) {
    const std::string source = format::source_name(argument);
    std::string text = format::read_file(argument);
    const auto format = format::recognise_mesh(text, source);
    if (!format) return format::read_any(text, source);
    if (*format == format::MeshFormat::tetgen)
      return triangulation_of(format::read_soup_file(argument), options);
    format::Soup soup = format::read_soup(text, source);
    text = std::string();
    return triangulation_of(std::move(soup), options);
  }
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
