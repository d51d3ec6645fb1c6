// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/canonize.hpp"

#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/real50.hpp"

#include <optional>
#include <random>
#include <utility>

namespace tetrarch::canonical {
namespace {

using hyperbolic::Hyperbolization;
using hyperbolic::Real50;

/// Below this a 60-digit tilt counts as zero: solutions are refined to 1e-45, conditioning takes a few
/// digits.
constexpr double high_precision_margin = 1e-30;

/// The sign of x where |x| exceeds the margin, else 0.
template <class Scalar>
int sign_beyond(const Scalar& x, double margin) {
  return x > margin ? 1 : x < -margin ? -1 : 0;
}

template <class Scalar>
Decorated<Scalar> decorate(const Triangulation& tri, const Hyperbolization<Scalar>& structure) {
  const Skeleton skeleton(tri);
  const auto types = hyperbolic::vertex_types(skeleton);
  Decorated<Scalar> m{tri, {}};
  std::vector<int> vertex;
  for (int t = 0; t < tri.size(); ++t) {
    m.gram.push_back(hyperbolic::gram_matrix(hyperbolic::lengths_at(skeleton, structure.lengths, t),
                                             hyperbolic::types_at(skeleton, types, t)));
    for (int v = 0; v < 4; ++v) vertex.push_back(skeleton.vertex({t, v}).value);
  }
  set_cusp_areas(m, vertex, skeleton.vertex_count(), Scalar(cusp_area));
  return m;
}

/// The structure in 60 digits, solved on this triangulation from the start.
std::optional<Hyperbolization<Real50>> solve_precisely(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  const auto structure = hyperbolic::hyperbolize(tri, skeleton);
  if (structure.outcome != hyperbolic::Outcome::geometric) return std::nullopt;
  return hyperbolic::refine<Real50>(skeleton, structure);
}

/// Which geometric move mends a concave face, with the corners and the inner product of the edge that it
/// makes.
template <class Scalar>
struct Mend {
  moves::Ball ball;
  int p = 0;
  int q = 0;
  Scalar product{0};
};

/// The move for the concave face f, if there is one. `doubtful` is set where a sign that matters is within
/// the margin.
template <class Scalar>
std::optional<Mend<Scalar>> mend(const Decorated<Scalar>& m, TetFace f, const Across<Scalar>& across,
                                 double margin, bool& doubtful) {
  int negative = 0;
  int zero = 0;
  int odd_one = -1;
  for (const int k : face_vertex[f.face]) {
    const int s = sign_beyond(across.a[k], margin);
    if (s > 0) continue;
    odd_one = k;
    (s < 0 ? negative : zero) += 1;
  }
  if (negative + zero == 0) {
    auto ball = moves::two_three_ball(m.tri, f);
    if (!std::holds_alternative<moves::Ball>(ball)) return std::nullopt;
    return Mend<Scalar>{std::get<moves::Ball>(std::move(ball)), 3, 4, product_across(m, f, across)};
  }
  if (negative + zero > 1) return std::nullopt;
  // The far vertex is seen past the edge of the face that lies opposite the odd one.
  std::array<int, 2> ends{};
  int count = 0;
  for (const int v : face_vertex[f.face])
    if (v != odd_one) ends[count++] = v;
  const DirectedTetEdge edge{f.tet, ends[0], ends[1]};
  if (negative == 1) {
    auto ball = moves::three_two_ball(m.tri, edge);
    if (!std::holds_alternative<moves::Ball>(ball)) return std::nullopt;
    return Mend<Scalar>{std::get<moves::Ball>(std::move(ball)), 0, 0, Scalar(0)};
  }
  doubtful = true; // the coordinate is zero, as far as can be seen
  auto ball = moves::four_four_ball(m.tri, edge, 0);
  if (!std::holds_alternative<moves::Ball>(ball)) return std::nullopt;
  const int corner = std::get<moves::Ball>(ball).before[0].corners[f.face];
  if (corner % 2 == 1) ball = moves::four_four_ball(m.tri, edge, 1);
  return Mend<Scalar>{std::get<moves::Ball>(std::move(ball)), corner, (corner + 2) % 4,
                      product_across(m, f, across)};
}

struct Walked {
  bool done = false;     ///< no concave face is left
  bool doubtful = false; ///< a sign within the margin played a part
};

/// Mends concave faces until none is left, none can be mended, or the budget is spent.
template <class Scalar>
Walked mend_all(Decorated<Scalar>& m, double margin, int& budget, const Progress& progress) {
  Walked walked;
  bool doubtful_move = false;
  while (true) {
    progress.step("canonical decomposition");
    walked.doubtful = doubtful_move;
    bool concave = false;
    std::optional<Mend<Scalar>> next;
    for (int t = 0; t < m.tri.size() && !next; ++t) {
      for (int f = 0; f < 4 && !next; ++f) {
        const Gluing g = m.tri.gluing({t, f});
        if (g.tet < t || (g.tet == t && g.perm[f] < f)) continue; // each face once
        const Across<Scalar> across = look_across(m, {t, f});
        const int sign = sign_beyond(across.tilt, margin);
        walked.doubtful |= sign == 0;
        if (sign >= 0 || g.tet == t) continue;
        concave = true;
        next = mend(m, {t, f}, across, margin, doubtful_move);
      }
    }
    if (!next) {
      walked.done = !concave;
      return walked;
    }
    if (budget-- <= 0) return walked;
    m = move(m, next->ball, next->p, next->q, next->product);
  }
}

/// A few random 2-3 moves, each followed by whatever 3-2 moves chance picks: another triangulation of the
/// same manifold.
Triangulation shaken(Triangulation tri, std::mt19937_64& random) {
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  const int wanted = 2 + below(4);
  for (int made = 0, tries = 0; made < wanted && tries < 200; ++tries) {
    const auto ball = moves::two_three_ball(tri, {below(tri.size()), below(4)});
    if (!std::holds_alternative<moves::Ball>(ball)) continue;
    tri = moves::replace(tri, std::get<moves::Ball>(ball)).tri;
    ++made;
  }
  for (int tries = 0; tries < 40 * wanted; ++tries) {
    const int i = below(4);
    const auto ball = moves::three_two_ball(tri, {below(tri.size()), i, (i + 1 + below(3)) % 4});
    if (std::holds_alternative<moves::Ball>(ball)) tri = moves::replace(tri, std::get<moves::Ball>(ball)).tri;
  }
  return tri;
}

/// Reads tilts off the finished decomposition: flat faces and the smallest tilt that is none.
template <class Scalar>
void record_faces(const Decorated<Scalar>& m, double margin, Canonical& out) {
  out.flat.assign(static_cast<std::size_t>(m.tri.size()), {});
  out.smallest_tilt = 1e300;
  for (int t = 0; t < m.tri.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      using std::abs;
      const Scalar tilt = look_across(m, {t, f}).tilt;
      out.flat[t][f] = sign_beyond(tilt, margin) == 0;
      out.has_flat_faces |= out.flat[t][f];
      if (!out.flat[t][f]) out.smallest_tilt = std::min(out.smallest_tilt, static_cast<double>(abs(tilt)));
    }
  }
}

/// Cells, canonical triangulation and signature of a finished decomposition.
void name_cells(Canonical& out) {
  if (!out.has_flat_faces) {
    out.cells.assign(static_cast<std::size_t>(out.triangulation.size()), "tetrahedron");
    out.canonical_triangulation = out.triangulation;
  } else {
    CellDecomposition parts = cell_decomposition(out.triangulation, Skeleton(out.triangulation), out.flat);
    for (const Cell& cell : parts.cells) out.cells.push_back(cell.name());
    out.canonical_triangulation = std::move(parts.coned);
  }
  out.isometry_signature = signature(out.canonical_triangulation);
}

/// One attempt from one solved triangulation: in double precision, and in high precision where a sign is in
/// doubt.
bool attempt(const Triangulation& tri, const Hyperbolization<double>& structure,
             const CanonizeOptions& options, const Progress& progress, Canonical& out) {
  Decorated<double> m = decorate(tri, structure);
  int budget = options.move_budget;
  Walked walked = mend_all(m, options.sign_margin, budget, progress);
  out.triangulation = m.tri;
  if (!walked.doubtful) {
    if (walked.done) record_faces(m, options.sign_margin, out);
  } else if (const auto solved = solve_precisely(m.tri)) {
    Decorated<Real50> precise = decorate(m.tri, *solved);
    walked = mend_all(precise, high_precision_margin, budget, progress);
    out.triangulation = precise.tri;
    if (walked.done) record_faces(precise, high_precision_margin, out);
  } else {
    walked.done = false;
  }
  out.geometric_moves += options.move_budget - budget;
  return walked.done;
}

} // namespace

Canonical canonize(const Triangulation& tri, const Hyperbolization<double>& structure,
                   const CanonizeOptions& options, const Progress& progress) {
  if (structure.outcome != hyperbolic::Outcome::geometric)
    throw PreconditionError("only a solved structure has a canonical decomposition");
  Canonical out;
  bool done = attempt(tri, structure, options, progress, out);
  std::mt19937_64 random(options.seed);
  Triangulation last = tri; // the walk goes on from the last geometric triangulation that has not grown much
  const int largest = tri.size() + 8;
  while (!done && out.restarts < options.restarts) {
    ++out.restarts;
    progress.step("changing the triangulation");
    Triangulation other = shaken(last, random);
    const auto solved = hyperbolic::hyperbolize(other, Skeleton(other));
    if (solved.outcome != hyperbolic::Outcome::geometric) continue;
    done = attempt(other, solved, options, progress, out);
    if (other.size() <= largest) last = std::move(other);
  }
  if (!done) return out;
  out.outcome = Canonical::Outcome::canonical;
  name_cells(out);
  return out;
}

std::vector<Isomorphism> isometry_group(const Canonical& canonical) {
  return automorphisms(canonical.canonical_triangulation);
}

IsometryAnswer compare(const Canonical& a, const Canonical& b) {
  using Verdict = IsometryAnswer::Verdict;
  for (const Canonical* m : {&a, &b}) {
    if (m->outcome != Canonical::Outcome::canonical)
      return {Verdict::undecided, "no canonical decomposition was found within the budget", {}};
    if (m->has_flat_faces)
      return {Verdict::undecided,
              "a face of the canonical decomposition is flat to 30 digits, which is not a proof",
              {}};
  }
  auto isometry = find_isomorphism(a.canonical_triangulation, b.canonical_triangulation);
  if (isometry)
    return {Verdict::isometric, "the canonical triangulations are isomorphic", *std::move(isometry)};
  return {Verdict::not_isometric, "the canonical triangulations differ", {}};
}

} // namespace tetrarch::canonical
