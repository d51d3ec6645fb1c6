// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/solid/split_edges.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/tet.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace tetrarch::solid {
namespace {

/// The edges to be split, the first to be split first.
class Queue {
public:
  Queue(const TetMesh& mesh, const std::vector<EdgePoint>& splits) {
    std::vector<std::pair<double, std::uint64_t>> order;
    order.reserve(splits.size());
    const int vertices = static_cast<int>(mesh.points.size());
    for (const EdgePoint& s : splits) {
      if (s.from < 0 || s.to < 0 || s.from >= vertices || s.to >= vertices || s.from == s.to)
        throw PreconditionError("an edge to be split has no ends");
      order.emplace_back(-numeric::distance(mesh.points[s.from], mesh.points[s.to]), key(s.from, s.to));
    }
    std::vector<int> by_rank(splits.size());
    for (std::size_t k = 0; k < splits.size(); ++k) by_rank[k] = static_cast<int>(k);
    std::sort(by_rank.begin(), by_rank.end(), [&](int a, int b) { return order[a] < order[b]; });
    for (std::size_t rank = 0; rank < by_rank.size(); ++rank)
      if (!at_.emplace(order[by_rank[rank]].second, Entry{static_cast<int>(rank), by_rank[rank]}).second)
        throw PreconditionError("an edge is to be split twice");
  }

  struct Entry {
    int rank = -1;
    int split = -1;
  };
  /// None where the edge stays; then the split is -1.
  Entry find(int a, int b) const {
    const auto it = at_.find(key(a, b));
    return it == at_.end() ? Entry{} : it->second;
  }

private:
  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U | static_cast<std::uint64_t>(std::max(a, b));
  }
  std::unordered_map<std::uint64_t, Entry> at_;
};

/// A piece of a tetrahedron, and in which of its faces the faces of the piece lie.
struct Piece {
  std::array<int, 4> corners;
  std::array<int, 4> face;
};

class Splitter {
public:
  Splitter(const TetMesh& mesh, const std::vector<EdgePoint>& splits)
      : mesh_(mesh), queue_(mesh, splits), used_(splits.size(), 0) {}

  SplitTets run(const std::vector<EdgePoint>& splits) {
    result_.mesh.points = mesh_.points;
    for (const EdgePoint& s : splits) result_.mesh.points.push_back(place(s));
    result_.mesh.tetrahedra.reserve(mesh_.tetrahedra.size());
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t)
      split({mesh_.tetrahedra[t], {0, 1, 2, 3}}, static_cast<int>(t));
    if (std::find(used_.begin(), used_.end(), 0) != used_.end())
      throw PreconditionError("an edge to be split is none of the mesh");
    return std::move(result_);
  }

private:
  std::array<double, 3> place(const EdgePoint& s) const {
    std::array<double, 3> p{};
    for (int k = 0; k < 3; ++k)
      p[k] = (1 - s.part) * mesh_.points[s.from][k] + s.part * mesh_.points[s.to][k];
    return p;
  }

  /// Edges that end at a new vertex are never in the queue, so the recursion is at most six deep.
  void split(const Piece& piece, int origin) {
    Queue::Entry first;
    int edge = -1;
    for (int e = 0; e < 6; ++e) {
      const Queue::Entry found =
          queue_.find(piece.corners[edge_vertex[e][0]], piece.corners[edge_vertex[e][1]]);
      if (found.split < 0 || (edge >= 0 && found.rank > first.rank)) continue;
      first = found;
      edge = e;
    }
    if (edge < 0) {
      result_.mesh.tetrahedra.push_back(piece.corners);
      result_.origin.push_back(origin);
      result_.face_of.insert(result_.face_of.end(), piece.face.begin(), piece.face.end());
      return;
    }
    used_[first.split] = 1;
    for (int side = 0; side < 2; ++side) {
      const int moved = edge_vertex[edge][side];
      const int kept = edge_vertex[edge][1 - side];
      Piece half = piece;
      half.corners[moved] = static_cast<int>(mesh_.points.size()) + first.split;
      half.face[kept] = -1; // between the halves
      split(half, origin);
    }
  }

  const TetMesh& mesh_;
  Queue queue_;
  std::vector<char> used_; ///< of each split, whether its edge was met
  SplitTets result_;
};

} // namespace

SplitTets split_edges(const TetMesh& mesh, const std::vector<EdgePoint>& splits) {
  return Splitter(mesh, splits).run(splits);
}

} // namespace tetrarch::solid
