// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/orbifold_search.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/marked.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace tetrarch::hyperbolic {
namespace {

/// What no change of the triangulation mends.
bool orbifold_hopeless(OrbifoldOutcome outcome) {
  return outcome == OrbifoldOutcome::bad_vertex || outcome == OrbifoldOutcome::boundary_faces ||
         outcome == OrbifoldOutcome::invalid;
}

/// How far a result is from a structure; solutions of no positive volume are none.
int distance(const OrbifoldStructure& s) {
  if (!s.solved() || !(s.volume > s.volume_error)) return 1'000'000;
  return 2 * s.negative() + s.flat();
}

class OrbifoldSearcher {
public:
  OrbifoldSearcher(const OrbifoldSearchOptions& options, const Progress& progress)
      : options_(options), progress_(progress) {}

  OrbifoldSearch run(const Triangulation& given, const Marks& marks) {
    const Skeleton skeleton(given);
    if (!skeleton.is_connected())
      throw PreconditionError("find_orbifold: the triangulation is not connected");
    if (settled({given, marks})) return std::move(found_);
    moves::MarkedComplex small(given, skeleton, edge_orders(skeleton, marks));
    moves::reduce(small, progress_);
    if (settled(small.compact())) return std::move(found_);
    const int most_tets = std::max(small.size(), given.size()) + options_.most_extra_tets;
    SplitMix64 random(options_.seed);
    while (found_.attempts < options_.attempts) {
      progress_.step("searching for a structure", static_cast<double>(found_.attempts) / options_.attempts);
      const bool from_best = found_.structure.solved() && random.below(4) != 0;
      moves::MarkedComplex trial = from_best ? best() : small;
      if (from_best) {
        stir(trial, random);
      } else {
        moves::shake(trial, 1 + random.below(3 + found_.attempts), random);
      }
      if (trial.size() > most_tets || random.below(from_best ? 6 : 2) == 0)
        moves::reduce(trial, progress_.silent());
      if (trial.size() > most_tets) continue;
      if (settled(trial.compact())) break;
    }
    return std::move(found_);
  }

private:
  moves::MarkedComplex best() const {
    const Skeleton skeleton(found_.triangulation);
    return {found_.triangulation, skeleton, edge_orders(skeleton, found_.marks)};
  }

  /// Moves at tetrahedra that are turned over or flat, and a few anywhere.
  void stir(moves::MarkedComplex& trial, SplitMix64& random) const {
    const std::vector<int>& orientation = found_.structure.orientation;
    std::vector<int> bad;
    for (std::size_t t = 0; t < orientation.size(); ++t)
      if (orientation[t] <= 0) bad.push_back(static_cast<int>(t));
    const int tet = bad[static_cast<std::size_t>(random.below(static_cast<int>(bad.size())))];
    const auto [a, b] = edge_vertex[random.below(6)];
    if (random.below(3) == 0) {
      if (!trial.apply({moves::MoveKind::three_two, tet, a, b}))
        (void)trial.apply({moves::MoveKind::four_four, tet, a, b, random.below(2)});
    } else {
      (void)trial.apply({moves::MoveKind::two_three, tet, random.below(4)});
    }
    moves::shake(trial, random.below(4), random);
  }

  /// Solves; true if the search is over.
  bool settled(const moves::MarkedTriangulation& marked) {
    const Skeleton skeleton(marked.tri);
    OrbifoldStructure s = solve_orbifold(marked.tri, skeleton, edge_orders(skeleton, marked.marks),
                                         options_.solve, progress_.silent());
    const bool first = found_.attempts++ == 0;
    ++found_.seen[static_cast<std::size_t>(s.outcome)];
    const bool over = s.outcome == OrbifoldOutcome::geometric || orbifold_hopeless(s.outcome);
    const int here = distance(s);
    const int there = distance(found_.structure);
    if (first || over || here < there || (here == there && s.solved())) {
      found_.triangulation = marked.tri;
      found_.marks = marked.marks;
      found_.structure = std::move(s);
      found_.changed = !first;
    }
    return over;
  }

  const OrbifoldSearchOptions& options_;
  const Progress& progress_;
  OrbifoldSearch found_;
};

} // namespace

OrbifoldSearch find_orbifold(const Triangulation& tri, const Marks& marks,
                             const OrbifoldSearchOptions& options, const Progress& progress) {
  return OrbifoldSearcher(options, progress).run(tri, marks);
}

std::string describe(const OrbifoldSearch& search) {
  const std::string tried =
      search.attempts == 1 ? "1 triangulation" : std::to_string(search.attempts) + " triangulations";
  const OrbifoldStructure& s = search.structure;
  if (s.solved()) {
    const std::string what =
        s.outcome == OrbifoldOutcome::geometric ? "geometric" : "solved, with tetrahedra turned over or flat";
    return search.changed ? what + ", on a triangulation made from the given one (" + tried + " tried)"
                          : what + ", on the triangulation given";
  }
  std::string text = "no structure found on " + tried + ":";
  for (int k = 0; k < orbifold_outcome_count; ++k)
    if (search.seen[static_cast<std::size_t>(k)] > 0)
      text += " " + std::to_string(search.seen[static_cast<std::size_t>(k)]) + " " +
              to_string(static_cast<OrbifoldOutcome>(k)) + ",";
  text.back() = '.';
  return text;
}

} // namespace tetrarch::hyperbolic
