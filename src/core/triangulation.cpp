// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/triangulation.hpp"

#include "tetrarch/core/error.hpp"

#include <atomic>
#include <string>

namespace tetrarch {
namespace {

/// Each thread takes revisions in blocks: enumerations glue and unglue many millions of times, and one
/// counter shared by every glue would make threads wait for each other.
std::uint64_t fresh_revision() {
  constexpr std::uint64_t block = 1 << 20;
  static std::atomic<std::uint64_t> taken{1};
  thread_local std::uint64_t next = 0;
  if (next % block == 0) next = taken++ * block;
  return next++;
}

std::string name(TetFace f) {
  return "face " + std::to_string(f.face) + " of tetrahedron " + std::to_string(f.tet);
}

} // namespace

Triangulation::Triangulation(int tets) : tets_(static_cast<std::size_t>(tets)), revision_(fresh_revision()) {}

int Triangulation::add_tetrahedra(int count) {
  const int first = size();
  tets_.resize(tets_.size() + static_cast<std::size_t>(count));
  revision_ = fresh_revision();
  return first;
}

void Triangulation::require_valid(TetFace f) const {
  if (f.tet < 0 || f.tet >= size() || f.face < 0 || f.face > 3)
    throw PreconditionError(name(f) + " does not exist: there are " + std::to_string(size()) + " tetrahedra");
}

void Triangulation::glue(TetFace f, int other, Perm4 p) {
  require_valid(f); // before p is asked about it
  const TetFace g{other, p[f.face]};
  require_valid(g);
  if (f == g) throw PreconditionError(name(f) + " cannot be glued to itself");
  for (const TetFace h : {f, g})
    if (!is_boundary(h)) throw PreconditionError(name(h) + " is glued already");
  tets_[static_cast<std::size_t>(f.tet)][f.face] = {other, p};
  tets_[static_cast<std::size_t>(other)][g.face] = {f.tet, p.inverse()};
  revision_ = fresh_revision();
}

void Triangulation::unglue(TetFace f) {
  require_valid(f);
  if (is_boundary(f)) return;
  const TetFace g = partner(f);
  tets_[static_cast<std::size_t>(f.tet)][f.face] = {};
  tets_[static_cast<std::size_t>(g.tet)][g.face] = {};
  revision_ = fresh_revision();
}

Components components(const Triangulation& tri) {
  Components parts{0, std::vector<int>(static_cast<std::size_t>(tri.size()), -1)};
  std::vector<int> stack;
  for (int root = 0; root < tri.size(); ++root) {
    if (parts.of[root] >= 0) continue;
    parts.of[root] = parts.count;
    stack.push_back(root);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int f = 0; f < 4; ++f) {
        const int u = tri.gluing({t, f}).tet;
        if (u < 0 || parts.of[u] >= 0) continue;
        parts.of[u] = parts.count;
        stack.push_back(u);
      }
    }
    ++parts.count;
  }
  return parts;
}

Triangulation component(const Triangulation& tri, const Components& parts, int c) {
  std::vector<int> image(static_cast<std::size_t>(tri.size()), -1);
  int size = 0;
  for (int t = 0; t < tri.size(); ++t)
    if (parts.of[t] == c) image[t] = size++;
  Triangulation part(size);
  for (int t = 0; t < tri.size(); ++t) {
    if (parts.of[t] != c) continue;
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet >= 0 && part.is_boundary({image[t], f})) part.glue({image[t], f}, image[g.tet], g.perm);
    }
  }
  return part;
}

std::vector<Triangulation> split(const Triangulation& tri, const Components& parts) {
  std::vector<Triangulation> out(static_cast<std::size_t>(parts.count));
  std::vector<int> image(static_cast<std::size_t>(tri.size()), -1);
  for (int t = 0; t < tri.size(); ++t) image[t] = out[parts.of[t]].add_tetrahedra();
  for (int t = 0; t < tri.size(); ++t) {
    Triangulation& part = out[parts.of[t]];
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet >= 0 && part.is_boundary({image[t], f})) part.glue({image[t], f}, image[g.tet], g.perm);
    }
  }
  return out;
}

std::optional<std::vector<int>> orientation(const Triangulation& tri) {
  std::vector<int> sign(static_cast<std::size_t>(tri.size()), 0);
  std::vector<int> stack;
  for (int root = 0; root < tri.size(); ++root) {
    if (sign[root] != 0) continue;
    sign[root] = 1;
    stack.push_back(root);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int f = 0; f < 4; ++f) {
        const Gluing g = tri.gluing({t, f});
        if (g.tet < 0) continue;
        const int wanted = -g.perm.sign() * sign[t];
        if (sign[g.tet] == 0) {
          sign[g.tet] = wanted;
          stack.push_back(g.tet);
        } else if (sign[g.tet] != wanted) {
          return std::nullopt;
        }
      }
    }
  }
  return sign;
}

Triangulation relabelled(const Triangulation& tri, const std::vector<int>& image,
                         const std::vector<Perm4>& perm) {
  Triangulation out(tri.size());
  for (int t = 0; t < tri.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      const TetFace here{image[t], perm[t][f]};
      if (g.tet >= 0 && out.is_boundary(here))
        out.glue(here, image[g.tet], perm[g.tet] * g.perm * perm[t].inverse());
    }
  }
  return out;
}

} // namespace tetrarch
