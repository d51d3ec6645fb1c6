// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "info.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/format/read.hpp"
#include "tetrarch/workshop/simplify.hpp"
#include "tetrarch/workshop/truncate.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

/// What both commands take.
struct ConversionArguments {
  std::string input;
  std::string output;
  std::string log;
  Doctor doctor;
};

void declare_shared(OptionTable& table, ConversionArguments& options, workshop::MoveOptions& how) {
  table.add("-o,--output", options.output, "the file to write (its extension names the format)")
      .output_file(require_triangulation);
  table.add("--moves", options.log, "write a log of all moves to this file, one per line").output_file();
  declare_doctor(table, options.doctor);
  table.add("--audit", how.audit,
            "compare the triangulation with one built from nothing after every 1,000th move; slow");
}

/// The triangulation, and `how` with what the session and the file add.
format::Document prepare(const ConversionArguments& options, workshop::MoveOptions& how,
                         const Context& context) {
  format::Document document = read_triangulation(options.input, context, options.doctor);
  require_manifolds(document.triangulation, options.input);
  how.name = document.name;
  how.seed = context.seed;
  how.keep_log = !options.log.empty();
  return document;
}

/// Text, JSON and files of either.
template <class Found>
Result result_of(Found found, const format::Document& input, const ConversionArguments& options,
                 const Context& context) {
  Result result;
  result.warnings = input.warnings;
  result.json = tree_of(found);
  result.text = block(rows_of(found, shown_signature(found.info, context)));
  format::Document document = format::document_of(std::move(found.triangulation), input.name);
  if (!options.output.empty()) add_file(result, options.output, document);
  result.value = std::make_shared<Value>(std::move(document));
  if (options.log.empty()) return result;
  std::string lines;
  for (const moves::Move& move : found.log) lines += move.str() + "\n";
  result.files.push_back({options.log, std::move(lines)});
  return result;
}

struct SimplifyArguments : ConversionArguments {
  workshop::SimplifyOptions how;
};

Result simplify(const SimplifyArguments& options, const Context& context) {
  workshop::SimplifyOptions how = options.how;
  const format::Document input = prepare(options, how, context);
  return result_of(workshop::simplify(input.triangulation, how, context.progress), input, options, context);
}

struct TruncateArguments : ConversionArguments {
  workshop::TruncateOptions how;
};

Result truncate(const TruncateArguments& options, const Context& context) {
  workshop::TruncateOptions how = options.how;
  const format::Document input = prepare(options, how, context);
  workshop::Truncation found = workshop::truncate(input.triangulation, how, context.progress);
  const std::vector<std::string> remarks = found.remarks();
  Result result = result_of(std::move(found), input, options, context);
  result.warnings.insert(result.warnings.end(), remarks.begin(), remarks.end());
  return result;
}

} // namespace

Run declare_simplify(OptionTable& table) {
  const auto options = std::make_shared<SimplifyArguments>();
  table.add("X", options->input, "a triangulation or a mesh").required();
  table.add("--keep-boundary", options->how.keep_boundary,
            "leave the triangles of the real boundary as they are");
  declare_shared(table, *options, options->how);
  return [options](const Context& context) { return simplify(*options, context); };
}

Run declare_truncate(OptionTable& table) {
  const auto options = std::make_shared<TruncateArguments>();
  table
      .add("MESH", options->input, "a mesh of tetrahedra, a closed surface, or a triangulation with boundary")
      .required();
  table.add("--keep-spheres", options->how.keep_spheres,
            "truncate boundary spheres instead of filling them in");
  declare_shared(table, *options, options->how);
  return [options](const Context& context) { return truncate(*options, context); };
}

} // namespace tetrarch::program
