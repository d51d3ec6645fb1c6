// SPDX-License-Identifier: GPL-2.0-or-later
#include "quotients.hpp"
#include "surface_reason.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "words.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>

namespace tetrarch::reasons {
namespace {

using algebra::Presentation;
using algebra::Word;

/// The first rotation, by letters, of the cyclic word or of its inverse.
Word standard(const Word& word) {
  Word best = word;
  for (Word turned : {word, inverse(word)})
    for (std::size_t k = 0; k < word.size(); ++k) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      best = std::min(best, turned);
    }
  return best;
}

std::vector<Word> standard(const std::vector<Word>& relators) {
  std::vector<Word> all;
  all.reserve(relators.size());
  for (const Word& relator : relators) all.push_back(standard(algebra::cyclically_reduced(relator)));
  std::sort(all.begin(), all.end());
  return all;
}

bool has_letters_of(const Presentation& group, const Word& word) {
  return std::all_of(word.begin(), word.end(),
                     [&group](int letter) { return letter != 0 && std::abs(letter) <= group.generators; });
}

/// Whether n words generate the free group of rank n, which makes them the images of an automorphism: draw
/// them as loops at one point and fold edges of one letter that leave one point or reach one point, until
/// none are left; what remains is to be one point (Stallings).
class Folding {
public:
  bool generates(const std::vector<Word>& words, int rank) {
    points_ = 1;
    for (const Word& word : words) {
      int at = 0;
      for (std::size_t k = 0; k < word.size(); ++k) {
        const int to = k + 1 == word.size() ? 0 : points_++;
        edges_.push_back(word[k] > 0 ? Edge{at, word[k], to} : Edge{to, -word[k], at});
        at = to;
      }
    }
    root_.resize(static_cast<std::size_t>(points_));
    std::iota(root_.begin(), root_.end(), 0);
    while (fold()) {
    }
    std::vector<int> letters;
    for (const Edge& edge : edges_) {
      if (find(edge.from) != find(0) || find(edge.to) != find(0)) return false;
      letters.push_back(edge.letter);
    }
    std::sort(letters.begin(), letters.end());
    letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
    return static_cast<int>(letters.size()) == rank;
  }

private:
  struct Edge {
    int from, letter, to;
  };
  int find(int point) const {
    while (root_[static_cast<std::size_t>(point)] != point) point = root_[static_cast<std::size_t>(point)];
    return point;
  }
  bool join(int a, int b) {
    if (find(a) == find(b)) return false;
    root_[static_cast<std::size_t>(find(a))] = find(b);
    return true;
  }
  bool fold() {
    std::map<std::pair<int, int>, int> out, in;
    bool folded = false;
    for (const Edge& edge : edges_) {
      folded |= join(out.try_emplace({find(edge.from), edge.letter}, edge.to).first->second, edge.to);
      folded |= join(in.try_emplace({find(edge.to), edge.letter}, edge.from).first->second, edge.from);
    }
    return folded;
  }

  int points_ = 0;
  std::vector<Edge> edges_;
  std::vector<int> root_;
};

std::string wrong_with_presentation(const GroupEvidence& seen) {
  const Triangulation tri = from_signature(seen.triangulation);
  const Presentation read = algebra::simplified(algebra::dual_presentation(tri, Skeleton(tri)).presentation);
  if (read != seen.from) return "the presentation is not that of the triangulation's group";
  if (static_cast<int>(seen.image.size()) != seen.from.generators ||
      seen.shown.generators != seen.from.generators)
    return "an automorphism has an image of each generator";
  for (const std::vector<Word>* words : {&seen.image, &seen.shown.relators, &seen.elements})
    for (const Word& word : *words)
      if (!has_letters_of(seen.shown, word)) return "a letter names no generator";
  if (!Folding().generates(seen.image, seen.from.generators))
    return "the images do not generate the free group";
  if (standard(substituted(algebra::unchanged(seen.from), seen.image).presentation.relators) !=
      standard(seen.shown.relators))
    return "the relators are not those that the automorphism makes";
  return {};
}

bool says_the_same(const Claim& claim, Kind kind, const GroupEvidence& seen) {
  return claim.kind == kind && claim.generators == seen.generators && claim.elements == seen.elements &&
         claim.p == seen.p && claim.q == seen.q;
}

std::string wrong_with_group(const Reason& reason) {
  const GroupEvidence& seen = *reason.group;
  if (std::string wrong = wrong_with_presentation(seen); !wrong.empty()) return wrong;
  const Triangulation tri = from_signature(seen.triangulation);
  const Skeleton skeleton(tri);
  std::vector<Claim> claims = splittings(seen.shown);
  if (skeleton.is_orientable()) {
    bool cusps = false;
    for (const VertexId v : all<VertexId>(skeleton.vertex_count())) cusps |= skeleton.link(v).euler == 0;
    for (Claim& claim : relations(seen.shown, cusps || skeleton.has_boundary_faces()))
      claims.push_back(std::move(claim));
  }
  const bool covered = !seen.quotient || !seen.quotient->cover ||
                       static_cast<int>(seen.quotient->cover->sheet.size()) == seen.shown.generators;
  if (!covered) return "the finite group has no image of some generator";
  bool pattern = false;
  for (const Claim& claim : claims) {
    if (!says_the_same(claim, reason.kind, seen)) continue;
    pattern = true;
    if (seen.quotient ? shows(*seen.quotient, seen.shown, claim) : claim.is_proof()) return {};
  }
  return pattern ? "the finite group does not show what it should" : "the relators do not have that pattern";
}

/// The surface is cut along again, with generous budgets.
std::string wrong_with_surface(const Reason& reason) {
  const SurfaceEvidence& seen = *reason.surface;
  const Triangulation tri = from_signature(seen.triangulation);
  const Skeleton skeleton(tri);
  if (!skeleton.is_orientable() || skeleton.has_boundary_faces() || !skeleton.is_connected())
    return "the triangulation is not one of an orientable manifold with ideal vertices";
  if (!is_normal_surface(tri, seen.coordinates)) return "the coordinates are no normal surface";
  const auto again = reason_of_surface(tri, seen.coordinates, {}, {});
  if (!again) return "the surface proves nothing";
  if (again->kind != reason.kind || again->surface->euler != seen.euler ||
      again->surface->orientable != seen.orientable || again->surface->separating != seen.separating)
    return "the surface is another one";
  return {};
}

} // namespace

std::string what_is_wrong(const Reason& reason) {
  if (reason.group) return wrong_with_group(reason);
  if (reason.surface) return wrong_with_surface(reason);
  return {};
}

} // namespace tetrarch::reasons
