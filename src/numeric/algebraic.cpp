// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/algebraic.hpp"

#include "raw_ball.hpp"

#include <flint/fmpq_poly.h>
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace tetrarch::numeric {

static_assert(sizeof(fmpq_poly_struct) == 4 * sizeof(std::uint64_t));

/// The one place that knows what is stored.
struct AlgebraicAccess {
  static fmpq_poly_struct* of(Algebraic& x) {
    return static_cast<fmpq_poly_struct*>(static_cast<void*>(x.storage_.data()));
  }
  static const fmpq_poly_struct* of(const Algebraic& x) {
    return static_cast<const fmpq_poly_struct*>(static_cast<const void*>(x.storage_.data()));
  }
};

static fmpq_poly_struct* raw(Algebraic& x) {
  return AlgebraicAccess::of(x);
}
static const fmpq_poly_struct* raw(const Algebraic& x) {
  return AlgebraicAccess::of(x);
}

namespace {

/// How many bits of the numbers each coefficient of a relation takes: those that are found by chance have as
/// many bits, and those that are believed less than half.
constexpr int bits_per_coefficient = 100;
constexpr int believed_bits = 45;

/// An integer polynomial that clears up after itself.
class IntegerPolynomial {
public:
  IntegerPolynomial() { fmpz_poly_init(p_); }
  IntegerPolynomial(const IntegerPolynomial& other) : IntegerPolynomial() { fmpz_poly_set(p_, other.p_); }
  IntegerPolynomial& operator=(const IntegerPolynomial& other) {
    fmpz_poly_set(p_, other.p_);
    return *this;
  }
  ~IntegerPolynomial() { fmpz_poly_clear(p_); }
  fmpz_poly_struct* raw() { return p_; }
  const fmpz_poly_struct* raw() const { return p_; }
  int degree() const { return static_cast<int>(fmpz_poly_degree(p_)); }
  Ball at(const Ball& x) const {
    Ball value;
    arb_fmpz_poly_evaluate_arb(numeric::raw(value), p_, numeric::raw(x), working_precision());
    return value;
  }
  std::string text() const {
    char* const written = fmpz_poly_get_str_pretty(p_, "x");
    std::string result(written);
    flint_free(written);
    return result;
  }

private:
  fmpz_poly_t p_;
};

/// Whole numbers c, not all 0, with c_0 x_0 + ... + c_n x_n = 0 as far as can be seen, as the polynomial
/// c_0 + c_1 x + ...; nothing where only chance would give such.
std::optional<IntegerPolynomial> relation(const std::vector<Ball>& x) {
  const auto n = static_cast<slong>(x.size());
  const slong bits = bits_per_coefficient * n;
  fmpz_mat_t rows;
  fmpz_mat_init(rows, n, n + 1);
  bool known = true;
  for (slong k = 0; k < n; ++k) {
    fmpz_one(fmpz_mat_entry(rows, k, k));
    const Ball scaled = midpoint(ldexp(x[k], static_cast<int>(bits)));
    known = known && is_finite(x[k]) && radius(x[k]) < ldexp(Ball(1), static_cast<int>(-bits));
    if (known) arf_get_fmpz(fmpz_mat_entry(rows, k, n), arb_midref(numeric::raw(scaled)), ARF_RND_NEAR);
  }
  std::optional<IntegerPolynomial> found;
  if (known) {
    fmpz_lll_t how;
    fmpz_lll_context_init_default(how);
    fmpz_lll(rows, nullptr, how);
    bool small = true;
    for (slong k = 0; k <= n; ++k) small &= fmpz_bits(fmpz_mat_entry(rows, 0, k)) < believed_bits;
    if (small) {
      found.emplace();
      for (slong k = 0; k < n; ++k) fmpz_poly_set_coeff_fmpz(found->raw(), k, fmpz_mat_entry(rows, 0, k));
    }
  }
  fmpz_mat_clear(rows);
  return found;
}

/// 1, x, ..., x^degree.
std::vector<Ball> powers(const Ball& x, int degree) {
  std::vector<Ball> list{Ball(1)};
  for (int k = 0; k < degree; ++k) list.push_back(list.back() * x);
  return list;
}

/// The factor of which x seems to be a root.
std::optional<IntegerPolynomial> factor_at(const IntegerPolynomial& p, const Ball& x) {
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, p.raw());
  std::optional<IntegerPolynomial> found;
  for (slong k = 0; k < factors->num && !found; ++k) {
    IntegerPolynomial factor;
    fmpz_poly_set(factor.raw(), factors->p + k);
    if (!(abs(factor.at(x)) > 0)) found = factor;
  }
  fmpz_poly_factor_clear(factors);
  return found;
}

/// The least polynomial of which x seems to be a root, of at most that degree.
std::optional<IntegerPolynomial> least_polynomial(const Ball& x, int most_degree,
                                                  const std::function<void()>& still_wanted) {
  for (int degree = 1;; degree = std::min(most_degree, degree < 4 ? degree + 1 : degree * 3 / 2)) {
    if (still_wanted) still_wanted();
    if (const auto multiple = relation(powers(x, degree)))
      if (multiple->degree() > 0) return factor_at(*multiple, x);
    if (degree >= most_degree) return std::nullopt;
  }
}

} // namespace

/// m and the interval of its root.
class RealField {
public:
  /// Nothing unless m has exactly one root in the ball.
  static std::shared_ptr<const RealField> make(const IntegerPolynomial& m, const Ball& root) {
    IntegerPolynomial slope;
    fmpz_poly_derivative(slope.raw(), m.raw());
    const Ball below = m.at(lower_end(root));
    const Ball above = m.at(upper_end(root));
    const bool changes = (below < 0 && above > 0) || (below > 0 && above < 0);
    if (!changes || !(abs(slope.at(root)) > 0)) return nullptr;
    return std::shared_ptr<const RealField>(new RealField(m, root));
  }
  ~RealField() { fmpq_poly_clear(modulus_); }
  RealField(const RealField&) = delete;
  RealField& operator=(const RealField&) = delete;

  const fmpq_poly_struct* modulus() const { return modulus_; }
  const Ball& root() const { return root_; }

  /// -(c_1 + c_2 theta + ...) / c_0 of a relation c_0 x + c_1 + c_2 theta + ... = 0.
  static Algebraic solved(std::shared_ptr<const RealField> field, const IntegerPolynomial& c) {
    Algebraic x;
    for (slong k = 1; k <= c.degree(); ++k)
      fmpq_poly_set_coeff_fmpz(numeric::raw(x), k - 1, fmpz_poly_get_coeff_ptr(c.raw(), k));
    fmpq_poly_scalar_div_fmpz(numeric::raw(x), numeric::raw(x), fmpz_poly_get_coeff_ptr(c.raw(), 0));
    fmpq_poly_neg(numeric::raw(x), numeric::raw(x));
    x.field_ = std::move(field);
    return x;
  }

private:
  RealField(const IntegerPolynomial& m, Ball root) : root_(std::move(root)) {
    fmpq_poly_init(modulus_);
    fmpq_poly_set_fmpz_poly(modulus_, m.raw());
  }
  fmpq_poly_t modulus_;
  Ball root_;
};

Algebraic::Algebraic(int value) : storage_() {
  fmpq_poly_init(raw(*this));
  fmpq_poly_set_si(raw(*this), value);
}

Algebraic::Algebraic(const Algebraic& other) : field_(other.field_), storage_() {
  fmpq_poly_init(raw(*this));
  fmpq_poly_set(raw(*this), raw(other));
}

Algebraic::Algebraic(Algebraic&& other) noexcept : field_(std::move(other.field_)), storage_() {
  fmpq_poly_init(raw(*this));
  fmpq_poly_swap(raw(*this), raw(other));
}

Algebraic& Algebraic::operator=(const Algebraic& other) {
  if (this == &other) return *this;
  field_ = other.field_;
  fmpq_poly_set(raw(*this), raw(other));
  return *this;
}

Algebraic& Algebraic::operator=(Algebraic&& other) noexcept {
  std::swap(field_, other.field_);
  fmpq_poly_swap(raw(*this), raw(other));
  return *this;
}

Algebraic::~Algebraic() {
  fmpq_poly_clear(raw(*this));
}

Algebraic& Algebraic::operator+=(const Algebraic& x) {
  if (!field_) field_ = x.field_;
  fmpq_poly_add(raw(*this), raw(*this), raw(x));
  return *this;
}

Algebraic& Algebraic::operator-=(const Algebraic& x) {
  if (!field_) field_ = x.field_;
  fmpq_poly_sub(raw(*this), raw(*this), raw(x));
  return *this;
}

Algebraic& Algebraic::operator*=(const Algebraic& x) {
  if (!field_) field_ = x.field_;
  fmpq_poly_mul(raw(*this), raw(*this), raw(x));
  if (field_) fmpq_poly_rem(raw(*this), raw(*this), field_->modulus());
  return *this;
}

bool Algebraic::is_same(const Algebraic& x) const {
  return fmpq_poly_equal(raw(*this), raw(x)) != 0;
}

std::optional<Algebraic> Algebraic::inverse() const {
  if (fmpq_poly_is_zero(raw(*this)) != 0) return std::nullopt;
  Algebraic result;
  result.field_ = field_;
  if (!field_) {
    fmpq_poly_inv(raw(result), raw(*this));
    return result;
  }
  Algebraic common;
  Algebraic other;
  fmpq_poly_xgcd(raw(common), raw(result), raw(other), raw(*this), field_->modulus());
  if (fmpq_poly_is_one(raw(common)) == 0) return std::nullopt;
  return result;
}

Ball Algebraic::value() const {
  IntegerPolynomial numerator;
  fmpq_poly_get_numerator(numerator.raw(), raw(*this));
  Ball denominator;
  arb_set_fmpz(raw(denominator), fmpq_poly_denref(raw(*this)));
  return numerator.at(field_ ? field_->root() : Ball(0)) / denominator;
}

namespace {

/// The field that grows until it seems to hold every number.
class Recognizer {
public:
  Recognizer(const std::vector<Ball>& numbers, int most_degree, const std::function<void()>& still_wanted)
      : numbers_(numbers), most_degree_(most_degree), still_wanted_(still_wanted) {
    fmpz_poly_set_coeff_si(least_.raw(), 1, 1);
  }

  std::optional<Recognized> run() {
    for (;;) {
      const int doubtful = express();
      if (doubtful < 0) break;
      if (!grow(numbers_[doubtful])) return std::nullopt;
    }
    const auto field = RealField::make(least_, widened(theta_, ldexp(Ball(1), -root_bits)));
    if (!field) return std::nullopt;
    Recognized found{least_.text(), least_.degree(), {}};
    for (const IntegerPolynomial& c : relations_) found.numbers.push_back(RealField::solved(field, c));
    return found;
  }

private:
  /// Relations of all numbers with powers of theta; -1, or the first number that has none.
  int express() {
    relations_.clear();
    for (int k = 0; k < static_cast<int>(numbers_.size()); ++k) {
      const auto same = std::find_if(numbers_.begin(), numbers_.begin() + k,
                                     [&](const Ball& x) { return overlap(x, numbers_[k]); });
      if (same != numbers_.begin() + k) {
        relations_.push_back(relations_[static_cast<std::size_t>(same - numbers_.begin())]);
        continue;
      }
      if (still_wanted_) still_wanted_();
      std::vector<Ball> list = powers(theta_, least_.degree() - 1);
      list.insert(list.begin(), numbers_[k]);
      const auto c = relation(list);
      if (!c || fmpz_is_zero(fmpz_poly_get_coeff_ptr(c->raw(), 0)) != 0) return k;
      relations_.push_back(*c);
    }
    return -1;
  }

  /// Another generator, of a greater degree.
  bool grow(const Ball& x) {
    for (const Ball& generator : {x, theta_ + x, theta_ + 2 * x, theta_ - x}) {
      const auto least = least_polynomial(generator, most_degree_, still_wanted_);
      if (!least || least->degree() <= least_.degree()) continue;
      theta_ = generator;
      least_ = *least;
      return true;
    }
    return false;
  }

  /// The root's interval: narrow beside other roots, wide beside rounding.
  static constexpr int root_bits = 400;

  const std::vector<Ball>& numbers_;
  int most_degree_;
  const std::function<void()>& still_wanted_;
  Ball theta_ = 0;
  IntegerPolynomial least_; ///< x at first: the rationals
  std::vector<IntegerPolynomial> relations_;
};

} // namespace

std::optional<Recognized> recognize(const std::vector<Ball>& numbers, int most_degree,
                                    const std::function<void()>& still_wanted) {
  return Recognizer(numbers, most_degree, still_wanted).run();
}

} // namespace tetrarch::numeric
