// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <CLI/CLI.hpp>
#include <map>
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
  hyperbolic::Method method = hyperbolic::Method::newton;
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
      const auto [p, q] = skeleton.ends(edge);
      const bool infinite =
          types[p] == hyperbolic::VertexType::ideal || types[q] == hyperbolic::VertexType::ideal;
      if (!infinite) metric.edge_lengths.back()[e] = format::Number(found.lengths[edge]);
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

std::string report(const Hyperbolization<double>& found, const Skeleton& skeleton) {
  if (found.outcome != Outcome::geometric)
    return block({{"outcome", outcome_word(found.outcome)},
                  {"reason", describe(found, skeleton)},
                  {"residual", scientific(found.residual, 1)},
                  {"iterations", std::to_string(found.iterations)}});
  std::vector<std::pair<std::string, std::string>> rows{{"outcome", "geometric"},
                                                        {"volume", fixed(found.volume, 12)},
                                                        {"residual", scientific(found.residual, 1)},
                                                        {"iterations", std::to_string(found.iterations)}};
  for (const EdgeId e : all<EdgeId>(found.lengths.size()))
    rows.emplace_back("edge " + std::to_string(e.value), "length " + fixed(found.lengths[e], 10) +
                                                             ", valence " +
                                                             std::to_string(skeleton.valence(e)));
  for (std::size_t t = 0; t < found.dihedral_angles.size(); ++t) {
    std::vector<std::string> angles;
    for (const double a : found.dihedral_angles[t]) angles.push_back(fixed(a, 10));
    rows.emplace_back("angles " + std::to_string(t), joined(angles, " "));
  }
  return block(rows);
}

Result hyperbolize(const Options& options, const Context& context) {
  format::Document document = read_triangulation(options.input);
  const Skeleton skeleton(document.triangulation);
  hyperbolic::HyperbolizeOptions how;
  how.method = options.method;
  const auto found = hyperbolic::hyperbolize(document.triangulation, skeleton, how, context.progress);
  if (found.outcome == Outcome::stopped) throw Stopped();
  if (found.outcome == Outcome::invalid || found.outcome == Outcome::boundary_faces)
    throw InputError({options.input, 0}, describe(found, skeleton));

  Result result;
  result.warnings = document.warnings;
  result.status = status_of(found.outcome);
  const bool geometric = found.outcome == Outcome::geometric;
  result.json["outcome"] = outcome_word(found.outcome);
  if (!geometric) {
    result.json["reason"] = to_string(found.outcome);
    result.json["explanation"] = describe(found, skeleton);
  }
  result.json["volume"] = geometric ? Json(found.volume) : Json();
  result.json["edge_lengths"] = numbers(found.lengths);
  result.json["dihedral_angles"] = Json::array();
  for (const auto& angles : found.dihedral_angles) result.json["dihedral_angles"].push_back(numbers(angles));
  result.json["residual"] = found.residual;
  result.json["iterations"] = found.iterations;
  result.text = report(found, skeleton);
  if (!options.history.empty()) {
    std::ostringstream csv;
    write_history_csv(csv, found.history);
    result.files.push_back({options.history, csv.str()});
  }
  if (!options.output.empty()) {
    if (geometric) {
      attach_metric(document, skeleton, found);
      result.files.push_back({options.output, write_json(document)});
    } else {
      result.warnings.push_back(options.output + " was not written: no structure was found");
    }
  }
  return result;
}

} // namespace

Run declare_hyperbolize(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  static const std::map<std::string, hyperbolic::Method> methods{{"newton", hyperbolic::Method::newton},
                                                                 {"flow", hyperbolic::Method::flow}};
  app.add_option("X", options->input, "a closed gluing; vertices are truncated or cusps")->required();
  app.add_option("--method", options->method, "newton (default) or flow: Luo's curvature flow from length 1")
      ->transform(CLI::CheckedTransformer(methods).description("{newton,flow}"));
  app.add_option("--history", options->history, "the flow's history of sum K^2, as CSV");
  app.add_option("-o,--output", options->output, "the triangulation with its metric, as JSON");
  return [options](const Context& context) {
    if (!options->history.empty() && options->method != hyperbolic::Method::flow)
      throw InputError("--history needs --method flow: Newton's method has no flow to record");
    return hyperbolize(*options, context);
  };
}

} // namespace tetrarch::program
