// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/unfold/relax.hpp"

#include "flat_energy.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/flat_triangle.hpp"
#include "tetrarch/numeric/sparse_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::unfold {
namespace {

using Complex = std::complex<double>;
using Kind = FlatFreedom::Kind;

/// The unknowns of the points: none, one or two of each, and the entries of the matrix that an element meets.
class Unknowns {
public:
  Unknowns(const std::vector<FlatElement>& elements, const std::vector<FlatFreedom>& freedom) {
    first_.push_back(0);
    for (const FlatFreedom& f : freedom)
      first_.push_back(first_.back() + (f.kind == Kind::fixed ? 0 : f.kind == Kind::free ? 2 : 1));
    // Each pair of a column and a row below it, by columns.
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(static_cast<std::size_t>(size()));
    for (int j = 0; j < size(); ++j) pairs.emplace_back(j, j);
    for (const FlatElement& e : elements) {
      const std::vector<int> own = of(e);
      for (const int column : own)
        for (const int row : own)
          if (column < row) pairs.emplace_back(column, row);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    matrix_.first.assign(1, 0);
    for (const auto& [column, row] : pairs) {
      while (static_cast<int>(matrix_.first.size()) <= column)
        matrix_.first.push_back(static_cast<int>(matrix_.row.size()));
      matrix_.row.push_back(row);
    }
    matrix_.first.push_back(static_cast<int>(matrix_.row.size()));
    matrix_.value.assign(matrix_.row.size(), 0.0);
    entries_.reserve(elements.size());
    for (const FlatElement& e : elements) entries_.push_back(entries_of(of(e)));
  }

  int size() const { return first_.back(); }
  int first(int point) const { return first_[static_cast<std::size_t>(point)]; }
  int count(int point) const { return first_[static_cast<std::size_t>(point) + 1] - first(point); }

  numeric::SymmetricMatrix& matrix() { return matrix_; }
  /// Where the product of unknowns i and j <= i of the element is: in the order (0, 0), (1, 0), (1, 1), ...
  const std::array<int, 21>& entries(std::size_t element) const { return entries_[element]; }

private:
  std::vector<int> of(const FlatElement& e) const {
    std::vector<int> result;
    for (const int v : e.corner)
      for (int k = 0; k < count(v); ++k) result.push_back(first(v) + k);
    return result;
  }
  std::array<int, 21> entries_of(const std::vector<int>& own) const {
    std::array<int, 21> result{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const int column = std::min(own[i], own[j]);
        const auto begin = matrix_.row.begin() + matrix_.first[static_cast<std::size_t>(column)];
        const auto end = matrix_.row.begin() + matrix_.first[static_cast<std::size_t>(column) + 1];
        result[next++] =
            static_cast<int>(std::lower_bound(begin, end, std::max(own[i], own[j])) - matrix_.row.begin());
      }
    return result;
  }

  std::vector<int> first_;
  numeric::SymmetricMatrix matrix_;
  std::vector<std::array<int, 21>> entries_;
};

Complex tangent(const FlatFreedom& f) {
  const Complex unit = f.arm / std::abs(f.arm);
  return f.kind == Kind::circle ? Complex(0, 1) * unit : unit;
}

/// The triangles in the plane, and their descent.
class Drawing {
public:
  Drawing(std::vector<FlatElement> elements, std::vector<FlatFreedom> freedom)
      : elements_(std::move(elements)), freedom_(std::move(freedom)), unknowns_(elements_, freedom_),
        cholesky_(unknowns_.matrix()), shift_(freedom_.size(), 0.0) {
    for (const FlatElement& e : elements_) {
      derivative_.emplace_back(e.wanted);
      total_weight_ += e.weight;
    }
  }

  bool can_move() const { return unknowns_.size() > 0; }
  std::vector<Complex> take_shift() { return std::move(shift_); }

  double energy() const {
    double sum = 0;
    for (std::size_t t = 0; t < elements_.size(); ++t)
      sum += elements_[t].weight * flat_energy(derivative_[t], elements_[t].now);
    return sum / total_weight_;
  }

  /// Moves the points one step down from energy `now`. Returns the energy then: `now` where there is no way.
  double step(Model model, double now) {
    const std::vector<double> x = direction(model);
    if (x.empty()) return now;
    double fall = 0; // along the direction, a slope
    for (std::size_t i = 0; i < x.size(); ++i) fall -= gradient_[i] * x[i];
    fall /= total_weight_;
    if (!(fall > 0)) return now;
    constexpr double part_of_the_way = 0.9;
    constexpr double armijo = 1e-4;
    constexpr int most_halvings = 40;
    double length = std::min(1.0, part_of_the_way * way_until_flat(x));
    const std::vector<FlatElement> before = elements_;
    for (int k = 0; k < most_halvings; ++k, length /= 2) {
      const std::vector<Complex> moves = moved(x, length);
      for (std::size_t t = 0; t < elements_.size(); ++t)
        for (const std::size_t end : {0, 1})
          elements_[t].now[end] =
              before[t].now[end] + moves[before[t].corner[end + 1]] - moves[before[t].corner[0]];
      const double there = energy();
      if (!(there < now - armijo * length * fall)) continue;
      for (std::size_t v = 0; v < moves.size(); ++v) {
        shift_[v] += moves[v];
        if (freedom_[v].kind == Kind::circle) freedom_[v].arm += moves[v];
      }
      return there;
    }
    elements_ = before;
    return now;
  }

private:
  /// The minimum of the quadratic model; empty if the matrix cannot be factored.
  std::vector<double> direction(Model model) {
    gradient_.assign(static_cast<std::size_t>(unknowns_.size()), 0.0);
    std::vector<double>& value = unknowns_.matrix().value;
    std::fill(value.begin(), value.end(), 0.0);
    std::vector<Complex> whole_gradient(freedom_.size(), 0.0);
    for (std::size_t t = 0; t < elements_.size(); ++t) {
      const FlatElement& e = elements_[t];
      const FlatQuadratic q = flat_quadratic(derivative_[t], e.now, model);
      for (std::size_t k = 0; k < 3; ++k)
        whole_gradient[e.corner[k]] += e.weight * Complex(q.gradient[2 * k], q.gradient[2 * k + 1]);
      add(e, q, unknowns_.entries(t));
    }
    for (std::size_t v = 0; v < freedom_.size(); ++v) {
      const FlatFreedom& f = freedom_[v];
      const int first = unknowns_.first(static_cast<int>(v));
      if (f.kind == Kind::free) {
        gradient_[first] = whole_gradient[v].real();
        gradient_[first + 1] = whole_gradient[v].imag();
      } else if (f.kind != Kind::fixed) {
        gradient_[first] = (std::conj(tangent(f)) * whole_gradient[v]).real();
      }
      // A point that is pushed towards the center of its circle is held by the circle's bend.
      if (f.kind == Kind::circle)
        value[unknowns_.matrix().first[first]] +=
            std::max(0.0, -(std::conj(f.arm) * whole_gradient[v]).real() / std::norm(f.arm));
    }
    // What turns as a whole costs nothing; a little holds it, and what is in no element.
    double greatest = 0;
    for (int j = 0; j < unknowns_.size(); ++j)
      greatest = std::max(greatest, value[unknowns_.matrix().first[j]]);
    constexpr double a_little = 1e-10;
    for (int j = 0; j < unknowns_.size(); ++j) {
      double& diagonal = value[unknowns_.matrix().first[j]];
      diagonal = diagonal > 0 ? diagonal * (1 + a_little) : greatest;
    }
    if (!std::isfinite(greatest) || !cholesky_.factor(unknowns_.matrix())) return {};
    std::vector<double> load;
    load.reserve(gradient_.size());
    for (const double g : gradient_) load.push_back(-g);
    std::vector<double> x(load.size());
    cholesky_.solve(load, x);
    const bool finite = std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
    return finite ? x : std::vector<double>{};
  }

  void add(const FlatElement& e, const FlatQuadratic& q, const std::array<int, 21>& entries) {
    // Of each unknown of the element, its direction in the six coordinates: two of them at most.
    std::array<std::pair<std::size_t, Complex>, 6> unknown{};
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const FlatFreedom& f = freedom_[e.corner[k]];
      if (f.kind == Kind::free) {
        unknown[n++] = {2 * k, Complex(1, 0)};
        unknown[n++] = {2 * k, Complex(0, 1)};
      } else if (f.kind != Kind::fixed) {
        unknown[n++] = {2 * k, tangent(f)};
      }
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const auto& [at, u] = unknown[i];
        const auto& [from, w] = unknown[j];
        const auto& h = q.hessian;
        unknowns_.matrix().value[entries[next++]] +=
            e.weight * (u.real() * (h[at][from] * w.real() + h[at][from + 1] * w.imag()) +
                        u.imag() * (h[at + 1][from] * w.real() + h[at + 1][from + 1] * w.imag()));
      }
  }

  Complex straight(const std::vector<double>& x, std::size_t v) const {
    const FlatFreedom& f = freedom_[v];
    const int first = unknowns_.first(static_cast<int>(v));
    if (f.kind == Kind::fixed) return 0;
    return f.kind == Kind::free ? Complex(x[first], x[first + 1]) : x[first] * tangent(f);
  }

  /// Of each point, on its curve.
  std::vector<Complex> moved(const std::vector<double>& x, double length) const {
    std::vector<Complex> result(freedom_.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
      const FlatFreedom& f = freedom_[v];
      result[v] = length * straight(x, v);
      if (f.kind != Kind::circle) continue;
      const double turn = (result[v] / f.arm).imag();
      // e^(i turn) - 1 without cancellation.
      result[v] = f.arm * Complex(-2 * std::pow(std::sin(turn / 2), 2), std::sin(turn));
    }
    return result;
  }

  double way_until_flat(const std::vector<double>& x) const {
    double least = INFINITY;
    for (const FlatElement& e : elements_) {
      const Complex origin = straight(x, e.corner[0]);
      least = std::min(
          least, first_flat(e.now, {straight(x, e.corner[1]) - origin, straight(x, e.corner[2]) - origin}));
    }
    return least;
  }

  std::vector<FlatElement> elements_;
  std::vector<FlatFreedom> freedom_;
  std::vector<FlatDerivative> derivative_;
  double total_weight_ = 0;
  Unknowns unknowns_;
  numeric::SparseCholesky cholesky_;
  std::vector<double> gradient_;
  std::vector<Complex> shift_;
};

void require_flat(const std::vector<FlatElement>& elements, const std::vector<FlatFreedom>& freedom) {
  const int points = static_cast<int>(freedom.size());
  for (const FlatElement& e : elements) {
    for (const int v : e.corner)
      if (v < 0 || v >= points) throw PreconditionError("relaxed: a corner is none of the points");
    if (!is_counterclockwise(e))
      throw PreconditionError("relaxed: triangles and their wanted shapes must be counterclockwise");
  }
}

} // namespace

bool is_counterclockwise(const FlatElement& element) {
  return numeric::cross(element.wanted[0], element.wanted[1]) > 0 &&
         numeric::cross(element.now[0], element.now[1]) > 0;
}

Relaxed relaxed(std::vector<FlatElement> elements, std::vector<FlatFreedom> freedom,
                const FlatOptions& options, const Progress& progress) {
  require_flat(elements, freedom);
  Relaxed result;
  result.shift.assign(freedom.size(), 0.0);
  if (elements.empty()) return result;
  std::vector<char> is_met(freedom.size(), 0);
  for (const FlatElement& e : elements)
    for (const int v : e.corner) is_met[v] = 1;
  for (std::size_t v = 0; v < freedom.size(); ++v)
    if (!is_met[v]) freedom[v].kind = Kind::fixed;
  Drawing drawing(std::move(elements), std::move(freedom));
  result.before = result.after = drawing.energy();
  if (!drawing.can_move() || !std::isfinite(result.before)) return result;
  // Far away reweighting goes straighter, near by Newton is quicker.
  Model model = Model::reweighted;
  constexpr double nearly_there = 0.05;
  while (result.steps < options.most_steps) {
    progress.step("distortion", result.steps / static_cast<double>(options.most_steps));
    const double next = drawing.step(model, result.after);
    const double gain = (result.after - next) / result.after;
    result.after = next;
    ++result.steps;
    if (model == Model::reweighted) {
      if (gain < nearly_there) model = Model::newton;
    } else if (gain < options.least_gain) {
      result.settled = true;
      break;
    }
  }
  result.shift = drawing.take_shift();
  return result;
}

} // namespace tetrarch::unfold
