// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Balls: real numbers known up to a radius, for proofs by computation.
///
///     ----------[=====m=====]----------      the set of all x with |x - m| <= r
///
/// Every operation gives a ball that contains the results for all numbers in its operands, whatever is
/// rounded on the way: f(x) lies in f(X) for x in X. So what a formula in balls says of signs is proved. A
/// ball that holds all reals (a division by a ball around 0, the root of a negative number) knows nothing.
///
/// Comparisons are certain: x < y is true if every number in x is below every one in y. Hence !(x < y) does
/// not say x >= y; formulas shared with other scalars are written so that a doubt falls on the safe side.
/// `==` asks for the same exact number twice, and `!=` is its negation.
///
/// Balls are Arb's (Johansson 2017), wrapped here once; this header costs nothing. Their midpoints have the
/// working precision of the thread (`WorkingPrecision`). Cost: 20 to 50 ns a sum or product at 53 bits, half
/// a microsecond an elementary function.

#include "tetrarch/numeric/predicates.hpp"
#include "tetrarch/numeric/scalar.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace tetrarch::numeric {

class Ball {
public:
  Ball() : Ball(0) {}
  Ball(int value);    ///< exact
  Ball(double value); ///< exact; knows nothing where `value` is no number or infinite
  Ball(const Ball& other);
  Ball(Ball&& other) noexcept;
  Ball& operator=(const Ball& other);
  Ball& operator=(Ball&& other) noexcept;
  ~Ball();

  Ball& operator+=(const Ball& x);
  Ball& operator-=(const Ball& x);
  Ball& operator*=(const Ball& x);
  Ball& operator/=(const Ball& x);
  friend Ball operator+(const Ball& x, const Ball& y) { return Ball(x) += y; }
  friend Ball operator-(const Ball& x, const Ball& y) { return Ball(x) -= y; }
  friend Ball operator*(const Ball& x, const Ball& y) { return Ball(x) *= y; }
  friend Ball operator/(const Ball& x, const Ball& y) { return Ball(x) /= y; }
  friend Ball operator-(const Ball& x) { return Ball(0) -= x; }

  friend bool operator<(const Ball& x, const Ball& y) { return y.certainly_above(x); }
  friend bool operator>(const Ball& x, const Ball& y) { return x.certainly_above(y); }
  friend bool operator<=(const Ball& x, const Ball& y) { return y.certainly_not_below(x); }
  friend bool operator>=(const Ball& x, const Ball& y) { return x.certainly_not_below(y); }
  friend bool operator==(const Ball& x, const Ball& y) { return x.is_same_number(y); }

private:
  friend struct BallAccess;
  bool certainly_above(const Ball& x) const;
  bool certainly_not_below(const Ball& x) const;
  bool is_same_number(const Ball& x) const;

  std::array<std::uint64_t, 6> storage_; ///< an arb_struct
};

/// The number of bits that midpoints of balls are computed with in this thread.
long working_precision();
/// Sets it for a scope; at least 2, at most 1,000,000.
class WorkingPrecision {
public:
  explicit WorkingPrecision(long bits);
  ~WorkingPrecision();
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;

private:
  long before_;
};

Ball abs(const Ball& x);
Ball sqrt(const Ball& x);
Ball exp(const Ball& x);
Ball log(const Ball& x);
Ball sinh(const Ball& x);
Ball cosh(const Ball& x);
Ball sin(const Ball& x);
Ball cos(const Ball& x);
Ball atan2(const Ball& y, const Ball& x);
/// x times 2^exponent, exactly.
Ball ldexp(const Ball& x, int exponent);

/// The midpoint, exact.
Ball midpoint(const Ball& x);
/// No less than the radius, exact.
Ball radius(const Ball& x);
/// What was left out of `value`, for instance the tail of a series: a ball grows by it. Other scalars carry
/// their errors apart.
template <class Scalar>
Scalar widened(const Scalar& value, const Scalar& /*by*/) {
  return value;
}
template <>
Ball widened(const Ball& value, const Ball& by);
/// Exact ends of an interval that contains x; rounded outward.
Ball lower_end(const Ball& x);
Ball upper_end(const Ball& x);

/// Every number in `inner` lies in `outer`.
bool contains(const Ball& outer, const Ball& inner);
/// Some number lies in both.
bool overlap(const Ball& x, const Ball& y);
/// False: the ball knows nothing, not even a bound.
bool is_finite(const Ball& x);
/// Undecided where x holds 0 and other numbers.
Sign sign(const Ball& x);

/// The double nearest to the midpoint.
double to_double(const Ball& x);
/// Where all balls take their memory from, in place of functions that abort where there is none. They may
/// throw. To be called before the first ball is made.
void take_memory_from(void* (*allocate)(std::size_t), void* (*allocate_cleared)(std::size_t, std::size_t),
                      void* (*reallocate)(void*, std::size_t), void (*release)(void*));
/// How many leading binary digits of x are certain; at most a few more than the working precision, and
/// negative where none is.
int certain_bits(const Ball& x);
/// A decimal number no greater than any in x, with so many significant digits; and one no less.
std::string lower_decimal(const Ball& x, int digits);
std::string upper_decimal(const Ball& x, int digits);
/// As many of the first `digits` significant digits as are certain, within one unit of the last.
std::string certain_digits(const Ball& x, int digits);
/// The midpoint exactly, as a hexadecimal floating-point number: an integer times a power of two, "0x1ap-4".
std::string hexadecimal(const Ball& x);

/// How many binary digits a scalar computes with.
template <class Scalar>
int bits() {
  return std::numeric_limits<Scalar>::digits;
}
template <>
inline int bits<Ball>() {
  return static_cast<int>(working_precision());
}

template <>
Ball pi<Ball>();
/// Rounding is in the radius already.
template <>
inline Ball unit<Ball>() {
  return Ball(0);
}

} // namespace tetrarch::numeric
