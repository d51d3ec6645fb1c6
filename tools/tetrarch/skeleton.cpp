// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/skeleton.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// "3:012": a face, edge or vertex of tetrahedron 3, by its vertices.
std::string local_name(int tet, std::initializer_list<int> vertices) {
  std::string name = std::to_string(tet) + ":";
  for (const int v : vertices) name += std::to_string(v);
  return name;
}

std::string face_name(TetFace f) {
  std::string name = std::to_string(f.tet) + ":";
  for (int v = 0; v < 4; ++v)
    if (v != f.face) name += std::to_string(v);
  return name;
}

void add_gluings(const Triangulation& tri, Json& json, Rows& rows) {
  json["gluings"] = Json::array();
  for (int t = 0; t < tri.size(); ++t) {
    Json faces = Json::array();
    std::vector<std::string> words;
    for (int f = 0; f < 4; ++f) {
      const TetFace face{t, f};
      const bool free = tri.is_boundary(face);
      const Gluing g = free ? Gluing{} : tri.gluing(face);
      faces.push_back(free ? Json() : Json{g.tet, g.perm.str()});
      words.push_back(free ? "boundary" : std::to_string(g.tet) + " (" + g.perm.str() + ")");
    }
    json["gluings"].push_back(std::move(faces));
    rows.emplace_back("tetrahedron " + std::to_string(t), joined(words, "  "));
  }
}

void add_faces(const Skeleton& skeleton, Json& json, Rows& rows) {
  json["faces"] = Json::array();
  for (const FaceId f : all<FaceId>(skeleton.face_count())) {
    std::vector<std::string> names;
    for (const TetFace side : skeleton.preimages(f)) names.push_back(face_name(side));
    json["faces"].push_back({{"preimages", names}});
    rows.emplace_back("face " + std::to_string(f.value),
                      joined(names, " = ") + (names.size() == 1 ? ", boundary" : ""));
  }
}

void add_edges(const Skeleton& skeleton, Json& json, Rows& rows) {
  json["edges"] = Json::array();
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    std::vector<std::string> names;
    for (const Walk& w : skeleton.around(e)) names.push_back(local_name(w.tet, {w.from(), w.to()}));
    const auto [from, to] = skeleton.ends(e);
    const bool reversed = skeleton.is_reversed(e);
    json["edges"].push_back({{"valence", skeleton.valence(e)},
                             {"ends", {from.value, to.value}},
                             {"boundary", skeleton.is_boundary(e)},
                             {"reversed", reversed},
                             {"preimages", names}});
    rows.emplace_back("edge " + std::to_string(e.value),
                      "from vertex " + std::to_string(from.value) + " to " + std::to_string(to.value) +
                          ", valence " + std::to_string(skeleton.valence(e)) +
                          (skeleton.is_boundary(e) ? ", boundary" : "") +
                          (reversed ? ", identified with itself reversed" : "") + ": " + joined(names, " "));
  }
}

void add_vertices(const Skeleton& skeleton, Json& json, Rows& rows) {
  json["vertices"] = Json::array();
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    std::vector<std::string> names;
    for (const TetVertex corner : skeleton.preimages(v))
      names.push_back(local_name(corner.tet, {corner.vertex}));
    const std::string link = skeleton.link(v).str();
    json["vertices"].push_back({{"link", link}, {"ideal", skeleton.is_ideal(v)}, {"preimages", names}});
    rows.emplace_back("vertex " + std::to_string(v.value),
                      "link " + link + (skeleton.is_ideal(v) ? " (ideal)" : "") + ": " + joined(names, " "));
  }
}

Result describe_skeleton(const std::string& input, const Context& context) {
  const format::Document document = read_triangulation(input, context);
  const Skeleton skeleton(document.triangulation);
  Result result;
  result.warnings = document.warnings;
  Rows rows;
  add_gluings(document.triangulation, result.json, rows);
  add_faces(skeleton, result.json, rows);
  add_edges(skeleton, result.json, rows);
  add_vertices(skeleton, result.json, rows);
  result.text = block(rows);
  return result;
}

} // namespace

fields::List fields::of_skeleton() {
  namespace type = workshop::type;
  const workshop::Type names = type::list(type::text);
  const workshop::Type glued = type::or_null(type::tuple({type::integer, type::text}));
  return {{"gluings", "",
           "of each tetrahedron, across its faces 0 to 3: the tetrahedron there, and where its vertices go; "
           "null: boundary",
           type::list(type::list(glued, 4))},
          {"faces", "", "of each class its preimages, as 3:012",
           type::list(type::object({{"preimages", names}}))},
          {"edges", "",
           "of each class valence, ends (vertices), boundary, reversed (identified with itself), preimages",
           type::list(type::object({{"valence", type::integer},
                                    {"ends", type::list(type::integer, 2)},
                                    {"boundary", type::truth},
                                    {"reversed", type::truth},
                                    {"preimages", names}}))},
          {"vertices", "", "of each class its link, whether it is ideal, and its preimages",
           type::list(type::object({{"link", type::text}, {"ideal", type::truth}, {"preimages", names}}))}};
}

Run declare_skeleton(OptionTable& table) {
  const auto input = std::make_shared<std::string>();
  table.add("X", *input, "a triangulation or a mesh").required();
  return [input](const Context& context) { return describe_skeleton(*input, context); };
}

} // namespace tetrarch::program
