// SPDX-License-Identifier: GPL-2.0-or-later
#include "surface_reason.hpp"

#include "cut_open.hpp"
#include "quotients.hpp"
#include "span.hpp"
#include "tetrarch/algebra/whitehead.hpp"
#include "tetrarch/core/signature.hpp"
#include "words.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace tetrarch::reasons {
namespace {

using algebra::Presentation;
using algebra::Word;

/// A presentation, and words of its group that follow every change of generators.
struct Followed {
  Presentation group;
  std::vector<Word> words;
};

constexpr std::size_t longest_word = 4000;

void replace(Followed& f, int generator, const Word& by) {
  std::vector<Word> word_of;
  for (int g = 1; g <= f.group.generators; ++g) word_of.push_back({g});
  word_of[static_cast<std::size_t>(generator)] = by;
  algebra::Renamed now{f.group, f.words};
  now = substituted(now, word_of);
  f = {std::move(now.presentation), std::move(now.image)};
}

/// Eliminates a generator that occurs once in a relator, the shortest such relator first, and tells which; -1
/// if there is none or words have grown long.
int eliminate(Followed& f) {
  if (std::any_of(f.words.begin(), f.words.end(), [](const Word& w) { return w.size() > longest_word; }))
    return -1;
  const Word* best = nullptr;
  std::size_t place = 0;
  for (const Word& relator : f.group.relators) {
    if (best != nullptr && relator.size() >= best->size()) continue;
    for (std::size_t k = 0; k < relator.size(); ++k)
      if (std::count_if(relator.begin(), relator.end(),
                        [&](int x) { return std::abs(x) == std::abs(relator[k]); }) == 1) {
        best = &relator;
        place = k;
        break;
      }
  }
  if (best == nullptr) return -1;
  // relator = p x q = 1, so that x = (q p)^-1.
  Word rest(best->begin() + static_cast<std::ptrdiff_t>(place) + 1, best->end());
  rest.insert(rest.end(), best->begin(), best->begin() + static_cast<std::ptrdiff_t>(place));
  const int x = (*best)[place];
  replace(f, std::abs(x) - 1, x > 0 ? inverse(rest) : rest);
  return std::abs(x) - 1;
}

/// Leaves out generators that were eliminated, and so occur nowhere.
void renumber(Followed& f, const std::vector<bool>& eliminated) {
  std::vector<int> number(eliminated.size(), 0);
  int count = 0;
  for (std::size_t g = 0; g < eliminated.size(); ++g)
    if (!eliminated[g]) number[g] = ++count;
  const auto renamed = [&number](Word& word) {
    for (int& x : word)
      x = x > 0 ? number[static_cast<std::size_t>(x - 1)] : -number[static_cast<std::size_t>(-x - 1)];
  };
  for (Word& word : f.group.relators) renamed(word);
  for (Word& word : f.words) renamed(word);
  f.group.generators = count;
}

/// A short presentation of the same group.
Followed shortened(Followed f, const Progress& progress) {
  f = [&f] {
    const algebra::Renamed same = algebra::unchanged(f.group);
    return Followed{same.presentation, f.words};
  }();
  std::vector<bool> eliminated(static_cast<std::size_t>(f.group.generators), false);
  for (int gone = eliminate(f); gone >= 0; gone = eliminate(f)) {
    progress.step("the group of a side");
    eliminated[static_cast<std::size_t>(gone)] = true;
  }
  renumber(f, eliminated);
  const algebra::Renamed less = algebra::shortest(f.group, progress);
  for (Word& word : f.words) {
    algebra::Renamed one{f.group, {word}};
    word = substituted(one, less.image).image.front();
  }
  f.group = less.presentation;
  return f;
}

std::vector<std::pair<Word, Word>> all_pairs(int generators) {
  std::vector<std::pair<Word, Word>> pairs;
  for (int a = 1; a <= generators; ++a)
    for (int b = 1; b < a; ++b) pairs.push_back({{b}, {a}});
  return pairs;
}

std::string seen_in(const Quotient& quotient) {
  if (quotient.cover) return "in permutations of " + std::to_string(quotient.cover->degree) + " sheets";
  return "in the first homology modulo " + std::to_string(quotient.modulus);
}

/// The sentence that shows some generator of the group not to be 1; empty if none does.
std::string not_trivial(const Presentation& group, const ReasonOptions& options, const Progress& progress) {
  const algebra::AbelianGroup homology = algebra::abelianized(group);
  if (!homology.is_trivial()) return "first homology " + homology.str();
  std::vector<Claim> claims;
  for (int g = 1; g <= group.generators; ++g) {
    Claim claim;
    claim.not_one = {{g}};
    claims.push_back(claim);
  }
  const auto proved = first_proved(claims, group, options.degree, options.cover_steps, progress);
  return proved && proved->quotient ? "a group that is not trivial, " + seen_in(*proved->quotient) : "";
}

Word times(const Word& x, int p, const Word& y, int q) {
  Word word;
  for (const auto& [of, n] : {std::pair(x, p), std::pair(y, q)})
    for (int k = 0; k < std::abs(n); ++k) {
      const Word next = n > 0 ? of : inverse(of);
      word.insert(word.end(), next.begin(), next.end());
    }
  return algebra::freely_reduced(word);
}

int rank_with(Presentation group, const std::vector<Word>& killed) {
  group.relators.insert(group.relators.end(), killed.begin(), killed.end());
  return algebra::abelianized(group).rank();
}

/// A slope of the torus, a product of its two generators, that bounds rationally on this side; nothing if
/// none does or none is short. Found modulo a prime, believed over the integers.
std::optional<Word> slope_that_bounds(const Followed& side) {
  constexpr int prime = 10'007;
  constexpr int most = 40;
  Span relations(side.group.generators, prime);
  for (const Word& relator : side.group.relators) relations.add(relations.vector_of(relator));
  const int rank = rank_with(side.group, {});
  for (int size = 1; size <= most; ++size)
    for (int p = 0; p <= size; ++p)
      for (int q = -size; q <= size; ++q) {
        if (std::max(p, std::abs(q)) != size || std::gcd(p, q) != 1) continue;
        const Word slope = times(side.words[0], p, side.words[1], q);
        Span with = relations;
        if (!with.add(with.vector_of(slope)) && rank_with(side.group, {slope}) == rank) return slope;
      }
  return std::nullopt;
}

/// The sentence that shows the torus to be incompressible on this side: a compressing disk would have a
/// boundary that is 1 in the group, thus the one slope that bounds. Empty if it is not shown.
std::string incompressible(const Followed& side, const ReasonOptions& options, const Progress& progress) {
  if (rank_with(side.group, {}) - rank_with(side.group, side.words) == 2)
    return "incompressible: no slope bounds";
  const auto slope = slope_that_bounds(side);
  if (!slope) return {};
  Claim claim;
  claim.not_one = {*slope};
  const auto proved = first_proved({claim}, side.group, options.degree, options.cover_steps, progress);
  if (!proved || !proved->quotient) return {};
  return "incompressible: the slope that bounds is not 1, " + seen_in(*proved->quotient);
}

/// The sentence that shows this side to be no product of the torus with an interval.
std::string no_product(const Side& side, const Skeleton& skeleton, const Followed& group,
                       const ReasonOptions& options, const Progress& progress) {
  if (side.boundary.empty()) return "no cusp";
  if (side.boundary.size() > 1 || skeleton.link(side.boundary.front()).euler != 0)
    return "other boundary than a cusp";
  Claim claim;
  claim.one_not_commuting = {all_pairs(group.group.generators)};
  const auto proved = first_proved({claim}, group.group, options.degree, options.cover_steps, progress);
  if (!proved || !proved->quotient) return {};
  return "no product: the group is not abelian, " + seen_in(*proved->quotient);
}

Reason with_surface(Kind kind, std::string text, std::string theorem, const Triangulation& tri,
                    const Coordinates& coordinates, const SurfaceShape& shape) {
  Reason reason;
  reason.kind = kind;
  reason.text = std::move(text);
  reason.theorem = std::move(theorem);
  SurfaceEvidence evidence;
  evidence.triangulation = signature(tri);
  evidence.coordinates = coordinates;
  evidence.euler = shape.euler;
  evidence.orientable = shape.two_sided; // the manifold is
  evidence.separating = shape.separating;
  reason.surface = std::move(evidence);
  return reason;
}

std::optional<Reason> of_sphere(const CutOpen& cut, const Triangulation& tri, const Coordinates& coordinates,
                                const ReasonOptions& options, const Progress& progress) {
  Reason reason =
      with_surface(Kind::essential_sphere, "a normal sphere has no ball on either side",
                   "every sphere in a hyperbolic manifold bounds a ball", tri, coordinates, cut.shape());
  for (const Side& side : cut.sides()) {
    std::string why = side.boundary.empty()
                          ? not_trivial(shortened({side.group, {}}, progress).group, options, progress)
                          : "a boundary component";
    if (why.empty()) return std::nullopt;
    reason.surface->sides.push_back(std::move(why));
  }
  return reason;
}

std::optional<Reason> of_torus(const CutOpen& cut, const Triangulation& tri, const Skeleton& skeleton,
                               const Coordinates& coordinates, const ReasonOptions& options,
                               const Progress& progress) {
  Reason reason =
      with_surface(Kind::essential_torus, "a normal torus is incompressible and parallel to no cusp",
                   "every incompressible torus in a hyperbolic manifold is parallel to a cusp", tri,
                   coordinates, cut.shape());
  for (const Side& side : cut.sides()) {
    if (side.loops.size() != 2) return std::nullopt;
    const Followed group = shortened({side.group, side.loops}, progress);
    const std::string closed = incompressible(group, options, progress);
    if (closed.empty()) return std::nullopt;
    const std::string other = no_product(side, skeleton, group, options, progress);
    if (other.empty()) return std::nullopt;
    std::string& said = reason.surface->sides.emplace_back(closed);
    said.append("; ").append(other);
  }
  return reason;
}

constexpr long long most_pieces = 2000;

} // namespace

std::optional<Reason> reason_of_surface(const Triangulation& tri, const Coordinates& coordinates,
                                        const ReasonOptions& options, const Progress& progress) {
  if (std::accumulate(coordinates.begin(), coordinates.end(), 0LL) > most_pieces) return std::nullopt;
  const Skeleton skeleton(tri);
  const CutOpen cut(tri, skeleton, coordinates);
  const SurfaceShape& shape = cut.shape();
  if (!shape.connected || shape.euler < 0) return std::nullopt;
  if (shape.euler == 1)
    return with_surface(Kind::projective_plane, "a normal surface is a projective plane",
                        "an orientable hyperbolic manifold holds no projective plane", tri, coordinates,
                        shape);
  if (shape.euler == 0 && !shape.two_sided)
    return with_surface(Kind::klein_bottle, "a normal surface is a Klein bottle",
                        "an orientable hyperbolic manifold holds no Klein bottle", tri, coordinates, shape);
  if (!shape.separating)
    return with_surface(
        Kind::nonseparating,
        std::string("a normal ") + (shape.euler == 2 ? "sphere" : "torus") + " does not separate",
        "spheres and tori in an orientable hyperbolic manifold separate it", tri, coordinates, shape);
  return shape.euler == 2 ? of_sphere(cut, tri, coordinates, options, progress)
                          : of_torus(cut, tri, skeleton, coordinates, options, progress);
}

std::optional<Reason> reason_of_surfaces(const Triangulation& given, const ReasonOptions& options,
                                         const Progress& progress) {
  if (given.size() > options.most_tetrahedra || Skeleton(given).has_boundary_faces()) return std::nullopt;
  // As its signature labels it: whoever checks the surface reads it from there.
  const Triangulation tri = from_signature(signature(given));
  const auto surfaces = vertex_surfaces(tri, options.surface_steps, progress);
  if (!surfaces) return std::nullopt;
  for (const Coordinates& coordinates : *surfaces)
    if (auto reason = reason_of_surface(tri, coordinates, options, progress)) return reason;
  return std::nullopt;
}

} // namespace tetrarch::reasons
