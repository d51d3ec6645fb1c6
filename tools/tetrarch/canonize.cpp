// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/union_find.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/hyperbolic/search.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

namespace tetrarch::program {
namespace {

using canonical::Canonical;
using hyperbolic::Outcome;

/// A manifold that was solved and canonised, or the sentence that says why not.
struct Solved {
  std::optional<Canonical> canonical;
  std::string why_not;
  Outcome outcome = Outcome::invalid;
  double volume = 0;
  std::vector<std::string> warnings; ///< from reading the input
};

Solved solve(const std::string& input, const Context& context) {
  const format::Document document = read_triangulation(input, context);
  require_manifold(document.triangulation, input);
  hyperbolic::SearchOptions search;
  search.seed = context.seed;
  const hyperbolic::Search found = find_structure(document.triangulation, search, context.progress);
  const auto& structure = found.structure;
  Solved solved{std::nullopt, {}, structure.outcome, structure.volume, document.warnings};
  if (structure.outcome != Outcome::geometric) {
    solved.why_not = describe(found);
    return solved;
  }
  canonical::CanonizeOptions options;
  options.seed = context.seed;
  solved.canonical = canonical::canonize(found.triangulation, structure, options, context.progress);
  if (solved.canonical->outcome != Canonical::Outcome::canonical)
    solved.why_not = "a face stays concave and no move mends it, after " +
                     std::to_string(solved.canonical->restarts) + " changes of the triangulation";
  return solved;
}

std::string cell_summary(const std::vector<std::string>& cells) {
  std::map<std::string, int> count;
  for (const std::string& cell : cells) ++count[cell];
  std::vector<std::string> items;
  items.reserve(count.size());
  for (const auto& [cell, n] : count) items.push_back(counted(n, cell));
  return joined(items, ", ");
}

/// Tetrahedra with a flat face between them are parts of one cell; cells are numbered by their first one.
format::CanonicalCells cells_of(const Canonical& c) {
  std::vector<int> root(static_cast<std::size_t>(c.triangulation.size()));
  std::iota(root.begin(), root.end(), 0);
  for (int t = 0; t < c.triangulation.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (c.flat[t][f]) {
        const int a = find_root(root, t);
        const int b = find_root(root, c.triangulation.gluing({t, f}).tet);
        root[std::max(a, b)] = std::min(a, b);
      }
  format::CanonicalCells result{c.cells, std::vector<int>(root.size()), c.flat, c.isometry_signature, {}};
  int cells = 0;
  for (int t = 0; t < c.triangulation.size(); ++t) {
    const int first = find_root(root, t);
    result.cell_of[t] = first == t ? cells++ : result.cell_of[first];
  }
  return result;
}

Result canonize(const std::string& input, const std::string& output, const Context& context) {
  const Solved solved = solve(input, context);
  Result result;
  result.warnings = solved.warnings;
  if (!solved.why_not.empty()) {
    result.status = solved.outcome == Outcome::projective_plane ? Status::proved_no : Status::undecided;
    result.json = {{"outcome", "not found"}, {"reason", solved.why_not}};
    result.text = block({{"outcome", "not found"}, {"reason", solved.why_not}});
    return result;
  }
  const Canonical& c = *solved.canonical;
  const std::size_t order = isometry_group(c).size();
  result.json = {{"outcome", "canonical"},
                 {"cells", c.cells},
                 {"isometry_signature", c.isometry_signature},
                 {"isometry_group_order", order},
                 {"tetrahedra", c.triangulation.size()},
                 {"flat_faces", c.has_flat_faces},
                 {"smallest_tilt", c.smallest_tilt},
                 {"volume", solved.volume}};
  result.text = block({{"cells", cell_summary(c.cells)},
                       {"isometry signature", c.isometry_signature},
                       {"isometry group", "order " + std::to_string(order)},
                       {"tetrahedra", std::to_string(c.triangulation.size())},
                       {"smallest tilt", scientific(c.smallest_tilt, 3)},
                       {"volume", fixed(solved.volume, 12)}});
  if (c.has_flat_faces)
    result.warnings.emplace_back("some faces are flat to 30 digits, which is evidence and no proof");
  format::Document document = format::document_of(c.triangulation);
  document.canonical = cells_of(c);
  if (!output.empty()) result.files.push_back({output, write_json(document)});
  result.value = std::make_shared<Value>(std::move(document));
  return result;
}

Json isometry_json(const Isomorphism& isometry) {
  Json perms = Json::array();
  for (const Perm4 p : isometry.perm) perms.push_back(p.str());
  return {{"tetrahedra", isometry.tet}, {"vertices", perms}};
}

Result isometric(const std::string& x, const std::string& y, const Context& context) {
  using Verdict = canonical::IsometryAnswer::Verdict;
  const Solved a = solve(x, context);
  const Solved b = solve(y, context);
  canonical::IsometryAnswer answer;
  if (!a.why_not.empty())
    answer.reason = x + ": " + a.why_not;
  else if (!b.why_not.empty())
    answer.reason = y + ": " + b.why_not;
  else
    answer = compare(*a.canonical, *b.canonical);

  Result result;
  result.warnings = a.warnings;
  result.warnings.insert(result.warnings.end(), b.warnings.begin(), b.warnings.end());
  const bool yes = answer.verdict == Verdict::isometric;
  const bool unknown = answer.verdict == Verdict::undecided;
  result.status = yes ? Status::done : unknown ? Status::undecided : Status::proved_no;
  result.json["isometric"] = unknown ? Json() : Json(yes);
  result.json["reason"] = answer.reason;
  result.text = std::string(yes       ? "isometric"
                            : unknown ? "undecided"
                                      : "not isometric") +
                ": " + answer.reason + "\n";
  if (!yes) return result;
  result.json["isometry"] = isometry_json(answer.isometry);
  result.json["from"] = signature(a.canonical->canonical_triangulation);
  result.text += "canonical tetrahedra of " + x + " go to those of " + y + ":\n";
  for (std::size_t t = 0; t < answer.isometry.tet.size(); ++t)
    result.text += "  " + std::to_string(t) + " -> " + std::to_string(answer.isometry.tet[t]) +
                   ", vertices 0123 -> " + answer.isometry.perm[t].str() + "\n";
  return result;
}

} // namespace

Run declare_canonize(OptionTable& table) {
  const auto input = std::make_shared<std::string>();
  const auto output = std::make_shared<std::string>();
  table.add("X", *input, "a triangulation that carries a hyperbolic structure").required();
  table.add("-o,--output", *output, "write the canonical triangulation with its cells as JSON")
      .value_name("FILE");
  return [input, output](const Context& context) { return canonize(*input, *output, context); };
}

Run declare_isometric(OptionTable& table) {
  const auto x = std::make_shared<std::string>();
  const auto y = std::make_shared<std::string>();
  table.add("X", *x, "a triangulation that carries a hyperbolic structure").required();
  table.add("Y", *y, "another triangulation that carries a hyperbolic structure").required();
  return [x, y](const Context& context) { return isometric(*x, *y, context); };
}

} // namespace tetrarch::program
