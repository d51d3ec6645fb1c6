// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A triangulated disk: a surface that is proved to be a disk, with its boundary in order.
///
/// Its mates run in opposite directions, and its boundary runs along its sides, so that the disk lies to the
/// left. Coarse covering disks have triangles glued to themselves and edges that are loops.

#include "tetrarch/surface/surface.hpp"

#include <vector>

namespace tetrarch::bundle {

using surface::Side;
using surface::sides_of;

/// A surface that is a disk.
class Disk : public surface::Surface {
public:
  /// From the corners of triangles of consistent orientation; as `surface::Surface`, and throws `InputError`
  /// unless this is a disk: all mates run in opposite directions, connected, with boundary, V - E + F = 1.
  /// O(n).
  Disk(int vertices, std::vector<Triangle> triangles);

  /// From gluings: the mate of each side, none on the boundary. Vertices are numbered by first corner. Throws
  /// `PreconditionError` if mates are not mutual, `InputError` unless this is a disk. O(n).
  explicit Disk(const Table<Side, Side>& mate);
  /// The same from a surface: throws `InputError` unless it is a disk without turned mates. O(n).
  explicit Disk(Surface surface);

  /// O(1).
  int edge_count() const { return (side_count() + static_cast<int>(boundary_.size())) / 2; }
  /// The boundary sides in the order in which the boundary runs; the one of least number comes first.
  const std::vector<Side>& boundary() const { return boundary_; }
  /// For each vertex, whether it lies on the boundary. O(n).
  std::vector<char> boundary_vertices() const;

private:
  void find_boundary();

  std::vector<Side> boundary_;
};

} // namespace tetrarch::bundle
