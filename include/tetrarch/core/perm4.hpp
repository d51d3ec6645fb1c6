// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Permutations of {0,1,2,3}, as one byte: the rank in the lexicographic order of the images.
///
/// Rank 0 is 0123, rank 1 is 0132, ..., rank 23 is 3210. Law: `(p * q)[i] == p[q[i]]`. Every operation is a
/// table look-up. The rank is also the number that isomorphism signatures use for a gluing.

#include <array>
#include <compare>
#include <cstdint>
#include <string>

namespace tetrarch {

/// A permutation of 0, 1, 2, 3.
class Perm4 {
public:
  static constexpr int count = 24;

  constexpr Perm4() = default;
  /// The permutation 0 -> a, 1 -> b, 2 -> c, 3 -> d. Undefined unless these are 0..3 in some order; text from
  /// outside is checked by whoever parses it.
  constexpr Perm4(int a, int b, int c, int d) : rank_(rank_of(a, b, c, d)) {}

  static constexpr Perm4 from_rank(int rank) {
    Perm4 p;
    p.rank_ = static_cast<std::uint8_t>(rank);
    return p;
  }
  /// The transposition of i and j (the identity if i == j).
  static constexpr Perm4 swap(int i, int j) {
    std::array<int, 4> a{0, 1, 2, 3};
    a[i] = j;
    a[j] = i;
    return {a[0], a[1], a[2], a[3]};
  }

  constexpr int rank() const { return rank_; }
  constexpr int operator[](int i) const;
  constexpr Perm4 operator*(Perm4 q) const;
  constexpr Perm4 inverse() const;
  /// +1 for an even permutation, -1 for an odd one.
  constexpr int sign() const;
  /// The i with (*this)[i] == image.
  constexpr int preimage(int image) const { return inverse()[image]; }
  /// Four digits, for instance "0132".
  std::string str() const;

  friend constexpr auto operator<=>(Perm4, Perm4) = default;

private:
  static constexpr std::uint8_t rank_of(int a, int b, int c, int d) {
    const int r1 = b - (a < b);
    const int r2 = c - (a < c) - (b < c);
    (void)d;
    return static_cast<std::uint8_t>(6 * a + 2 * r1 + r2);
  }

  std::uint8_t rank_ = 0;
};

namespace detail {

struct Perm4Tables {
  std::array<std::array<std::uint8_t, 4>, 24> image{};
  std::array<std::array<std::uint8_t, 24>, 24> product{};
  std::array<std::uint8_t, 24> inverse{};
  std::array<std::int8_t, 24> sign{};

  constexpr Perm4Tables() {
    for (int r = 0; r < 24; ++r) image[r] = unrank(r);
    for (int p = 0; p < 24; ++p) {
      int inversions = 0;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) inversions += image[p][i] > image[p][j];
      sign[p] = static_cast<std::int8_t>(inversions % 2 == 0 ? 1 : -1);
      for (int q = 0; q < 24; ++q) {
        const int r = rank(p, q);
        product[p][q] = static_cast<std::uint8_t>(r);
        if (r == 0) inverse[p] = static_cast<std::uint8_t>(q);
      }
    }
  }

private:
  static constexpr std::array<std::uint8_t, 4> unrank(int r) {
    std::array<std::uint8_t, 4> rest{0, 1, 2, 3};
    std::array<std::uint8_t, 4> out{};
    int size = 4;
    int weight = 6;
    for (int i = 0; i < 4; ++i) {
      const int k = r / weight;
      r %= weight;
      out[i] = rest[k];
      for (int j = k; j + 1 < size; ++j) rest[j] = rest[j + 1];
      --size;
      if (size > 0) weight /= size;
    }
    return out;
  }
  constexpr int rank(int p, int q) const {
    return Perm4(image[p][image[q][0]], image[p][image[q][1]], image[p][image[q][2]], image[p][image[q][3]])
        .rank();
  }
};

inline constexpr Perm4Tables perm4_tables{};

} // namespace detail

constexpr int Perm4::operator[](int i) const {
  return detail::perm4_tables.image[rank_][i];
}
constexpr Perm4 Perm4::operator*(Perm4 q) const {
  return from_rank(detail::perm4_tables.product[rank_][q.rank_]);
}
constexpr Perm4 Perm4::inverse() const {
  return from_rank(detail::perm4_tables.inverse[rank_]);
}
constexpr int Perm4::sign() const {
  return detail::perm4_tables.sign[rank_];
}

inline std::string Perm4::str() const {
  std::string text;
  for (int i = 0; i < 4; ++i) text += static_cast<char>('0' + (*this)[i]);
  return text;
}

} // namespace tetrarch
