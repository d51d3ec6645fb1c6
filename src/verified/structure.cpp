// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/verified/structure.hpp"

#include "edge_system.hpp"
#include "gauge.hpp"
#include "tetrarch/core/error.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>

namespace tetrarch::verified {
namespace {

using numeric::Ball;
using Lengths = hyperbolic::Metric<Ball>;

/// A Newton step with an inverse in doubles gains some 45 bits; so many more are carried along.
constexpr int bits_per_step = 45;
/// Where a box does not hold its image, a larger one may: by these powers of two.
constexpr int radii = 4;
constexpr int larger = 4;
/// Of the arithmetic that gives the volume at the midpoint.
constexpr int bits_beside_volume = 32;
constexpr const char* missing_tetrahedron = "a tetrahedron does not exist beyond doubt";

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// -K'(m)^-1 in doubles; nothing where it is not finite.
std::optional<Matrix> approximate_inverse(const EdgeSystem& system,
                                          const hyperbolic::Metric<double>& lengths) {
  const SparseRows<double> h = system.hessian(lengths);
  Matrix dense = Matrix::Zero(h.size(), h.size());
  for (int i = 0; i < h.size(); ++i)
    for (const auto& [j, value] : h.rows[i]) dense(i, j) = value;
  if (h.size() > 0) dense = dense.inverse().eval();
  if (!dense.allFinite()) return std::nullopt;
  return dense;
}

/// Y times the left sides.
std::vector<Ball> applied(const Matrix& y, const std::vector<Ball>& left) {
  std::vector<Ball> step(left.size(), Ball(0));
  for (int i = 0; i < y.rows(); ++i)
    for (int j = 0; j < y.cols(); ++j) step[i] += y(i, j) * left[j];
  return step;
}

Ball largest(const std::vector<Ball>& step) {
  Ball worst = 0;
  for (const Ball& x : step) {
    const Ball size = numeric::upper_end(abs(x));
    if (!(size <= worst)) worst = size; // what is no number stays
  }
  return worst;
}

/// A number no less than `bound`, exact and of few digits.
Ball exactly(const Ball& bound) {
  return numeric::radius(widened(Ball(0), bound));
}

/// One attempt, in the working precision of the scope.
class Attempt {
public:
  /// `points`: what proves the equations that finite vertices drop; null without such vertices.
  Attempt(const EdgeSystem& system, const Gauge* points, const hyperbolic::Metric<double>& start,
          const Progress& progress)
      : system_(system), points_(points), progress_(progress), middle_(start.size(), Ball(0)) {
    for (const EdgeId e : all<EdgeId>(start.size())) middle_[e] = start[e];
  }

  Certification run(const Matrix& y, bool volume) {
    const auto step = last_step(y);
    if (!step) return {std::nullopt, missing_tetrahedron};
    const auto radius = smallest_radius(y, *step);
    if (!radius) return {std::nullopt, "no box of lengths is mapped into its inside"};
    return proof(*radius, volume);
  }

  /// The box of a zero that is the only one within `reach`, where no curvature changes by as much as 1.
  std::optional<Lengths> run_alone(const Matrix& y, const Ball& reach) {
    const auto step = last_step(y);
    if (!step || !maps_into_itself(y, *step, reach) || !(total_slope_ * reach < 1)) return std::nullopt;
    const auto radius = smallest_radius(y, *step);
    if (!radius) return std::nullopt;
    return box(*radius);
  }

private:
  /// Newton's step from the refined midpoints.
  std::optional<std::vector<Ball>> last_step(const Matrix& y) {
    if (!refine(y)) return std::nullopt;
    const auto k = system_.curvature(middle_);
    if (!k) return std::nullopt;
    return applied(y, system_.equations(*k));
  }

  std::optional<Ball> smallest_radius(const Matrix& y, const std::vector<Ball>& step) {
    Ball radius = exactly(2 * largest(step));
    if (radius == Ball(0) && y.rows() > 0) radius = ldexp(Ball(1), -numeric::bits<Ball>());
    for (int attempt = 0; attempt < radii; ++attempt, radius = ldexp(radius, larger)) {
      progress_.step("certifying");
      if (maps_into_itself(y, step, radius)) return radius;
    }
    return std::nullopt;
  }

  /// Moves the midpoints to within rounding of a zero, if there is one near by.
  bool refine(const Matrix& y) {
    const int bits = numeric::bits<Ball>();
    // From doubles: one step to leave their rounding behind, and one more for each 45 bits beyond them.
    const int steps = bits <= 53 ? 1 : 2 + (bits - 53) / bits_per_step;
    for (int n = 1; n <= steps; ++n) {
      progress_.step("refining");
      const numeric::WorkingPrecision enough(std::min(bits, bits_per_step * (n + 2)));
      const auto k = system_.curvature(middle_);
      if (!k) return false;
      const std::vector<Ball> step = applied(y, system_.equations(*k));
      const numeric::WorkingPrecision full(bits);
      for (const EdgeId e : all<EdgeId>(middle_.size()))
        if (system_.unknown(e) >= 0)
          middle_[e] = numeric::midpoint(middle_[e] + numeric::midpoint(step[system_.unknown(e)]));
    }
    return true;
  }

  Lengths box(const Ball& radius) const {
    Lengths lengths = middle_;
    for (const EdgeId e : all<EdgeId>(lengths.size()))
      if (system_.unknown(e) >= 0) lengths[e] = widened(lengths[e], radius);
    return lengths;
  }

  /// Krawczyk's test. That the tetrahedra exist on the box is tested with it, and that at its zero no
  /// curvature is left.
  bool maps_into_itself(const Matrix& y, const std::vector<Ball>& step, const Ball& radius) {
    const Lengths lengths = box(radius);
    const auto curvature = system_.curvature(lengths);
    if (!curvature) return false;
    const SparseRows<Ball> h = system_.hessian(lengths);
    total_slope_ = 0;
    for (const auto& row : h.rows)
      for (const auto& entry : row) total_slope_ += abs(entry.value);
    for (int i = 0; i < h.size(); ++i) {
      progress_.step("certifying");
      if (!(abs(step[i]) + defect(y, h, i) * radius < radius)) return false;
    }
    return points_ == nullptr || points_->dropped_vanish(system_.fixed(), lengths, *curvature);
  }

  /// The sum of the absolute values in a row of 1 - Y H.
  static Ball defect(const Matrix& y, const SparseRows<Ball>& h, int i) {
    std::vector<Ball> row(h.rows.size(), Ball(0));
    row[i] = 1;
    for (int k = 0; k < h.size(); ++k)
      for (const auto& [j, value] : h.rows[k]) row[j] -= y(i, k) * value;
    Ball sum = 0;
    for (const Ball& entry : row) sum += abs(entry);
    return sum;
  }

  /// With G(l) = V - 1/2 sum l K, dG = -1/2 sum K dl, and G is the volume at the structure, where K is 0.
  /// From there to the midpoint each l changes by no more than r, and K by no more than the sum of |dK/dl| r.
  /// Twice that leaves room for another's rounding. A few more bits, at one point, are cheap.
  Certification proof(const Ball& radius, bool with_volume) const {
    StructureProof found;
    found.bits = numeric::bits<Ball>();
    found.lengths = box(radius);
    found.radius = radius;
    found.fixed = system_.fixed();
    if (!with_volume) return {std::move(found), {}};
    const numeric::WorkingPrecision precise(found.bits + bits_beside_volume);
    const auto k = system_.curvature(middle_);
    const auto volume = system_.volume(middle_, progress_);
    if (!k || !volume) return {std::nullopt, missing_tetrahedron};
    Ball g = *volume;
    for (const EdgeId e : all<EdgeId>(middle_.size())) g -= middle_[e] * (*k)[e] / 2;
    found.volume = widened(g, Ball(radius * radius * total_slope_));
    return {std::move(found), {}};
  }

  const EdgeSystem& system_;
  const Gauge* points_;
  const Progress& progress_;
  Lengths middle_;
  Ball total_slope_ = 0;
};

/// As many decimal digits as are certain, and three more to tell the ends apart.
int digits_of(const Ball& x) {
  constexpr double digits_per_bit = 0.30103;
  return 3 + std::max(0, static_cast<int>(numeric::certain_bits(x) * digits_per_bit));
}

void require_found(const Triangulation& tri, const Skeleton& skeleton,
                   const hyperbolic::Hyperbolization<double>& found) {
  skeleton.require_current(tri);
  if (found.outcome != hyperbolic::Outcome::geometric || found.lengths.size() != skeleton.edge_count())
    throw PreconditionError("certify: needs a geometric structure of this triangulation");
}

} // namespace

VolumeInterval volume_interval(const StructureProof& proof) {
  const numeric::WorkingPrecision precision(proof.bits + bits_beside_volume);
  const int digits = digits_of(proof.volume);
  return {numeric::lower_decimal(proof.volume, digits), numeric::upper_decimal(proof.volume, digits)};
}

Certification certify(const Triangulation& tri, const Skeleton& skeleton,
                      const hyperbolic::Hyperbolization<double>& found, const CertifyOptions& options,
                      const Progress& progress) {
  require_found(tri, skeleton, found);
  const Gauge gauge(tri, skeleton);
  const EdgeSystem system =
      gauge.has_points() ? EdgeSystem(skeleton, gauge.choose(found.lengths)) : EdgeSystem(skeleton);
  if (!system.is_square())
    return {std::nullopt, "the identities of the cusps and finite vertices depend on each other"};
  if (system.unknowns() > options.most_unknowns)
    return {std::nullopt, "it has " + std::to_string(system.unknowns()) + " unknown lengths, and at most " +
                              std::to_string(options.most_unknowns) + " are certified"};
  const auto y = approximate_inverse(system, found.lengths);
  if (!y) return {std::nullopt, "the equations are singular"};
  Certification last;
  for (int bits = options.bits; bits <= std::max(options.bits, options.most_bits); bits *= 2) {
    const numeric::WorkingPrecision precision(bits);
    last = Attempt(system, gauge.has_points() ? &gauge : nullptr, found.lengths, progress)
               .run(*y, options.volume);
    if (last.proof) break;
  }
  return last;
}

std::optional<hyperbolic::Metric<Ball>> solve_merged(const Skeleton& skeleton,
                                                     const Table<EdgeId, int>& block,
                                                     const hyperbolic::Metric<double>& start, double reach,
                                                     const Progress& progress) {
  const EdgeSystem system(skeleton, block);
  if (system.is_free() || system.unknowns() > CertifyOptions{}.most_unknowns) return std::nullopt;
  std::vector<double> sum(static_cast<std::size_t>(system.unknowns()), 0);
  std::vector<int> count(sum.size(), 0);
  for (const EdgeId e : all<EdgeId>(start.size())) {
    sum[block[e]] += start[e];
    ++count[block[e]];
  }
  hyperbolic::Metric<double> even = start;
  for (const EdgeId e : all<EdgeId>(start.size())) even[e] = sum[block[e]] / count[block[e]];
  const auto y = approximate_inverse(system, even);
  if (!y) return std::nullopt;
  return Attempt(system, nullptr, even, progress).run_alone(*y, reach);
}

Certification certify_to(int digits, const Triangulation& tri, const Skeleton& skeleton,
                         const hyperbolic::Hyperbolization<double>& found, const Progress& progress) {
  constexpr double bits_per_digit = 3.3219280948873626; // log2(10), rounded up
  Certification last;
  for (int spare = 64; spare <= 1024; spare *= 4) {
    const int bits = static_cast<int>(std::ceil(digits * bits_per_digit)) + spare;
    last = certify(tri, skeleton, found, {bits, bits}, progress);
    if (!last.proof) continue;
    const numeric::WorkingPrecision precision(bits);
    const Ball& volume = last.proof->volume;
    if (numeric::certain_bits(volume) > bits - spare + 4) return last;
  }
  if (last.proof) last = {std::nullopt, "the volume is not enclosed to so many digits"};
  return last;
}

} // namespace tetrarch::verified
