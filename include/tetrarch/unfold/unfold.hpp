// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Maps of tetrahedra without folds.
///
///      .-----.          .-----.     Each element has a shape that it would like to have, and J, 3 x 3,
///      |\ x  |          |\    |     is the linear map from there to where its corners are. Its energy is
///      | \/\ |   --->   | \ x |
///      | / \\|          |  \ /|       tr(J'J) / chi(det J)^(2/3) + theta (det(J)^2 + 1) / chi(det J),
///      '-----'          '---'-'
///                                   with chi(D) = (D + sqrt(D^2 + eps^2)) / 2: about D for D > 0, and
///                                   small but positive for D <= 0, so that what is turned over has a
///                                   finite energy and a way back.
///
/// The energy is minimized by L-BFGS, again and again, while eps falls towards 0: a wall grows where det J is
/// 0, behind those that have passed it. Corners of hexahedra (`Brick`) are elements, too. No success is
/// guaranteed, but the result never has more folded elements than the start. One thread, sums in the order of
/// the elements: the same everywhere.
///
/// Source: Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov, "Foldover-free maps in 50 lines of
/// code" (2021), sections 2 and 3. L-BFGS: Nocedal and Wright, "Numerical Optimization", chapter 7.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tetrarch::unfold {

using numeric::Point;
using numeric::Vector;

/// Four of the points, and the shape that they would like to have.
struct Element {
  std::array<int, 4> corner{};
  std::array<Vector, 3>
      inverse{};     ///< of the matrix whose columns are the wanted edges from corner 0, by rows
  double weight = 1; ///< of its energy in the sum
};

/// The element with these corners that would like to have these edges from the first to the others. Throws
/// PreconditionError unless they make a positive volume.
Element element(const std::array<int, 4>& corner, const std::array<Vector, 3>& edges, double weight = 1);

/// A hexahedron: its eight corners are elements, each with the three edges there. Quicker than the eight.
struct Brick {
  std::array<int, 8> corner{}; ///< 0 to 3 around the bottom, 4 to 7 above them
  Vector inverse{};            ///< of the lengths it would like to have, from corner 0 to 1, 3 and 4
  double weight = 1;           ///< of each corner's energy in the sum
};

/// The hexahedron that would like to be a box with these edges from corner 0 to 1, 3 and 4. Throws
/// PreconditionError unless all are positive.
Brick brick(const std::array<int, 8>& corner, const std::array<double, 3>& lengths, double weight = 1);

/// Where a point may go.
struct Freedom {
  enum class Kind : std::uint8_t { free, plane, line, fixed } kind = Kind::free;
  Vector direction{}; ///< unit: the normal of the plane, or along the line

  /// The part of a motion that is allowed.
  Vector allowed(const Vector& motion) const;
};

/// A spring that holds a point near a place: near a plane, a line or a point. It adds weight times the square
/// of the distance to the energy.
struct Pull {
  int point = 0;
  Freedom held{}; ///< the plane, line or point (`fixed`) through the target; what is `free` has no spring
  Point target{};
  double weight = 1;

  /// What is between the point and where it is held.
  Vector away(const Point& p) const;
};

struct Problem {
  std::vector<Element> elements{};
  std::vector<Brick> bricks{};
  std::vector<Freedom> freedom{}; ///< of each point
  std::vector<Pull> pulls{};
};

struct Options {
  double theta = 0.5; ///< how much sizes count beside angles
  /// The first epsilon where elements are folded, about. With 1 all becomes small at first; with less,
  /// springs hold the whole while few elements open, but what is folded deeply may not find out.
  double reach = 1;
  int most_rounds = 100; ///< after which what is still folded stays so
  /// So many rounds on end that gain no more than `flat` and open no fold are enough.
  int most_idle_rounds = 10;
  int iterations = 300;     ///< of L-BFGS in a round, at most
  double flat = 1e-6;       ///< gain of an iteration, in terms of the energy, at which a round is over
  double least_gain = 1e-3; ///< of the energy in a round, in terms of it: with less, and no fold, it is done
};

/// The energy, and if wanted its gradient, in which forbidden motions are still there. O(elements).
double energy(const std::vector<Element>& elements, const std::vector<Point>& points, double theta,
              double epsilon, std::vector<Vector>* gradient = nullptr);

/// The same of bricks, which is added to the gradient. O(bricks).
double add_energy(const std::vector<Brick>& bricks, const std::vector<Point>& points, double theta,
                  double epsilon, std::vector<Vector>& gradient);

/// det J of each element: 1 for those of the wanted volume, 0 or less for those that are folded.
std::vector<double> determinants(const std::vector<Element>& elements, const std::vector<Point>& points);
/// The same of the eight corners of each brick.
std::vector<double> determinants(const std::vector<Brick>& bricks, const std::vector<Point>& points);

struct Unfolded {
  std::vector<Point> points; ///< the best
  std::vector<Point> last;   ///< where the descent ended, whatever is folded there
  int folded_before = 0;     ///< elements with a determinant of 0 or less, or none at all
  int folded_after = 0;
  int rounds = 0;
  int iterations = 0;
  double least_determinant = 0;
};

/// The best of the points met at the end of a round, the start included: of fewest folded elements, then the
/// latest. Throws PreconditionError unless there is a freedom for each point, and all corners and what is
/// pulled are points. O(n) an iteration.
Unfolded unfold(const Problem& problem, std::vector<Point> start, const Options& options = {},
                const Progress& progress = {});

} // namespace tetrarch::unfold
