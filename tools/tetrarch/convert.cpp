// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/read.hpp"

#include <CLI/CLI.hpp>
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
  if (const auto format = format::format_for_extension(options.output)) return *format;
  throw InputError({options.output, 0},
                   "no format has this extension (expected .json, .tri, .sig, .txt or .fmp, or --to)");
}

Result convert(const Options& options) {
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
  app.add_option("X", options->input, "a triangulation")->required();
  app.add_option("-o,--output", options->output, "the file to write (its extension names the format)");
  app.add_option("--to", options->to, "the format: json, tri, sig or fmp; standard output if there is no -o")
      ->transform(CLI::CheckedTransformer(formats).description("{json,tri,sig,fmp}"));
  return [options](const Context&) { return convert(*options); };
}

} // namespace tetrarch::program
