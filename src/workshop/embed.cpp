// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/embed.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/embed/mobius.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::workshop {
namespace {

using Domain = embed::Domain<double>;

int longest_word(const embed::Piece& piece) {
  return *std::max_element(piece.length.begin(), piece.length.end());
}

double farthest(const embed::Piece& piece) {
  return *std::max_element(piece.distance.begin(), piece.distance.end());
}

Tree matrix_tree(const embed::Matrix4<double>& m) {
  Tree rows = Tree::array();
  for (const auto& row : m) rows.push_back(row);
  return rows;
}

Tree mobius_tree(const embed::Matrix4<double>& m) {
  const auto mobius = embed::mobius_of(m);
  Tree entries = Tree::array();
  for (const auto& z : {mobius.a, mobius.b, mobius.c, mobius.d}) entries.push_back({z.re, z.im});
  return {{"matrix", entries}, {"reverses_orientation", mobius.reverses}};
}

Tree residuals_tree(const Embedding& e) {
  const embed::Residuals& r = e.residuals;
  return {{"seam", r.seam},
          {"relator", r.relator},
          {"relator_sl2c", r.relator_sl2c},
          {"edge_rotation", r.edge_rotation},
          {"boundary_plane", r.boundary_plane},
          {"gauss_bonnet", r.gauss_bonnet}};
}

Tree placed_tree(const Domain& domain) {
  Tree tets = Tree::array();
  for (std::size_t t = 0; t < domain.vertices.size(); ++t) {
    Tree types = Tree::array();
    for (const auto type : domain.types[t]) types.push_back(to_string(type));
    tets.push_back({{"vertices", domain.vertices[t]}, {"types", types}, {"parent", domain.entrance[t].tet}});
  }
  return tets;
}

Tree pairings_tree(const Domain& domain) {
  Tree faces = Tree::array();
  for (const auto& face : domain.faces) {
    Tree hexagons = Tree::array();
    for (const TetFace f : face.hexagons) hexagons.push_back({f.tet, f.face});
    faces.push_back(
        {{"hexagons", hexagons}, {"partner", face.partner}, {"pairing", matrix_tree(face.pairing)}});
  }
  return faces;
}

Tree domain_tree(const Embedding& e) {
  const Domain& domain = e.at.domain;
  const algebra::Presentation& group = domain.group.presentation;
  Tree generators = Tree::array();
  for (const auto& g : domain.holonomy)
    generators.push_back({{"so31", matrix_tree(g)}, {"sl2c", mobius_tree(g)}});
  Tree relators = Tree::array();
  for (const algebra::Word& word : group.relators)
    relators.push_back(algebra::word_str(word, group.generators));
  return {{"half_space", matrix_tree(domain.half_space)},
          {"tetrahedra", placed_tree(domain)},
          {"gluable_faces", pairings_tree(domain)},
          {"generators", generators},
          {"relators", relators}};
}

Type domain_type() {
  const Type matrix = type::list(type::list(type::number, 4), 4);
  const Type placed = type::object({{"vertices", type::list(type::list(type::number, 4), 4)},
                                    {"types", type::list(type::text, 4)},
                                    {"parent", type::integer}});
  const Type face = type::object({{"hexagons", type::list(type::list(type::integer, 2))},
                                  {"partner", type::integer},
                                  {"pairing", matrix}});
  const Type mobius = type::object(
      {{"matrix", type::list(type::list(type::number, 2), 4)}, {"reverses_orientation", type::truth}});
  return type::object({{"half_space", matrix},
                       {"tetrahedra", type::list(placed)},
                       {"gluable_faces", type::list(face)},
                       {"generators", type::list(type::object({{"so31", matrix}, {"sl2c", mobius}}))},
                       {"relators", type::list(type::text)}});
}

Tree piece_tree(const Embedding& e) {
  const embed::Piece& piece = e.piece;
  return {{"count", piece.copies.size()},
          {"complete", piece.complete},
          {"longest_word", longest_word(piece)},
          {"farthest", farthest(piece)},
          {"largest_duplicate_difference", piece.largest_duplicate},
          {"smallest_difference", piece.closest}};
}

/// Written out while its generators are single letters.
std::string placed_group_text(const algebra::Presentation& group) {
  if (group.generators <= 26) return group.str();
  return counted(group.generators, "generator") + ", " +
         counted(static_cast<long long>(group.relators.size()), "relator");
}

embed::BoundaryLift lift_of(const Placement& at, int boundary) {
  std::vector<embed::BoundaryLift> lifts = boundary_lifts(at.triangulation(), at.skeleton, at.domain);
  if (boundary < 0 || boundary >= static_cast<int>(lifts.size()))
    throw PreconditionError("there is no boundary component " + std::to_string(boundary));
  return std::move(lifts[static_cast<std::size_t>(boundary)]);
}

} // namespace

Verdict Placement::verdict() const {
  return search.structure.outcome == hyperbolic::Outcome::geometric ? Verdict::yes : Verdict::undecided;
}

std::string Placement::why_not() const {
  if (verdict() == Verdict::yes) return "";
  return describe(search.structure, skeleton) + " (" + describe(search) + ")";
}

std::vector<std::string> Placement::remarks() const {
  std::vector<std::string> sentences;
  if (search.filled_spheres > 0)
    sentences.push_back(counted(search.filled_spheres, "boundary sphere") +
                        " filled with balls: this is another manifold than the given one");
  if (search.changed)
    sentences.push_back("the structure was found on another triangulation, of " +
                        counted(triangulation().size(), "tetrahedron") + ": " + signature(triangulation()));
  return sentences;
}

int Placement::boundary_count() const {
  int count = 0;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    count += skeleton.link(v).is_sphere() ? 0 : 1;
  return count;
}

Placement placement(const Triangulation& tri, const PlacementOptions& options, const Progress& progress) {
  hyperbolic::SearchOptions how;
  how.seed = options.seed;
  Placement found{options.name, find_structure(tri, how, progress), Skeleton(Triangulation()), {}};
  found.skeleton = Skeleton(found.triangulation());
  if (found.verdict() == Verdict::yes)
    found.domain = embed::fundamental_domain(found.triangulation(), found.skeleton, found.search.structure,
                                             {options.cusp_area}, progress);
  return found;
}

std::vector<std::string> Embedding::remarks() const {
  std::vector<std::string> sentences = at.remarks();
  const embed::Residuals& r = residuals;
  if (constexpr double visible = 1e-6; !(std::max({r.seam, r.boundary_plane, r.edge_rotation}) < visible))
    sentences.push_back("the domain is too large for double precision: its far parts are off by " +
                        scientific(std::max(r.seam, r.boundary_plane), 1));
  return sentences;
}

Embedding embedding(Placement at, const EmbedOptions& options, const Progress& progress) {
  if (at.verdict() != Verdict::yes) throw PreconditionError("there is no structure to embed");
  Embedding found{std::move(at), {}, {}, {}};
  const Domain& domain = found.at.domain;
  if (options.boundary) {
    found.lift = lift_of(found.at, *options.boundary);
    found.piece = group_piece(found.lift->pairings, found.lift->size, options.bounds, progress);
  } else {
    found.piece = universal_cover(domain, options.bounds, progress);
  }
  found.residuals = embed::residuals(found.at.triangulation(), found.at.skeleton, domain);
  return found;
}

Rows rows_of(const Embedding& e) {
  const embed::Residuals& r = e.residuals;
  return {{"manifold", e.at.name},
          {"volume", fixed(e.at.search.structure.volume, 12)},
          {"tetrahedra", std::to_string(e.at.triangulation().size())},
          {"gluable faces", std::to_string(e.at.domain.faces.size())},
          {"group", placed_group_text(e.at.domain.group.presentation)},
          {"seam error", scientific(r.seam, 1)},
          {"relators",
           scientific(r.relator, 1) + " in SO(3,1), " + scientific(r.relator_sl2c, 1) + " in SL(2,C)"},
          {"edge rotations", scientific(r.edge_rotation, 1)},
          {"boundary planes", scientific(r.boundary_plane, 1)},
          {"Gauss-Bonnet", scientific(r.gauss_bonnet, 1)},
          {"copies", std::to_string(e.piece.copies.size()) + ", words up to length " +
                         std::to_string(longest_word(e.piece)) + ", up to distance " +
                         fixed(farthest(e.piece), 3)}};
}

template <>
const FieldList<Embedding>& fields_of<Embedding>() {
  using E = const Embedding&;
  static const FieldList<Embedding> fields{
      {{"signature", "", "of the triangulation that carries the structure", type::text},
       [](E e) -> Tree { return signature(e.at.triangulation()); }},
      {{"volume", "curvature -1", "of the manifold", type::number},
       [](E e) -> Tree { return e.at.search.structure.volume; }},
      {{"residuals", "",
        "what would be 0 without rounding: seam, relator, relator_sl2c, edge_rotation (radians), "
        "boundary_plane and gauss_bonnet",
        type::object({{"seam", type::number},
                      {"relator", type::number},
                      {"relator_sl2c", type::number},
                      {"edge_rotation", type::number},
                      {"boundary_plane", type::number},
                      {"gauss_bonnet", type::number}})},
       residuals_tree},
      {{"domain", "curvature -1",
        "half_space, the isometry to the upper half space; tetrahedra, with vertices in the hyperboloid "
        "model; "
        "gluable_faces, with their pairings; generators, as so31 and sl2c; relators",
        domain_type()},
       domain_tree},
      {{"copies", "curvature -1",
        "count, complete (nothing within other bounds was cut off by the number of copies), longest_word, "
        "farthest (a distance), "
        "largest_duplicate_difference and smallest_difference of isometries",
        type::object({{"count", type::integer},
                      {"complete", type::truth},
                      {"longest_word", type::integer},
                      {"farthest", type::number},
                      {"largest_duplicate_difference", type::number},
                      {"smallest_difference", type::number}})},
       piece_tree}};
  return fields;
}

} // namespace tetrarch::workshop
