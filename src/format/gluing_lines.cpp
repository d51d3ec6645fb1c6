// SPDX-License-Identifier: GPL-2.0-or-later
#include "gluing_lines.hpp"

namespace tetrarch::format {

void GluingLines::read_one(std::int64_t tetrahedra) {
  const std::string whose = " of tetrahedron " + std::to_string(table_.size());
  std::array<Gluing, 4> faces{};
  std::array<std::string_view, 4> tokens{};
  const std::string neighbour = "a neighbor" + whose + ", 0 to " + std::to_string(tetrahedra - 1);
  for (Gluing& g : faces) g.tet = static_cast<int>(in_.integer(neighbour, 0, tetrahedra - 1));
  const std::string permutation = "a permutation" + whose + ", like 0132";
  for (std::size_t f = 0; f < 4; ++f) {
    tokens[f] = in_.token(permutation);
    const std::optional<Perm4> perm = parse_perm(tokens[f]);
    if (!perm) in_.fail_at(tokens[f], permutation);
    faces[f].perm = *perm;
  }
  table_.push_back(faces);
  perm_tokens_.push_back(tokens);
}

Triangulation GluingLines::checked() const {
  if (const std::optional<GluingFault> fault = find_fault(table_)) {
    const std::string_view token =
        perm_tokens_[static_cast<std::size_t>(fault->at.tet)][static_cast<std::size_t>(fault->at.face)];
    throw InputError(in_.place_of(token), fault->what);
  }
  return build(table_);
}

std::string gluing_lines_of(const Triangulation& tri, int t) {
  std::string neighbours;
  std::string perms;
  for (int f = 0; f < 4; ++f) {
    const Gluing g = tri.gluing({t, f});
    const std::string number = std::to_string(g.tet);
    neighbours += std::string(number.size() < 4 ? 4 - number.size() : 0, ' ') + number + " ";
    perms += " " + g.perm.str();
  }
  neighbours.back() = '\n';
  return neighbours + perms + "\n";
}

} // namespace tetrarch::format
