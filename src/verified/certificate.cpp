// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/verified/certificate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tetrarch::verified {
namespace {

using Json = nlohmann::ordered_json;

Json gluings(const Triangulation& tri) {
  Json list = Json::array();
  for (int t = 0; t < tri.size(); ++t) {
    Json faces = Json::array();
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      faces.push_back({g.tet, g.perm.str()});
    }
    list.push_back(std::move(faces));
  }
  return list;
}

Json edges(const Skeleton& skeleton, const StructureProof& proof) {
  Json list = Json::array();
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const Walk& first = skeleton.around(e).front();
    const bool fixed = std::find(proof.fixed.begin(), proof.fixed.end(), e) != proof.fixed.end();
    list.push_back({{"tetrahedron", first.tet},
                    {"edge", first.edge().edge},
                    {"length", numeric::hexadecimal(proof.lengths[e])},
                    {"fixed", fixed}});
  }
  return list;
}

Json claims(const Skeleton& skeleton, const StructureProof& proof) {
  std::vector<int> links;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) links.push_back(skeleton.link(v).euler);
  std::sort(links.begin(), links.end());
  const VolumeInterval volume = volume_interval(proof);
  return {{"orientable", skeleton.is_orientable()}, {"links", links}, {"volume", {volume.low, volume.high}}};
}

/// The faces, one entry for both sides.
Json faces(const Triangulation& tri, const CellClaims& cells) {
  Json list = Json::array();
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (TetFace{g.tet, g.perm[f]} < TetFace{t, f}) continue;
      const std::string& flat = cells.flat[t][f];
      list.push_back({{"tetrahedron", t}, {"face", f}, {"flat", flat.empty() ? Json() : Json(flat)}});
    }
  return list;
}

bool has_cusps(const Skeleton& skeleton) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.link(v).euler == 0) return true;
  return false;
}

/// A list with one item a line.
std::string lines(const Json& list) {
  std::string text = "[";
  for (std::size_t k = 0; k < list.size(); ++k) text += (k == 0 ? "\n    " : ",\n    ") + list[k].dump();
  return text + "\n  ]";
}

} // namespace

std::string certificate(const Triangulation& tri, const Skeleton& skeleton, const StructureProof& proof,
                        const std::optional<CellClaims>& cells) {
  skeleton.require_current(tri);
  const std::string about_cells = cells ? ",\n  \"cells\": {\"cusp_area\":" +
                                              (has_cusps(skeleton) ? Json(cells->cusp_area) : Json()).dump() +
                                              ",\"faces\": " + lines(faces(tri, *cells)) + "}"
                                        : "";
  return "{\n  \"format\": \"tetrarch-certificate\",\n  \"version\": 1,\n  \"gluings\": " +
         lines(gluings(tri)) + ",\n  \"bits\": " + std::to_string(proof.bits) +
         ",\n  \"radius\": " + Json(numeric::hexadecimal(proof.radius)).dump() +
         ",\n  \"edges\": " + lines(edges(skeleton, proof)) +
         ",\n  \"claims\": " + claims(skeleton, proof).dump() + about_cells + "\n}\n";
}

} // namespace tetrarch::verified
