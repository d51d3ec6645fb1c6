// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Real algebraic numbers, exactly.
///
/// Let theta be the one root of an integer polynomial m in an interval. The numbers of the field Q(theta) are
/// polynomials in theta with rational coefficients, kept below the degree of m: sums and products are exact.
/// Equal polynomials are equal numbers. Different ones may be equal as well if m has factors; no proof here
/// asks that they differ.
///
/// `recognize` guesses the field and the polynomials from balls, by lattice reduction. What it gives is not
/// known to be what the balls hold: prove it by the equations that define the numbers.
/// Sources: Lenstra-Lenstra-Lovasz 1982; Cohen, A Course in Computational Algebraic Number Theory, section
/// 2.7. The arithmetic is FLINT's.

#include "tetrarch/numeric/ball.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::numeric {

class RealField;

/// A number of one field; a whole number belongs to all of them. Numbers of two fields do not mix.
class Algebraic {
public:
  Algebraic() : Algebraic(0) {}
  Algebraic(int value);
  Algebraic(const Algebraic& other);
  Algebraic(Algebraic&& other) noexcept;
  Algebraic& operator=(const Algebraic& other);
  Algebraic& operator=(Algebraic&& other) noexcept;
  ~Algebraic();

  Algebraic& operator+=(const Algebraic& x);
  Algebraic& operator-=(const Algebraic& x);
  Algebraic& operator*=(const Algebraic& x);
  friend Algebraic operator+(Algebraic x, const Algebraic& y) { return x += y; }
  friend Algebraic operator-(Algebraic x, const Algebraic& y) { return x -= y; }
  friend Algebraic operator*(Algebraic x, const Algebraic& y) { return x *= y; }
  friend Algebraic operator-(const Algebraic& x) { return Algebraic(0) -= x; }
  /// The same polynomial.
  friend bool operator==(const Algebraic& x, const Algebraic& y) { return x.is_same(y); }

  /// The inverse; nothing where the polynomial shares a factor with m.
  std::optional<Algebraic> inverse() const;
  /// A ball that holds the number, in the working precision.
  Ball value() const;

private:
  friend class RealField;
  friend struct AlgebraicAccess;
  bool is_same(const Algebraic& x) const;

  std::shared_ptr<const RealField> field_; ///< none: a whole number
  std::array<std::uint64_t, 4> storage_;   ///< an fmpq_poly_struct
};

/// What numbers seem to be.
struct Recognized {
  std::string polynomial; ///< m, for instance "x^2-3"
  int degree = 0;
  std::vector<Algebraic> numbers; ///< in the order of the balls
};

/// A field of at most this degree that seems to hold all of the numbers, given by balls of radius
/// 2^-(100 (most_degree + 1)) or less, in a working precision that keeps powers of the numbers so. Nothing
/// where none is seen. `still_wanted` is called before each lattice reduction, and may throw to end the
/// search; one takes 0.1 s for degree 16. O(d^4) for each number.
std::optional<Recognized> recognize(const std::vector<Ball>& numbers, int most_degree,
                                    const std::function<void()>& still_wanted = {});

} // namespace tetrarch::numeric
