// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/boundary_surface.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/text.hpp"

#include <filesystem>
#include <memory>

namespace tetrarch::program {
namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
  std::string to; ///< the name of a format; empty: as the extension says
  Doctor doctor;
};

format::FileFormat target(const ConvertArguments& options) {
  if (options.to == "json") return format::FileFormat::json;
  if (options.to == "tri") return format::FileFormat::snappea;
  if (options.to == "sig") return format::FileFormat::signature;
  if (options.to == "fmp") return format::FileFormat::fmp;
  if (options.output.empty()) return format::FileFormat::json;
  return output_format(options.output);
}

bool holds_surfaces_only(format::MeshFormat format) {
  return format == format::MeshFormat::obj || format == format::MeshFormat::off ||
         format == format::MeshFormat::stl || format == format::MeshFormat::ply;
}

/// Asked before anything is read.
void require_target(const ConvertArguments& options) {
  const std::string& path = options.output;
  if (path.empty() || !options.to.empty() || format::mesh_format_for_extension(path) ||
      format::format_for_extension(path))
    return;
  throw InputError({path, 0},
                   "no format has this extension (expected of a triangulation: .json, .tri, .sig, .txt or "
                   ".fmp; of a mesh also: .mesh, .meshb, .msh, .node, .vtk, .vtu, .obj, .off, .stl or .ply)");
}

/// From mesh to mesh, without asking whether it is good for anything: `check` does.
Result convert_mesh(const ConvertArguments& options, format::MeshFormat to, const Context& context) {
  format::Soup soup = read_soup(options.input, context);
  Result result;
  result.warnings = mend(soup, options.doctor);
  if (holds_surfaces_only(to) && !soup.tetrahedra.empty()) {
    const auto tetrahedra = static_cast<long long>(soup.tetrahedra.size());
    soup = doctor::boundary_surface(soup);
    result.warnings.push_back("the boundary of " + counted(tetrahedra, "tetrahedron") + " was written, " +
                              counted(static_cast<long long>(soup.triangles.size()), "triangle"));
  }
  if (const format::Ledger lost = format::not_held(soup, to); !lost.empty())
    result.warnings.push_back(lost.sentence("not written"));
  result.json = {{"output", options.output},
                 {"format", format::name_of(to)},
                 {"tetrahedra", soup.tetrahedra.size()},
                 {"triangles", soup.triangles.size()},
                 {"warnings", result.warnings}};
  result.value = std::make_shared<Value>(format::mesh_document_of(soup));
  if (to == format::MeshFormat::tetgen)
    format::write_soup_file(soup, options.output); // two files
  else
    result.files.push_back({options.output, format::write_soup(soup, to)});
  return result;
}

/// Whether JSON of it is a mesh again: what is JSON already or has fields, with all that it says, and
/// surfaces. JSON of any other mesh is its triangulation.
bool stays_mesh(const format::MeshDocument& mesh) {
  return !mesh.members.is_null() || !mesh.fields.empty() || mesh.soup.tetrahedra.empty();
}

/// What is to be written as a JSON mesh; null if it is something else.
const format::MeshDocument* json_mesh(const ConvertArguments& options, const Value& value) {
  const auto* const mesh = std::get_if<format::MeshDocument>(&value);
  if (options.to == "mesh" && mesh == nullptr)
    throw InputError({options.input, 0},
                     "this is a " + kind_of(value) + " (expected a mesh: it has no coordinates)");
  const bool wanted =
      options.to == "mesh" || (options.to.empty() && format::has_extension(options.output, ".json"));
  return wanted && mesh != nullptr && (options.to == "mesh" || stays_mesh(*mesh)) ? mesh : nullptr;
}

Result convert_json_mesh(const ConvertArguments& options, const format::MeshDocument& mesh) {
  Result result;
  std::string text = write_mesh_json(mesh);
  if (options.output.empty()) {
    result.text = std::move(text);
    result.is_file = true;
    return result;
  }
  result.json = {{"output", options.output},
                 {"format", "mesh"},
                 {"tetrahedra", mesh.soup.tetrahedra.size()},
                 {"triangles", mesh.soup.triangles.size()},
                 {"warnings", result.warnings}};
  result.files.push_back({options.output, std::move(text)});
  return result;
}

/// The value; of a mesh that is to stay one, mended.
ValuePointer mended_value(const ConvertArguments& options, const Context& context,
                          std::vector<std::string>& done) {
  ValuePointer value = read_value(options.input, context);
  const auto* const mesh = std::get_if<format::MeshDocument>(value.get());
  const bool asked = options.doctor.weld || options.doctor.component || options.doctor.repair;
  if (mesh == nullptr || !asked) return value;
  if (!mesh->fields.empty() || !mesh->hexahedra.empty())
    throw InputError({options.input, 0}, "--weld, --component and --repair would part this mesh from what is "
                                         "known at its vertices and elements");
  format::Soup soup = mesh->soup;
  done = mend(soup, options.doctor);
  return std::make_shared<Value>(format::mesh_document_of(std::move(soup)));
}

Result convert(const ConvertArguments& options, const Context& context) {
  require_target(options);
  std::vector<std::string> mended;
  if (const auto to = format::mesh_format_for_extension(options.output); to && options.to.empty())
    return convert_mesh(options, *to, context);
  const ValuePointer value = mended_value(options, context, mended);
  if (const format::MeshDocument* mesh = json_mesh(options, *value)) {
    Result result = convert_json_mesh(options, *mesh);
    result.warnings.insert(result.warnings.begin(), mended.begin(), mended.end());
    result.value = value;
    return result;
  }
  const format::Document document = triangulation_of(options.input, *value, context);
  const format::FileFormat to = target(options);
  format::Written written = format::write_any(document, to);
  Result result;
  result.warnings = std::move(mended);
  result.warnings.insert(result.warnings.end(), document.warnings.begin(), document.warnings.end());
  result.warnings.insert(result.warnings.end(), written.warnings.begin(), written.warnings.end());
  result.value = std::make_shared<Value>(document);
  if (options.output.empty()) {
    result.text = std::move(written.text);
    result.is_file = true;
    return result;
  }
  result.json = {{"output", options.output},
                 {"format", format::name_of(to)},
                 {"tetrahedra", document.triangulation.size()},
                 {"warnings", result.warnings}};
  result.files.push_back({options.output, std::move(written.text)});
  return result;
}

} // namespace

fields::List fields::of_convert() {
  namespace type = workshop::type;
  return {{"output", "", "the file written; without one, the file's content is printed in place of this",
           type::text},
          {"format", "", "its format", type::text},
          {"tetrahedra", "", "number of tetrahedra", type::integer},
          {"triangles", "", "of a mesh: number of triangles", type::integer, false},
          {"warnings", "", "a sentence each, as on standard error", type::list(type::text)}};
}

Run declare_convert(OptionTable& table) {
  const auto options = std::make_shared<ConvertArguments>();
  table.add("X", options->input, "a triangulation or a mesh; a mesh can become a mesh of another format")
      .required();
  table.add("-o,--output", options->output, "the file to write (its extension names the format)")
      .output_file();
  table
      .add("--to", options->to,
           "the format, whatever the extension: json (triangulation), tri, sig, fmp, or mesh (JSON of a "
           "mesh); without -o, print to standard output")
      .one_of({"json", "tri", "sig", "fmp", "mesh"});
  declare_doctor(table, options->doctor);
  return [options](const Context& context) { return convert(*options, context); };
}

} // namespace tetrarch::program
