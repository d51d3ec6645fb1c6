// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The unsolved part of a disk, and its partition into sub-components of basic types.
///
/// Vocabulary of the text, for the sub-mesh of all unsolved triangles:
///   - the *valence* of a triangle is the number of unsolved triangles next to it; *dangling*: valence 1,
///     *singular*: valence 0 (5.2.1 has "dangling" twice);
///   - a *component* is a maximal set of unsolved triangles connected through edges; it is a disk;
///   - a *separating edge* lies between two unsolved triangles with both ends on the boundary of the
///     component; it is a *breaking edge* if one of the two has valence 3;
///   - a *sub-component* is *aggregated* (edges inside, none of them separating), *linear* (a strip of two or
///     more triangles; all edges inside are separating) or *singular* (one triangle, no edge inside);
///   - a *minimal set* of breaking edges is one along which a component falls into sub-components no union
///     of which is a sub-component.
///
/// Why the whole is linear. Each round of Algorithm I solves exactly the *frontier*: the unsolved triangles
/// with a vertex that is *exposed*, that is, on the boundary of the disk or on a solved triangle. An
/// unexposed vertex has all its triangles in one component, so "on the boundary of its component" is the
/// same as "exposed", and every rule above is local to the frontier: no interior is ever searched. The next
/// frontier is found by walking around the vertices newly exposed.
/// Source: Yin, 5.2.1 and 5.2.4.

#include "tetrarch/bundle/disk.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace tetrarch::bundle {

/// The sub-mesh of unsolved triangles, peeled frontier by frontier.
class UnsolvedMesh {
public:
  /// All triangles unsolved. O(n).
  explicit UnsolvedMesh(const Disk& disk);

  const Disk& disk() const { return *disk_; }
  /// The unsolved triangles with an exposed vertex. Empty once all is solved.
  const std::vector<int>& frontier() const { return frontier_; }
  bool is_solved(int triangle) const { return state_[triangle] == State::solved; }
  bool is_in_frontier(int triangle) const { return state_[triangle] == State::frontier; }

  // All that follows is asked of frontier triangles and their sides only.

  /// Whether there is an unsolved triangle behind the side.
  bool is_inner(Side s) const { return (bits_[s.triangle()] >> (3 + s.corner()) & 1) != 0; }
  /// Whether the vertex that the side starts from, or ends at, is exposed.
  bool starts_exposed(Side s) const { return (bits_[s.triangle()] >> s.next().corner() & 1) != 0; }
  bool ends_exposed(Side s) const { return (bits_[s.triangle()] >> s.previous().corner() & 1) != 0; }
  bool is_separating(Side s) const { return is_inner(s) && starts_exposed(s) && ends_exposed(s); }
  int valence(int triangle) const { return std::popcount(static_cast<unsigned>(bits_[triangle] >> 3)); }
  /// Whether all three vertices are exposed: the triangle is no part of an aggregated sub-component, as all
  /// its inner sides are separating.
  bool is_thin(int triangle) const { return (bits_[triangle] & 7) == 7; }

  /// Declares the frontier solved and finds the next. O(frontier and next frontier).
  void peel();

private:
  enum class State : std::uint8_t { interior, frontier, solved };
  void enter_frontier(int triangle);
  void describe_frontier();

  const Disk* disk_;
  std::vector<State> state_;
  std::vector<char> exposed_; ///< of each vertex
  /// Of each frontier triangle: bit c, whether corner c is exposed; bit 3 + c, whether side c is inner. The
  /// rules ask for little else, and a byte a triangle stays in the cache.
  std::vector<std::uint8_t> bits_;
  std::vector<int> frontier_;
};

enum class PieceType : std::uint8_t { aggregated, linear, singular };

/// A sub-component, of an aggregated one the frontier. Triangles `first` .. `first + count - 1` of the
/// partition's list: a strip in order from end to end; a frontier in the order of the loop f1, f2, ... that
/// it forms, counterclockwise.
struct Piece {
  PieceType type = PieceType::singular;
  int first = 0;
  int count = 0;
};

/// The frontier cut along a minimal set of breaking edges.
class Partition {
public:
  explicit Partition(const Disk& disk);

  /// Discards the old cut and cuts the frontier of `mesh`, which belongs to the same disk. O(frontier).
  void update(const UnsolvedMesh& mesh);

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<int>& triangles() const { return triangles_; }
  /// One side of each edge of the minimal set.
  const std::vector<Side>& breaking_edges() const { return breaking_edges_; }
  /// The number of the piece that a frontier triangle is in.
  int piece_of(int triangle) const { return piece_of_[triangle]; }
  /// Whether side s of a frontier triangle lies inside a linear piece.
  bool is_joined(Side s) const { return (joined_[s.triangle()] >> s.corner() & 1) != 0; }
  /// The joined sides of a triangle: of a singular piece 0, at the end of a linear one 1, in its middle 2;
  /// of an aggregated one 0.
  int joined_count(int triangle) const;
  /// The way on along a strip: the joined side of the triangle, other than the one through which it was
  /// entered; none at the strip's end. At its start `entered` is none.
  Side strip_exit(int triangle, Side entered) const;
  /// Whether the triangle is singular or the end of a strip: then its values alone must be safe.
  bool is_end(int triangle) const;

private:
  void join(const Disk& disk, Side s);
  void join_strips(const UnsolvedMesh& mesh);
  void collect_strip(const Disk& disk, int end);
  void collect_loop(const UnsolvedMesh& mesh, int start);
  void close_piece(PieceType type);

  std::vector<int> piece_of_;
  std::vector<std::uint8_t> joined_;
  std::vector<int> triangles_;
  std::vector<Piece> pieces_;
  std::vector<Side> breaking_edges_;
};

/// The side through which the loop of an aggregated piece's frontier leaves a triangle: it runs from an
/// exposed vertex to one that is not.
Side loop_exit(const UnsolvedMesh& mesh, int triangle);

/// The first stage of the partition: the component, numbered by first piece, of each piece. O(pieces).
std::vector<int> components(const Disk& disk, const Partition& partition);

} // namespace tetrarch::bundle
