// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/read.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>

namespace tetrarch::program {
namespace {

struct Options {
  std::string input;
  std::string output;
  std::optional<format::FileFormat> to;
};

format::FileFormat target(const Options& options) {
  if (options.to) return *options.to;
  if (options.output.empty()) return format::FileFormat::json;
  return output_format(options.output);
}

/// From mesh to mesh, without asking whether it is good for anything: `check` does.
Result convert_mesh(const Options& options, format::MeshFormat to) {
  std::error_code ignored;
  if (options.input != "-" && !std::filesystem::exists(options.input, ignored))
    throw InputError({options.input, 0},
                     "no such file (expected a mesh: other triangulations have no coordinates)");
  require_folder(options.output);
  const format::Soup soup = format::read_soup_file(options.input);
  Result result;
  result.warnings = soup.warnings;
  result.json = {{"output", options.output},
                 {"format", format::name_of(to)},
                 {"tetrahedra", soup.tetrahedra.size()},
                 {"triangles", soup.triangles.size()},
                 {"warnings", result.warnings}};
  if (to == format::MeshFormat::tetgen)
    format::write_soup_file(soup, options.output); // two files
  else
    result.files.push_back({options.output, format::write_soup(soup, to)});
  return result;
}

Result convert(const Options& options) {
  if (const auto to = format::mesh_format_for_extension(options.output); to && !options.to)
    return convert_mesh(options, *to);
  const format::Document document = read_triangulation(options.input);
  const format::FileFormat to = target(options);
  format::Written written = format::write_any(document, to);
  Result result;
  result.warnings = document.warnings;
  result.warnings.insert(result.warnings.end(), written.warnings.begin(), written.warnings.end());
  if (options.output.empty()) {
    result.text = std::move(written.text);
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

Run declare_convert(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  static const std::map<std::string, format::FileFormat> formats{{"json", format::FileFormat::json},
                                                                 {"tri", format::FileFormat::snappea},
                                                                 {"sig", format::FileFormat::signature},
                                                                 {"fmp", format::FileFormat::fmp}};
  app.add_option("X", options->input, "a triangulation or a mesh; a mesh may become a mesh")->required();
  app.add_option("-o,--output", options->output, "the file to write (its extension names the format)");
  app.add_option("--to", options->to, "the format: json, tri, sig or fmp; standard output if there is no -o")
      ->transform(CLI::CheckedTransformer(formats).description("{json,tri,sig,fmp}"));
  return [options](const Context&) { return convert(*options); };
}

} // namespace tetrarch::program
