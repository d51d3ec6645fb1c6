// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/charts.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>

namespace tetrarch::polycube {
namespace {

using namespace numeric;
using surface::Side;
using surface::Surface;

/// For each vertex a side that starts there.
std::vector<Side> first_sides(const Surface& surface) {
  std::vector<Side> result(static_cast<std::size_t>(surface.vertex_count()));
  for (int s = 0; s < surface.side_count(); ++s)
    if (Side& first = result[surface.from(Side(s))]; !first.exists()) first = Side(s);
  return result;
}

/// The next side that starts at the same vertex, counterclockwise.
Side turned(const Surface& surface, Side s) {
  return surface.mate(s.previous());
}

/// The mark of each triangle's chart, found by floods.
void flood_charts(const Surface& surface, const Facets& facets, const std::vector<Label>& label,
                  Charts& charts) {
  charts.of.assign(label.size(), -1);
  std::vector<int> stack;
  for (int first = 0; first < surface.triangle_count(); ++first) {
    if (charts.of[first] >= 0) continue;
    const int chart = charts.count();
    charts.label.push_back(label[first]);
    charts.area.push_back(0);
    charts.of[first] = chart;
    stack.push_back(first);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      charts.area[chart] += facets.area[t];
      for (const Side s : surface::sides_of(t)) {
        const int u = surface.mate(s).triangle();
        if (charts.of[u] >= 0 || label[u] != label[first]) continue;
        charts.of[u] = chart;
        stack.push_back(u);
      }
    }
  }
}

/// What lies between charts, for walking.
class Seams {
public:
  Seams(const Surface& surface, Charts& charts)
      : surface_(surface), charts_(charts), first_(first_sides(surface)) {}

  bool separates(Side s) const { return charts_.of[s.triangle()] != charts_.of[surface_.mate(s).triangle()]; }
  void find_around() {
    for (int v = 0; v < surface_.vertex_count(); ++v) {
      std::vector<int>& around = charts_.around.emplace_back();
      std::vector<int>& begins = charts_.begins.emplace_back();
      const Side first = first_[v];
      Side s = first;
      do {
        if (separates(s)) {
          around.push_back(charts_.of[s.triangle()]);
          begins.push_back(surface_.to(s));
        }
        s = turned(surface_, s);
      } while (s != first);
      if (around.size() > 2) charts_.corners.push_back(v);
      if (around.empty()) around.push_back(charts_.of[first.triangle()]);
    }
  }
  void find_lines() {
    std::vector<char> done(static_cast<std::size_t>(surface_.side_count()));
    const auto walk = [&](Side s) {
      if (!separates(s) || done[s.value] != 0) return;
      Line line;
      line.left = charts_.of[s.triangle()];
      line.right = charts_.of[surface_.mate(s).triangle()];
      const int start = surface_.from(s);
      line.vertices.push_back(start);
      while (true) {
        done[s.value] = done[surface_.mate(s).value] = 1;
        const int v = surface_.to(s);
        line.vertices.push_back(v);
        if (is_corner(v) || v == start) break;
        s = next_along(s);
      }
      line.is_closed = !is_corner(start);
      charts_.lines.push_back(std::move(line));
    };
    for (const int v : charts_.corners) {
      Side s = first_[v];
      do {
        walk(s);
        s = turned(surface_, s);
      } while (s != first_[v]);
    }
    for (int s = 0; s < surface_.side_count(); ++s) walk(Side(s));
  }
  void find_curves() {
    charts_.corners_of_curve.resize(static_cast<std::size_t>(charts_.count()));
    std::vector<char> done(static_cast<std::size_t>(surface_.side_count()));
    for (int first = 0; first < surface_.side_count(); ++first) {
      if (done[first] != 0 || !separates(Side(first))) continue;
      int corners = 0;
      Side s(first);
      do {
        done[s.value] = 1;
        if (is_corner(surface_.from(s))) ++corners;
        s = next_in_chart(s);
      } while (s.value != first);
      charts_.corners_of_curve[charts_.of[s.triangle()]].push_back(corners);
    }
  }

private:
  bool is_corner(int v) const { return charts_.around[v].size() > 2; }
  /// The side between charts that follows at a vertex which is no corner.
  Side next_along(Side s) const {
    const Side back = surface_.mate(s);
    Side next = turned(surface_, back);
    while (!separates(next)) next = turned(surface_, next);
    return next;
  }
  /// The side of the same chart's boundary curve that follows: the first, clockwise from the way back.
  Side next_in_chart(Side s) const {
    Side next = s.next();
    while (!separates(next)) next = surface_.mate(next).next();
    return next;
  }

  const Surface& surface_;
  Charts& charts_;
  std::vector<Side> first_;
};

using Sectors = std::vector<Sector>;

/// The least of all rotations.
template <class Around>
Around least_rotation(Around around) {
  Around least = around;
  for (std::size_t k = 1; k < around.size(); ++k) {
    std::rotate(around.begin(), around.begin() + 1, around.end());
    least = std::min(least, around);
  }
  return least;
}

/// Octant k is on the positive side of axis a if bit a of k is set; rays are numbered as labels are. Between
/// two octants that differ in one axis is a quarter of a plane, between two rays.
struct Quarter {
  Label label = -1;
  int to = -1; ///< ray; counterclockwise, seen from outside
};

/// The sectors around the corner of filled octants, or none where the surface there is no disk.
Sectors sectors_around(unsigned filled) {
  std::array<Quarter, labels> from{}; // the ray
  int quarters = 0;
  for (unsigned octant = 0; octant < 8; ++octant)
    for (int a = 0; a < 3; ++a) {
      const unsigned beyond = octant ^ (1U << static_cast<unsigned>(a));
      if ((filled >> octant & 1U) == 0 || (filled >> beyond & 1U) != 0) continue;
      const int b = (a + 1) % 3;
      const int c = (a + 2) % 3;
      const bool is_up = (beyond >> static_cast<unsigned>(a) & 1U) != 0;
      const bool b_up = (octant >> static_cast<unsigned>(b) & 1U) != 0;
      const bool c_up = (octant >> static_cast<unsigned>(c) & 1U) != 0;
      int start = 2 * b + (b_up ? 0 : 1);
      int end = 2 * c + (c_up ? 0 : 1);
      // From b to c is counterclockwise around +a in two of four quadrants.
      if ((b_up == c_up) != is_up) std::swap(start, end);
      if (from[start].label >= 0) return {}; // two sheets meet along the ray
      from[start] = {2 * a + (is_up ? 0 : 1), end};
      ++quarters;
    }
  Sectors around;
  for (int first = 0; first < labels && around.empty(); ++first)
    for (int ray = first; from[ray].label >= 0;) {
      around.push_back({from[ray].label, ray});
      ray = from[ray].to;
      if (ray == first) break;
    }
  if (static_cast<int>(around.size()) != quarters) return {};
  // Quarters of one plane are one sector, which begins where the first of them does.
  Sectors merged;
  for (std::size_t k = 0; k < around.size(); ++k)
    if (around[k].label != around[(k + around.size() - 1) % around.size()].label) merged.push_back(around[k]);
  return merged;
}

/// All corners that cubes make, with the ways of lines and without.
struct KnownCorners {
  KnownCorners() {
    for (unsigned filled = 0; filled < 256; ++filled) {
      const Sectors around = sectors_around(filled);
      if (around.size() <= 2) continue;
      sectors.insert(least_rotation(around));
      std::vector<Label> alone;
      for (const Sector& s : around) alone.push_back(s.label);
      labels.insert(least_rotation(alone));
    }
  }
  std::set<Sectors> sectors;
  std::set<std::vector<Label>> labels;
};

const KnownCorners& known_corners() {
  static const KnownCorners known;
  return known;
}

/// The vertices at which a line turns back: where it is farthest before, and where after that it is least.
void find_turning_points(const product::Solid& solid, const Charts& charts, const Line& line,
                         std::vector<Fault>& faults) {
  constexpr double tolerated = 0.1; // of the length
  const std::size_t axis = charts.axis(line);
  const auto at = [&](int v) { return solid.point(solid.vertex[v]); };
  double length = 0;
  for (std::size_t k = 1; k < line.vertices.size(); ++k)
    length += distance(at(line.vertices[k]), at(line.vertices[k - 1]));
  const double forward = at(line.vertices.back())[axis] >= at(line.vertices.front())[axis] ? 1 : -1;
  int farthest = line.vertices.front();
  int back = farthest;
  double worst = 0;
  int crest = farthest;
  for (const int v : line.vertices) {
    const double x = forward * at(v)[axis];
    if (x > forward * at(crest)[axis]) crest = v;
    if (const double loss = forward * at(crest)[axis] - x; loss > worst) {
      worst = loss;
      farthest = crest;
      back = v;
    }
  }
  if (!line.is_closed && worst <= tolerated * length) return;
  for (const int v : {farthest, back}) faults.push_back({Fault::Kind::turning_point, v, at(v)});
}

} // namespace

Charts charts(const product::Solid& solid, const Facets& facets, const std::vector<Label>& label) {
  Charts result;
  flood_charts(solid.boundary, facets, label, result);
  Seams seams(solid.boundary, result);
  seams.find_around();
  seams.find_lines();
  seams.find_curves();
  return result;
}

bool is_corner_of_cubes(const std::vector<Label>& around) {
  return known_corners().labels.contains(least_rotation(around));
}

bool is_corner_of_cubes(const std::vector<Sector>& around) {
  return known_corners().sectors.contains(least_rotation(around));
}

std::vector<Fault> faults(const product::Solid& solid, const Charts& charts) {
  std::vector<Fault> result;
  const auto add = [&](Fault::Kind kind, int v) {
    result.push_back({kind, v, solid.point(solid.vertex[v])});
  };
  for (const Line& line : charts.lines)
    if (are_opposite(charts.label[line.left], charts.label[line.right]))
      add(Fault::Kind::opposite, line.vertices[line.vertices.size() / 2]);
  for (const int v : charts.corners) {
    std::vector<Label> around;
    for (const int chart : charts.around[v]) around.push_back(charts.label[chart]);
    if (!is_corner_of_cubes(around)) add(Fault::Kind::corner, v);
  }
  constexpr int fewest = 4;
  std::vector<char> is_named(static_cast<std::size_t>(charts.count()));
  for (int t = 0; t < static_cast<int>(charts.of.size()); ++t) {
    const int chart = charts.of[t];
    if (is_named[chart] != 0) continue;
    is_named[chart] = 1;
    const std::vector<int>& curves = charts.corners_of_curve[chart];
    if (curves.empty()) add(Fault::Kind::few_corners, solid.boundary.corners(t)[0]);
    for (const int corners : curves)
      if (corners < fewest) add(Fault::Kind::few_corners, solid.boundary.corners(t)[0]);
  }
  for (const Line& line : charts.lines)
    if (!are_opposite(charts.label[line.left], charts.label[line.right]))
      find_turning_points(solid, charts, line, result);
  return result;
}

int count(const std::vector<Fault>& faults, Fault::Kind kind) {
  return static_cast<int>(
      std::count_if(faults.begin(), faults.end(), [kind](const Fault& f) { return f.kind == kind; }));
}

} // namespace tetrarch::polycube
