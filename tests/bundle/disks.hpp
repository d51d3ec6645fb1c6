// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Every triangulated disk of a few triangles, and random ones of any size and depth.

#include "support/random.hpp"
#include "tetrarch/bundle/cutting_pattern.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace tetrarch::support {

/// Triangulated disks with up to 8 triangles, up to isomorphism and reflection, where triangles may be glued
/// to themselves and edges may be loops; and their boundary assignments, 2^b for b boundary edges. Counted by
/// another program, written before this one.
inline constexpr long disks_up_to_8 = 4919;
inline constexpr long assignments_up_to_8 = 327830;

namespace detail {

/// A disk with a root among its boundary sides: the first. Counterclockwise.
struct RootedDisk {
  std::vector<bundle::Side> mate;
  std::vector<bundle::Side> boundary;

  void glue(bundle::Side s, bundle::Side t) {
    mate[s.value] = t;
    mate[t.value] = s;
  }
};

/// Triangle 0 with root side 0, and behind its sides 1 and 2 a disk or, if it has no triangles, nothing.
inline RootedDisk join(const RootedDisk& first, const RootedDisk& second) {
  using bundle::Side;
  RootedDisk out{std::vector<Side>(3), {Side(0)}};
  const auto append = [&](Side s, const RootedDisk& part) {
    if (part.mate.empty()) {
      out.boundary.push_back(s);
      return;
    }
    const int shift = static_cast<int>(out.mate.size());
    for (const Side m : part.mate) out.mate.push_back(m.exists() ? Side(m.value + shift) : m);
    out.glue(s, Side(part.boundary[0].value + shift));
    for (std::size_t k = 1; k < part.boundary.size(); ++k)
      out.boundary.emplace_back(part.boundary[k].value + shift);
  };
  append(Side(1), first);
  append(Side(2), second);
  return out;
}

/// A triangle over the first two boundary edges of a disk; its third side is the root.
inline RootedDisk cover(RootedDisk disk) {
  using bundle::Side;
  const Side root(static_cast<int>(disk.mate.size()));
  disk.mate.resize(disk.mate.size() + 3);
  disk.glue(root.previous(), disk.boundary[0]);
  disk.glue(root.next(), disk.boundary[1]);
  disk.boundary.erase(disk.boundary.begin());
  disk.boundary[0] = root;
  return disk;
}

/// The gluing as a walk from a root sees it that turns left or right in every triangle: two disks have a
/// common code if and only if an isomorphism takes root to root.
inline std::vector<int> code_from(const RootedDisk& disk, bundle::Side root, bool mirrored) {
  using bundle::Side;
  const auto turn = [&](Side s) { return mirrored ? s.previous() : s.next(); };
  std::vector<Side> entry{root};
  std::map<int, int> number{{root.triangle(), 0}};
  std::vector<int> code;
  for (std::size_t k = 0; k < entry.size(); ++k) {
    Side s = entry[k]; // by value: the list grows
    for (int turns = 0; turns < 3; ++turns, s = turn(s)) {
      const Side there = disk.mate[s.value];
      if (!there.exists()) {
        code.push_back(-1);
        continue;
      }
      const auto [at, fresh] = number.emplace(there.triangle(), static_cast<int>(entry.size()));
      if (fresh) entry.push_back(there);
      int steps = 0;
      for (Side u = entry[at->second]; u != there; u = turn(u)) ++steps;
      code.push_back(3 * at->second + steps);
    }
  }
  return code;
}

inline std::vector<int> code_of(const RootedDisk& disk) {
  std::vector<int> least;
  for (const bundle::Side root : disk.boundary)
    for (const bool mirrored : {false, true}) {
      std::vector<int> code = code_from(disk, root, mirrored);
      if (least.empty() || code < least) least = std::move(code);
    }
  return least;
}

} // namespace detail

/// All disks of 1, ..., `most` triangles, one of each class. Take away the triangle on a root edge: what is
/// left is two disks if its apex was on the boundary (or fewer), one if not, and nothing if it was glued to
/// itself.
inline std::vector<bundle::Disk> small_disks(int most) {
  using detail::RootedDisk;
  std::vector<std::vector<RootedDisk>> all{{RootedDisk{}}};
  std::vector<bundle::Disk> out;
  for (int n = 1; n <= most; ++n) {
    std::vector<RootedDisk> found;
    for (int k = 0; k < n; ++k)
      for (const RootedDisk& first : all[k])
        for (const RootedDisk& second : all[n - 1 - k]) found.push_back(detail::join(first, second));
    for (const RootedDisk& disk : all[n - 1])
      if (disk.boundary.size() >= 2) found.push_back(detail::cover(disk));
    if (n == 1) {
      RootedDisk folded = detail::join({}, {});
      folded.glue(bundle::Side(1), bundle::Side(2));
      folded.boundary.resize(1);
      found.push_back(folded);
    }
    std::map<std::vector<int>, const RootedDisk*> classes;
    for (const RootedDisk& disk : found) classes.emplace(detail::code_of(disk), &disk);
    for (const auto& [code, disk] : classes) out.emplace_back(Table<bundle::Side, bundle::Side>(disk->mate));
    all.push_back(std::move(found));
  }
  return out;
}

struct RandomDisk {
  /// A grid of so many squares, each cut along a random diagonal: about min(columns, rows) / 2 layers deep.
  int columns = 1;
  int rows = 1;
  /// So many triangles are split into three around a new vertex.
  int splits = 0;
  /// So many triangles are put on random boundary edges, which makes strips and branches.
  int outgrowth = 0;
  /// Whether triangles and vertices are renamed at random, so that neighbours lie far apart in memory.
  bool shuffled = false;
};

namespace detail {

inline std::vector<bundle::Disk::Triangle> random_grid(const RandomDisk& wanted, Random& random) {
  std::vector<bundle::Disk::Triangle> triangles;
  const int across = wanted.columns + 1;
  for (int y = 0; y < wanted.rows; ++y)
    for (int x = 0; x < wanted.columns; ++x) {
      const int a = y * across + x;
      const int b = a + 1;
      const int c = b + across;
      const int d = a + across;
      if (random.below(2) == 0)
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      else
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
    }
  return triangles;
}

} // namespace detail

/// 2 * columns * rows + 2 * splits + outgrowth triangles, simplicial. O(n).
inline bundle::Disk random_disk(const RandomDisk& wanted, Random& random) {
  auto triangles = detail::random_grid(wanted, random);
  int vertices = (wanted.columns + 1) * (wanted.rows + 1);
  for (int k = 0; k < wanted.splits; ++k) {
    auto& split = triangles[random.below(static_cast<int>(triangles.size()))];
    const auto [a, b, c] = split;
    const int centre = vertices++;
    split = {a, b, centre};
    triangles.insert(triangles.end(), {{b, c, centre}, {c, a, centre}});
  }
  const bundle::Disk inner(vertices, triangles);
  std::vector<std::pair<int, int>> edges;
  for (const bundle::Side s : inner.boundary()) edges.emplace_back(inner.from(s), inner.to(s));
  for (int k = 0; k < wanted.outgrowth; ++k) {
    auto& edge = edges[random.below(static_cast<int>(edges.size()))];
    const auto [a, b] = edge;
    const int tip = vertices++;
    triangles.push_back({b, a, tip});
    edge = {a, tip};
    edges.emplace_back(tip, b);
  }
  if (wanted.shuffled) {
    std::vector<int> name(static_cast<std::size_t>(vertices));
    std::iota(name.begin(), name.end(), 0);
    random.shuffle(name);
    random.shuffle(triangles);
    for (auto& corners : triangles)
      for (int& v : corners) v = name[v];
  }
  return {vertices, std::move(triangles)};
}

inline bundle::BoundaryValues random_boundary(const bundle::Disk& disk, Random& random) {
  bundle::BoundaryValues values(disk.boundary().size());
  for (int& value : values) value = random.below(2) == 0 ? 1 : -1;
  return values;
}

} // namespace tetrarch::support
