// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "info.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/moves/drill.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

struct Options {
  std::string input;
  std::vector<std::string> edges;
  std::string output;
  bool cut = false;
};

/// "5": the class of this number; "3:01": that of the edge 01 of tetrahedron 3.
EdgeId edge_named(const std::string& word, const Skeleton& skeleton) {
  const std::string expected = " (expected the number of an edge, 0 to " +
                               std::to_string(skeleton.edge_count() - 1) + ", or one of a tetrahedron: 3:01)";
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) {
    const auto number = format::parse_integer(word);
    if (!number || *number < 0 || *number >= skeleton.edge_count())
      throw InputError("EDGES: found " + in_quotes(word) + expected);
    return EdgeId(static_cast<int>(*number));
  }
  const auto tet = format::parse_integer(word.substr(0, colon));
  const std::string ends = word.substr(colon + 1);
  const bool good = tet && *tet >= 0 && *tet < skeleton.tetrahedron_count() && ends.size() == 2 &&
                    ends[0] >= '0' && ends[0] <= '3' && ends[1] >= '0' && ends[1] <= '3' &&
                    ends[0] != ends[1];
  if (!good) throw InputError("EDGES: found " + in_quotes(word) + expected);
  return skeleton.edge(TetEdge{static_cast<int>(*tet), edge_number[ends[0] - '0'][ends[1] - '0']});
}

/// Words are separated by commas or given one by one.
Table<EdgeId, bool> edges_named(const std::vector<std::string>& words, const Skeleton& skeleton) {
  Table<EdgeId, bool> chosen(skeleton.edge_count(), false);
  for (const std::string& list : words)
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t comma = std::min(list.find(',', at), list.size());
      const EdgeId e = edge_named(list.substr(at, comma - at), skeleton);
      if (skeleton.is_reversed(e))
        throw InputError("EDGES: edge " + std::to_string(e.value) + " is identified with itself backwards");
      chosen[e] = true;
      at = comma + 1;
    }
  return chosen;
}

Json meridians_json(const moves::CutOut& made) {
  Json list = Json::array();
  for (const auto& path : made.meridians) {
    Json steps = Json::array();
    for (const DirectedTetEdge& e : path) steps.push_back(Json{e.tet, e.from, e.to});
    list.push_back(std::move(steps));
  }
  return list;
}

Result drill(const Options& options, const Context& context) {
  if (!options.output.empty()) output_format(options.output);
  const format::Document document = read_triangulation(options.input, context);
  require_manifolds(document.triangulation, options.input);
  const Skeleton skeleton(document.triangulation);
  const Table<EdgeId, bool> edges = edges_named(options.edges, skeleton);
  Json drilled = Json::array();
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (edges[e]) drilled.push_back(e.value);
  Result result;
  result.warnings = document.warnings;
  Triangulation tri;
  Json meridians;
  if (options.cut) {
    moves::CutOut made = moves::cut_out(document.triangulation, skeleton, edges);
    meridians = meridians_json(made);
    tri = std::move(made.tri);
  } else {
    moves::TruncateOptions how;
    how.simplify.seed = context.seed;
    tri =
        moves::truncate(moves::drill(document.triangulation, skeleton, edges).tri, how, context.progress).tri;
  }
  Info info = info_of(tri, document.name, context);
  info.json["drilled"] = drilled;
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

Run declare_drill(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("X", options->input, "a triangulation or a mesh").required();
  table
      .add("EDGES", options->edges,
           "numbers of edges, as 'skeleton X' has them: 0,3,5, or 2:01 by tetrahedron")
      .required();
  table.add("--cut", options->cut,
            "cut the edges out and leave real boundary, unsimplified, with a meridian of each edge");
  table.add("-o,--output", options->output, "the file to write (its extension names the format)")
      .value_name("FILE");
  return [options](const Context& context) { return drill(*options, context); };
}

} // namespace tetrarch::program
