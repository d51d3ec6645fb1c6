// SPDX-License-Identifier: GPL-2.0-or-later
#include "clausen.hpp"

#include "tetrarch/hyperbolic/volume.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/scalar.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace tetrarch::hyperbolic {
namespace {

using numeric::Ball;

/// Coefficients of the two series of Clausen's function, for n = 1, 2, ...:
///   Cl(x)      = x - x log x + sum zero[n] x^(2n+1),   zero[n] = |B_2n| / (2n (2n+1)!)
///   Cl(pi - y) = y log 2     - sum half[n] y^(2n+1),   half[n] = (4^n - 1) zero[n]
/// Used for x <= 2 pi/3 and y <= pi/3, where each term is at most a ninth of the one before.
template <class Scalar>
struct ClausenSeries {
  std::vector<Scalar> zero;
  std::vector<Scalar> half;

  /// The tangent numbers T_n = 4^n (4^n - 1) |B_2n| / (2n) come from a recurrence that only adds positive
  /// numbers (Brent-Harvey 2011), so no digit is lost, in any scalar. An even number of terms: they are
  /// summed two by two.
  explicit ClausenSeries(int pairs) {
    const int terms = 2 * pairs;
    std::vector<Scalar> tangent(static_cast<std::size_t>(terms) + 1, Scalar(1));
    for (int k = 2; k <= terms; ++k) tangent[k] = (k - 1) * tangent[k - 1];
    for (int k = 2; k <= terms; ++k)
      for (int j = k; j <= terms; ++j) tangent[j] = (j - k) * tangent[j - 1] + (j - k + 2) * tangent[j];
    Scalar power = 1;
    Scalar factorial = 1;
    for (int n = 1; n <= terms; ++n) {
      power *= 4;
      factorial *= 2 * n * (2 * n + 1);
      half.push_back(tangent[n] / (power * factorial));
      zero.push_back(half.back() / (power - 1));
    }
  }
};

template <class Scalar>
const ClausenSeries<Scalar>& clausen_series() {
  static const ClausenSeries<Scalar> series(static_cast<int>(numeric::bits<Scalar>() / (4 * std::log2(3.0))));
  return series;
}

/// One for each precision. A term is less than a seventh of the one before even where the range is left by
/// rounding, so that all behind the last one come to less than 2^-bits of the first.
template <>
const ClausenSeries<Ball>& clausen_series() {
  constexpr double bits_of_two_pairs = 5.6; // 2 log2(7), rounded down
  thread_local std::map<int, ClausenSeries<Ball>> series;
  const int bits = numeric::bits<Ball>();
  return series.try_emplace(bits, static_cast<int>(bits / bits_of_two_pairs) + 1).first->second;
}

/// sum c[n] x^(2n+1). Odd and even terms apart, so that two chains of products run side by side.
template <class Scalar>
Scalar odd_series(const std::vector<Scalar>& c, const Scalar& x) {
  using std::ldexp;
  const Scalar square = x * x;
  const Scalar fourth = square * square;
  Scalar odd = 0;
  Scalar even = 0;
  for (std::size_t n = c.size(); n > 0; n -= 2) {
    odd = odd * fourth + c[n - 2];
    even = even * fourth + c[n - 1];
  }
  const Scalar cube = x * square;
  return numeric::widened(Scalar(cube * (odd + even * square)),
                          Scalar(cube * ldexp(c.front(), -numeric::bits<Scalar>())));
}

/// pi less its nearest number of the scalar.
template <class Scalar>
Scalar rest_of_pi() {
  return Scalar(0); // the scalar holds ten digits more than results need
}
template <>
double rest_of_pi<double>() {
  return 1.2246467991473532e-16; // the sine of the double nearest to pi
}

/// For r in (0, 2 pi/3]; the slope there is |log(2 sin(r/2))|, within 0.2 of |log r|.
template <class Scalar>
ClausenTerm<Scalar> near_whole_turn(const Scalar& r, const Scalar& r_error) {
  using std::abs;
  using std::log;
  const Scalar logarithm = log(r);
  const Scalar size = abs(logarithm);
  ClausenTerm<Scalar> term;
  term.value = r - r * logarithm + odd_series(clausen_series<Scalar>().zero, r);
  // Cl is concave on (0, pi/3) and odd, hence |Cl(x + e) - Cl(x)| <= 2 Cl(e/2) for all x.
  term.slope = r >= 2 * r_error ? Scalar(size + 1) : Scalar(2 + abs(log(r_error)));
  term.error = term.slope * r_error + 6 * numeric::unit<Scalar>() * r * (1 + size);
  term.distance = r;
  return term;
}

template <class Scalar>
Scalar log_two() {
  using std::log;
  static const Scalar value = log(Scalar(2));
  return value;
}
template <>
Ball log_two() {
  return log(Ball(2));
}

/// Cl(pi - y) for y in [0, pi/3]; the slope there is at most log 2.
template <class Scalar>
ClausenTerm<Scalar> near_half_turn(const Scalar& y, const Scalar& y_error) {
  ClausenTerm<Scalar> term;
  term.value = y * log_two<Scalar>() - odd_series(clausen_series<Scalar>().half, y);
  term.slope = Scalar(0.7);
  term.error = term.slope * y_error + 4 * numeric::unit<Scalar>() * y;
  term.distance = numeric::pi<Scalar>() - y;
  return term;
}

/// The whole number nearest to x; one of the nearest will do.
template <class Scalar>
Scalar nearest_integer(const Scalar& x) {
  using std::floor;
  return floor(Scalar(x + Scalar(0.5)));
}
template <>
Ball nearest_integer(const Ball& x) {
  return {std::round(numeric::to_double(x))};
}

/// Cl at an argument that is a whole turn, or in a ball too near to one to be told from it.
template <class Scalar>
ClausenTerm<Scalar> at_whole_turn(const Scalar& /*r*/, const Scalar& /*r_error*/) {
  return {};
}
template <>
ClausenTerm<Ball> at_whole_turn(const Ball& r, const Ball& r_error) {
  const Ball reach = upper_end(abs(r) + r_error);
  ClausenTerm<Ball> term{};
  if (reach > 0) term.error = reach * (2 + abs(log(reach))); // as in near_whole_turn
  return term;
}

/// `value` with the sign of a rest that may be negative, the other way round if `turned`.
template <class Scalar>
Scalar with_sign(const Scalar& value, const Scalar& rest, bool turned) {
  return (rest < 0) != turned ? Scalar(-value) : value;
}
template <>
Ball with_sign(const Ball& value, const Ball& rest, bool turned) {
  if (!(rest < 0) && !(rest >= 0)) return numeric::widened(Ball(0), value);
  return (rest < 0) != turned ? -value : value;
}

template <class Scalar>
ClausenTerm<Scalar> term_at(int half_turns, const Scalar& x, const Scalar& x_error) {
  using std::abs;
  const Scalar half_turn = numeric::pi<Scalar>();
  Scalar rest = x;
  Scalar error = x_error;
  if (abs(x) > half_turn) {
    const Scalar turns = nearest_integer(Scalar(x / (2 * half_turn)));
    rest = (x - 2 * half_turn * turns) - 2 * rest_of_pi<Scalar>() * turns;
    error += 4 * numeric::unit<Scalar>() * half_turn * abs(turns);
  }
  const Scalar size = abs(rest);
  const bool odd = half_turns % 2 != 0;
  const bool far = odd ? 3 * size > half_turn : 3 * size > 2 * half_turn;
  const Scalar other = (half_turn - size) + rest_of_pi<Scalar>();
  if (far) error += 2 * numeric::unit<Scalar>() * half_turn;
  const Scalar& argument = far ? other : size;
  ClausenTerm<Scalar> term{};
  if (odd == far) {
    term = argument > 0 ? near_whole_turn(argument, error) : at_whole_turn(argument, error);
  } else {
    term = near_half_turn(argument, error);
  }
  // Cl(x) has the sign of its rest; Cl(pi + y) = -Cl(pi - y).
  term.value = with_sign(term.value, rest, odd);
  return term;
}

} // namespace

template <class Scalar>
ClausenTerm<Scalar> clausen_term(int half_turns, const Scalar& x, const Scalar& x_error) {
  return term_at(half_turns, x, x_error);
}

/// At the midpoint; the radius enters by the bound of what it can change, so that vertical tangents do no
/// harm.
template <>
ClausenTerm<Ball> clausen_term(int half_turns, const Ball& x, const Ball& /*x_error*/) {
  constexpr double wide = 0.25;     // beyond it the slopes are not those of term_at
  constexpr double largest = 1.015; // Cl(pi/3) = 1.01494...
  if (!(radius(x) < wide)) return {widened(Ball(0), Ball(largest)), Ball(0), Ball(0), Ball(0)};
  ClausenTerm<Ball> term = term_at(half_turns, midpoint(x), radius(x));
  term.value = widened(term.value, term.error);
  return term;
}

template <class Scalar>
Scalar clausen(const Scalar& x) {
  return clausen_term(0, x, Scalar(0)).value;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template ClausenTerm<Scalar> clausen_term(int, const Scalar&, const Scalar&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE
#define TETRARCH_INSTANTIATE(Scalar) template Scalar clausen(const Scalar&);
TETRARCH_FOR_EACH_FORMULA(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
