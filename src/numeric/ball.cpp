// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/ball.hpp"

#include "raw_ball.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <utility>

namespace tetrarch::numeric {

namespace {

constexpr long most_bits = 1'000'000;
/// Enough for ends of intervals: they differ from the midpoint by few bits of the radius.
constexpr long guard_bits = 64;

long& precision() {
  thread_local long bits = 53;
  return bits;
}

/// The result of Arb's function of one argument.
template <class Function>
Ball made(Function function, const Ball& x) {
  Ball result;
  function(raw(result), raw(x), precision());
  return result;
}

Ball ball_of(const arf_t value) {
  Ball result;
  arb_set_arf(raw(result), value);
  return result;
}

/// An end of the interval; `bound` rounds outward.
template <class Bound>
Ball end_of(const Ball& x, Bound bound) {
  arf_t end;
  arf_init(end);
  bound(end, raw(x), precision() + guard_bits);
  Ball result = ball_of(end);
  arf_clear(end);
  return result;
}

/// The midpoint in decimal, rounded in that direction: "-0.5", "6.45", "1.5e-30".
std::string decimal(const Ball& exact, int digits, mpfr_rnd_t direction) {
  mpfr_t value;
  mpfr_init2(value, precision() + 2 * guard_bits);
  arf_get_mpfr(value, arb_midref(raw(exact)), direction);
  char* text = nullptr;
  const char* const format = direction == MPFR_RNDD ? "%.*RDg" : "%.*RUg";
  const int length = mpfr_asprintf(&text, format, digits, value);
  mpfr_clear(value);
  if (length < 0) throw std::bad_alloc();
  std::string result(text);
  mpfr_free_str(text);
  return result;
}

} // namespace

Ball::Ball(int value) : storage_() {
  arb_init(raw(*this));
  arb_set_si(raw(*this), value);
}

Ball::Ball(double value) : storage_() {
  arb_init(raw(*this));
  if (std::isfinite(value))
    arb_set_d(raw(*this), value);
  else
    arb_indeterminate(raw(*this));
}

Ball::Ball(const Ball& other) : storage_() {
  arb_init(raw(*this));
  arb_set(raw(*this), raw(other));
}

Ball::Ball(Ball&& other) noexcept : storage_() {
  arb_init(raw(*this));
  arb_swap(raw(*this), raw(other));
}

Ball& Ball::operator=(const Ball& other) {
  arb_set(raw(*this), raw(other));
  return *this;
}

Ball& Ball::operator=(Ball&& other) noexcept {
  arb_swap(raw(*this), raw(other));
  return *this;
}

Ball::~Ball() {
  arb_clear(raw(*this));
}

Ball& Ball::operator+=(const Ball& x) {
  arb_add(raw(*this), raw(*this), raw(x), precision());
  return *this;
}

Ball& Ball::operator-=(const Ball& x) {
  arb_sub(raw(*this), raw(*this), raw(x), precision());
  return *this;
}

Ball& Ball::operator*=(const Ball& x) {
  arb_mul(raw(*this), raw(*this), raw(x), precision());
  return *this;
}

Ball& Ball::operator/=(const Ball& x) {
  arb_div(raw(*this), raw(*this), raw(x), precision());
  return *this;
}

bool Ball::certainly_above(const Ball& x) const {
  return arb_gt(raw(*this), raw(x)) != 0;
}

bool Ball::certainly_not_below(const Ball& x) const {
  return arb_ge(raw(*this), raw(x)) != 0;
}

bool Ball::is_same_number(const Ball& x) const {
  return arb_eq(raw(*this), raw(x)) != 0;
}

long working_precision() {
  return precision();
}

WorkingPrecision::WorkingPrecision(long bits) : before_(precision()) {
  precision() = std::clamp(bits, 2L, most_bits);
}

WorkingPrecision::~WorkingPrecision() {
  precision() = before_;
}

Ball abs(const Ball& x) {
  Ball result;
  arb_abs(raw(result), raw(x));
  return result;
}

Ball sqrt(const Ball& x) {
  return made(arb_sqrt, x);
}
Ball exp(const Ball& x) {
  return made(arb_exp, x);
}
Ball log(const Ball& x) {
  return made(arb_log, x);
}
Ball sinh(const Ball& x) {
  return made(arb_sinh, x);
}
Ball cosh(const Ball& x) {
  return made(arb_cosh, x);
}
Ball sin(const Ball& x) {
  return made(arb_sin, x);
}
Ball cos(const Ball& x) {
  return made(arb_cos, x);
}

Ball atan2(const Ball& y, const Ball& x) {
  Ball result;
  arb_atan2(raw(result), raw(y), raw(x), precision());
  return result;
}

Ball ldexp(const Ball& x, int exponent) {
  Ball result;
  arb_mul_2exp_si(raw(result), raw(x), exponent);
  return result;
}

Ball midpoint(const Ball& x) {
  return ball_of(arb_midref(raw(x)));
}

Ball radius(const Ball& x) {
  Ball result;
  arf_set_mag(arb_midref(raw(result)), arb_radref(raw(x)));
  return result;
}

template <>
Ball widened(const Ball& value, const Ball& by) {
  Ball result(value);
  arb_add_error(raw(result), raw(by));
  return result;
}

Ball lower_end(const Ball& x) {
  return end_of(x, arb_get_lbound_arf);
}

Ball upper_end(const Ball& x) {
  return end_of(x, arb_get_ubound_arf);
}

bool contains(const Ball& outer, const Ball& inner) {
  return arb_contains(raw(outer), raw(inner)) != 0;
}

bool overlap(const Ball& x, const Ball& y) {
  return arb_overlaps(raw(x), raw(y)) != 0;
}

bool is_finite(const Ball& x) {
  return arb_is_finite(raw(x)) != 0;
}

Sign sign(const Ball& x) {
  if (arb_is_zero(raw(x)) != 0) return Sign::zero;
  if (arb_is_positive(raw(x)) != 0) return Sign::positive;
  return arb_is_negative(raw(x)) != 0 ? Sign::negative : Sign::undecided;
}

void take_memory_from(void* (*allocate)(std::size_t), void* (*allocate_cleared)(std::size_t, std::size_t),
                      void* (*reallocate)(void*, std::size_t), void (*release)(void*)) {
  __flint_set_memory_functions(allocate, allocate_cleared, reallocate, release);
}

double to_double(const Ball& x) {
  return arf_get_d(arb_midref(raw(x)), ARF_RND_NEAR);
}

int certain_bits(const Ball& x) {
  return static_cast<int>(std::clamp(arb_rel_accuracy_bits(raw(x)), -most_bits, precision() + guard_bits));
}

std::string lower_decimal(const Ball& x, int digits) {
  return decimal(lower_end(x), digits, MPFR_RNDD);
}

std::string upper_decimal(const Ball& x, int digits) {
  return decimal(upper_end(x), digits, MPFR_RNDU);
}

std::string certain_digits(const Ball& x, int digits) {
  const std::unique_ptr<char, void (*)(void*)> text(arb_get_str(raw(x), digits, ARB_STR_NO_RADIUS),
                                                    flint_free);
  return text.get();
}

std::string hexadecimal(const Ball& x) {
  fmpz_t mantissa;
  fmpz_t exponent;
  fmpz_init(mantissa);
  fmpz_init(exponent);
  arf_get_fmpz_2exp(mantissa, exponent, arb_midref(raw(x)));
  const bool negative = fmpz_sgn(mantissa) < 0;
  fmpz_abs(mantissa, mantissa);
  const std::unique_ptr<char, void (*)(void*)> digits(fmpz_get_str(nullptr, 16, mantissa), flint_free);
  std::string text =
      (negative ? "-0x" : "0x") + std::string(digits.get()) + "p" + std::to_string(fmpz_get_si(exponent));
  fmpz_clear(mantissa);
  fmpz_clear(exponent);
  return text;
}

void free_thread_cache() {
  flint_cleanup();
  mpfr_free_cache();
}

template <>
Ball pi<Ball>() {
  Ball result;
  arb_const_pi(raw(result), precision());
  return result;
}

} // namespace tetrarch::numeric
