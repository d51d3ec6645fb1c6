// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/flips.hpp"

#include "tetrarch/core/random.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/predicates.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tetrarch::canonical {
namespace {

using numeric::Sign;
using numeric::sign_beyond;

/// A concave face, seen from a tetrahedron that is not flat.
template <class Scalar>
struct Concave {
  TetFace face;
  Across<Scalar> across;
  Scalar drop; ///< tilt times cone volume: what its move adds to the sum of cone volumes
};

/// A move, the inner product of the edge that it makes between corners p and q (p == q: none), and which of
/// the new tetrahedra are flat.
template <class Scalar>
struct Flip {
  moves::Ball ball;
  int p = 0;
  int q = 0;
  Scalar product{0};
  std::array<bool, 3> flat{};
};

template <class Scalar>
class Flipper {
public:
  Flipper(Decorated<Scalar>& m, const FlipOptions& options)
      : m_(m), options_(options), random_(options.seed) {}

  Flips run(const Progress& progress) {
    Flips flips;
    while (true) {
      progress.step("canonical decomposition");
      std::vector<Concave<Scalar>> concave = concave_faces();
      if (options_.seed != 0) shuffle(concave);
      if (concave.empty()) {
        flips.end = std::find(m_.flat.begin(), m_.flat.end(), true) == m_.flat.end() ? Flips::End::convex
                                                                                     : Flips::End::stuck;
        return flips;
      }
      const auto [at, flip] = first_flip(concave);
      if (!flip) return flips;
      if (flips.moves == options_.most_moves) {
        flips.end = Flips::End::exhausted;
        return flips;
      }
      ++flips.moves;
      flips.path.push_back(flip->ball);
      for (const bool flat : flip->flat) flips.flat_tets += flat;
      if (!make(*flip, concave[at].drop)) {
        flips.end = Flips::End::inexact;
        return flips;
      }
    }
  }

private:
  /// Those that stick out most come first.
  std::vector<Concave<Scalar>> concave_faces() const {
    std::vector<Concave<Scalar>> found;
    for (int t = 0; t < m_.tri.size(); ++t) {
      if (m_.is_flat(t)) continue;
      for (int f = 0; f < 4; ++f) {
        const Gluing g = m_.tri.gluing({t, f});
        const bool seen = g.tet < t || (g.tet == t && g.perm[f] < f);
        if (seen && !m_.is_flat(g.tet)) continue; // each face once
        Across<Scalar> across = look_across(m_, {t, f});
        if (sign_beyond(across.tilt, options_.margin) != Sign::negative) continue;
        const Scalar drop = across.tilt * cone_volume(m_, t);
        found.push_back({{t, f}, std::move(across), drop});
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.drop < b.drop; });
    return found;
  }

  void shuffle(std::vector<Concave<Scalar>>& faces) {
    for (int k = static_cast<int>(faces.size()) - 1; k > 0; --k)
      std::swap(faces[k], faces[random_.below(k + 1)]);
  }

  std::pair<std::size_t, std::optional<Flip<Scalar>>>
  first_flip(const std::vector<Concave<Scalar>>& concave) const {
    for (std::size_t k = 0; k < concave.size(); ++k)
      if (auto flip = flip_at(concave[k])) return {k, std::move(flip)};
    return {0, std::nullopt};
  }

  std::optional<Flip<Scalar>> flip_at(const Concave<Scalar>& concave) const {
    const auto& shared = face_vertex[concave.face.face];
    std::array<Sign, 3> sign{};
    for (int c = 0; c < 3; ++c) sign[c] = sign_beyond(concave.across.a[shared[c]], options_.margin);
    const auto positive = std::count(sign.begin(), sign.end(), Sign::positive);
    if (positive == 2)
      for (int c = 0; c < 3; ++c)
        if (sign[c] != Sign::positive)
          if (auto flip = three_two(concave.face, c)) return flip;
    if (std::count(sign.begin(), sign.end(), Sign::negative) > 0) return std::nullopt;
    return two_three(concave, sign);
  }

  /// At the face's edge opposite its corner c.
  std::optional<Flip<Scalar>> three_two(TetFace f, int c) const {
    const auto& shared = face_vertex[f.face];
    auto ball = moves::three_two_ball(m_.tri, {f.tet, shared[(c + 1) % 3], shared[(c + 2) % 3]});
    if (!std::holds_alternative<moves::Ball>(ball)) return std::nullopt;
    return Flip<Scalar>{std::get<moves::Ball>(std::move(ball)), 0, 0, Scalar(0), {}};
  }

  std::optional<Flip<Scalar>> two_three(const Concave<Scalar>& concave,
                                        const std::array<Sign, 3>& sign) const {
    if (m_.is_flat(m_.tri.gluing(concave.face).tet)) return std::nullopt;
    auto ball = moves::two_three_ball(m_.tri, concave.face);
    if (!std::holds_alternative<moves::Ball>(ball)) return std::nullopt;
    // The new tetrahedra omit the corners 2, 0, 1 of the face.
    return Flip<Scalar>{std::get<moves::Ball>(std::move(ball)),
                        3,
                        4,
                        product_across(m_, concave.face, concave.across),
                        {sign[2] != Sign::positive, sign[0] != Sign::positive, sign[1] != Sign::positive}};
  }

  /// False if the sum of cone volumes did not change by `drop`.
  bool make(const Flip<Scalar>& flip, const Scalar& drop) {
    using std::abs;
    Scalar before(0);
    for (const moves::Placed& placed : flip.ball.before) before += cone_volume(m_, placed.tet);
    m_ = move(m_, flip.ball, flip.p, flip.q, flip.product);
    const int first_new = m_.tri.size() - static_cast<int>(flip.ball.after.size());
    Scalar after(0);
    for (int k = 0; k < static_cast<int>(flip.ball.after.size()); ++k) {
      m_.flat[first_new + k] = flip.flat[k];
      after += cone_volume(m_, first_new + k);
    }
    // A coordinate within the margin was taken for 0, and the root of a determinant doubles the digits lost.
    using std::sqrt;
    return abs(Scalar(after - before - drop)) <= sqrt(options_.margin) * before;
  }

  Decorated<Scalar>& m_;
  FlipOptions options_;
  SplitMix64 random_;
};

} // namespace

template <class Scalar>
Flips flip_to_hull(Decorated<Scalar>& m, const FlipOptions& options, const Progress& progress) {
  if (m.flat.empty()) m.flat.assign(static_cast<std::size_t>(m.tri.size()), false);
  return Flipper<Scalar>(m, options).run(progress);
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Flips flip_to_hull(Decorated<Scalar>&, const FlipOptions&, const Progress&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::canonical
