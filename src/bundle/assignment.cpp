// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/assignment.hpp"

#include <algorithm>

namespace tetrarch::bundle {
namespace {

/// Which values occur on some sides.
struct Seen {
  bool plus = false;
  bool minus = false;

  void add(int value) {
    plus = plus || value > 0;
    minus = minus || value < 0;
  }
  bool both() const { return plus && minus; }
};

} // namespace

Assignment classify(const Partition& partition, const CuttingPattern& pattern, const Piece& piece) {
  if (piece.type == PieceType::aggregated) return {};
  Seen all;
  bool safe = true;
  for (int k = piece.first; k < piece.first + piece.count; ++k) {
    const int t = partition.triangles()[k];
    Seen here;
    for (const Side s : sides_of(t))
      if (!partition.is_joined(s)) here.add(pattern[s]);
    safe = safe && (partition.joined_count(t) == 2 || here.both());
    all.plus = all.plus || here.plus;
    all.minus = all.minus || here.minus;
  }
  if (safe) return {};
  if (all.both()) return {Danger::moderate, 0};
  return {Danger::extreme, all.plus ? 1 : all.minus ? -1 : 0};
}

bool is_safe(const UnsolvedMesh& mesh, const CuttingPattern& pattern) {
  return std::all_of(mesh.frontier().begin(), mesh.frontier().end(), [&](int t) {
    if (mesh.valence(t) > 1) return true;
    Seen seen;
    for (const Side s : sides_of(t))
      if (!mesh.is_inner(s)) seen.add(pattern[s]);
    return seen.both();
  });
}

} // namespace tetrarch::bundle
