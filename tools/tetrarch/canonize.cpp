// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/format/json.hpp"
#include "tetrarch/workshop/canonical.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"
#include "tetrarch/workshop/diagram.hpp"
#include "tetrarch/workshop/pair.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

struct CanonizeArguments {
  std::string input;
  std::string output;
  workshop::CanonicalOptions how;

  bool writes_certificate() const { return output.ends_with(".cert.json"); }
};

Result canonize(const CanonizeArguments& options, const Context& context) {
  const std::string& input = options.input;
  const std::string& output = options.output;
  workshop::CanonicalOptions how = options.how;
  how.seed = context.seed;
  const format::Document document = read_marked_triangulation(input, context);
  require_manifold(document.triangulation, input);
  workshop::require_filled(document, input);
  how.marks = document.marks;
  how.certify = options.writes_certificate();
  const workshop::Cells found = workshop::cells(document.triangulation, how, context.progress);
  Result result;
  result.warnings = document.warnings;
  result.status = status_of(found.verdict());
  result.json = tree_of(found);
  result.text = block(rows_of(found));
  if (found.verdict() != workshop::Verdict::yes) return result;
  if (!found.canonical->proof.certified)
    result.warnings.push_back("the cells are not proved: " + found.canonical->proof.why_not);
  format::Document cells = document_of(found);
  if (how.certify && found.certificate.empty()) {
    result.status = status_of(workshop::Verdict::undecided);
    result.warnings.push_back(output + " was not written: the cells are not proved");
  } else if (!output.empty()) {
    result.files.push_back({output, how.certify ? found.certificate : write_json(cells)});
  }
  result.value = std::make_shared<Value>(std::move(cells));
  return result;
}

struct IsometricOptions {
  std::string x;
  std::string y;
  bool pair = false;
};

/// Of two diagrams, with what was drilled.
Result compare_pairs(const IsometricOptions& options, const Context& context) {
  context.reads->any = true;
  const auto open = [&context](const std::string& what) {
    return workshop::open_diagram(what, {{}, samples_folder()}, context.seed, context.progress);
  };
  const diagram::Diagram x = open(options.x);
  const diagram::Diagram y = open(options.y);
  workshop::PairOptions how;
  how.seed = context.seed;
  const workshop::PairComparison found =
      workshop::compare_pairs(x, options.x, y, options.y, how, context.progress);
  Result result;
  result.status = status_of(found.verdict);
  result.json = tree_of(found);
  result.text = text_of(found);
  return result;
}

Result isometric(const IsometricOptions& options, const Context& context) {
  if (options.pair) return compare_pairs(options, context);
  const auto& [x, y, unused] = options;
  const format::Document given_x = read_marked_triangulation(x, context);
  require_manifold(given_x.triangulation, x);
  workshop::require_filled(given_x, x);
  const format::Document given_y = read_marked_triangulation(y, context);
  require_manifold(given_y.triangulation, y);
  workshop::require_filled(given_y, y);
  workshop::CanonicalOptions how;
  how.seed = context.seed;
  const workshop::Isometry found = isometry({given_x.triangulation, x, given_x.marks},
                                            {given_y.triangulation, y, given_y.marks}, how, context.progress);
  Result result;
  result.warnings = given_x.warnings;
  result.warnings.insert(result.warnings.end(), given_y.warnings.begin(), given_y.warnings.end());
  result.status = status_of(found.verdict());
  result.json = tree_of(found);
  result.text = text_of(found);
  return result;
}

} // namespace

Run declare_canonize(OptionTable& table) {
  const auto options = std::make_shared<CanonizeArguments>();
  table.add("X", options->input, "a triangulation that carries a hyperbolic structure").required();
  table
      .add("-o,--output", options->output,
           "write the canonical triangulation with its cells as JSON; to a name that ends in .cert.json, the "
           "certificate")
      .output_file(with_extension(".json"));
  table.add("--isometries", options->how.list_isometries, "list all isometries (in JSON)");
  table
      .add("--attempts", options->how.attempts,
           "greatest number of triangulations to try; fewer of large ones")
      .in_range(1, 10'000'000)
      .with_default();
  return [options](const Context& context) { return canonize(*options, context); };
}

Run declare_isometric(OptionTable& table) {
  const auto options = std::make_shared<IsometricOptions>();
  table.add("X", options->x, "a triangulation that carries a hyperbolic structure").required();
  table.add("Y", options->y, "another triangulation that carries a hyperbolic structure").required();
  table.add("--pair", options->pair,
            "X and Y are diagrams of links or graphs: compare the handlebodies in space, not their exteriors "
            "alone, and tell symmetry groups");
  return [options](const Context& context) { return isometric(*options, context); };
}

} // namespace tetrarch::program
