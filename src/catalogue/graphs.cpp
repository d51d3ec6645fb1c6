// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/graphs.hpp"

#include "tables.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tetrarch::catalogue {
namespace {

using Json = nlohmann::ordered_json;

SpatialGraph graph_of(const Json& j) {
  SpatialGraph g;
  g.name = j.at("name");
  g.kind = j.at("kind");
  g.crossings = j.at("crossings");
  g.genus = j.at("genus");
  g.homology = j.at("homology");
  g.signatures = j.at("signatures").get<std::vector<std::string>>();
  g.volume = j.value("volume", "");
  g.isometry_signature = j.value("isometry_signature", "");
  g.isometries = j.value("isometries", 0);
  if (j.contains("symmetries")) g.symmetries = j.at("symmetries").get<int>();
  if (j.contains("amphichiral")) g.amphichiral = j.at("amphichiral").get<bool>();
  g.parabolic_volume = j.value("parabolic_volume", "");
  return g;
}

template <class Holds>
std::vector<std::string> names_where(Holds holds) {
  std::vector<std::string> names;
  for (const SpatialGraph& g : stored_graphs())
    if (holds(g)) names.push_back(g.name);
  return names;
}

} // namespace

const std::vector<SpatialGraph>& stored_graphs() {
  static const std::vector<SpatialGraph> graphs = [] {
    std::vector<SpatialGraph> all;
    const Json table = Json::parse(detail::embedded_graphs());
    for (const Json& j : table.at("graphs")) all.push_back(graph_of(j));
    return all;
  }();
  return graphs;
}

std::vector<std::string> graphs_with_structure(std::string_view isometry_signature) {
  if (isometry_signature.empty()) return {};
  return names_where([&](const SpatialGraph& g) { return g.isometry_signature == isometry_signature; });
}

std::vector<std::string> graphs_with_triangulation(std::string_view signature) {
  return names_where([&](const SpatialGraph& g) {
    return std::find(g.signatures.begin(), g.signatures.end(), signature) != g.signatures.end();
  });
}

} // namespace tetrarch::catalogue
