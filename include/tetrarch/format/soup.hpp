// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// An indexed soup: what a mesh file says, before anyone believes it.
///
///     points        0: (0,0,0)   1: (1,0,0)   2: (0,1,0)   3: (0,0,1)
///     tetrahedra    0 1 2 3        each names four points by their index, right or wrong
///     triangles     0 2 1 ...      of a surface, the surface; of a solid, parts of its boundary
///
/// Every element remembers the number that the file calls it by and the line it stands on, so that whoever
/// finds a fault can name the place. Indices count from 0 here, whatever the file counts from; nothing is
/// checked but that they are integers. A soup of n tetrahedra takes 16 bytes for each, 24 for each point, 12
/// for each triangle, and 4 for each tag; numbers and lines take next to nothing, as they are kept as runs.
/// Polygons are cut into triangles and other volume cells into tetrahedra as they are read.

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/ledger.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tetrarch::format {

/// A list of integers kept as runs of consecutive ones: 1,2,3,...,1000000 is one run.
class Runs {
public:
  void push_back(int value);
  std::size_t size() const { return size_; }
  /// O(log of the number of runs).
  int operator[](std::size_t index) const;
  friend bool operator==(const Runs&, const Runs&) = default;

  struct Run {
    std::size_t first; ///< index of the first element
    int value;         ///< of that element
    friend bool operator==(Run, Run) = default;
  };
  const std::vector<Run>& runs() const { return runs_; }

private:
  std::vector<Run> runs_;
  std::size_t size_ = 0;
};

/// How a file names each element of a list, and where it stands. Both are empty for a soup that was made and
/// not read: its elements are counted from its `first_number`.
struct Labels {
  Runs numbers;
  Runs lines; ///< 1-based; 0 where the file is binary

  /// The number of element `index` (any index, for one that is not there) if the first is called `first`.
  long long number(std::int64_t index, int first) const;
  int line(std::int64_t index) const;
  friend bool operator==(const Labels&, const Labels&) = default;
};

/// The points, tetrahedra and triangles of a mesh file, unchecked.
struct Soup {
  std::string source;       ///< what error messages call the file
  std::string point_source; ///< the file of the points, where that is another one; else empty
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::array<int, 3>> triangles;
  /// Of each triangle, the patch that the file counts it to: MEDIT's reference, Gmsh's physical group (or,
  /// without one, its surface). Empty if the file has none, or 0 everywhere.
  std::vector<int> triangle_tags;
  /// Of each tetrahedron, the region that the file counts it to; likewise.
  std::vector<int> tetrahedron_tags;
  Labels point_labels;
  Labels tetrahedron_labels;
  Labels triangle_labels;
  /// What the file counts from; tells what an index out of range was in the file.
  int first_number = 0;
  /// What stands in the file and is not here, or not as it stands there.
  Ledger passed_over;
};

/// The number that the file calls point `index` by, in range or not.
inline long long point_number(const Soup& soup, int index) {
  return soup.point_labels.number(index, soup.first_number);
}

/// Throws InputError that names file, line and coordinate if one is infinite or no number. Every reader and
/// writer of meshes asks; `doctor::validate` does so of soups that no file stands behind. O(points).
void require_finite(const Soup& soup);

} // namespace tetrarch::format
