// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Knots and links as grid diagrams, to be drawn on the lattice of solids.hpp.
///
/// A grid diagram has n columns and n rows; each column is a vertical segment between two rows, each row a
/// horizontal segment between two columns, and vertical segments pass over horizontal ones. Draw columns at
/// height 1, rows at height 0, and join them where they end. The smallest n is the arc index of the link:
/// crossing number + 2 for an alternating one (Bae and Park, "An upper bound of arc index of links", 2000), p
/// + q for the torus link T(p,q), which is column c from row c to row c + p.

#include "support/solids.hpp"

#include <string>
#include <vector>

namespace tetrarch::support {

/// Column c joins rows from[c] and to[c]. Both are permutations, and from[c] != to[c].
struct GridDiagram {
  std::vector<int> from;
  std::vector<int> to;

  int size() const { return static_cast<int>(from.size()); }
};

/// The column that starts at the row where c ends. Going on leads round the component.
inline std::vector<int> next_column(const GridDiagram& grid) {
  std::vector<int> start(grid.from.size());
  for (int c = 0; c < grid.size(); ++c) start[grid.from[c]] = c;
  std::vector<int> next(grid.from.size());
  for (int c = 0; c < grid.size(); ++c) next[c] = start[grid.to[c]];
  return next;
}

inline int component_count(const GridDiagram& grid) {
  const std::vector<int> next = next_column(grid);
  std::vector<char> seen(next.size(), 0);
  int count = 0;
  for (int c = 0; c < grid.size(); ++c) {
    if (seen[c]) continue;
    ++count;
    for (int at = c; !seen[at]; at = next[at]) seen[at] = 1;
  }
  return count;
}

/// The link on the lattice: for every column itself, the step down at its end, the row that follows, and the
/// step up. Different segments meet only where they are joined.
inline std::vector<Segment> segments(const GridDiagram& grid) {
  const std::vector<int> next = next_column(grid);
  std::vector<Segment> all;
  for (int c = 0; c < grid.size(); ++c) {
    const int row = grid.to[c];
    all.push_back({{{c, grid.from[c], 1}, {c, row, 1}}});
    all.push_back({{{c, row, 1}, {c, row, 0}}});
    all.push_back({{{c, row, 0}, {next[c], row, 0}}});
    all.push_back({{{next[c], row, 0}, {next[c], row, 1}}});
  }
  return all;
}

/// The box around the link without the link's bars.
inline Voxels exterior(const GridDiagram& grid, const Scale& scale = {}) {
  return bars(segments(grid), scale).complement();
}

struct NamedLink {
  std::string name;
  GridDiagram grid;
  int components;
  double volume; ///< of the complete hyperbolic structure of the exterior, 0 where there is none
};

/// Up to mirror images. The grids of 4_1, 5_2, the Whitehead link and the Borromean rings were found by a
/// search among random ones; witnesses are two: Regina's HOMFLY polynomial and crossing number of the
/// diagram, and Regina's (SnapPea's) volume of `exterior(grid)` itself, coned and simplified. The volumes are
/// those of the census of cusped manifolds (m004, m015, m129; 7.3277 is twice the regular ideal octahedron).
/// Torus knots and links are Seifert fibred.
inline const std::vector<NamedLink>& links() {
  static const std::vector<NamedLink> all{
      {"unknot", {{0, 1}, {1, 0}}, 1, 0},
      {"trefoil", {{0, 1, 2, 3, 4}, {2, 3, 4, 0, 1}}, 1, 0},
      {"figure eight", {{1, 4, 3, 5, 0, 2}, {3, 2, 0, 1, 4, 5}}, 1, 2.029883212819},
      {"5_1", {{0, 1, 2, 3, 4, 5, 6}, {2, 3, 4, 5, 6, 0, 1}}, 1, 0},
      {"5_2", {{4, 5, 0, 6, 1, 3, 2}, {1, 3, 4, 2, 5, 6, 0}}, 1, 2.828122088330},
      {"Hopf link", {{0, 1, 2, 3}, {2, 3, 0, 1}}, 2, 0},
      {"Whitehead link", {{3, 5, 4, 1, 2, 0, 6}, {0, 2, 6, 3, 5, 4, 1}}, 2, 3.663862376709},
      {"Borromean rings", {{0, 4, 7, 5, 2, 6, 1, 3}, {6, 2, 3, 1, 0, 4, 5, 7}}, 3, 7.327724753417},
  };
  return all;
}

/// Throws PreconditionError for an unknown name.
inline const NamedLink& named_link(const std::string& name) {
  for (const NamedLink& l : links())
    if (l.name == name) return l;
  throw PreconditionError("no link is called " + in_quotes(name));
}

/// A random grid diagram of a link: columns and rows in random order, dealt out to the components evenly.
/// Needs columns >= 2 * components.
inline GridDiagram random_link(int columns, int components, Random& random) {
  std::vector<int> column(static_cast<std::size_t>(columns));
  std::iota(column.begin(), column.end(), 0);
  std::vector<int> row = column;
  random.shuffle(column);
  random.shuffle(row);
  GridDiagram grid{row, row};
  for (int part = 0; part < components; ++part) {
    const int begin = part * columns / components;
    const int end = (part + 1) * columns / components;
    for (int k = begin; k < end; ++k) {
      grid.from[column[k]] = row[k];
      grid.to[column[k]] = row[k + 1 == end ? begin : k + 1];
    }
  }
  return grid;
}

} // namespace tetrarch::support
