// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/search.hpp"

#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/moves/simplify.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <algorithm>
#include <unordered_set>

namespace tetrarch::hyperbolic {
namespace {

void require_searchable(const Triangulation& tri, const Skeleton& skeleton) {
  if (tri.size() == 0) throw PreconditionError("find_structure: the triangulation is empty");
  if (!skeleton.is_connected()) throw PreconditionError("find_structure: the triangulation is not connected");
  if (const auto defects = check(skeleton); !defects.empty())
    throw PreconditionError("find_structure: " + describe(defects.front(), skeleton));
}

/// After so many triangulations without success the search starts anew from another small one. Gluings of up
/// to four tetrahedra rarely need as many. The larger, the rarer a small triangulation carries the structure,
/// and the less walks near one that does not help.
int attempts_between_restarts(int tets) {
  return std::clamp(500 / tets, 3, 25);
}
/// So many triangulations are tried before `has_none` is asked: nearly all that carry a structure somewhere
/// are found by then, and what is asked takes as long as some of them.
int attempts_before_asking(int tets) {
  return std::clamp(2000 / tets, 2, 25);
}
/// Tetrahedra in all triangulations that are tried, for each of `SearchOptions::attempts`.
constexpr long long tetrahedra_each = 250;
/// Between the seeds of restarts.
constexpr std::uint64_t restart_stride = 0x9e3779b97f4a7c15;

/// Boundary components of the input that no vertex of the result stands for.
int filled_spheres(const moves::Truncation& truncation) {
  int filled = 0;
  for (const moves::BoundaryImage& image : truncation.boundary) filled += image.vertex.tet < 0 ? 1 : 0;
  return filled;
}

bool needs_truncation(const Skeleton& skeleton) {
  if (skeleton.has_boundary_faces()) return true;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.link(v).is_sphere()) return true;
  return false;
}

/// Whether no change of the triangulation can help.
bool hopeless(Outcome outcome) {
  return outcome == Outcome::projective_plane || outcome == Outcome::finite_vertices;
}

class Searcher {
public:
  Searcher(const SearchOptions& options, const Progress& progress) : options_(options), progress_(progress) {
    options_.solve.method = Method::newton;
  }

  Search run(const Triangulation& given) {
    const Skeleton skeleton(given);
    require_searchable(given, skeleton);
    Triangulation start = given;
    if (needs_truncation(skeleton)) {
      moves::TruncateOptions how;
      how.simplify.seed = options_.seed;
      moves::Truncation truncation = moves::truncate(given, how, progress_);
      start = std::move(truncation.tri);
      found_.filled_spheres = filled_spheres(truncation);
      found_.changed = true;
    }
    if (settled(start)) return std::move(found_);
    moves::SimplifyOptions how;
    how.seed = options_.seed;
    const Triangulation simple = moves::simplified(start, how, progress_);
    if (settled(simple)) return std::move(found_);
    wander(simple);
    return std::move(found_);
  }

private:
  /// Solves on a triangulation not met before; true if the search is over.
  bool settled(const Triangulation& tri) {
    if (!known_.insert(signature(tri)).second) return false;
    const bool first = found_.attempts++ == 0;
    tetrahedra_ += tri.size();
    if (!first) found_.changed = true;
    const Skeleton skeleton(tri);
    auto structure = hyperbolize(tri, skeleton, options_.solve, progress_.silent());
    if (structure.outcome == Outcome::stopped) throw Stopped();
    const Outcome outcome = structure.outcome;
    bad_tet_ = structure.tet;
    if (bad_tet_ < 0 && structure.edge.value >= 0) bad_tet_ = skeleton.around(structure.edge).front().tet;
    ++found_.seen[static_cast<std::size_t>(outcome)];
    // The last word without success is about the simplified triangulation, the second at most.
    if (outcome == Outcome::geometric || found_.attempts <= 2) {
      found_.triangulation = tri;
      found_.structure = std::move(structure);
    }
    return outcome == Outcome::geometric || hopeless(outcome);
  }

  void wander(const Triangulation& simple) {
    const int most_tets = simple.size() + options_.most_extra_tets;
    moves::Complex base(simple);
    int base_bad = bad_tet_;
    SplitMix64 random(options_.seed);
    const int between = attempts_between_restarts(simple.size());
    int next_restart = found_.attempts + between;
    const int ask_after = attempts_before_asking(simple.size());
    bool asked = false;
    // Walks that end where somebody has been cost little but must end too.
    const long long most_walks = 20LL * options_.attempts;
    const long long most_tetrahedra = tetrahedra_each * options_.attempts;
    for (long long walk = 0;
         walk < most_walks && found_.attempts < options_.attempts && tetrahedra_ < most_tetrahedra; ++walk) {
      progress_.step("searching for a structure", static_cast<double>(found_.attempts) / options_.attempts);
      if (options_.has_none && !asked && found_.attempts >= ask_after) {
        asked = true;
        if (options_.has_none(found_.triangulation)) return;
      }
      if (found_.attempts >= next_restart) {
        next_restart = found_.attempts + between;
        if (start_anew(simple, most_tets, base)) return;
        base_bad = bad_tet_ < base.size() ? bad_tet_ : -1;
        continue;
      }
      moves::Complex trial = base;
      if (base_bad >= 0 && random.below(2) == 0) stir(trial, base_bad, random);
      moves::shake(trial, 1 + random.below(3 + static_cast<int>(walk % 8)), random);
      if (random.below(2) == 0 || trial.size() > most_tets) moves::reduce(trial);
      trial.pack();
      if (trial.size() > most_tets) continue;
      if (settled(trial.triangulation())) return;
      if (random.below(4) != 0) continue;
      base = std::move(trial);
      base_bad = bad_tet_ < base.size() ? bad_tet_ : -1;
    }
  }

  /// Puts another triangulation into `base`, as small as can be found from another seed: a large one has many
  /// local minima, and one in a few of them carries the structure when walks from the others never arrive.
  /// True if the search is over.
  bool start_anew(const Triangulation& simple, int most_tets, moves::Complex& base) {
    SplitMix64 random(options_.seed + static_cast<std::uint64_t>(found_.attempts) * restart_stride);
    moves::SimplifyOptions how;
    how.seed = random.next();
    moves::Complex other(simple);
    moves::shake(other, 2 * simple.size(), random);
    const Triangulation fresh = moves::simplified(other.triangulation(), how, progress_.silent());
    bad_tet_ = -1;
    if (fresh.size() > most_tets) return false;
    base = moves::Complex(fresh);
    return settled(fresh);
  }

  /// A move at a tetrahedron that degenerates: it flattens towards an edge or a face, which has to go.
  static void stir(moves::Complex& complex, int tet, SplitMix64& random) {
    const auto [a, b] = edge_vertex[random.below(6)];
    if (!moves::apply(complex, {moves::MoveKind::three_two, tet, a, b})) return;
    if (!moves::apply(complex, {moves::MoveKind::four_four, tet, a, b, random.below(2)})) return;
    (void)moves::apply(complex, {moves::MoveKind::two_three, tet, random.below(4)});
  }

  SearchOptions options_;
  const Progress& progress_;
  Search found_;
  std::unordered_set<std::string> known_;
  long long tetrahedra_ = 0; ///< of all that were tried
  int bad_tet_ = -1;
};

} // namespace

Search find_structure(const Triangulation& tri, const SearchOptions& options, const Progress& progress) {
  return Searcher(options, progress).run(tri);
}

std::string describe(const Search& search) {
  const std::string tried =
      search.attempts == 1 ? "1 triangulation" : std::to_string(search.attempts) + " triangulations";
  if (search.structure.outcome == Outcome::geometric)
    return search.changed ? "geometric, on a triangulation made from the given one (" + tried + " tried)"
                          : "geometric, on the triangulation given";
  std::string text = "no structure found on " + tried + ":";
  for (int k = 0; k < outcome_count; ++k)
    if (search.seen[static_cast<std::size_t>(k)] > 0)
      text += " " + std::to_string(search.seen[static_cast<std::size_t>(k)]) + " " +
              to_string(static_cast<Outcome>(k)) + ",";
  text.back() = '.';
  return text;
}

} // namespace tetrarch::hyperbolic
