// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/hyperbolic/cusp.hpp"
#include "tetrarch/hyperbolic/search.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <sstream>

namespace tetrarch::program {
namespace {

using hyperbolic::Hyperbolization;
using hyperbolic::Outcome;

struct Options {
  std::string input;
  std::string output;
  std::string history;
  std::string method = "newton";
  bool as_given = false;
  int attempts = hyperbolic::SearchOptions{}.attempts;
};

/// The word users see first; `reason` keeps the finer one.
std::string outcome_word(Outcome outcome) {
  if (outcome == Outcome::geometric) return "geometric";
  if (outcome == Outcome::projective_plane) return "not hyperbolic";
  return "not found";
}

Json numbers(const auto& values) {
  Json list = Json::array();
  for (const double x : values) list.push_back(x);
  return list;
}

/// An end of the edge lies in a cusp: its length depends on the horosphere there.
bool into_a_cusp(const Skeleton& skeleton, const Table<VertexId, hyperbolic::VertexType>& types, EdgeId e) {
  const auto [p, q] = skeleton.ends(e);
  return types[p] == hyperbolic::VertexType::ideal || types[q] == hyperbolic::VertexType::ideal;
}

std::string describe(const hyperbolic::Cusp& cusp) {
  const char* surface = cusp.orientable ? "torus, shape " : "Klein bottle, covered by a torus of shape ";
  const std::string real = fixed(cusp.shape.real(), 10);
  return surface + (real == "-0.0000000000" ? real.substr(1) : real) + " + " + fixed(cusp.shape.imag(), 10) +
         " i";
}

Json cusps_json(const std::vector<hyperbolic::Cusp>& cusps) {
  Json list = Json::array();
  for (const auto& cusp : cusps)
    list.push_back(Json{{"vertex", cusp.vertex.value},
                        {"type", cusp.orientable ? "torus" : "Klein bottle"},
                        {"shape", numbers(std::array{cusp.shape.real(), cusp.shape.imag()})},
                        {"area", cusp.area},
                        {"residual", cusp.residual}});
  return list;
}

/// The structure as the document's metric: signed lengths where the edge is finite, angles, volume.
void attach_metric(format::Document& document, const Skeleton& skeleton,
                   const Hyperbolization<double>& found) {
  const auto types = hyperbolic::vertex_types(skeleton);
  format::Metric metric;
  for (int t = 0; t < document.triangulation.size(); ++t) {
    metric.edge_lengths.emplace_back();
    metric.dihedral_angles.emplace_back();
    for (int e = 0; e < 6; ++e) {
      const EdgeId edge = skeleton.edge({t, e});
      if (!into_a_cusp(skeleton, types, edge))
        metric.edge_lengths.back()[e] = format::Number(found.lengths[edge]);
      metric.dihedral_angles.back()[e] = format::Number(found.dihedral_angles[t][e]);
    }
  }
  metric.volume = format::Number(found.volume);
  document.metric = std::move(metric);
}

Status status_of(Outcome outcome) {
  if (outcome == Outcome::geometric) return Status::done;
  return outcome == Outcome::projective_plane ? Status::proved_no : Status::undecided;
}

/// The search with Newton's method; then, if that is asked for, the flow on the triangulation that it found.
hyperbolic::Search solve(const Triangulation& tri, const Options& options, const Context& context) {
  hyperbolic::SearchOptions how;
  how.seed = context.seed;
  how.attempts = options.as_given ? 1 : options.attempts;
  hyperbolic::Search found;
  if (options.as_given) {
    found.triangulation = tri;
    found.attempts = 1;
  } else {
    found = find_structure(tri, how, context.progress);
    if (options.method == "newton") return found;
  }
  hyperbolic::HyperbolizeOptions once;
  once.method = options.method == "flow" ? hyperbolic::Method::flow : hyperbolic::Method::newton;
  found.structure =
      hyperbolic::hyperbolize(found.triangulation, Skeleton(found.triangulation), once, context.progress);
  if (found.structure.outcome == Outcome::stopped) throw Stopped();
  if (options.as_given) ++found.seen[static_cast<std::size_t>(found.structure.outcome)];
  return found;
}

/// Half of the last digit that a volume is printed with: a larger bound of its error is printed too.
constexpr double last_digit_of_volume = 5e-13;

/// Whose structure it is, where that is not the manifold given.
std::string filling(int spheres) {
  return spheres == 1
             ? "1 boundary sphere is filled with a ball: this is another manifold than the given one"
             : std::to_string(spheres) +
                   " boundary spheres are filled with balls: this is another manifold than the given one";
}

std::vector<std::pair<std::string, std::string>> rows_of(const hyperbolic::Search& search,
                                                         const Skeleton& skeleton) {
  const Hyperbolization<double>& found = search.structure;
  if (found.outcome != Outcome::geometric)
    return {{"outcome", outcome_word(found.outcome)},
            {"reason", describe(found, skeleton)},
            {"tried", describe(search)},
            {"residual", scientific(found.residual, 1)},
            {"iterations", std::to_string(found.iterations)}};
  std::vector<std::pair<std::string, std::string>> rows{{"outcome", describe(search)},
                                                        {"signature", signature(search.triangulation)},
                                                        {"volume", fixed(found.volume, 12)},
                                                        {"residual", scientific(found.residual, 1)},
                                                        {"iterations", std::to_string(found.iterations)}};
  if (!(found.volume_error < last_digit_of_volume))
    rows.insert(rows.begin() + 3, {"error", "volume right to within " + scientific(found.volume_error, 1)});
  const auto types = hyperbolic::vertex_types(skeleton);
  for (const EdgeId e : all<EdgeId>(found.lengths.size()))
    rows.emplace_back("edge " + std::to_string(e.value),
                      "length " + fixed(found.lengths[e], 10) +
                          (into_a_cusp(skeleton, types, e) ? " to the horosphere" : "") + ", valence " +
                          std::to_string(skeleton.valence(e)));
  for (const auto& cusp : hyperbolic::cusps(search.triangulation, skeleton, found.lengths))
    rows.emplace_back("cusp " + std::to_string(cusp.vertex.value), describe(cusp));
  for (std::size_t t = 0; t < found.dihedral_angles.size(); ++t) {
    std::vector<std::string> angles;
    for (const double a : found.dihedral_angles[t]) angles.push_back(fixed(a, 10));
    rows.emplace_back("angles " + std::to_string(t), joined(angles, " "));
  }
  return rows;
}

std::vector<std::pair<std::string, std::string>> report(const hyperbolic::Search& search,
                                                        const Skeleton& skeleton) {
  auto rows = rows_of(search, skeleton);
  if (search.filled_spheres > 0) rows.insert(rows.begin() + 1, {"filled", filling(search.filled_spheres)});
  return rows;
}

Json report_json(const hyperbolic::Search& search, const Skeleton& skeleton) {
  const Hyperbolization<double>& found = search.structure;
  const bool geometric = found.outcome == Outcome::geometric;
  Json json{{"outcome", outcome_word(found.outcome)}};
  if (!geometric) {
    json["reason"] = to_string(found.outcome);
    json["explanation"] = describe(found, skeleton);
    json["tried"] = describe(search);
  }
  json["volume"] = geometric ? Json(found.volume) : Json();
  json["volume_error"] = geometric && std::isfinite(found.volume_error) ? Json(found.volume_error) : Json();
  json["signature"] = signature(search.triangulation);
  json["changed"] = search.changed;
  json["filled_spheres"] = search.filled_spheres;
  json["attempts"] = search.attempts;
  json["edge_lengths"] = numbers(found.lengths);
  json["dihedral_angles"] = Json::array();
  for (const auto& angles : found.dihedral_angles) json["dihedral_angles"].push_back(numbers(angles));
  if (geometric) {
    const auto types = hyperbolic::vertex_types(skeleton);
    json["into_cusps"] = Json::array();
    for (const EdgeId e : all<EdgeId>(found.lengths.size()))
      if (into_a_cusp(skeleton, types, e)) json["into_cusps"].push_back(e.value);
    json["cusps"] = cusps_json(hyperbolic::cusps(search.triangulation, skeleton, found.lengths));
  }
  json["residual"] = found.residual;
  json["iterations"] = found.iterations;
  return json;
}

Result hyperbolize(const Options& options, const Context& context) {
  require_folder(options.history);
  if (!options.output.empty() && output_format(options.output) != format::FileFormat::json)
    throw InputError({options.output, 0}, "only JSON holds a metric (expected the extension .json)");
  format::Document document = read_triangulation(options.input, context);
  require_manifold(document.triangulation, options.input);
  const hyperbolic::Search search = solve(document.triangulation, options, context);
  const Hyperbolization<double>& found = search.structure;
  document.triangulation = search.triangulation;
  const Skeleton skeleton(document.triangulation);

  Result result;
  result.warnings = document.warnings;
  result.status = status_of(found.outcome);
  result.json = report_json(search, skeleton);
  result.text = block(report(search, skeleton));
  if (!options.history.empty()) {
    std::ostringstream csv;
    write_history_csv(csv, found.history);
    result.files.push_back({options.history, csv.str()});
  }
  if (found.outcome != Outcome::geometric) {
    if (!options.output.empty())
      result.warnings.push_back(options.output + " was not written: no structure was found");
    return result;
  }
  if (search.changed) { // what else the document says is about another triangulation
    document.members = nullptr;
    document.canonical.reset();
    document.bundle.reset();
    document.provenance = nullptr;
  }
  attach_metric(document, skeleton, found);
  if (!options.output.empty()) result.files.push_back({options.output, write_json(document)});
  result.value = std::make_shared<Value>(std::move(document));
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
  table.add("-o,--output", options->output, "write the triangulation with its metric as JSON")
      .value_name("FILE");
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
