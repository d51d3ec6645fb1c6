// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A surface drawn in the plane, or on a cylinder, and vertices that move until no triangle is turned over:
/// what `unflip_on_cylinder` and its like have in common.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/slit/unflip.hpp"

#include <complex>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace tetrarch::slit {

/// What a vertex must stay to the left of: its distance from a side, `now`, grows by Re(conj(normal) step).
struct Wall {
  double now = 0;
  std::complex<double> normal;
};

/// The distance from the nearest wall after a step.
double least(const std::vector<Wall>& walls, std::complex<double> step);

/// The step along `direction` to the highest value of `least`, and the step anywhere; 0 if none is higher. By
/// trying all meetings of two or three of up to twenty walls; of more, by a few of them, to which the one
/// that ends up nearest is added again and again: O(walls) a time.
std::complex<double> best_along(const std::vector<Wall>& walls, std::complex<double> direction);
std::complex<double> best_anywhere(const std::vector<Wall>& walls);

/// A drawing by the differences along its sides, so that it may lie on a cylinder.
class Drawing {
public:
  /// `slides(v)`: the direction in which a vertex may move, 0 for any; `kept(v, step)`: the step that keeps
  /// it on its curve.
  struct Freedom {
    std::function<std::complex<double>(int)> slides;
    std::function<std::complex<double>(int, std::complex<double>)> kept;
  };

  /// `along`: of each side what is between its ends. Only the `judged` triangles are to be set right, and
  /// those `skipped` are no walls. Keeps references to the mesh.
  Drawing(const surface::TriangleMesh& mesh, std::vector<std::complex<double>> along,
          std::vector<char> skipped, std::vector<int> judged);

  /// `moved` is told of each step of a vertex; the first moves are those given. Ends with the best drawing
  /// that was met: the fewest flipped triangles, then the fewest narrow ones.
  Unflipped set_right(const Freedom& freedom, const std::function<void(int, std::complex<double>)>& moved,
                      const std::map<int, std::complex<double>>& first_moves, const Progress& progress);

  const std::vector<std::complex<double>>& along() const { return along_; }

private:
  using Complex = std::complex<double>;

  struct Count {
    int flipped = 0;
    int narrow = 0;
  };

  /// Whether a triangle is narrower than its shape in space by this factor, or turned over. In units of its
  /// longest side, as squares of small ones underflow.
  bool is_flipped(int t, double factor) const;
  std::vector<int> flipped_among_all() const;
  Count count() const;
  void keep_if_better(Count& best);
  void take_back(const std::function<void(int, Complex)>& moved);
  /// Moves the vertices near some triangles all at once, by the foldover-free energy. Nothing where the part
  /// goes around the cylinder, as it is no part of the plane then, or is too large to be done in a second.
  void unfold_around(const std::vector<int>& triangles, int rings, const Freedom& freedom,
                     const std::function<void(int, Complex)>& take, const Progress& progress) const;
  /// Places of the vertices of some triangles, each piece somewhere; nothing if they do not lie in a plane.
  std::map<int, Complex> laid_out(const std::vector<int>& part, std::map<int, std::vector<int>>& at) const;
  /// The vertices of triangles and so many rings around, each once, in the order in which they are met.
  std::vector<int> around(const std::vector<int>& triangles, int rings) const;
  std::vector<Wall> walls(int v) const;
  /// Of a vertex of one triangle: the step that takes it to the middle between the two others. On a circle
  /// that is where the triangle is widest; along the tangent it would grow for ever.
  Complex to_the_middle(int v) const;
  /// The step that takes v farther from its walls; 0 if there is none.
  Complex improved(int v, const Freedom& freedom) const;
  void move(int v, Complex step);

  const surface::Surface& surface_;
  const std::vector<numeric::Point>& points_;
  std::vector<Complex> along_;
  std::vector<char> skipped_;
  std::vector<int> judged_;
  std::vector<double> width_; ///< of each judged triangle in space
  std::vector<surface::SideEnd> some_end_;
  std::vector<std::pair<int, Complex>> since_best_; ///< steps
  std::map<int, Complex> total_;                    ///< of each vertex that moved, up to the best drawing
};

} // namespace tetrarch::slit
