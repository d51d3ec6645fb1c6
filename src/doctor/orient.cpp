// SPDX-License-Identifier: GPL-2.0-or-later
#include "orient.hpp"

namespace tetrarch::doctor {
namespace {

/// Gives part `part` to all triangles reached from `first`, and signs to them.
void spread(const Surface& surface, int first, int part, Signs& signs, std::vector<int>& queue) {
  queue.assign(1, first);
  signs.parts.of[first] = part;
  signs.sign[first] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int t = queue[next];
    for (const Side s : sides_of(t)) {
      if (surface.is_boundary(s)) continue;
      const int other = surface.mate(s).triangle();
      const int wanted = surface.is_turned(s) ? -signs.sign[t] : signs.sign[t];
      if (signs.parts.of[other] < 0) {
        signs.parts.of[other] = part;
        signs.sign[other] = wanted;
        queue.push_back(other);
      } else if (signs.sign[other] != wanted) {
        signs.orientable[part] = 0;
      }
    }
  }
}

} // namespace

Signs signs_of(const Surface& surface) {
  const auto size = static_cast<std::size_t>(surface.triangle_count());
  Signs signs{{0, std::vector<int>(size, -1)}, std::vector<int>(size, 0), {}};
  std::vector<int> queue;
  for (int t = 0; t < surface.triangle_count(); ++t) {
    if (signs.parts.of[t] >= 0) continue;
    signs.orientable.push_back(1);
    spread(surface, t, signs.parts.count++, signs, queue);
  }
  return signs;
}

std::vector<char> minority(const Signs& signs) {
  std::vector<int> balance(signs.orientable.size(), 0);
  for (std::size_t t = 0; t < signs.sign.size(); ++t) balance[signs.parts.of[t]] += signs.sign[t];
  std::vector<char> turned(signs.sign.size(), 0);
  for (std::size_t t = 0; t < signs.sign.size(); ++t) {
    const int part = signs.parts.of[t];
    const int lesser = balance[part] >= 0 ? -1 : 1;
    turned[t] = static_cast<char>(signs.orientable[part] && signs.sign[t] == lesser);
  }
  return turned;
}

} // namespace tetrarch::doctor
