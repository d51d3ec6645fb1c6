// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/pair.hpp"

#include "tetrarch/canonical/flips.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/moves/log.hpp"
#include "tetrarch/moves/simplify.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace tetrarch::canonical {
namespace {

using hyperbolic::Hyperbolization;
using hyperbolic::Outcome;
using moves::FreeWord;
using moves::inverse;
using moves::Monodromy;
using moves::product;

struct Marked {
  Triangulation tri;
  Monodromy monodromy;
};

/// The words on the coned triangulation: of the crossings through walls those of the walls, none elsewhere.
Monodromy coned_words(const Triangulation& tri, Monodromy monodromy, const FlatFaces& flat,
                      const CellDecomposition& cells) {
  flatten_words(tri, monodromy, flat);
  Monodromy out(cells.coned.size());
  constexpr int through_wall = 3;
  for (int s = 0; s < cells.coned.size(); ++s) {
    const auto& [wall, off] = cells.origin[static_cast<std::size_t>(s)];
    std::array<int, 2> ends{};
    int corner = 0;
    for (const int v : face_vertex[wall.face])
      if (v != off) {
        ends[corner] = v;
        out.at(s, corner++, through_wall) = monodromy.at(wall.tet, v, wall.face);
      }
    out.set_hand(s, monodromy.hand(wall.tet) * Perm4(ends[0], ends[1], off, wall.face).sign());
  }
  return out;
}

/// Flips from a solved triangulation to the cells, with the words; nothing where flips get stuck.
template <class Scalar>
std::optional<Marked> flipped(Marked at, Decorated<Scalar> decorated, double margin, std::uint64_t seed,
                              const Progress& progress) {
  FlipOptions how;
  how.margin = margin;
  how.seed = seed;
  const Flips flips = flip_to_hull(decorated, how, progress);
  if (flips.end != Flips::End::convex) return std::nullopt;
  for (const moves::Ball& ball : flips.path) {
    moves::Replaced next = moves::replace(at.tri, ball);
    at.monodromy = moves::carried(std::move(at.monodromy), at.tri, ball, next);
    at.tri = std::move(next.tri);
  }
  return at;
}

std::optional<MarkedCells> cells_from(const Marked& start, const Hyperbolization<double>& structure,
                                      std::uint64_t seed, const Progress& progress) {
  constexpr double margin = 1e-8;
  auto at =
      flipped(start, decorate(start.tri, Skeleton(start.tri), structure.lengths), margin, seed, progress);
  if (!at) return std::nullopt;
  const auto solved = hyperbolic::hyperbolize(at->tri, Skeleton(at->tri));
  if (solved.outcome != Outcome::geometric) return std::nullopt;
  CanonizeOptions no_restart;
  no_restart.restarts = 0;
  MarkedCells out;
  out.canonical = canonize(at->tri, solved, no_restart, progress);
  // The words are known on this triangulation alone.
  if (out.canonical.outcome != Canonical::Outcome::canonical || !(out.canonical.triangulation == at->tri))
    return std::nullopt;
  if (!out.canonical.has_flat_faces) {
    out.monodromy = std::move(at->monodromy);
    return out;
  }
  const CellDecomposition cells = cell_decomposition(at->tri, Skeleton(at->tri), out.canonical.flat);
  out.monodromy = coned_words(at->tri, std::move(at->monodromy), out.canonical.flat, cells);
  out.canonical.canonical_triangulation = cells.coned;
  return out;
}

/// A random walk that carries the words.
std::optional<Marked> wandered(const Marked& from, SplitMix64& random) {
  moves::Complex complex(from.tri);
  moves::MoveLog log;
  moves::shake(complex, 1 + random.below(8), random, &log);
  if (random.below(2) == 0) {
    moves::SimplifyOptions how;
    how.log = &log;
    moves::reduce(complex, how);
  }
  moves::Complex again(from.tri);
  Monodromy words = from.monodromy;
  for (const moves::Move& move : log)
    if (!moves::carry(again, words, move)) return std::nullopt;
  const moves::Complex::Compact end = again.compact();
  Marked out{end.tri, compacted(words, end)};
  shorten(out.tri, out.monodromy);
  return out;
}

/// Walks over the triangles of one link from a root, in the first triangulation, with the words from the root
/// in both.
class LinkWalk {
public:
  LinkWalk(const Triangulation& a, const Monodromy& words_a, const Isomorphism& to, const Monodromy& words_b)
      : a_(a), words_a_(words_a), to_(to), words_b_(words_b), from_root_(static_cast<std::size_t>(a.size())) {
  }

  bool is_done(TetVertex v) const { return from_root_[v.tet][v.vertex].has_value(); }

  /// The loops that generate the group of the link at v.
  Correspondence loops(TetVertex root) {
    Correspondence found;
    from_root_[root.tet][root.vertex] = Words{};
    std::vector<TetVertex> pending{root};
    while (!pending.empty()) {
      const TetVertex at = pending.back();
      pending.pop_back();
      for (int f = 0; f < 4; ++f) {
        if (f == at.vertex) continue;
        const Gluing g = a_.gluing({at.tet, f});
        const TetVertex next{g.tet, g.perm[at.vertex]};
        Words words = *from_root_[at.tet][at.vertex];
        const Perm4 p = to_.perm[at.tet];
        words.first = product(words.first, words_a_.at(at.tet, at.vertex, f));
        words.second = product(words.second, words_b_.at(to_.tet[at.tet], p[at.vertex], p[f]));
        auto& known = from_root_[next.tet][next.vertex];
        if (!known) {
          known = std::move(words);
          pending.push_back(next);
        } else {
          found.add(product(words.first, inverse(known->first)),
                    product(words.second, inverse(known->second)));
        }
      }
    }
    return found;
  }

private:
  using Words = std::pair<FreeWord, FreeWord>;

  const Triangulation& a_;
  const Monodromy& words_a_;
  const Isomorphism& to_;
  const Monodromy& words_b_;
  std::vector<std::array<std::optional<Words>, 4>> from_root_;
};

} // namespace

MarkedCells marked_cells(const Triangulation& tri, const Monodromy& monodromy, const MarkedOptions& options,
                         const Progress& progress) {
  SplitMix64 random(options.seed);
  Marked at{tri, monodromy};
  const int most_tets = tri.size() + 8;
  constexpr int orders = 5; // random orders of flips, where the usual one gets stuck
  for (int attempt = 0; attempt < options.attempts; ++attempt) {
    progress.step("cells with meridians", -1);
    const auto structure = hyperbolic::hyperbolize(at.tri, Skeleton(at.tri));
    if (structure.outcome == Outcome::geometric)
      for (std::uint64_t seed = 0; seed < orders; ++seed)
        if (auto found = cells_from(at, structure, seed, progress)) return *std::move(found);
    std::optional<Marked> next = wandered(at, random);
    if (next && next->tri.size() <= most_tets) at = *std::move(next);
  }
  MarkedCells out;
  out.why_not = "no moves to the canonical cells were found from " + std::to_string(options.attempts) +
                " triangulations";
  return out;
}

bool extends(const Triangulation& a, const Monodromy& words_a, const Isomorphism& isomorphism,
             const Monodromy& words_b) {
  LinkWalk walk(a, words_a, isomorphism, words_b);
  for (int t = 0; t < a.size(); ++t)
    for (int v = 0; v < 4; ++v) {
      if (walk.is_done({t, v})) continue;
      const Correspondence::Answer answer = walk.loops({t, v}).answer();
      if (!answer.exists) return false;
      if (!answer.generates) throw PreconditionError("extends: the homomorphism is not onto");
    }
  return true;
}

std::vector<Correspondence> link_loops(const Triangulation& tri, const Monodromy& words_a,
                                       const Monodromy& words_b) {
  Isomorphism identity;
  for (int t = 0; t < tri.size(); ++t) identity.tet.push_back(t);
  identity.perm.resize(static_cast<std::size_t>(tri.size()));
  LinkWalk walk(tri, words_a, identity, words_b);
  std::vector<Correspondence> out;
  for (int t = 0; t < tri.size(); ++t)
    for (int v = 0; v < 4; ++v)
      if (!walk.is_done({t, v})) out.push_back(walk.loops({t, v}));
  return out;
}

PairIsometries pair_isometries(const MarkedCells& a, const MarkedCells& b) {
  PairIsometries found;
  found.all = isomorphisms(a.canonical.canonical_triangulation, b.canonical.canonical_triangulation);
  for (const Isomorphism& isometry : found.all) {
    if (!extends(a.canonical.canonical_triangulation, a.monodromy, isometry, b.monodromy)) continue;
    found.extending.push_back(isometry);
    found.hands.push_back(a.monodromy.hand(0) * isometry.perm[0].sign() * b.monodromy.hand(isometry.tet[0]));
  }
  return found;
}

CommonTriangulation common_triangulation(const Triangulation& a, const Monodromy& words_a,
                                         const Triangulation& b, const Monodromy& words_b,
                                         const CommonOptions& options, const Progress& progress) {
  constexpr long long most_letters = 20'000;
  SplitMix64 random(options.seed);
  std::array<std::map<std::string, std::vector<Marked>>, 2> met;
  std::array<Marked, 2> at{Marked{a, words_a}, Marked{b, words_b}};
  const std::array<Marked, 2> start = at;
  const int most_tets = std::max(a.size(), b.size()) + 1;
  CommonTriangulation out;
  for (int walk = 0; walk < 2 * options.walks; ++walk) {
    progress.step("common triangulation", walk / (2.0 * options.walks));
    const std::size_t side = static_cast<std::size_t>(walk % 2);
    const std::string name = signature(at[side].tri);
    const auto other = met[1 - side].find(name);
    if (other != met[1 - side].end()) {
      for (const Marked& there : other->second) {
        const Marked& one = side == 0 ? at[side] : there;
        const Marked& two = side == 0 ? there : at[side];
        const std::vector<Isomorphism> between = isomorphisms(one.tri, two.tri);
        if (out.signature.empty()) out.signature = name;
        out.isomorphisms += between.size();
        for (const Isomorphism& iso : between)
          if (extends(one.tri, one.monodromy, iso, two.monodromy)) {
            out.signature = name;
            out.hands.push_back(one.monodromy.hand(0) * iso.perm[0].sign() * two.monodromy.hand(iso.tet[0]));
          }
      }
      if (!out.hands.empty()) return out;
    }
    constexpr std::size_t most_kept = 4; // of one triangulation, with different words
    if (auto& kept = met[side][name]; kept.size() < most_kept) kept.push_back(at[side]);
    std::optional<Marked> next = wandered(at[side], random);
    if (!next || next->tri.size() > most_tets) continue;
    at[side] = next->monodromy.letter_count() > most_letters ? start[side] : *std::move(next);
  }
  return out;
}

} // namespace tetrarch::canonical
