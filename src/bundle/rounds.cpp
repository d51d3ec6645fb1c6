// SPDX-License-Identifier: GPL-2.0-or-later
#include "rounds.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch::bundle {
namespace {

/// A value for side s that makes its triangle safe if the other sides let it: the opposite of one that is
/// given, else any.
int opposite_of_given(const CuttingPattern& pattern, Side s) {
  for (const Side other : {s.next(), s.previous()})
    if (!pattern.is_open(other)) return -pattern[other];
  return 1;
}

/// Procedure 5.2.1. The minimal set leaves no edge with an end of a strip or a singular piece on both sides,
/// so one side at most has to be careful, and that one is served first.
void solve_breaking_edges(Work& work) {
  for (const Side s : work.partition.breaking_edges()) {
    const Side mate = work.disk().mate(s);
    const Side careful = work.partition.is_end(mate.triangle()) ? mate : s;
    const bool needed = work.partition.is_end(careful.triangle());
    work.set(careful, needed ? opposite_of_given(work.pattern, careful) : 1);
  }
}

/// 5.2.6: every triangle inside the strip is entered with -1 and left with +1; the ends are safe already.
void solve_strip(Work& work, const Piece& strip) {
  Side entered;
  for (int k = strip.first; k + 1 < strip.first + strip.count; ++k) {
    const Side exit = work.partition.strip_exit(work.partition.triangles()[k], entered);
    work.set(exit, 1);
    entered = work.disk().mate(exit);
  }
}

/// 5.2.7: the triangles of the frontier's loop are entered with -1 and left with +1, which completes them.
/// The edges behind which the interior begins are given values that keep the interior safe. The text forgets
/// those behind which there is a triangle of the same loop, further on: any value will do.
void solve_frontier(Work& work, const Piece& loop) {
  for (int k = loop.first; k < loop.first + loop.count; ++k) {
    const int t = work.partition.triangles()[k];
    for (const Side s : sides_of(t)) {
      if (!work.mesh.is_inner(s) || !work.pattern.is_open(s)) continue;
      const Side inward = work.disk().mate(s);
      const bool entry = work.mesh.ends_exposed(s) && !work.mesh.starts_exposed(s);
      if (!work.mesh.is_in_frontier(inward.triangle()))
        work.set(inward, opposite_of_given(work.pattern, inward));
      else if (!entry)
        work.set(s, 1);
    }
  }
}

/// Definition 5.1.3 [1] asks of the whole disk what Definition 5.2.1 calls safe.
void require_restricted(const Work& work) {
  if (!is_safe(work.mesh, work.pattern))
    throw PreconditionError(
        "not restricted: the boundary edges of some triangle, two or three, have one value");
}

} // namespace

void tell(const Watch& watch, const Work& work, Round::Stage stage, bool dangerous) {
  if (watch) watch({work.round, stage, dangerous, work.mesh, work.partition, work.pattern});
}

void solve_safe_piece(Work& work, const Piece& piece) {
  if (piece.type == PieceType::linear) solve_strip(work, piece);
  if (piece.type == PieceType::aggregated) solve_frontier(work, piece);
}

void run_rounds(Work& work, const Watch& watch) {
  for (; !work.mesh.frontier().empty(); ++work.round) {
    work.partition.update(work.mesh);
    tell(watch, work, Round::Stage::begun);
    solve_breaking_edges(work);
    tell(watch, work, Round::Stage::completed);
    for (const Piece& piece : work.partition.pieces()) solve_safe_piece(work, piece);
    tell(watch, work, Round::Stage::solved);
    work.mesh.peel();
  }
}

CuttingPattern cut_restricted(const Disk& disk, const BoundaryValues& boundary, const Watch& watch) {
  Work work(disk, boundary);
  require_restricted(work);
  run_rounds(work, watch);
  return std::move(work.pattern);
}

BoundaryValues restricted_boundary(const Disk& disk) {
  // +1 everywhere, but on the last boundary side of a triangle that has several -1.
  BoundaryValues values;
  for (const Side s : disk.boundary()) {
    const int others = (disk.is_boundary(s.next()) ? 1 : 0) + (disk.is_boundary(s.previous()) ? 1 : 0);
    const bool last = !disk.is_boundary(s.next()) || (others == 2 && s.corner() == 2);
    values.push_back(others > 0 && last ? -1 : 1);
  }
  return values;
}

CuttingPattern cut_free(const Disk& disk, const Watch& watch) {
  return cut_restricted(disk, restricted_boundary(disk), watch);
}

} // namespace tetrarch::bundle
