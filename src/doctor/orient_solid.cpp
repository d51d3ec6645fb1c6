// SPDX-License-Identifier: GPL-2.0-or-later
#include "orient_solid.hpp"

namespace tetrarch::doctor {
namespace {

/// Gives signs to the component of `first` along its gluings; returns its tetrahedra, and in `orientable`
/// whether the signs fit everywhere.
std::vector<int> spread_solid(const Triangulation& tri, int first, std::vector<int>& sign, bool& orientable) {
  std::vector<int> members{first};
  sign[first] = 1;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const int t = members[next];
    for (int f = 0; f < 4; ++f) {
      const Gluing gluing = tri.gluing({t, f});
      if (gluing.tet < 0) continue;
      // Of an odd permutation the handedness of both is the same (core/tet.hpp).
      const int wanted = gluing.perm.sign() < 0 ? sign[t] : -sign[t];
      if (sign[gluing.tet] == 0) {
        sign[gluing.tet] = wanted;
        members.push_back(gluing.tet);
      } else if (sign[gluing.tet] != wanted) {
        orientable = false;
      }
    }
  }
  return members;
}

} // namespace

double rounded_volume(const format::Soup& soup, const std::array<int, 4>& corners) {
  std::array<std::array<double, 3>, 3> e{};
  const auto& origin = soup.points[static_cast<std::size_t>(corners[0])];
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      e[k][axis] = soup.points[static_cast<std::size_t>(corners[k + 1])][axis] - origin[axis];
  return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
          e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
         6;
}

std::vector<int> solid_signs(const format::Soup& soup, const Triangulation& tri,
                             const std::vector<char>& proper) {
  std::vector<int> sign(static_cast<std::size_t>(tri.size()), 0);
  for (int t = 0; t < tri.size(); ++t) {
    if (sign[t] != 0 || !proper[t]) continue;
    bool orientable = true;
    const std::vector<int> members = spread_solid(tri, t, sign, orientable);
    double total = 0;
    for (const int m : members) total += sign[m] * rounded_volume(soup, soup.tetrahedra[m]);
    // Not 0 before the loop over t is done: that would visit the members again.
    const int factor = !orientable ? 2 : total < 0 ? -1 : 1;
    for (const int m : members) sign[m] *= factor;
  }
  for (int& s : sign)
    if (s == 2 || s == -2) s = 0;
  return sign;
}

} // namespace tetrarch::doctor
