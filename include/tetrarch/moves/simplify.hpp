// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Fewer tetrahedra, the same manifold.
///
/// The first phase is greedy. It takes tetrahedra from a worklist, makes every legal move that removes
/// tetrahedra (3-2, 2-0, 2-1, vertex merges with the edge of largest valence first, shelling, closing of
/// books), and returns only to the neighborhood of a move. The order matters, large edges first: a merge
/// removes all tetrahedra at its edge, and edges of small valence leave through 3-2 and 2-0 moves instead;
/// merging in any order was forty times slower on a ball of three million tetrahedra, because a few edges
/// then grow without bound. The second phase makes excursions: random 2-3 and 4-4 moves, then the greedy
/// phase again. It keeps a result that is no larger, and it ends when a whole budget of excursions in a row
/// has won nothing. Source: Yin, section 4.2.2, steps [1] and [3].

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/log.hpp"

#include <functional>

namespace tetrarch::moves {

struct SimplifyOptions {
  std::uint64_t seed = 1;
  /// The budget of excursions in a row that win nothing: a number for each remaining tetrahedron, within a
  /// least and a greatest total. An excursion takes about ten microseconds and copies the complex.
  int excursions_per_tet = 100;
  int least_excursions = 500;
  int most_excursions = 10'000;
  /// Greatest number of tetrahedra that all excursions together may copy: a second or two for a large result.
  long long most_work = 50'000'000;
  /// Merge along boundary edges, shell and close books; otherwise the boundary stays as it is.
  bool change_boundary = true;
  /// Every move is appended to this log.
  MoveLog* log = nullptr;
  /// Called after every `audit_every` moves, for instance to compare with an independent `Skeleton`.
  std::function<void(const Complex&)> audit;
  int audit_every = 1000;
};

/// How many moves of each kind were made, by MoveKind; those of rejected excursions do not count.
struct MoveCounts {
  std::array<long long, move_kind_count> of{};
  long long operator[](MoveKind kind) const { return of[static_cast<std::size_t>(kind)]; }
  void add(const MoveCounts& more);
  long long total() const;
};

/// The greedy part alone. Near-linear: about 0.5 microseconds per tetrahedron on cubes and meshes, measured
/// up to 3,000,000. Every move lowers (tetrahedra, boundary faces), so it ends.
MoveCounts reduce(Complex& complex, const SimplifyOptions& options = {}, const Progress& progress = {});

struct Simplification {
  MoveCounts counts;
  /// What became of each vertex of before; -1: it is gone.
  Table<VertexId, VertexId> vertices;
};

/// Both parts. What is left is a local minimum: no single reducing move applies, and the last excursions
/// found nothing smaller. Smaller triangulations may exist. Finite vertices are removed before tetrahedra are
/// counted, by pinching where merging fails: one is left only where a component has no other vertex. The
/// complex comes out packed. Deterministic for a seed.
Simplification simplify(Complex& complex, const SimplifyOptions& options = {}, const Progress& progress = {});

/// The same of a triangulation that stays as it is.
Triangulation simplified(const Triangulation& tri, const SimplifyOptions& options = {},
                         const Progress& progress = {});

/// `count` random moves that keep the manifold and its vertices: 2-3 on a random face or 4-4 at a random
/// edge, with equal chances. Attempts that are illegal count.
void shake(Complex& complex, int count, SplitMix64& random, MoveLog* log = nullptr);

} // namespace tetrarch::moves
