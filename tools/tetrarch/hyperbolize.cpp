// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/workshop/structure.hpp"

#include <memory>
#include <sstream>

namespace tetrarch::program {
namespace {

struct Options {
  std::string input;
  std::string output;
  std::string history;
  std::string method = "newton";
  bool as_given = false;
  int attempts = workshop::StructureOptions{}.attempts;
  bool certify = false;
  int digits = 0;

  bool writes_certificate() const { return output.ends_with(".cert.json"); }
};

/// What else the file says stays true if the triangulation stayed the same.
format::Document with_structure(format::Document document, const workshop::Structure& found) {
  format::Document solved = document_of(found);
  if (found.search.changed) {
    solved.name = document.name;
    solved.warnings = std::move(document.warnings);
    return solved;
  }
  document.metric = std::move(solved.metric);
  return document;
}

Result hyperbolize(const Options& options, const Context& context) {
  require_folder(options.history);
  if (!options.output.empty() && output_format(options.output) != format::FileFormat::json)
    throw InputError({options.output, 0}, "only JSON holds a metric (expected the extension .json)");
  format::Document document = read_triangulation(options.input, context);
  require_manifold(document.triangulation, options.input);
  workshop::StructureOptions how;
  how.method = options.method == "flow" ? hyperbolic::Method::flow : hyperbolic::Method::newton;
  how.as_given = options.as_given;
  how.attempts = options.attempts;
  how.seed = context.seed;
  how.certify = options.certify || options.writes_certificate();
  how.digits = options.digits;
  const workshop::Structure found = structure(document.triangulation, how, context.progress);

  Result result;
  result.warnings = document.warnings;
  result.status = status_of(found.verdict());
  result.json = tree_of(found);
  result.text = block(rows_of(found));
  if (!options.history.empty()) {
    std::ostringstream csv;
    write_history_csv(csv, found.search.structure.history);
    result.files.push_back({options.history, csv.str()});
  }
  if (found.verdict() != workshop::Verdict::yes) {
    if (!options.output.empty())
      result.warnings.push_back(options.output + " was not written: no structure was " +
                                (found.certified ? "certified" : "found"));
    return result;
  }
  format::Document solved = with_structure(std::move(document), found);
  if (!options.output.empty())
    result.files.push_back(
        {options.output, options.writes_certificate() ? found.certificate : write_json(solved)});
  result.value = std::make_shared<Value>(std::move(solved));
  return result;
}

} // namespace

Run declare_hyperbolize(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("X", options->input, "a triangulation or a mesh; its boundary becomes geodesic, or a cusp")
      .required();
  table.add("--method", options->method, "the method: newton, or flow for Luo's curvature flow from length 1")
      .one_of({"newton", "flow"})
      .with_default();
  table.add("--history", options->history, "write the flow's sum of K^2 at each step as CSV")
      .value_name("FILE");
  table
      .add("-o,--output", options->output,
           "write the triangulation with its metric as JSON; to a name that ends in .cert.json, the "
           "certificate")
      .value_name("FILE");
  table.add("--certify", options->certify, "prove that the structure exists, and enclose its volume");
  table.add("--digits", options->digits, "the same, with so many digits of the volume").in_range(1, 2'000);
  table.add("--as-given", options->as_given, "solve on the given triangulation and on no other");
  table.add("--attempts", options->attempts, "greatest number of triangulations to try")
      .in_range(1, 10'000'000)
      .with_default();
  return [options](const Context& context) {
    if (!options->history.empty() && options->method != "flow")
      throw InputError("--history needs --method flow");
    return hyperbolize(*options, context);
  };
}

} // namespace tetrarch::program
