// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/partition.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace tetrarch::bundle {

UnsolvedMesh::UnsolvedMesh(const Disk& disk)
    : disk_(&disk), state_(static_cast<std::size_t>(disk.triangle_count()), State::interior),
      exposed_(disk.boundary_vertices()), bits_(state_.size(), 0) {
  for (int t = 0; t < disk.triangle_count(); ++t) {
    const auto& corners = disk.corners(t);
    if (std::any_of(corners.begin(), corners.end(), [&](int v) { return exposed_[v] != 0; }))
      enter_frontier(t);
  }
  describe_frontier();
}

void UnsolvedMesh::enter_frontier(int triangle) {
  state_[triangle] = State::frontier;
  frontier_.push_back(triangle);
}

void UnsolvedMesh::describe_frontier() {
  for (const int t : frontier_) {
    unsigned bits = 0;
    for (const Side s : sides_of(t)) {
      if (exposed_[disk_->apex(s)] != 0) bits |= 1U << s.corner();
      if (!disk_->is_boundary(s) && !is_solved(disk_->mate(s).triangle())) bits |= 8U << s.corner();
    }
    bits_[t] = static_cast<std::uint8_t>(bits);
  }
}

void UnsolvedMesh::peel() {
  const std::vector<int> peeled = std::exchange(frontier_, {});
  for (const int t : peeled) state_[t] = State::solved;
  for (const int t : peeled)
    for (const Side s : sides_of(t)) {
      if (starts_exposed(s) || exposed_[disk_->from(s)] != 0) continue;
      // A vertex not exposed before is interior: turning about it comes home.
      exposed_[disk_->from(s)] = 1;
      Side around = s;
      do {
        if (state_[around.triangle()] == State::interior) enter_frontier(around.triangle());
        around = disk_->mate(around).next();
      } while (around != s);
    }
  describe_frontier();
}

Partition::Partition(const Disk& disk)
    : piece_of_(static_cast<std::size_t>(disk.triangle_count()), -1), joined_(piece_of_.size(), 0) {}

void Partition::update(const UnsolvedMesh& mesh) {
  triangles_.clear();
  pieces_.clear();
  breaking_edges_.clear();
  join_strips(mesh);
  // A strip is collected from whichever end comes first, so triangles in the middle have their turn with it.
  for (const int t : mesh.frontier()) {
    if (piece_of_[t] >= 0) continue;
    if (!mesh.is_thin(t))
      collect_loop(mesh, t);
    else if (joined_count(t) < 2)
      collect_strip(mesh.disk(), t);
  }
}

int Partition::joined_count(int triangle) const {
  return std::popcount(joined_[triangle]);
}

Side Partition::strip_exit(int triangle, Side entered) const {
  for (const Side s : sides_of(triangle))
    if (s != entered && is_joined(s)) return s;
  return {};
}

bool Partition::is_end(int triangle) const {
  return pieces_[piece_of(triangle)].type != PieceType::aggregated && joined_count(triangle) < 2;
}

void Partition::join(const Disk& disk, Side s) {
  for (const Side side : {s, disk.mate(s)})
    joined_[side.triangle()] |= static_cast<std::uint8_t>(1 << side.corner());
}

/// Joins thin triangles to strips across separating edges, as long as no triangle is joined on three sides.
/// What is left of the separating edges is a minimal set of breaking edges. All are breaking: a triangle of
/// valence 1 or 2 never refuses, so two of them are always joined. It is minimal: an edge is left only beside
/// an aggregated piece or the middle of a strip, so no two pieces make one.
void Partition::join_strips(const UnsolvedMesh& mesh) {
  const Disk& disk = mesh.disk();
  for (const int t : mesh.frontier()) {
    piece_of_[t] = -1;
    joined_[t] = 0;
  }
  const auto takes_more = [&](int t) { return mesh.is_thin(t) && joined_count(t) < 2; };
  for (const int t : mesh.frontier())
    for (const Side s : sides_of(t)) {
      if (!mesh.is_separating(s) || s.value > disk.mate(s).value) continue;
      if (takes_more(t) && takes_more(disk.mate(s).triangle()))
        join(disk, s);
      else
        breaking_edges_.push_back(s);
    }
}

void Partition::collect_strip(const Disk& disk, int end) {
  Side entered;
  for (int t = end; t >= 0;) {
    piece_of_[t] = static_cast<int>(pieces_.size());
    triangles_.push_back(t);
    const Side exit = strip_exit(t, entered);
    entered = exit.exists() ? disk.mate(exit) : Side();
    t = exit.exists() ? entered.triangle() : -1;
  }
  close_piece(joined_count(end) == 0 ? PieceType::singular : PieceType::linear);
}

void Partition::collect_loop(const UnsolvedMesh& mesh, int start) {
  int t = start;
  do {
    piece_of_[t] = static_cast<int>(pieces_.size());
    triangles_.push_back(t);
    t = mesh.disk().mate(loop_exit(mesh, t)).triangle();
  } while (t != start);
  close_piece(PieceType::aggregated);
}

void Partition::close_piece(PieceType type) {
  const int first = pieces_.empty() ? 0 : pieces_.back().first + pieces_.back().count;
  pieces_.push_back({type, first, static_cast<int>(triangles_.size()) - first});
}

Side loop_exit(const UnsolvedMesh& mesh, int triangle) {
  for (const Side s : sides_of(triangle))
    if (mesh.starts_exposed(s) && !mesh.ends_exposed(s)) return s;
  return {};
}

std::vector<int> components(const Disk& disk, const Partition& partition) {
  std::vector<int> root(partition.pieces().size());
  std::iota(root.begin(), root.end(), 0);
  for (const Side s : partition.breaking_edges()) {
    const int here = numeric::find_root(root, partition.piece_of(s.triangle()));
    const int there = numeric::find_root(root, partition.piece_of(disk.mate(s).triangle()));
    root[std::max(here, there)] = std::min(here, there);
  }
  std::vector<int> component(root.size());
  int count = 0;
  for (int p = 0; p < static_cast<int>(root.size()); ++p) {
    const int r = numeric::find_root(root, p);
    component[p] = r == p ? count++ : component[r];
  }
  return component;
}

} // namespace tetrarch::bundle
