// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/reasons/reason.hpp"
#include "tetrarch/algebra/group.hpp"

#include "group_reason.hpp"
#include "surface_reason.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/double_cover.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/moves/simplify.hpp"

#include <array>
#include <utility>

namespace tetrarch::reasons {
namespace {

struct Kinds {
  bool cusps = false;
  bool projective_planes = false;
};

Kinds boundary_kinds(const Triangulation& tri, const Skeleton& skeleton) {
  Kinds kinds;
  for (const BoundaryComponent& component : boundary_components(tri, skeleton)) {
    kinds.cusps |= component.type.euler == 0;
    kinds.projective_planes |= component.type.euler == 1;
  }
  return kinds;
}

/// Of the triangulation as its signature labels it: whoever checks the reason reads it from there.
std::optional<Reason> by_group(const Triangulation& given, const ReasonOptions& options,
                               const Progress& progress) {
  if (!options.groups) return std::nullopt;
  const std::string text = signature(given);
  const Triangulation tri = from_signature(text);
  const Skeleton skeleton(tri);
  const algebra::Presentation group =
      algebra::simplified(algebra::dual_presentation(tri, skeleton).presentation, {}, progress);
  const Setting setting{skeleton.is_orientable(), boundary_kinds(tri, skeleton).cusps};
  auto reason = reason_of_group(group, setting, options, progress);
  if (reason) reason->group->triangulation = text;
  return reason;
}

Reason of_projective_plane() {
  Reason reason;
  reason.kind = Kind::projective_plane;
  reason.text = "a component of the boundary is a projective plane";
  reason.theorem = "the group of a hyperbolic manifold has no torsion";
  return reason;
}

/// Of an orientable manifold, or of a manifold as it is.
std::optional<Reason> search(const Triangulation& tri, const ReasonOptions& options,
                             const Progress& progress) {
  if (auto reason = by_group(tri, options, progress)) return reason;
  if (Skeleton(tri).is_orientable())
    if (auto reason = reason_of_surfaces(tri, options, progress)) return reason;
  // Other triangulations present the same group otherwise.
  constexpr int moves_each = 20;
  constexpr int most_changed = 60; // tetrahedra: the groups of larger ones take a second each
  if (tri.size() > most_changed) return std::nullopt;
  SplitMix64 random(options.seed);
  moves::Complex complex(tri);
  for (int k = 0; k < options.changes; ++k) {
    progress.step("reading other triangulations");
    moves::shake(complex, moves_each, random);
    moves::reduce(complex);
    if (auto reason = by_group(complex.triangulation(), options, progress)) return reason;
  }
  return std::nullopt;
}

} // namespace

const char* to_string(Kind kind) {
  constexpr std::array names{
      "cyclic group",  "abelian group", "free product",     "root",         "twice",
      "stable letter", "amalgam",       "torsion",          "common power", "conjugate powers",
      "commuting",     "plane",         "projective plane", "Klein bottle", "not separating",
      "sphere",        "torus"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<Reason> why_not_hyperbolic(const Triangulation& tri, const ReasonOptions& options,
                                         const Progress& progress) {
  const Skeleton skeleton(tri);
  if (tri.size() == 0 || !skeleton.is_connected())
    throw PreconditionError("why_not_hyperbolic: needs a connected manifold");
  if (const auto defects = check(skeleton); !defects.empty())
    throw PreconditionError("why_not_hyperbolic: " + describe(defects.front(), skeleton));
  if (boundary_kinds(tri, skeleton).projective_planes) return of_projective_plane();
  if (auto reason = search(tri, options, progress)) return reason;
  if (skeleton.is_orientable()) return std::nullopt;
  auto reason = search(orientable_double_cover(tri), options, progress);
  if (reason) reason->in_double_cover = true;
  return reason;
}

std::optional<Reason> quick_reason(const Triangulation& simplified, const Triangulation& given,
                                   std::uint64_t seed, const Progress& progress) {
  ReasonOptions quick;
  quick.seed = seed;
  quick.changes = 0;
  quick.most_tetrahedra = 0;
  constexpr int most_given = 10'000;
  auto reason = why_not_hyperbolic(simplified, quick, progress);
  if (!reason && simplified.size() < given.size() && given.size() <= most_given)
    reason = why_not_hyperbolic(given, quick, progress);
  return reason;
}

} // namespace tetrarch::reasons
