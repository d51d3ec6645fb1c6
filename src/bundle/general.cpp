// SPDX-License-Identifier: GPL-2.0-or-later
#include "rounds.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch::bundle {
namespace {

/// The moderately dangerous strip f0, ..., fn of Procedure 5.3.2. Edge i, between f(i-1) and f(i), has some
/// value x(i) in f(i-1) and -x(i) in f(i).
class Strip {
public:
  Strip(Work& work, const Piece& piece) : work_(work), piece_(piece) {
    Side entered;
    for (int i = 0; i < last(); ++i) {
      exits_.push_back(work.partition.strip_exit(triangle(i), entered));
      entered = work.disk().mate(exits_.back());
    }
  }

  int last() const { return piece_.count - 1; }
  /// Whether a boundary side of f(i) has this value.
  bool has(int i, int value) const {
    for (const Side s : sides_of(triangle(i)))
      if (!work_.partition.is_joined(s) && work_.pattern[s] == value) return true;
    return false;
  }
  void set_edge(int i, int x) { work_.set(exits_[i - 1], x); }

private:
  int triangle(int i) const { return work_.partition.triangles()[piece_.first + i]; }

  Work& work_;
  const Piece& piece_;
  std::vector<Side> exits_; ///< of f0, f1, ...: towards the next triangle
};

/// Triangles i1 < i2 of a strip with boundary values b and -b.
struct Stops {
  int i1, i2, b;
};

/// Two neighbours will do: where neighbours never have opposite values, all values are equal.
Stops find_stops(const Strip& strip) {
  for (int i = 1; i <= strip.last(); ++i)
    for (const int b : {1, -1})
      if (strip.has(i - 1, b) && strip.has(i, -b)) return {i - 1, i, b};
  throw PreconditionError("an extremely dangerous strip cannot be solved");
}

/// Procedure 5.3.2, second half. Before the stops each edge completes the triangle that it leaves, between
/// them edges are as in a safe strip, behind them each completes the triangle that it enters. The text's b1
/// and b2 are constants, but must be read at each triangle; and its steps [1] and [5], for the first and
/// last edge, hold only where that edge does not lie between the stops.
void solve_moderate_piece(Work& work, const Piece& piece) {
  Strip strip(work, piece);
  const auto [i1, i2, b] = find_stops(strip);
  for (int i = 1; i <= strip.last(); ++i) {
    if (i <= i1)
      strip.set_edge(i, strip.has(i - 1, 1) ? -1 : 1);
    else if (i <= i2)
      strip.set_edge(i, -b);
    else
      strip.set_edge(i, strip.has(i, 1) ? 1 : -1);
  }
}

} // namespace

CuttingResult cut_general(const Disk& disk, const BoundaryValues& boundary, const Watch& watch) {
  Work work(disk, boundary);
  if (!is_safe(work.mesh, work.pattern)) {
    work.partition.update(work.mesh);
    tell(watch, work, Round::Stage::begun, true);
    if (auto obstruction = relieve(work)) return *std::move(obstruction);
    tell(watch, work, Round::Stage::completed, true);
    for (const Piece& piece : work.partition.pieces()) {
      const bool safe = classify(work.partition, work.pattern, piece).danger == Danger::safe;
      safe ? solve_safe_piece(work, piece) : solve_moderate_piece(work, piece);
    }
    tell(watch, work, Round::Stage::solved, true);
    work.mesh.peel();
    ++work.round;
  }
  run_rounds(work, watch);
  return std::move(work.pattern);
}

} // namespace tetrarch::bundle
