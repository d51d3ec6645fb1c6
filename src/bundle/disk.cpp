// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/disk.hpp"

#include "tetrarch/core/error.hpp"

#include <string>
#include <utility>

namespace tetrarch::bundle {
namespace {

void require_oriented(const Disk& disk) {
  for (int k = 0; k < disk.side_count(); ++k) {
    const Side s(k);
    if (disk.is_turned(s))
      throw InputError("triangles " + std::to_string(s.triangle()) + " and " +
                       std::to_string(disk.mate(s).triangle()) + ", edge " + std::to_string(disk.from(s)) +
                       "-" + std::to_string(disk.to(s)) + ": both run along it in the same direction");
  }
}

} // namespace

Disk::Disk(Surface surface) : Surface(std::move(surface)) {
  require_oriented(*this);
  find_boundary();
}

Disk::Disk(int vertices, std::vector<Triangle> triangles) : Disk(Surface(vertices, std::move(triangles))) {}

Disk::Disk(const Table<Side, Side>& mate) : Disk(Surface(mate)) {}

void Disk::find_boundary() {
  if (triangle_count() == 0) throw InputError("a disk needs a triangle");
  if (surface::parts(*this).count != 1)
    throw InputError("no disk: the triangles are not connected through edges");
  for (int k = 0; k < side_count(); ++k)
    if (is_boundary(Side(k))) boundary_.push_back(Side(k));
  if (boundary_.empty()) throw InputError("no disk: the surface has no boundary");
  // A connected surface with boundary has V - E + F <= 1 with equality for the disk alone, and vertices where
  // it touches itself only lower V: this one number says all that is left.
  const int euler = vertex_count() - edge_count() + triangle_count();
  if (euler != 1)
    throw InputError("no disk: vertices - edges + triangles = " + std::to_string(euler) + ", not 1");
  for (std::size_t k = 1; k < boundary_.size(); ++k)
    boundary_[k] = surface::next_on_boundary(*this, {boundary_[k - 1], false}).side;
}

std::vector<char> Disk::boundary_vertices() const {
  std::vector<char> on_boundary(static_cast<std::size_t>(vertex_count()), 0);
  for (const Side s : boundary_) on_boundary[from(s)] = 1;
  return on_boundary;
}

} // namespace tetrarch::bundle
