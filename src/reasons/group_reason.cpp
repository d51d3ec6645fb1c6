// SPDX-License-Identifier: GPL-2.0-or-later
#include "group_reason.hpp"

#include "quotients.hpp"
#include "tetrarch/algebra/whitehead.hpp"

#include <algorithm>

namespace tetrarch::reasons {
namespace {

using algebra::Presentation;
using algebra::Renamed;
using algebra::Word;
using algebra::word_str;

constexpr const char* splitting =
    "a group that splits over a cyclic group belongs to a manifold with an essential "
    "sphere, disk, annulus or Moebius band";

/// "a^3" with longer words in parentheses.
std::string power_str(const Word& word, int exponent, int generators) {
  std::string text = word_str(word, generators);
  if (exponent == 1) return text;
  return (word.size() > 1 ? "(" + text + ")" : text) + "^" + std::to_string(exponent);
}

std::string listed(const std::vector<int>& generators, int of) {
  std::string text;
  for (const int g : generators) text += (text.empty() ? "" : ", ") + word_str({g + 1}, of);
  return text;
}

/// For each presentation that may be looked at, so many substitutions.
constexpr int twists_each = 10;

struct Sentence {
  std::string text;
  std::string theorem;
};

Sentence splitting_sentence(const Claim& claim, const Presentation& group) {
  const int n = group.generators;
  switch (claim.kind) {
  case Kind::cyclic_group:
    return {group.generators == 0 ? "the group is trivial" : "the group is cyclic",
            "the group of a hyperbolic manifold is not cyclic"};
  case Kind::abelian_group:
    return {"the group is abelian", "the group of a hyperbolic manifold of finite volume is not abelian"};
  case Kind::free_product:
    return {"no relator joins the generators " + listed(claim.generators, n) +
                " to the others: a free product",
            "the group of a hyperbolic manifold with geodesic boundary is no free product"};
  case Kind::root:
    if (claim.p == 0)
      return {"no relator holds the generator " + listed(claim.generators, n) + ": a free product with Z",
              "the group of a hyperbolic manifold with geodesic boundary is no free product"};
    return {"every relator holds the generator " + listed(claim.generators, n) + " in powers of " +
                power_str({claim.generators.front() + 1}, claim.p, n) +
                " only: the group splits over that power",
            splitting};
  case Kind::twice:
    return {"the generator " + listed(claim.generators, n) +
                " occurs twice, in one relator: the group splits over a cyclic group",
            splitting};
  case Kind::stable_letter:
    return {"every relator holds the generator " + listed(claim.generators, n) +
                " only where it conjugates powers of " + word_str(claim.elements[0], n) +
                ": the group splits over a cyclic group",
            splitting};
  default:
    return {"powers of " + word_str(claim.elements[0], n) + " are all that joins the generators " +
                listed(claim.generators, n) + " to the others: the group splits over a cyclic group",
            splitting};
  }
}

Sentence relation_sentence(const Claim& claim, const Presentation& group) {
  const int n = group.generators;
  const auto element = [&](std::size_t k) { return word_str(claim.elements[k], n); };
  switch (claim.kind) {
  case Kind::torsion:
    return {power_str(claim.elements[0], claim.p, n) + " = 1 and " + element(0) + " is not 1: torsion",
            "the group of a hyperbolic manifold has no torsion"};
  case Kind::common_power:
    return {power_str(claim.elements[0], claim.p, n) + " = " + power_str(claim.elements[1], claim.q, n) +
                ", and " + element(0) + " and " + element(1) + " do not commute",
            "in a discrete group of isometries without torsion, elements with a common power commute"};
  case Kind::conjugate_powers:
    return {element(0) + " takes " + power_str(claim.elements[1], claim.p, n) + " to " +
                power_str(claim.elements[1], claim.q, n) +
                (claim.p == claim.q ? ", and the two do not commute" : ", and " + element(1) + " is not 1"),
            "in a discrete group of isometries without torsion, what takes a power of an element to a power "
            "of it "
            "commutes with it"};
  case Kind::commuting:
    return {
        element(1) + " and " + element(2) + " commute with " + element(0) +
            ", which is not 1, and not with each other",
        "in a discrete group of isometries without torsion, elements that commute with the same one commute"};
  default:
    return {element(0) + " and " + element(1) + " commute and generate no cyclic group, and there is no cusp",
            "without cusps, elements of a hyperbolic manifold's group that commute lie in one cyclic group"};
  }
}

bool is_splitting(Kind kind) {
  return kind <= Kind::amalgam;
}

Reason reason_of(const Proved& proved, const Presentation& from, const Renamed& seen) {
  const Sentence sentence = is_splitting(proved.claim.kind)
                                ? splitting_sentence(proved.claim, seen.presentation)
                                : relation_sentence(proved.claim, seen.presentation);
  Reason reason;
  reason.kind = proved.claim.kind;
  reason.text = sentence.text;
  reason.theorem = sentence.theorem;
  GroupEvidence evidence;
  evidence.from = from;
  evidence.image = seen.image;
  evidence.shown = seen.presentation;
  evidence.generators = proved.claim.generators;
  evidence.elements = proved.claim.elements;
  evidence.p = proved.claim.p;
  evidence.q = proved.claim.q;
  evidence.quotient = proved.quotient;
  reason.group = std::move(evidence);
  return reason;
}

} // namespace

std::optional<Reason> reason_of_group(const Presentation& group, const Setting& setting,
                                      const ReasonOptions& options, const Progress& progress) {
  // First what costs next to nothing, in the presentations that people would write.
  const auto split = [&](const Renamed& seen) -> std::optional<Reason> {
    const auto proved = first_proved(splittings(seen.presentation), seen.presentation, 0, 0, progress);
    return proved ? std::optional(reason_of(*proved, group, seen)) : std::nullopt;
  };
  if (auto reason = split(algebra::unchanged(group))) return reason;
  const Renamed short_one = shortest(group, progress);
  if (auto reason = split(short_one)) return reason;
  const std::vector<Renamed> others = as_short(short_one, options.presentations, progress);
  for (const Renamed& seen : others)
    if (const auto proved = first_proved(splittings(seen.presentation), seen.presentation, 0, 0, progress))
      return reason_of(*proved, group, seen);
  constexpr std::size_t most_twisted = 10;
  for (std::size_t k = 0; k < others.size() && k < most_twisted; ++k) {
    Claim claim;
    if (const auto seen = with_stable_letter(others[k], options.presentations * twists_each, claim))
      return reason_of({claim, std::nullopt}, group, *seen);
  }
  constexpr std::size_t most_with_covers = 6;
  for (std::size_t k = 0; k < others.size() && k < most_with_covers; ++k) {
    const Presentation& shown = others[k].presentation;
    std::vector<Claim> claims = splittings(shown);
    if (setting.orientable)
      for (Claim& claim : relations(shown, setting.has_cusps)) claims.push_back(std::move(claim));
    if (const auto proved = first_proved(claims, shown, options.degree, options.cover_steps, progress))
      return reason_of(*proved, group, others[k]);
  }
  return std::nullopt;
}

} // namespace tetrarch::reasons
