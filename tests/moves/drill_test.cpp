// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/drill.hpp"

#include "support/enumeration.hpp"
#include "support/homology.hpp"
#include "support/laws.hpp"
#include "support/zoo.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <queue>
#include <set>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::moves;
using namespace tetrarch::support;

namespace {

using EdgeSet = Table<EdgeId, bool>;

/// Calls visit(edges) for every non-empty set of edges without reversed ones.
template <class Visit>
void for_each_edge_set(const Skeleton& skeleton, Visit visit) {
  const int count = skeleton.edge_count();
  for (int bits = 1; bits < 1 << count; ++bits) {
    EdgeSet edges(count, false);
    bool good = true;
    for (const EdgeId e : all<EdgeId>(count)) {
      edges[e] = (bits >> e.value & 1) != 0;
      good &= !edges[e] || !skeleton.is_reversed(e);
    }
    if (good) visit(edges);
  }
}

std::vector<std::string> drilled_boundary_types(const Triangulation& tri) {
  std::vector<std::string> types;
  for (const BoundaryComponent& b : boundary_components(tri, Skeleton(tri)))
    if (!b.type.is_sphere()) types.push_back(b.type.str());
  std::sort(types.begin(), types.end());
  return types;
}

/// First homology, group (as simplified) and boundary but for spheres.
std::string description(const Triangulation& tri) {
  std::string text = first_homology(tri);
  for (const std::string& type : drilled_boundary_types(tri)) text += ", " + type;
  return text;
}

/// Half the sum of the Euler characteristics of the boundary: of the exterior of a graph with v vertices and
/// e edges in a closed manifold, v - e.
int half_boundary_euler(const Triangulation& tri) {
  int sum = 0;
  for (const BoundaryComponent& b : boundary_components(tri, Skeleton(tri))) sum += b.type.euler;
  return sum / 2;
}

int graph_euler(const Skeleton& skeleton, const EdgeSet& edges) {
  std::set<int> vertices;
  int count = 0;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (edges[e]) {
      vertices.insert(skeleton.ends(e).first.value);
      vertices.insert(skeleton.ends(e).second.value);
      ++count;
    }
  return static_cast<int>(vertices.size()) - count;
}

/// The classes of loops along edges, as words of the dual presentation.
class EdgePaths {
public:
  explicit EdgePaths(const Triangulation& tri)
      : tri_(tri), skeleton_(tri), dual_(algebra::dual_presentation(tri, skeleton_)) {
    for (std::size_t g = 0; g < dual_.generator_face.size(); ++g)
      generator_[skeleton_.face(dual_.generator_face[g])] = static_cast<int>(g) + 1;
  }
  const algebra::Presentation& group() const { return dual_.presentation; }

  /// A closed path of edges, each starting at the vertex class where the one before ends. Pushed into the
  /// tetrahedra: from one to the next through tetrahedra round their common vertex, whose star is a cone on
  /// a disk or sphere.
  algebra::Word word(const std::vector<DirectedTetEdge>& path) const {
    algebra::Word word;
    for (std::size_t k = 0; k < path.size(); ++k) {
      const DirectedTetEdge here = path[k];
      const DirectedTetEdge next = path[(k + 1) % path.size()];
      const algebra::Word turn = round_vertex({here.tet, here.to}, {next.tet, next.from});
      word.insert(word.end(), turn.begin(), turn.end());
    }
    return word;
  }

private:
  int letter(TetFace f) const {
    const auto found = generator_.find(skeleton_.face(f));
    if (found == generator_.end()) return 0;
    return dual_.generator_face[found->second - 1] == f ? found->second : -found->second;
  }

  algebra::Word round_vertex(TetVertex from, TetVertex to) const {
    std::map<TetVertex, algebra::Word> reached{{from, {}}};
    std::queue<TetVertex> front;
    front.push(from);
    while (reached.count(to) == 0) {
      REQUIRE(!front.empty()); // the edges do not meet
      const TetVertex at = front.front();
      front.pop();
      for (int f = 0; f < 4; ++f) {
        const Gluing g = tri_.gluing({at.tet, f});
        if (f == at.vertex || g.tet < 0) continue;
        algebra::Word word = reached.at(at);
        if (const int l = letter({at.tet, f}); l != 0) word.push_back(l);
        const TetVertex beyond{g.tet, g.perm[at.vertex]};
        if (reached.emplace(beyond, std::move(word)).second) front.push(beyond);
      }
    }
    return reached.at(to);
  }

  const Triangulation& tri_;
  Skeleton skeleton_;
  algebra::DualPresentation dual_;
  std::map<FaceId, int> generator_;
};

/// Connected valid gluings of up to two tetrahedra, with or without boundary and ideal vertices; every so
/// many.
template <class Visit>
void for_each_manifold(int every, Visit visit) {
  std::set<std::string> seen;
  int number = 0;
  for_each_small_gluing([&](const Triangulation& tri) {
    if (number++ % every != 0 || components(tri).count != 1 || !is_valid(Skeleton(tri))) return;
    if (seen.insert(signature(tri)).second) visit(tri);
  });
}

} // namespace

TEST_CASE("every set of edges can be cut out", "[drill]") {
  int sets = 0;
  for_each_manifold(7, [&](const Triangulation& tri) {
    const Skeleton skeleton(tri);
    for_each_edge_set(skeleton, [&](const EdgeSet& edges) {
      ++sets;
      const CutOut cut = cut_out(tri, skeleton, edges);
      if (const auto wrong = laws::all_hold(cut.tri); !wrong.empty()) FAIL(gluing_text(tri) + wrong);
      REQUIRE(is_valid(Skeleton(cut.tri)));
    });
  });
  CHECK(sets > 1000);
}

TEST_CASE("crushing and cutting give the same manifold", "[drill]") {
  // Paths of random edges of subdivided manifolds; long ones cannot be crushed.
  int compared = 0;
  int refused = 0;
  SplitMix64 random(26);
  for (const ZooEntry& entry : zoo()) {
    const Triangulation coarse = entry.triangulation();
    if (coarse.size() > 6 || Skeleton(coarse).has_boundary_faces() || !is_valid(Skeleton(coarse))) continue;
    const Triangulation tri = barycentric(coarse).tri;
    const Skeleton skeleton(tri);
    for (int round = 0; round < 12; ++round) {
      EdgeSet edges(skeleton.edge_count(), false);
      for (int k = 0; k < 1 + 2 * round; ++k) edges[EdgeId(random.below(skeleton.edge_count()))] = true;
      const auto made = crushed(tri, skeleton, edges);
      if (!std::holds_alternative<Triangulation>(made)) {
        ++refused;
        continue;
      }
      ++compared;
      INFO(entry.name);
      const Triangulation& small = std::get<Triangulation>(made);
      REQUIRE(is_valid(Skeleton(small)));
      REQUIRE(small.size() < tri.size());
      REQUIRE(description(small) == description(cut_out(tri, skeleton, edges).tri));
    }
  }
  CHECK(compared > 30);
  CHECK(refused > 10);
}

TEST_CASE("the exterior has the homology and the boundary that Regina finds by pinching edges",
          "[drill][oracle]") {
  std::ifstream record(TETRARCH_SOURCE_DIR "/tests/oracle/regina_drilled.txt");
  std::string line;
  std::getline(record, line); // the version of Regina
  int sets = 0;
  int crushable = 0;
  while (std::getline(record, line)) {
    std::istringstream fields(line);
    std::string signature_text;
    std::string names;
    std::string exterior;
    std::getline(fields, signature_text, '|');
    std::getline(fields, names, '|');
    std::getline(fields, exterior, '|');
    const Triangulation tri = from_signature(signature_text);
    const Skeleton skeleton(tri);
    EdgeSet edges(skeleton.edge_count(), false);
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) { // 3:02
      const std::size_t colon = name.find(':');
      edges[skeleton.edge({std::stoi(name.substr(0, colon)),
                           edge_number[name[colon + 1] - '0'][name[colon + 2] - '0']})] = true;
    }
    INFO(line);
    ++sets;
    CHECK(description(cut_out(tri, skeleton, edges).tri) == exterior);
    const auto made = crushed(tri, skeleton, edges);
    if (!std::holds_alternative<Triangulation>(made)) continue;
    ++crushable;
    CHECK(description(std::get<Triangulation>(made)) == exterior);
  }
  CHECK(sets > 2000);
  CHECK(crushable > 20);
}

TEST_CASE("the boundary of a drilled graph has its Euler characteristic, and meridians fill it", "[drill]") {
  int meridians = 0;
  for_each_manifold(1, [&](const Triangulation& tri) {
    const Skeleton skeleton(tri);
    for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
      if (!skeleton.link(v).is_sphere()) return;
    for_each_edge_set(skeleton, [&](const EdgeSet& edges) {
      INFO(gluing_text(tri));
      const CutOut cut = cut_out(tri, skeleton, edges);
      REQUIRE(half_boundary_euler(cut.tri) == graph_euler(skeleton, edges));
      if (Skeleton(cut.tri).component_count() != 1) return;
      const EdgePaths paths(cut.tri);
      algebra::Presentation filled = paths.group();
      for (const auto& path : cut.meridians) {
        filled.relators.push_back(paths.word(path));
        ++meridians;
      }
      REQUIRE(abelianized(filled).str() == first_homology(tri));
      // The whole group, where it is simple enough to be recognised.
      const algebra::Presentation before = simplified(algebra::dual_presentation(tri, skeleton).presentation);
      if (before.generators <= 1) REQUIRE(simplified(filled) == before);
    });
  });
  CHECK(meridians > 100);
}

TEST_CASE("the edges of the one-tetrahedron sphere are a trefoil and an unknot", "[drill]") {
  // The edge of valence 1 of bkaagj is a trefoil, as is well known: with c = ab the relator abbaB says
  // (cb)^2 = b^3. The other edge has the group of an unknot.
  const Triangulation sphere = from_signature("bkaagj");
  const Skeleton skeleton(sphere);
  std::map<int, int> generators;
  for (const EdgeId e : all<EdgeId>(2)) {
    EdgeSet edges(2, false);
    edges[e] = true;
    const CutOut cut = cut_out(sphere, skeleton, edges);
    REQUIRE(description(cut.tri) == "Z, torus");
    const Skeleton drilled(cut.tri);
    generators[skeleton.valence(e)] =
        simplified(algebra::dual_presentation(cut.tri, drilled).presentation).generators;
  }
  CHECK(generators == std::map<int, int>{{1, 2}, {5, 1}});
}

TEST_CASE("trees among the drilled edges are counted", "[drill]") {
  // The boundary of a 4-simplex: five vertices, all edges between them.
  const Triangulation sphere = from_signature("fvPQccdedeegovcfb");
  const Skeleton skeleton(sphere);
  for_each_edge_set(skeleton, [&](const EdgeSet& edges) {
    int spheres = 0;
    const CutOut cut = cut_out(sphere, skeleton, edges);
    for (const BoundaryComponent& b : boundary_components(cut.tri, Skeleton(cut.tri)))
      spheres += b.type.is_sphere() ? 1 : 0;
    REQUIRE(tree_count(skeleton, edges) == spheres);
  });
}

TEST_CASE("drilling changes nothing far from the edges", "[drill]") {
  const Triangulation fine = barycentric(from_signature("fvPQccdedeegovcfb")).tri;
  const Skeleton skeleton(fine);
  EdgeSet edges(skeleton.edge_count(), false);
  edges[EdgeId(0)] = true;
  const CutOut cut = cut_out(fine, skeleton, edges);
  int whole = 0;
  for (int t = 0; t < fine.size(); ++t)
    if (std::count(cut.origin.begin(), cut.origin.end(), t) == 1) ++whole;
  CHECK(whole > 0);
  const auto [a, b] = skeleton.ends(EdgeId(0));
  std::set<int> touched;
  for (const VertexId v : {a, b})
    for (const TetVertex at : skeleton.preimages(v)) touched.insert(at.tet);
  CHECK(whole == fine.size() - static_cast<int>(touched.size()));
}

TEST_CASE("drilling refuses what it cannot do", "[drill]") {
  Triangulation tri = from_signature("cPcbbbihq");
  const Skeleton skeleton(tri);
  CHECK_THROWS_AS(cut_out(tri, skeleton, EdgeSet(7, false)), PreconditionError);
  CHECK_THROWS_AS(crushed(tri, skeleton, EdgeSet(0, false)), PreconditionError);
  tri.unglue({0, 0});
  CHECK_THROWS_AS(drill(tri, skeleton, EdgeSet(1, true)), PreconditionError);
}
