// SPDX-License-Identifier: GPL-2.0-or-later
/// The incremental partition against the words of sections 5.2.1, 5.2.4 and 5.3.2, taken literally and at any
/// cost, in every round on every small disk and on random ones.
#include "tetrarch/bundle/partition.hpp"

#include "bundle/disks.hpp"
#include "tetrarch/bundle/cut.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <set>

using namespace tetrarch;
using namespace tetrarch::bundle;
using namespace tetrarch::support;

namespace {

using TriangleSet = std::set<int>;

/// A sub-mesh as the text sees it: a set of triangles, cut open along some edges.
struct SubMesh {
  const Disk& disk;
  TriangleSet triangles;
  std::set<int> cut{}; ///< sides, both of each edge

  bool is_inner(Side s) const {
    return !disk.is_boundary(s) && cut.count(s.value) == 0 && triangles.count(disk.mate(s).triangle()) != 0;
  }
  int valence(int t) const {
    const auto sides = sides_of(t);
    return static_cast<int>(std::count_if(sides.begin(), sides.end(), [&](Side s) { return is_inner(s); }));
  }
  std::set<int> boundary_vertices() const {
    std::set<int> out;
    for (const int t : triangles)
      for (const Side s : sides_of(t))
        if (!is_inner(s)) out.insert({disk.from(s), disk.to(s)});
    return out;
  }
  std::vector<Side> separating() const {
    const std::set<int> boundary = boundary_vertices();
    std::vector<Side> out;
    for (const int t : triangles)
      for (const Side s : sides_of(t))
        if (is_inner(s) && boundary.count(disk.from(s)) != 0 && boundary.count(disk.to(s)) != 0)
          out.push_back(s);
    return out;
  }
  TriangleSet connected_to(int start) const {
    TriangleSet out{start};
    std::vector<int> stack{start};
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (const Side s : sides_of(t))
        if (is_inner(s) && out.insert(disk.mate(s).triangle()).second)
          stack.push_back(disk.mate(s).triangle());
    }
    return out;
  }
};

/// Definition 5.2.3.
std::optional<PieceType> type_of(const SubMesh& mesh) {
  std::map<int, int> with_valence;
  for (const int t : mesh.triangles) ++with_valence[mesh.valence(t)];
  if (with_valence[0] == 1 && mesh.triangles.size() == 1) return PieceType::singular;
  if (mesh.separating().empty()) return PieceType::aggregated;
  if (with_valence[1] == 2 && with_valence[3] == 0) return PieceType::linear;
  return std::nullopt;
}

/// The triangles of a sub-mesh that meet its boundary.
TriangleSet frontier_of(const SubMesh& mesh) {
  const std::set<int> boundary = mesh.boundary_vertices();
  TriangleSet out;
  for (const int t : mesh.triangles)
    for (const int v : mesh.disk.corners(t))
      if (boundary.count(v) != 0) out.insert(t);
  return out;
}

TriangleSet listed(const Partition& partition, const Piece& piece) {
  const auto from = partition.triangles().begin() + piece.first;
  return {from, from + piece.count};
}

/// The piece of each triangle, by cutting the unsolved triangles along the breaking edges; empty where one is
/// not of the type, the frontier or the component that the partition says.
std::vector<SubMesh> pieces_found(const Round& round, const SubMesh& whole) {
  SubMesh opened = whole;
  for (const Side s : round.partition.breaking_edges())
    opened.cut.insert({s.value, whole.disk.mate(s).value});
  std::vector<SubMesh> out;
  for (const Piece& piece : round.partition.pieces()) {
    const int start = round.partition.triangles()[piece.first];
    SubMesh mesh{whole.disk, opened.connected_to(start)};
    if (type_of(mesh) != piece.type || frontier_of(mesh) != listed(round.partition, piece)) return {};
    out.push_back(mesh);
  }
  const std::vector<int> component = components(whole.disk, round.partition);
  for (std::size_t p = 0; p < out.size(); ++p)
    for (std::size_t q = 0; q < out.size(); ++q) {
      const bool together =
          whole.connected_to(*out[p].triangles.begin()).count(*out[q].triangles.begin()) != 0;
      if (together != (component[p] == component[q])) return {};
    }
  return out;
}

/// What is wrong with the partition of this round; empty if nothing.
std::string disagreement(const Round& round) {
  const Disk& disk = round.mesh.disk();
  SubMesh whole{disk, {}};
  for (int t = 0; t < disk.triangle_count(); ++t)
    if (!round.mesh.is_solved(t)) whole.triangles.insert(t);
  const std::vector<SubMesh> pieces = pieces_found(round, whole);
  if (pieces.empty()) return "a piece is of another type, frontier or component";
  std::size_t covered = 0;
  for (const SubMesh& piece : pieces) covered += piece.triangles.size();
  if (covered != whole.triangles.size()) return "the pieces do not cover";
  for (const Side s : round.partition.breaking_edges()) {
    const std::vector<Side> separating = whole.separating();
    if (std::find(separating.begin(), separating.end(), s) == separating.end())
      return "an edge does not separate";
    if (whole.valence(s.triangle()) != 3 && whole.valence(disk.mate(s).triangle()) != 3)
      return "an edge is not breaking";
    SubMesh both = pieces[round.partition.piece_of(s.triangle())];
    const SubMesh& other = pieces[round.partition.piece_of(disk.mate(s).triangle())];
    both.triangles.insert(other.triangles.begin(), other.triangles.end());
    if (type_of(both)) return "two pieces make one";
  }
  return "";
}

/// Checks all rounds of Algorithm III on a disk; returns how many there were.
int check_rounds(const Disk& disk, std::string& found) {
  int rounds = 0;
  const CuttingPattern pattern = cut_free(disk, [&](const Round& round) {
    rounds = round.number;
    if (!found.empty()) return;
    found = broken_invariant(round);
    if (found.empty() && round.stage == Round::Stage::begun) found = disagreement(round);
  });
  if (found.empty()) found = why_not_valid(disk, pattern);
  return rounds;
}

} // namespace

TEST_CASE("The partition is the one of the text on every disk with up to 7 triangles", "[bundle]") {
  std::string found;
  for (const Disk& disk : small_disks(7)) check_rounds(disk, found);
  CHECK(found == "");
}

TEST_CASE("The partition is the one of the text on random disks, layer by layer", "[bundle]") {
  Random random(3);
  std::string found;
  int deepest = 0;
  for (int k = 0; k < 20; ++k) {
    const Disk disk = random_disk(
        {1 + random.below(10), 1 + random.below(10), random.below(30), random.below(40), true}, random);
    deepest = std::max(deepest, check_rounds(disk, found));
  }
  CHECK(found == "");
  CHECK(deepest >= 4);
}

TEST_CASE("A hexagon with a triangle in its middle: one strip and a singular piece", "[bundle]") {
  // By hand: three triangles around 0 2 4; two of them and the middle are a strip, the third is left over.
  const Disk hexagon(6, {{0, 2, 4}, {0, 1, 2}, {2, 3, 4}, {4, 5, 0}});
  UnsolvedMesh mesh(hexagon);
  Partition partition(hexagon);
  partition.update(mesh);
  REQUIRE(partition.pieces().size() == 2);
  CHECK(partition.breaking_edges().size() == 1);
  CHECK(partition.pieces()[0].count + partition.pieces()[1].count == 4);
  CHECK(partition.pieces()[0].type != partition.pieces()[1].type);
  mesh.peel();
  CHECK(mesh.frontier().empty());
}
