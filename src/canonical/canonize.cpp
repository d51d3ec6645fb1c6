// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/canonize.hpp"

#include "tetrarch/canonical/flips.hpp"
#include "tetrarch/canonical/hull.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/marked_isomorphism.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace tetrarch::canonical {
namespace {

using hyperbolic::Hyperbolization;
using numeric::Real50;

/// Below this a 60-digit tilt counts as zero: solutions are refined to 1e-45, conditioning takes a few
/// digits.
constexpr double high_precision_margin = 1e-30;
/// Flips in so many random orders are tried where the hull is far to seek: half of those that got stuck come
/// through.
constexpr std::uint64_t random_orders = 40;

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

/// What the tilts of a solved triangulation say of its faces.
struct Faces {
  FlatFaces flat;
  bool any_flat = false;
  bool any_concave = false;
  double smallest_tilt = 1e300; ///< of those that are not flat
};

template <class Scalar>
Faces faces_of(const Decorated<Scalar>& m, double margin) {
  Faces faces;
  faces.flat.assign(static_cast<std::size_t>(m.tri.size()), {});
  for (int t = 0; t < m.tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const auto tilt = static_cast<double>(look_across(m, {t, f}).tilt);
      const bool flat = std::abs(tilt) <= margin;
      faces.flat[t][f] = flat;
      faces.any_flat |= flat;
      if (flat) continue;
      faces.any_concave |= tilt < 0;
      faces.smallest_tilt = std::min(faces.smallest_tilt, std::abs(tilt));
    }
  return faces;
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

class Canonizer {
public:
  Canonizer(const CanonizeOptions& options, const Progress& progress)
      : options_(options), progress_(progress) {}

  Canonical run(const Triangulation& tri, const Hyperbolization<double>& structure) {
    bool done = attempt(tri, structure);
    std::mt19937_64 random(options_.seed);
    Triangulation last = tri; // the walk goes on from the last geometric one that has not grown much
    const int largest = tri.size() + 8;
    while (!done && out_.restarts < options_.restarts) {
      ++out_.restarts;
      progress_.step("changing the triangulation");
      Triangulation other = shaken(last, random);
      const auto solved = hyperbolic::hyperbolize(other, Skeleton(other));
      if (solved.outcome != hyperbolic::Outcome::geometric) continue;
      done = attempt(other, solved);
      if (other.size() <= largest) last = std::move(other);
    }
    if (done) {
      out_.outcome = Canonical::Outcome::canonical;
      name_cells(out_);
    }
    return std::move(out_);
  }

private:
  /// From one solved triangulation: by flips, or straight to the hull where they get stuck; in double
  /// precision, in high precision where that loses its way.
  bool attempt(const Triangulation& tri, const Hyperbolization<double>& structure) {
    const Skeleton skeleton(tri);
    if (attempt_with(decorate(tri, skeleton, structure.lengths), options_.sign_margin)) return true;
    const auto refined = hyperbolic::refine<Real50>(skeleton, structure, progress_);
    return attempt_with(decorate(tri, skeleton, refined.lengths), high_precision_margin);
  }

  template <class Scalar>
  bool attempt_with(const Decorated<Scalar>& m, double margin) {
    out_.by_hull = false;
    Decorated<Scalar> low =
        m; // what flips lead to; where they get stuck it is near the hull, and its tiles wide
    if (try_flips(low, margin, 0)) return true;
    if (std::find(low.flat.begin(), low.flat.end(), true) != low.flat.end()) low = m;
    HullOptions quick;
    quick.margin = margin;
    if (try_hull(low, quick)) return true;
    for (std::uint64_t seed = 1; seed <= random_orders; ++seed) {
      Decorated<Scalar> other = m;
      if (try_flips(other, margin, seed)) return true;
    }
    return try_hull(low, patient_hull_options(margin));
  }

  template <class Scalar>
  bool try_flips(Decorated<Scalar>& m, double margin, std::uint64_t seed) {
    return flip(m, margin, seed) && settle(m.tri, solve_again(to_double(m)));
  }

  template <class Scalar>
  bool try_hull(const Decorated<Scalar>& m, const HullOptions& how) {
    const auto cells = direct_hull(m, how, progress_);
    if (!cells) return false;
    const std::optional<Triangulation> tri = subdivision(*cells);
    if (!tri || !settle(*tri, hyperbolic::hyperbolize(*tri, Skeleton(*tri)))) return false;
    return out_.by_hull = true;
  }

  template <class Scalar>
  bool flip(Decorated<Scalar>& m, double margin, std::uint64_t seed) {
    const Flips flips = flip_to_hull(m, {margin, options_.move_budget, seed}, progress_);
    out_.geometric_moves += flips.moves;
    return flips.end == Flips::End::convex;
  }

  /// Believes the tilts of a structure that was solved anew, and these alone. Where one is within the margin
  /// the decision is made in high precision, with more moves if need be.
  bool settle(const Triangulation& tri, const Hyperbolization<double>& structure, int rounds_left = 3) {
    if (structure.outcome != hyperbolic::Outcome::geometric || rounds_left == 0) return false;
    const Skeleton skeleton(tri);
    const Faces rough = faces_of(decorate(tri, skeleton, structure.lengths), options_.sign_margin);
    if (!rough.any_flat) return record(tri, rough);
    const auto refined = hyperbolic::refine<Real50>(skeleton, structure, progress_);
    Decorated<Real50> precise = decorate(tri, skeleton, refined.lengths);
    const Faces faces = faces_of(precise, high_precision_margin);
    if (!faces.any_concave) return record(tri, faces);
    return flip(precise, high_precision_margin, 0) &&
           settle(precise.tri, solve_again(to_double(precise)), rounds_left - 1);
  }

  static Hyperbolization<double> solve_again(const Decorated<double>& m) {
    const Skeleton skeleton(m.tri);
    auto structure = hyperbolic::hyperbolize_from(edge_lengths(m, skeleton), skeleton);
    if (structure.outcome == hyperbolic::Outcome::geometric) return structure;
    return hyperbolic::hyperbolize(m.tri, skeleton);
  }

  static const Decorated<double>& to_double(const Decorated<double>& m) { return m; }
  static Decorated<double> to_double(const Decorated<Real50>& m) {
    Decorated<double> out{m.tri, {}, m.flat};
    for (const Gram<Real50>& w : m.gram) {
      out.gram.emplace_back();
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) out.gram.back()[i][j] = static_cast<double>(w[i][j]);
    }
    return out;
  }

  bool record(const Triangulation& tri, const Faces& faces) {
    if (faces.any_concave) return false;
    out_.triangulation = tri;
    out_.flat = faces.flat;
    out_.has_flat_faces = faces.any_flat;
    out_.smallest_tilt = faces.smallest_tilt;
    return true;
  }

  CanonizeOptions options_;
  const Progress& progress_;
  Canonical out_;
};

} // namespace

Canonical canonize(const Triangulation& tri, const Hyperbolization<double>& structure,
                   const CanonizeOptions& options, const Progress& progress) {
  if (structure.outcome != hyperbolic::Outcome::geometric)
    throw PreconditionError("only a solved structure has a canonical decomposition");
  return Canonizer(options, progress).run(tri, structure);
}

std::vector<Isomorphism> isometry_group(const Canonical& canonical) {
  const Triangulation& tri = canonical.canonical_triangulation;
  return marked_isomorphisms({tri, canonical.canonical_marks}, {tri, canonical.canonical_marks});
}

const char* to_string(IsometryAnswer::Proof proof) {
  constexpr std::array<const char*, 9> names{"none",  "isomorphism", "boundary", "homology", "volume",
                                             "cells", "structure",   "covers",   "marks"};
  return names[static_cast<std::size_t>(proof)];
}

IsometryAnswer compare(const Canonical& a, const Canonical& b) {
  using Proof = IsometryAnswer::Proof;
  using Verdict = IsometryAnswer::Verdict;
  for (const Canonical* m : {&a, &b})
    if (m->outcome != Canonical::Outcome::canonical)
      return {Verdict::undecided, Proof::none, "no canonical decomposition was found within the budget", {}};
  if (auto isometry = find_marked_isomorphism({a.canonical_triangulation, a.canonical_marks},
                                              {b.canonical_triangulation, b.canonical_marks}))
    return {Verdict::isometric, Proof::isomorphism, "the canonical triangulations are isomorphic",
            *std::move(isometry)};
  for (const Canonical* m : {&a, &b})
    if (!m->proof.certified)
      return {Verdict::undecided,
              Proof::none,
              "the canonical decompositions differ, but one is not proved" +
                  (m->proof.why_not.empty() ? std::string() : ": " + m->proof.why_not),
              {}};
  return {Verdict::not_isometric, Proof::cells, "the canonical triangulations differ", {}};
}

} // namespace tetrarch::canonical
