// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/checker/check.hpp"

#include "cells.hpp"
#include "gluing.hpp"
#include "inverse.hpp"
#include "links.hpp"
#include "tetrahedron.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tetrarch::checker {
namespace {

/// Ushijima's formula loses many digits where tetrahedra are nearly flat.
constexpr int guard_bits = 128;

using Matrix = std::vector<std::vector<Interval>>;

/// Whether a square matrix of whole numbers is invertible. Modulo a prime: yes there means yes.
bool is_invertible(std::vector<std::vector<std::int64_t>> m) {
  constexpr std::int64_t prime = 1'000'000'007;
  for (std::size_t c = 0; c < m.size(); ++c) {
    std::size_t pivot = c;
    while (pivot < m.size() && m[pivot][c] % prime == 0) ++pivot;
    if (pivot == m.size()) return false;
    std::swap(m[pivot], m[c]);
    for (std::size_t r = c + 1; r < m.size(); ++r) {
      const std::int64_t up = m[r][c];
      const std::int64_t down = m[c][c];
      for (std::size_t k = 0; k < m.size(); ++k)
        m[r][k] = ((m[r][k] * down - m[c][k] * up) % prime + prime) % prime;
    }
  }
  return true;
}

/// The curvatures of all edges, -dK/dl, and the sum of volumes; of lengths in a box or at a point.
struct Sums {
  std::vector<Interval> curvature;
  std::vector<std::array<Interval, 6>> angles; ///< by tetrahedron
  Matrix slope;
  Interval volume;
};

/// Follows one certificate; stops at the first thing that it cannot prove.
class Check {
public:
  Check(const Certificate& given, const StillWanted& ask)
      : given_(given), ask_(ask), classes_(classes_of(given.gluings)) {}

  Report run() {
    report_.tetrahedra = static_cast<int>(given_.gluings.size());
    report_.bits = given_.bits;
    report_.radius = given_.radius;
    report_.volume[0] = given_.volume[0];
    report_.volume[1] = given_.volume[1];
    report_.why_not = first_fault();
    report_.accepted = report_.why_not.empty();
    return report_;
  }

private:
  std::string first_fault() {
    if (!classes_.fault.empty()) return classes_.fault;
    for (std::string (Check::*step)() :
         {&Check::compare_links, &Check::find_edges, &Check::look_at_cusps, &Check::look_at_box}) {
      std::string fault = (this->*step)();
      if (!fault.empty()) return fault;
    }
    return {};
  }

  std::string compare_links() {
    std::vector<int> links = classes_.link;
    std::sort(links.begin(), links.end());
    report_.links = links;
    report_.orientable = classes_.orientable;
    report_.edges = static_cast<int>(classes_.ends.size());
    report_.cusps = static_cast<int>(std::count(links.begin(), links.end(), 0));
    if (links != given_.links) return "the vertex links are not those claimed";
    if (classes_.orientable != given_.orientable) return "orientability is not as claimed";
    return {};
  }

  /// Each class is named once.
  std::string find_edges() {
    const std::size_t count = classes_.ends.size();
    middle_.assign(count, Interval(0));
    std::vector<int> named(count, 0);
    place_.assign(count, -1);
    for (const Certificate::Edge& edge : given_.edges) {
      const int c = classes_.edge[edge.tet][edge.edge];
      ++named[c];
      middle_[c] = Interval(edge.length);
      if (edge.fixed) {
        fixed_.push_back(c);
      } else {
        place_[c] = static_cast<int>(free_.size());
        free_.push_back(c);
      }
    }
    for (const int times : named)
      if (times != 1) return "an edge has no length, or two";
    return {};
  }

  /// One length is fixed for each cusp, three for each finite vertex. With cusps alone, the dropped equations
  /// follow from the others by their sums; with finite vertices that is seen on the box.
  std::string look_at_cusps() {
    std::vector<int> number(classes_.link.size(), -1);
    int cusps = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (classes_.link[v] == 0) number[v] = cusps++;
    points_ = static_cast<int>(std::count(classes_.link.begin(), classes_.link.end(), 2));
    if (static_cast<int>(fixed_.size()) != cusps + 3 * points_)
      return "the number of fixed lengths is not that of the cusps and three for each finite vertex";
    if (points_ > 0) return {};
    std::vector<std::vector<std::int64_t>> ends(fixed_.size(), std::vector<std::int64_t>(fixed_.size(), 0));
    for (std::size_t k = 0; k < fixed_.size(); ++k)
      for (const int v : classes_.ends[fixed_[k]])
        if (number[v] >= 0) ++ends[number[v]][k];
    if (!is_invertible(ends)) return "the equations of the fixed edges do not follow from the others";
    return {};
  }

  std::optional<Sums> sums(const std::vector<Interval>& lengths, bool with_volume) const {
    Sums sum;
    sum.curvature.assign(lengths.size(), 2 * Interval::pi());
    sum.slope.assign(free_.size(), std::vector<Interval>(free_.size(), Interval(0)));
    for (std::size_t t = 0; t < given_.gluings.size(); ++t) {
      ask_();
      std::array<Interval, 6> six;
      const Corners kinds = kinds_at(classes_, static_cast<int>(t));
      for (int e = 0; e < 6; ++e) six[e] = lengths[classes_.edge[t][e]];
      const auto angles = dihedral_angles(six, kinds);
      if (!angles) return std::nullopt;
      std::array<Interval, 6> values;
      for (int e = 0; e < 6; ++e) {
        values[e] = (*angles)[e].value;
        const int c = classes_.edge[t][e];
        sum.curvature[c] = sum.curvature[c] - values[e];
        add_slopes((*angles)[e], t, place_[c], sum.slope);
      }
      sum.angles.push_back(values);
      if (with_volume) sum.volume = sum.volume + volume(values, kinds, ask_);
    }
    return sum;
  }

  void add_slopes(const Dual& angle, std::size_t t, int row, Matrix& slope) const {
    for (int f = 0; f < 6; ++f) {
      const int column = place_[classes_.edge[t][f]];
      if (row >= 0 && column >= 0) slope[row][column] = slope[row][column] + angle.slope[f];
    }
  }

  std::string look_at_box() {
    const Interval radius(given_.radius);
    if (!free_.empty() && !less(Interval(0), radius)) return "the radius is not positive";
    std::vector<Interval> box = middle_;
    for (const int c : free_) box[c] = box[c] + hull(-radius, radius);
    const auto at_middle = sums(middle_, true);
    const auto on_box = sums(box, false);
    if (!at_middle || !on_box) return "a tetrahedron does not exist for all lengths in the box";
    std::string fault = krawczyk(*at_middle, *on_box, radius);
    if (fault.empty() && points_ > 0 &&
        !dropped_vanish({given_.gluings, classes_, box, on_box->curvature, on_box->angles}, fixed_))
      return "the equations of the fixed edges do not follow from the others";
    if (fault.empty()) fault = look_at_volume(*at_middle, *on_box, radius);
    if (!fault.empty() || !given_.cells) return fault;
    return look_at_cells({given_.gluings, classes_, box, on_box->curvature, on_box->angles});
  }

  /// |Y K(m)| + |1 - Y H(X)| r < r, line by line; H = -K'.
  std::string krawczyk(const Sums& at_middle, const Sums& on_box, const Interval& radius) const {
    std::vector<std::vector<double>> h;
    for (const auto& row : on_box.slope) {
      h.emplace_back();
      for (const Interval& x : row) h.back().push_back(x.nearest_double());
    }
    const auto y = inverse(h);
    if (!y) return "the equations are singular";
    for (std::size_t i = 0; i < free_.size(); ++i) {
      ask_();
      Interval step;
      Interval row;
      for (std::size_t j = 0; j < free_.size(); ++j) {
        step = step + (*y)[i][j] * at_middle.curvature[free_[j]];
        Interval entry = i == j ? 1 : 0;
        for (std::size_t k = 0; k < free_.size(); ++k) entry = entry - (*y)[i][k] * on_box.slope[k][j];
        row = row + abs(entry);
      }
      if (!less(abs(step) + row * radius, radius)) return "the box is not mapped into its inside";
    }
    return {};
  }

  /// G = V - 1/2 sum l K has dG = -1/2 sum K dl, and K is 0 at the structure, within r of the middle.
  std::string look_at_volume(const Sums& at_middle, const Sums& on_box, const Interval& radius) const {
    Interval g = at_middle.volume;
    for (std::size_t c = 0; c < middle_.size(); ++c) g = g - middle_[c] * at_middle.curvature[c] / 2;
    Interval total;
    for (const auto& row : on_box.slope)
      for (const Interval& x : row) total = total + abs(x);
    const Interval error = radius * radius * total / 2;
    g = g + hull(-error, error);
    if (less_equal(Interval(given_.volume[0]), g) && less_equal(g, Interval(given_.volume[1]))) return {};
    return "the volume is not proved to lie between the ends claimed";
  }

  std::string look_at_cells(const OnBox& box) {
    std::string fault = fault_in_cells(box, *given_.cells);
    if (!fault.empty()) return fault;
    report_.has_cells = true;
    report_.cusp_area = given_.cells->cusp_area;
    for (const CellClaims::Face& face : given_.cells->faces) {
      if (face.flat.empty())
        ++report_.walls;
      else
        ++report_.unchecked[face.flat];
    }
    return {};
  }

  const Certificate& given_;
  const StillWanted& ask_;
  Classes classes_;
  Report report_;
  std::vector<Interval> middle_;  ///< lengths, by class
  std::vector<int> fixed_, free_; ///< classes
  int points_ = 0;                ///< finite vertices
  std::vector<int> place_;        ///< of each class among the free ones, or -1
};

} // namespace

Report check(std::string_view text, const std::string& source, const std::function<void()>& still_wanted) {
  const Certificate given = read(text, source);
  const StillWanted ask = still_wanted ? still_wanted : [] {};
  const Interval::Precision precision(given.bits + guard_bits);
  return Check(given, ask).run();
}

} // namespace tetrarch::checker
