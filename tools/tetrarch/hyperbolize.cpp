// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "edge_names.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"
#include "tetrarch/workshop/structure.hpp"

#include <memory>
#include <sstream>

namespace tetrarch::program {
namespace {

struct HyperbolizeArguments {
  std::string input;
  std::string output;
  std::string history;
  std::string method = "newton";
  bool as_given = false;
  int attempts = workshop::StructureOptions{}.attempts;
  bool certify = false;
  int digits = 0;
  std::vector<std::string> parabolic;
  std::vector<std::string> cones;

  bool writes_certificate() const { return output.ends_with(".cert.json"); }
};

/// The marks of the file, and those that are asked for, which replace them.
Marks marks_asked_for(const HyperbolizeArguments& options, const format::Document& document) {
  if (options.parabolic.empty() && options.cones.empty()) return document.marks;
  const Skeleton skeleton(document.triangulation);
  EdgeOrders orders = edge_orders(skeleton, document.marks);
  if (options.parabolic == std::vector<std::string>{"all"}) {
    for (double& order : orders)
      if (document.marks.empty() || order != 1) order = 0;
  } else {
    const Table<EdgeId, bool> chosen = edges_named(options.parabolic, skeleton, "--parabolic");
    for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
      if (chosen[e]) orders[e] = 0;
  }
  for (const std::string& word : options.cones) {
    const std::size_t colon = word.rfind(':');
    const auto order =
        colon == std::string::npos ? std::nullopt : format::parse_double(word.substr(colon + 1));
    if (!order || !is_edge_order(*order))
      throw InputError("--cone: found " + in_quotes(word) +
                       " (expected an edge and a number n of at least 1, for the angle 2 pi / n: 5:3)");
    orders[edge_named(word.substr(0, colon), skeleton, "--cone")] = *order;
  }
  return marks_of(skeleton, orders);
}

/// What else the file says stays true if the triangulation stayed the same.
format::Document with_structure(format::Document document, const workshop::Structure& found) {
  format::Document solved = document_of(found);
  if (found.search.changed) {
    solved.name = document.name;
    solved.warnings = std::move(document.warnings);
    return solved;
  }
  document.marks = std::move(solved.marks);
  document.metric = std::move(solved.metric);
  return document;
}

Result hyperbolize(const HyperbolizeArguments& options, const Context& context) {
  if (!options.output.empty() && output_format(options.output) != format::FileFormat::json)
    throw InputError({options.output, 0}, "only JSON holds a metric (expected the extension .json)");
  format::Document document = read_marked_triangulation(options.input, context);
  require_manifold(document.triangulation, options.input);
  workshop::require_filled(document, options.input);
  workshop::StructureOptions how;
  how.method = options.method == "flow" ? hyperbolic::Method::flow : hyperbolic::Method::newton;
  how.as_given = options.as_given;
  how.attempts = options.attempts;
  how.seed = context.seed;
  how.certify = options.certify || options.writes_certificate();
  how.digits = options.digits;
  how.marks = marks_asked_for(options, document);
  if (!how.marks.empty() && options.method == "flow")
    throw InputError("--method flow: the flow knows no marked edges (expected newton)");
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
  const bool turned_over = found.orbifold && found.orbifold->structure.solved() && !found.certified;
  if (found.verdict() != workshop::Verdict::yes && !turned_over) {
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
  const auto options = std::make_shared<HyperbolizeArguments>();
  table.add("X", options->input, "a triangulation or a mesh; its boundary becomes geodesic, or a cusp")
      .required();
  table.add("--method", options->method, "the method: newton, or flow for Luo's curvature flow from length 1")
      .one_of({"newton", "flow"})
      .with_default();
  table.add("--history", options->history, "write the flow's sum of K^2 at each step as CSV").output_file();
  table
      .add("-o,--output", options->output,
           "write the triangulation with its metric as JSON; to a name that ends in .cert.json, the "
           "certificate")
      .output_file();
  table.add("--certify", options->certify, "prove that the structure exists, and enclose its volume");
  table.add("--digits", options->digits, "the same, with so many digits of the volume").in_range(1, 2'000);
  table
      .add("--parabolic", options->parabolic,
           "edges whose meridians are to be parabolic, as 'skeleton X' numbers them: 0,3 or 2:01; or 'all' "
           "that the file marks, and where it marks none, all")
      .value_name("EDGES");
  table.add("--cone", options->cones, "an edge and n, for the cone angle 2 pi / n around it: 5:3, 2:01:2.5")
      .value_name("EDGE:N");
  table.add("--as-given", options->as_given, "solve on the given triangulation and on no other");
  table.add("--attempts", options->attempts, "greatest number of triangulations to try; fewer of large ones")
      .in_range(1, 10'000'000)
      .with_default();
  return [options](const Context& context) {
    if (!options->history.empty() && options->method != "flow")
      throw InputError("--history needs --method flow");
    return hyperbolize(*options, context);
  };
}

} // namespace tetrarch::program
