// SPDX-License-Identifier: GPL-2.0-or-later
#include "gluing_table.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch::format {
namespace {

std::string name(TetFace f) {
  return "face " + std::to_string(f.face) + " of tetrahedron " + std::to_string(f.tet);
}

/// What is wrong between f and the face it claims, which claims `back`; empty if they agree.
std::string disagreement(TetFace f, Gluing claim, TetFace other, Gluing back) {
  if (back.tet < 0)
    return name(f) + " is glued to " + name(other) + ", which is on the boundary seen from its side";
  const TetFace home{back.tet, back.perm[other.face]};
  if (home != f) return name(other) + " is glued twice: to " + name(f) + " and to " + name(home);
  if (back.perm != claim.perm.inverse())
    return name(f) + " is glued to " + name(other) + " by " + claim.perm.str() + ", which says " +
           back.perm.str() + " where the inverse " + claim.perm.inverse().str() + " was expected";
  return {};
}

std::string fault_of(const GluingTable& table, TetFace f) {
  const Gluing claim = table[static_cast<std::size_t>(f.tet)][f.face];
  if (claim.tet < 0) return {};
  const std::size_t other_tet = static_cast<std::size_t>(claim.tet);
  if (other_tet >= table.size())
    return name(f) + " is glued to tetrahedron " + std::to_string(claim.tet) + ", expected one of 0 to " +
           std::to_string(table.size() - 1);
  const TetFace other{claim.tet, claim.perm[f.face]};
  if (other == f) return name(f) + " is glued to itself";
  return disagreement(f, claim, other, table[other_tet][other.face]);
}

} // namespace

std::optional<GluingFault> find_fault(const GluingTable& table) {
  for (int t = 0; t < static_cast<int>(table.size()); ++t) {
    for (int f = 0; f < 4; ++f) {
      std::string what = fault_of(table, {t, f});
      if (!what.empty()) return GluingFault{{t, f}, std::move(what)};
    }
  }
  return std::nullopt;
}

Triangulation build(const GluingTable& table) {
  Triangulation tri(static_cast<int>(table.size()));
  for (int t = 0; t < tri.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      const Gluing claim = table[static_cast<std::size_t>(t)][f];
      if (claim.tet >= 0 && tri.is_boundary({t, f})) tri.glue({t, f}, claim.tet, claim.perm);
    }
  }
  return tri;
}

std::optional<Perm4> parse_perm(std::string_view text) {
  if (text.size() != 4) return std::nullopt;
  std::array<int, 4> image{};
  unsigned seen = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    image[i] = text[i] - '0';
    if (image[i] < 0 || image[i] > 3) return std::nullopt;
    seen |= 1U << static_cast<unsigned>(image[i]);
  }
  if (seen != 15U) return std::nullopt;
  return Perm4(image[0], image[1], image[2], image[3]);
}

} // namespace tetrarch::format
