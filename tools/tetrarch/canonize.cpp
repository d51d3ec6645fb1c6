// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

namespace tetrarch::program {
namespace {

using canonical::Canonical;
using hyperbolic::Outcome;

/// What was given: a manifold, with the boundary spheres that `find_structure` fills.
struct Given {
  format::Document document;
  std::vector<std::string> boundary; ///< the types of its components, sorted
  int spheres = 0;
};

Given read(const std::string& input, const Context& context) {
  Given given{read_triangulation(input, context), {}, 0};
  const Triangulation& tri = given.document.triangulation;
  require_manifold(tri, input);
  for (const BoundaryComponent& component : boundary_components(tri, Skeleton(tri))) {
    given.boundary.push_back(component.type.str());
    given.spheres += component.type.is_sphere();
  }
  std::sort(given.boundary.begin(), given.boundary.end());
  return given;
}

hyperbolic::Search structure_of(const Given& given, int attempts, const Context& context) {
  hyperbolic::SearchOptions search;
  search.seed = context.seed;
  search.attempts = attempts;
  return find_structure(given.document.triangulation, search, context.progress);
}

/// A manifold that was solved and canonised, or the sentence that says why not.
struct Solved {
  std::optional<Canonical> canonical;
  std::string why_not;
  Outcome outcome = Outcome::invalid;
  double volume = 0;
};

Solved canonised(const hyperbolic::Search& found, int attempts, const Context& context) {
  const auto& structure = found.structure;
  Solved solved{std::nullopt, {}, structure.outcome, structure.volume};
  if (structure.outcome != Outcome::geometric) {
    solved.why_not = describe(found);
    return solved;
  }
  canonical::CanonizeOptions options;
  options.seed = context.seed;
  options.restarts = attempts;
  solved.canonical = canonical::canonize(found.triangulation, structure, options, context.progress);
  if (solved.canonical->outcome != Canonical::Outcome::canonical)
    solved.why_not = "a face stays concave and no move mends it, after " +
                     std::to_string(solved.canonical->restarts) + " changes of the triangulation";
  return solved;
}

std::string filled_text(int spheres) {
  return std::to_string(spheres) + ": the structure is that of the filled manifold";
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
        const int a = numeric::find_root(root, t);
        const int b = numeric::find_root(root, c.triangulation.gluing({t, f}).tet);
        root[std::max(a, b)] = std::min(a, b);
      }
  format::CanonicalCells result{c.cells, std::vector<int>(root.size()), c.flat, c.isometry_signature, {}};
  int cells = 0;
  for (int t = 0; t < c.triangulation.size(); ++t) {
    const int first = numeric::find_root(root, t);
    result.cell_of[t] = first == t ? cells++ : result.cell_of[first];
  }
  return result;
}

Result canonize(const std::string& input, const std::string& output, int attempts, const Context& context) {
  const Given given = read(input, context);
  const Solved solved = canonised(structure_of(given, attempts, context), attempts, context);
  Result result;
  result.warnings = given.document.warnings;
  if (!solved.why_not.empty()) {
    result.status = solved.outcome == Outcome::projective_plane ? Status::proved_no : Status::undecided;
    result.json = {{"outcome", "not found"}, {"reason", solved.why_not}, {"filled_spheres", given.spheres}};
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
                 {"volume", solved.volume},
                 {"filled_spheres", given.spheres}};
  std::vector<std::pair<std::string, std::string>> rows{
      {"cells", cell_summary(c.cells)},
      {"isometry signature", c.isometry_signature},
      {"isometry group", "order " + std::to_string(order)},
      {"tetrahedra", std::to_string(c.triangulation.size())},
      {"smallest tilt", scientific(c.smallest_tilt, 3)},
      {"volume", fixed(solved.volume, 12)}};
  if (given.spheres > 0) rows.emplace_back("filled spheres", filled_text(given.spheres));
  result.text = block(rows);
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

constexpr const char* given_triangulations = "triangulations given";

/// The answer, and between which triangulations its isometry goes.
struct Compared {
  canonical::IsometryAnswer answer{};
  const char* between = "canonical triangulations";
  Triangulation from{};
};

Compared told(canonical::IsometryAnswer::Verdict verdict, canonical::IsometryAnswer::Proof proof,
              std::string reason) {
  Compared compared;
  compared.answer.verdict = verdict;
  compared.answer.proof = proof;
  compared.answer.reason = std::move(reason);
  return compared;
}

/// Yes if the triangulations given are isomorphic, where the first is known to carry a structure.
std::optional<Compared> compare_given(const Given& x, const Given& y) {
  using canonical::IsometryAnswer;
  auto isometry = find_isomorphism(x.document.triangulation, y.document.triangulation);
  if (!isometry) return std::nullopt;
  Compared compared = told(IsometryAnswer::Verdict::isometric, IsometryAnswer::Proof::isomorphism,
                           "the triangulations given are isomorphic");
  compared.answer.isometry = *std::move(isometry);
  compared.between = given_triangulations;
  compared.from = x.document.triangulation;
  return compared;
}

Compared compare_all(const std::string& x, const std::string& y, const Given& given_x, const Given& given_y,
                     const Context& context) {
  using canonical::IsometryAnswer;
  if (given_x.boundary != given_y.boundary) {
    const auto named = [](const Given& g) {
      return g.boundary.empty() ? std::string("none") : joined(g.boundary, ", ");
    };
    return told(IsometryAnswer::Verdict::not_isometric, IsometryAnswer::Proof::boundary,
                "the boundaries differ: " + named(given_x) + " against " + named(given_y));
  }
  const auto homology = [](const Given& g) {
    const Triangulation& tri = g.document.triangulation;
    return algebra::homology(tri, Skeleton(tri), 1);
  };
  if (const auto h_x = homology(given_x), h_y = homology(given_y); h_x != h_y)
    return told(IsometryAnswer::Verdict::not_isometric, IsometryAnswer::Proof::homology,
                "the first homology differs: " + h_x.str() + " against " + h_y.str());
  const int attempts = hyperbolic::SearchOptions{}.attempts;
  const hyperbolic::Search found = structure_of(given_x, attempts, context);
  if (found.structure.outcome == Outcome::geometric)
    if (auto compared = compare_given(given_x, given_y)) return *std::move(compared);
  const Solved a = canonised(found, attempts, context);
  const Solved b = canonised(structure_of(given_y, attempts, context), attempts, context);
  Compared compared;
  if (!a.why_not.empty())
    compared.answer.reason = x + ": " + a.why_not;
  else if (!b.why_not.empty())
    compared.answer.reason = y + ": " + b.why_not;
  else {
    compared.answer = compare(*a.canonical, *b.canonical);
    compared.from = a.canonical->canonical_triangulation;
  }
  return compared;
}

Result isometric(const std::string& x, const std::string& y, const Context& context) {
  using Verdict = canonical::IsometryAnswer::Verdict;
  const Given given_x = read(x, context);
  const Given given_y = read(y, context);
  const Compared compared = compare_all(x, y, given_x, given_y, context);
  const canonical::IsometryAnswer& answer = compared.answer;

  Result result;
  result.warnings = given_x.document.warnings;
  result.warnings.insert(result.warnings.end(), given_y.document.warnings.begin(),
                         given_y.document.warnings.end());
  const bool yes = answer.verdict == Verdict::isometric;
  const bool unknown = answer.verdict == Verdict::undecided;
  result.status = yes ? Status::done : unknown ? Status::undecided : Status::proved_no;
  result.json["isometric"] = unknown ? Json() : Json(yes);
  result.json["reason"] = answer.reason;
  result.json["proof"] = unknown ? Json() : Json(to_string(answer.proof));
  result.json["filled_spheres"] = std::max(given_x.spheres, given_y.spheres); // equal, or the answer is no
  result.text = std::string(yes       ? "isometric"
                            : unknown ? "undecided"
                                      : "not isometric") +
                ": " + answer.reason + "\n";
  if (yes && given_x.spheres > 0)
    result.text += "filled spheres: " + std::to_string(given_x.spheres) +
                   " in each; the isometry is one of the filled manifolds\n";
  if (!yes) return result;
  result.json["isometry"] = isometry_json(answer.isometry);
  result.json["between"] = compared.between;
  result.json["from"] = signature(compared.from);
  result.text +=
      std::string(compared.between == given_triangulations ? "tetrahedra of " : "canonical tetrahedra of ") +
      x + " go to those of " + y + ":\n";
  for (std::size_t t = 0; t < answer.isometry.tet.size(); ++t)
    result.text += "  " + std::to_string(t) + " -> " + std::to_string(answer.isometry.tet[t]) +
                   ", vertices 0123 -> " + answer.isometry.perm[t].str() + "\n";
  return result;
}

} // namespace

Run declare_canonize(OptionTable& table) {
  const auto input = std::make_shared<std::string>();
  const auto output = std::make_shared<std::string>();
  const auto attempts = std::make_shared<int>(hyperbolic::SearchOptions{}.attempts);
  table.add("X", *input, "a triangulation that carries a hyperbolic structure").required();
  table.add("-o,--output", *output, "write the canonical triangulation with its cells as JSON")
      .value_name("FILE");
  table.add("--attempts", *attempts, "greatest number of triangulations to try")
      .in_range(1, 10'000'000)
      .with_default();
  return [input, output, attempts](const Context& context) {
    return canonize(*input, *output, *attempts, context);
  };
}

Run declare_isometric(OptionTable& table) {
  const auto x = std::make_shared<std::string>();
  const auto y = std::make_shared<std::string>();
  table.add("X", *x, "a triangulation that carries a hyperbolic structure").required();
  table.add("Y", *y, "another triangulation that carries a hyperbolic structure").required();
  return [x, y](const Context& context) { return isometric(*x, *y, context); };
}

} // namespace tetrarch::program
