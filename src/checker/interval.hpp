// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Intervals of MPFI, and numbers with derivatives over them.

#include <array>
#include <cstddef>
#include <mpfi.h>
#include <string>

namespace tetrarch::checker {

/// A closed interval of reals. Every operation gives one that holds all results. Comparisons are certain.
class Interval {
public:
  Interval() : Interval(0.0) {}
  Interval(int value) : Interval(static_cast<double>(value)) {}
  Interval(double value) {
    mpfi_init2(x_, bits);
    mpfi_set_d(x_, value);
  }
  /// A number in decimal or hexadecimal, "-1.5e-3", "0x3p-1". `text` has been checked to be one.
  explicit Interval(const std::string& text);
  Interval(const Interval& other) {
    mpfi_init2(x_, bits);
    mpfi_set(x_, other.x_);
  }
  Interval& operator=(const Interval& other) {
    mpfi_set(x_, other.x_);
    return *this;
  }
  ~Interval() { mpfi_clear(x_); }

  friend Interval operator+(const Interval& a, const Interval& b) { return made(mpfi_add, a, b); }
  friend Interval operator-(const Interval& a, const Interval& b) { return made(mpfi_sub, a, b); }
  friend Interval operator*(const Interval& a, const Interval& b) { return made(mpfi_mul, a, b); }
  friend Interval operator/(const Interval& a, const Interval& b) { return made(mpfi_div, a, b); }
  friend Interval operator-(const Interval& a) { return made(mpfi_neg, a); }
  friend Interval abs(const Interval& a) { return made(mpfi_abs, a); }
  friend Interval sqrt(const Interval& a) { return made(mpfi_sqrt, a); }
  friend Interval exp(const Interval& a) { return made(mpfi_exp, a); }
  friend Interval log(const Interval& a) { return made(mpfi_log, a); }
  friend Interval cosh(const Interval& a) { return made(mpfi_cosh, a); }
  friend Interval sinh(const Interval& a) { return made(mpfi_sinh, a); }
  friend Interval sin(const Interval& a) { return made(mpfi_sin, a); }
  friend Interval cos(const Interval& a) { return made(mpfi_cos, a); }
  friend Interval acos(const Interval& a) { return made(mpfi_acos, a); }
  friend Interval atan2(const Interval& y, const Interval& x) { return made(mpfi_atan2, y, x); }
  /// All from the least to the greatest number in either.
  friend Interval hull(const Interval& a, const Interval& b) { return made(mpfi_union, a, b); }
  static Interval pi() {
    Interval result;
    mpfi_const_pi(result.x_);
    return result;
  }

  /// For all numbers in them; false where one is not a number.
  friend bool less(const Interval& a, const Interval& b) {
    return mpfr_less_p(&a.x_->right, &b.x_->left) != 0;
  }
  friend bool less_equal(const Interval& a, const Interval& b) {
    return mpfr_lessequal_p(&a.x_->right, &b.x_->left) != 0;
  }
  /// The middle, a single number; and what is left, around 0.
  Interval middle() const;
  Interval rest() const { return *this - middle(); }
  /// Its greatest number.
  Interval upper_end() const {
    Interval result;
    mpfi_set_fr(result.x_, &x_->right);
    return result;
  }
  double nearest_double() const { return mpfi_get_d(x_); }

  /// Of the intervals made from now on in this thread.
  static thread_local mpfr_prec_t bits;
  /// Sets that for a scope.
  class Precision {
  public:
    explicit Precision(mpfr_prec_t wanted) : before_(bits) { bits = wanted; }
    ~Precision() { bits = before_; }
    Precision(const Precision&) = delete;
    Precision& operator=(const Precision&) = delete;

  private:
    mpfr_prec_t before_;
  };

private:
  template <class Function, class... More>
  static Interval made(Function function, const Interval& a, const More&... more) {
    Interval result;
    function(result.x_, a.x_, more.x_...);
    return result;
  }

  mpfi_t x_;
};

/// A number that depends on the six lengths of a tetrahedron, with its derivatives.
struct Dual {
  Interval value;
  std::array<Interval, 6> slope{};

  friend Dual operator+(const Dual& a, const Dual& b) { return made(a.value + b.value, a, 1, b, 1); }
  friend Dual operator-(const Dual& a, const Dual& b) { return made(a.value - b.value, a, 1, b, -1); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return made(a.value * b.value, a, b.value, b, a.value);
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const Interval quotient = a.value / b.value;
    return made(quotient, a, 1 / b.value, b, -quotient / b.value);
  }
  /// f(a), where f'(a) is known.
  static Dual of(const Interval& value, const Dual& a, const Interval& derivative) {
    Dual result{value};
    for (std::size_t k = 0; k < 6; ++k) result.slope[k] = a.slope[k] * derivative;
    return result;
  }
  friend Dual sqrt(const Dual& a) {
    const Interval root = sqrt(a.value);
    return of(root, a, 1 / (2 * root));
  }
  friend Dual exp(const Dual& a) { return of(exp(a.value), a, exp(a.value)); }
  friend Dual cosh(const Dual& a) { return of(cosh(a.value), a, sinh(a.value)); }
  friend Dual sinh(const Dual& a) { return of(sinh(a.value), a, cosh(a.value)); }
  friend Dual acos(const Dual& a) { return of(acos(a.value), a, -1 / sqrt(1 - a.value * a.value)); }

private:
  static Dual made(const Interval& value, const Dual& a, const Interval& by_a, const Dual& b,
                   const Interval& by_b) {
    Dual result{value};
    for (std::size_t k = 0; k < 6; ++k) result.slope[k] = a.slope[k] * by_a + b.slope[k] * by_b;
    return result;
  }
};

} // namespace tetrarch::checker
