// SPDX-License-Identifier: GPL-2.0-or-later
#include "dual_tree.hpp"

#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"

#include <string>

namespace tetrarch::algebra {

Table<FaceId, char> dual_spanning_forest(const Triangulation& tri, const Skeleton& skeleton) {
  Table<FaceId, char> in_forest(skeleton.face_count(), 0);
  std::vector<char> seen(static_cast<std::size_t>(tri.size()), 0);
  std::vector<int> queue;
  queue.reserve(seen.size());
  for (int root = 0; root < tri.size(); ++root) {
    if (seen[root]) continue;
    seen[root] = 1;
    queue.push_back(root);
    for (std::size_t next = queue.size() - 1; next < queue.size(); ++next) {
      for (int f = 0; f < 4; ++f) {
        const TetFace face{queue[next], f};
        const int other = tri.gluing(face).tet;
        if (other < 0 || seen[other]) continue;
        seen[other] = 1;
        in_forest[skeleton.face(face)] = 1;
        queue.push_back(other);
      }
    }
  }
  return in_forest;
}

void require_manifold(const Triangulation& tri, const Skeleton& skeleton, const char* asked_for) {
  skeleton.require_current(tri);
  const std::vector<Defect> defects = check(skeleton);
  if (!defects.empty())
    throw PreconditionError(std::string(asked_for) + " needs a valid triangulation, but " +
                            describe(defects.front(), skeleton));
}

} // namespace tetrarch::algebra
