// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/isomorphism.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch {
namespace {

/// Follows the gluings of a component of `a` outward from one tetrahedron whose image is given.
class Follower {
public:
  Follower(const Triangulation& a, const Triangulation& b)
      : a_(a), b_(b), iso_{std::vector<int>(static_cast<std::size_t>(a.size()), -1),
                           std::vector<Perm4>(static_cast<std::size_t>(a.size()))},
        taken_(static_cast<std::size_t>(b.size()), 0) {}

  /// True, and the component's images are kept, if root -> (image, perm) extends to the component of root.
  bool extend(int root, int image, Perm4 perm) {
    queue_.clear();
    assign(root, image, perm);
    for (std::size_t next = 0; next < queue_.size(); ++next)
      if (!match_faces(queue_[next])) {
        for (const int t : queue_) {
          taken_[iso_.tet[t]] = 0;
          iso_.tet[t] = -1;
        }
        return false;
      }
    return true;
  }
  const Isomorphism& isomorphism() const { return iso_; }
  bool is_assigned(int t) const { return iso_.tet[t] >= 0; }
  bool is_taken(int u) const { return taken_[u] != 0; }
  /// Forgets everything, for the next candidate.
  void clear() {
    std::fill(iso_.tet.begin(), iso_.tet.end(), -1);
    std::fill(taken_.begin(), taken_.end(), 0);
  }

private:
  void assign(int t, int image, Perm4 perm) {
    iso_.tet[t] = image;
    iso_.perm[t] = perm;
    taken_[image] = 1;
    queue_.push_back(t);
  }
  bool match_faces(int t) {
    for (int f = 0; f < 4; ++f) {
      const Gluing g = a_.gluing({t, f});
      const Gluing h = b_.gluing({iso_.tet[t], iso_.perm[t][f]});
      if ((g.tet < 0) != (h.tet < 0)) return false;
      if (g.tet < 0) continue;
      const Perm4 wanted = h.perm * iso_.perm[t] * g.perm.inverse();
      if (iso_.tet[g.tet] < 0) {
        if (taken_[h.tet]) return false;
        assign(g.tet, h.tet, wanted);
      } else if (iso_.tet[g.tet] != h.tet || iso_.perm[g.tet] != wanted) {
        return false;
      }
    }
    return true;
  }

  const Triangulation& a_;
  const Triangulation& b_;
  Isomorphism iso_;
  std::vector<char> taken_;
  std::vector<int> queue_;
};

void require_connected(const Triangulation& tri) {
  if (components(tri).count != 1)
    throw PreconditionError("a list of isomorphisms needs connected triangulations");
}

} // namespace

std::optional<Isomorphism> find_isomorphism(const Triangulation& a, const Triangulation& b) {
  if (a.size() != b.size()) return std::nullopt;
  Follower follower(a, b);
  // Isomorphic components are interchangeable, so taking the first that fits is no loss.
  for (int root = 0; root < a.size(); ++root) {
    if (follower.is_assigned(root)) continue;
    bool found = false;
    for (int image = 0; image < b.size() && !found; ++image)
      for (int rank = 0; rank < Perm4::count && !found && !follower.is_taken(image); ++rank)
        found = follower.extend(root, image, Perm4::from_rank(rank));
    if (!found) return std::nullopt;
  }
  return follower.isomorphism();
}

std::vector<Isomorphism> isomorphisms(const Triangulation& a, const Triangulation& b) {
  require_connected(a);
  require_connected(b);
  std::vector<Isomorphism> found;
  if (a.size() != b.size()) return found;
  Follower follower(a, b);
  for (int image = 0; image < b.size(); ++image) {
    for (int rank = 0; rank < Perm4::count; ++rank) {
      if (!follower.extend(0, image, Perm4::from_rank(rank))) continue;
      found.push_back(follower.isomorphism());
      follower.clear();
    }
  }
  return found;
}

std::vector<Isomorphism> automorphisms(const Triangulation& tri) {
  return isomorphisms(tri, tri);
}

} // namespace tetrarch
