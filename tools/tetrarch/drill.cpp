// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "edge_names.hpp"
#include "info.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/moves/drill.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

struct DrillArguments {
  std::string input;
  std::vector<std::string> edges;
  std::string output;
  bool cut = false;
};

Json meridians_json(const moves::CutOut& made) {
  Json list = Json::array();
  for (const auto& path : made.meridians) {
    Json steps = Json::array();
    for (const DirectedTetEdge& e : path) steps.push_back(Json{e.tet, e.from, e.to});
    list.push_back(std::move(steps));
  }
  return list;
}

Result drill(const DrillArguments& options, const Context& context) {
  const format::Document document = read_triangulation(options.input, context);
  require_manifolds(document.triangulation, options.input);
  const Skeleton skeleton(document.triangulation);
  const Table<EdgeId, bool> edges = edges_named(options.edges, skeleton, "EDGES");
  Json drilled = Json::array();
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (edges[e]) drilled.push_back(e.value);
  Result result;
  result.warnings = document.warnings;
  Triangulation tri;
  Json meridians;
  int filled = 0;
  if (options.cut) {
    moves::CutOut made = moves::cut_out(document.triangulation, skeleton, edges);
    meridians = meridians_json(made);
    tri = std::move(made.tri);
  } else {
    moves::TruncateOptions how;
    how.simplify.seed = context.seed;
    tri =
        moves::truncate(moves::drill(document.triangulation, skeleton, edges).tri, how, context.progress).tri;
    filled = moves::tree_count(skeleton, edges);
    if (filled > 0)
      result.warnings.push_back(counted(filled, "sphere") +
                                " round drilled trees: filled in again ('--cut' leaves them)");
  }
  Info info = info_of(tri, document.name, context);
  info.json["drilled"] = drilled;
  info.json["filled_spheres"] = filled;
  info.json["meridians"] = std::move(meridians);
  info.json["input_tetrahedra"] = document.triangulation.size();
  result.json = std::move(info.json);
  result.text =
      block({{"drilled", counted(static_cast<long long>(drilled.size()), "edge")}}) + block(info.rows);
  format::Document out = format::document_of(std::move(tri));
  if (!options.output.empty()) add_file(result, options.output, out);
  result.value = std::make_shared<Value>(std::move(out));
  return result;
}

} // namespace

fields::List fields::of_drill() {
  namespace type = workshop::type;
  const workshop::Type path = type::list(type::list(type::integer, 3));
  return workshop::both_of(
      workshop::notes_of<workshop::Info>(),
      {{"drilled", "", "numbers of the edges, as given", type::list(type::integer)},
       {"filled_spheres", "", "spheres round drilled trees that were filled in again", type::integer},
       {"meridians", "",
        "with --cut, of each edge a path round it: tetrahedron, and the vertices from and to; null: without",
        type::or_null(type::list(path))},
       {"input_tetrahedra", "", "number of tetrahedra of the input", type::integer}});
}

Run declare_drill(OptionTable& table) {
  const auto options = std::make_shared<DrillArguments>();
  table.add("X", options->input, "a triangulation or a mesh").required();
  table
      .add("EDGES", options->edges,
           "numbers of edges, as 'skeleton X' has them: 0,3,5, or 2:01 by tetrahedron")
      .required();
  table.add("--cut", options->cut,
            "cut the edges out and leave real boundary, unsimplified, with a meridian of each edge");
  table.add("-o,--output", options->output, "the file to write (its extension names the format)")
      .output_file(require_triangulation);
  return [options](const Context& context) { return drill(*options, context); };
}

} // namespace tetrarch::program
