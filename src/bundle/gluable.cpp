// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/gluable.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <map>

namespace tetrarch::bundle {
namespace {

using surface::MarkedSurface;
using surface::Surface;

using GridTriangle = std::array<GridVertex, 3>;

int modulo(int x, int n) {
  const int rest = x % n;
  return rest < 0 ? rest + n : rest;
}

/// The bank whose first side is `first`: as far as the mark goes.
Band band_from(const MarkedSurface& cut, const Surface& open, Side first) {
  Band band{cut[first], false, {first}};
  while (true) {
    const Side next = surface::next_on_boundary(open, {band.sides.back(), false}).side;
    if (next == first) band.closed = true;
    if (next == first || open.mate(next).exists() || cut[next] != band.mark) break;
    band.sides.push_back(next);
  }
  return band;
}

} // namespace

std::vector<std::array<Band, 2>> bands(const MarkedSurface& cut) {
  const Surface open = surface::cut_open(cut);
  std::map<int, std::vector<Side>> curves;
  std::map<int, Side> first; // where the mark begins; on a closed curve the side of least number
  for (int k = 0; k < open.side_count(); ++k)
    if (const Side s(k); cut.is_cut(s)) {
      curves[cut[s]].push_back(s);
      const Side before = surface::next_on_boundary(open, {s, true}).side;
      if (!first.contains(cut[s]) || cut[before] != cut[s]) first[cut[s]] = s;
    }
  std::vector<std::array<Band, 2>> out;
  for (const auto& [mark, sides] : curves) {
    if (mark < 0) continue;
    std::array<Band, 2> pair{band_from(cut, open, first[mark]), band_from(cut, open, first[-mark])};
    const Side last = pair[0].sides.back();
    if (pair[0].closed) // the other bank starts where this one ends
      pair[1] = band_from(cut, open, cut.surface.mate(last));
    for (const Band& band : pair)
      if (band.sides.size() != sides.size())
        throw PreconditionError("the edges of mark " + std::to_string(mark) + " do not follow each other");
    out.push_back(std::move(pair));
  }
  return out;
}

int twist_along(const Band& band, const Recipe& recipe) {
  int sum = 0;
  for (const Side s : band.sides) sum += recipe.shift[s.value].twist();
  return sum;
}

std::vector<GridTriangle> band_triangles(const Band& band, const Recipe& recipe) {
  std::vector<GridTriangle> triangles;
  triangles.reserve(2 * band.sides.size() * static_cast<std::size_t>(recipe.fiber));
  for (int i = 0; i < static_cast<int>(band.sides.size()); ++i)
    for (int j = 0; j < recipe.fiber; ++j) {
      const GridVertex a{i, j};
      const GridVertex b{i + 1, j};
      const GridVertex c{i + 1, j + 1};
      const GridVertex d{i, j + 1};
      if (recipe.value[band.sides[i].value] > 0)
        triangles.insert(triangles.end(), {GridTriangle{a, b, c}, GridTriangle{a, c, d}});
      else
        triangles.insert(triangles.end(), {GridTriangle{d, a, b}, GridTriangle{d, b, c}});
    }
  return triangles;
}

GridVertex gluing_map(const Band& band, const Recipe& recipe, GridVertex v) {
  const int length = static_cast<int>(band.sides.size());
  const int shift =
      v.i < length ? recipe.shift[band.sides[v.i].value].start : recipe.shift[band.sides.back().value].stop;
  if (recipe.base.is_turned(band.sides[0])) return {v.i, shift - v.j};
  return {length - v.i, v.j + shift};
}

namespace {

/// Names that do not depend on how often one has gone round: i mod M where the band is closed, levels moved
/// together so that the least is in 0 .. N-1, the least vertex first.
class Names {
public:
  Names(const Band& band, const Recipe& recipe)
      : closed_(band.closed), length_(static_cast<int>(band.sides.size())), fiber_(recipe.fiber) {}

  GridVertex of(GridVertex v) const { return {closed_ ? modulo(v.i, length_) : v.i, modulo(v.j, fiber_)}; }

  GridTriangle of(GridTriangle t) const {
    int left = t[0].i;
    int low = t[0].j;
    for (const GridVertex& v : t) {
      left = std::min(left, v.i);
      low = std::min(low, v.j);
    }
    const int right = closed_ ? modulo(left, length_) - left : 0;
    const int up = modulo(low, fiber_) - low;
    for (GridVertex& v : t) v = {v.i + right, v.j + up};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  }

private:
  bool closed_;
  int length_;
  int fiber_;
};

class Audit {
public:
  Audit(const std::array<Band, 2>& pair, const Recipe& recipe)
      : a_(pair[0]), b_(pair[1]), recipe_(recipe), names_(b_, recipe),
        turned_(recipe.base.is_turned(a_.sides[0])) {}

  std::string run() const {
    const std::size_t length = a_.sides.size();
    for (std::size_t i = 0; i < length; ++i) {
      const Side across = turned_ ? b_.sides[i] : b_.sides[length - 1 - i];
      if (recipe_.base.mate(a_.sides[i]) != across)
        return at(i) + "the banks do not lie across from each other";
      if (i > 0 && (recipe_.shift[a_.sides[i].value].start - recipe_.shift[a_.sides[i - 1].value].stop) %
                           recipe_.fiber !=
                       0)
        return at(i) + "the gluing map jumps along the curve";
    }
    return triangles();
  }

private:
  static std::string at(std::size_t i) { return "edge " + std::to_string(i) + ": "; }

  GridTriangle image(const GridTriangle& t) const {
    GridTriangle out;
    // The gluing map of the edge below; where two edges meet, theirs may differ by whole turns.
    const int i = std::min({t[0].i, t[1].i, t[2].i});
    const Shift shift = recipe_.shift[a_.sides[i].value];
    for (int c = 0; c < 3; ++c) {
      const int here = shift.at(t[c].i == i);
      out[c] = turned_ ? GridVertex{t[c].i, here - t[c].j}
                       : GridVertex{static_cast<int>(a_.sides.size()) - t[c].i, t[c].j + here};
    }
    std::swap(out[1], out[2]);
    return names_.of(out);
  }

  /// Triangles go to triangles, each to its own; and with them edges and vertices, as the next corner around
  /// a vertex goes to the one before it.
  std::string triangles() const {
    std::vector<GridTriangle> images;
    for (const GridTriangle& t : band_triangles(a_, recipe_)) images.push_back(image(t));
    std::vector<GridTriangle> there;
    for (const GridTriangle& t : band_triangles(b_, recipe_)) there.push_back(names_.of(t));
    std::sort(images.begin(), images.end());
    std::sort(there.begin(), there.end());
    if (images != there) return "the gluing map is no bijection of triangles that turns them over";
    return rings();
  }

  /// The ring around each vertex: the triangle that follows one counterclockwise starts with the edge that
  /// the first one ends with.
  std::string rings() const {
    const auto successors = [&](const std::vector<GridTriangle>& triangles, const Names& names) {
      std::map<std::pair<GridVertex, GridVertex>, GridTriangle> starting; // edge v -> w starts this triangle
      for (const GridTriangle& t : triangles)
        for (int c = 0; c < 3; ++c) starting[{names.of(t[c]), names.of(t[(c + 1) % 3])}] = t;
      return starting;
    };
    if (recipe_.fiber < 3 || (a_.closed && a_.sides.size() < 3))
      return {}; // vertices do not tell edges apart
    const auto here = band_triangles(a_, recipe_);
    const auto there = band_triangles(b_, recipe_);
    const Names names(a_, recipe_);
    const auto next_here = successors(here, names);
    const auto next_there = successors(there, names_);
    for (const GridTriangle& t : here)
      for (int c = 0; c < 3; ++c) {
        const auto after = next_here.find({names.of(t[c]), names.of(t[(c + 2) % 3])});
        if (after == next_here.end()) continue; // the border of the band
        // In reverse: the image of t follows the image of `after` around the image of the vertex.
        const GridVertex v = names_.of(gluing_map(a_, recipe_, t[c]));
        if (!follows(image(after->second), image(t), v, next_there))
          return "the gluing map does not reverse the ring around a vertex";
      }
    return {};
  }

  template <class Starting>
  bool follows(const GridTriangle& first, const GridTriangle& second, GridVertex v,
               const Starting& starting) const {
    for (int c = 0; c < 3; ++c) {
      if (names_.of(first[c]) != v) continue;
      const auto found = starting.find({v, names_.of(first[(c + 2) % 3])});
      if (found != starting.end() && names_.of(found->second) == second) return true;
    }
    return false;
  }

  const Band& a_;
  const Band& b_;
  const Recipe& recipe_;
  Names names_;
  bool turned_;
};

} // namespace

std::string why_not_gluable(const std::array<Band, 2>& pair, const Recipe& recipe) {
  return Audit(pair, recipe).run();
}

} // namespace tetrarch::bundle
