// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrahedron.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetrarch::checker {
namespace {

Dual constant(int value) {
  return {Interval(value)};
}

/// w and s of the tetrahedron's edges, by their ends.
struct EdgeForms {
  std::array<std::array<Dual, 4>, 4> w{};
  std::array<std::array<Dual, 4>, 4> s{};
};

EdgeForms edge_forms(const std::array<Interval, 6>& lengths, const Corners& kinds) {
  EdgeForms forms;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [a, b] = ends_of_edge[e];
    Dual length{lengths[e]};
    length.slope[e] = 1;
    Dual w = exp(length);
    Dual s = w;
    if (kinds[a] * kinds[b] == 1) {
      w = cosh(length);
      s = sinh(length);
    } else if (kinds[a] * kinds[b] == -1) {
      w = sinh(length);
      s = cosh(length);
    } else if (kinds[a] == kinds[b]) {
      s = w = constant(2) * w;
    }
    forms.w[a][b] = forms.w[b][a] = w;
    forms.s[a][b] = forms.s[b][a] = s;
  }
  return forms;
}

/// As `corner_side`.
Dual side(const EdgeForms& f, const Corners& kinds, int v, int a, int b) {
  if (kinds[v] != 0)
    return (constant(kinds[v]) * f.w[a][b] + f.w[v][a] * f.w[v][b]) / (f.s[v][a] * f.s[v][b]);
  return constant(kinds[a]) / (f.w[v][a] * f.w[v][a]) + constant(kinds[b]) / (f.w[v][b] * f.w[v][b]) +
         constant(2) * f.w[a][b] / (f.w[v][a] * f.w[v][b]);
}

/// Whether that belongs to a side, of a length between 0 and pi if v is finite.
bool is_side(const Interval& known, int kind) {
  if (kind < 0) return less(abs(known), Interval(1));
  return less(Interval(kind), known);
}

/// The cosine of the angle between sides p and q of a triangle with the third side r, as known at v.
Dual cosine(const Dual& p, const Dual& q, const Dual& r, int kind) {
  const Dual one = constant(1);
  if (kind > 0) return (p * q - r) / (sqrt(p * p - one) * sqrt(q * q - one));
  if (kind < 0) return (r - p * q) / (sqrt(one - p * p) * sqrt(one - q * q));
  return (p + q - r) / (constant(2) * sqrt(p * q));
}

/// The angles of the triangle at v, at its corners on the edges to the other three vertices; nothing unless
/// it is a triangle for all lengths.
std::optional<std::array<Dual, 3>> triangle(const EdgeForms& forms, const Corners& kinds, int v,
                                            const std::array<int, 3>& others) {
  std::array<Dual, 3> opposite; // of the corner towards others[k]
  for (int k = 0; k < 3; ++k) {
    opposite[k] = side(forms, kinds, v, others[(k + 1) % 3], others[(k + 2) % 3]);
    if (!is_side(opposite[k].value, kinds[v])) return std::nullopt;
  }
  std::array<Dual, 3> angles;
  for (int k = 0; k < 3; ++k) {
    const Dual c = cosine(opposite[(k + 1) % 3], opposite[(k + 2) % 3], opposite[k], kinds[v]);
    if (!less(abs(c.value), Interval(1))) return std::nullopt;
    angles[k] = acos(c);
  }
  return angles;
}

} // namespace

Corners kinds_at(const Classes& classes, int tet) {
  Corners kinds{};
  for (int v = 0; v < 4; ++v) {
    const int euler = classes.link[classes.vertex[tet][v]];
    kinds[v] = euler > 0 ? -1 : euler < 0 ? 1 : 0;
  }
  return kinds;
}

Interval corner_side(const std::array<Interval, 6>& lengths, const Corners& kinds, int v, int a, int b) {
  return side(edge_forms(lengths, kinds), kinds, v, a, b).value;
}

std::array<std::array<Interval, 4>, 4> products(const std::array<Interval, 6>& lengths,
                                                const Corners& kinds) {
  const EdgeForms forms = edge_forms(lengths, kinds);
  std::array<std::array<Interval, 4>, 4> g;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) g[i][j] = i == j ? Interval(kinds[i]) : -forms.w[i][j].value;
  return g;
}

std::optional<std::array<Dual, 6>> dihedral_angles(const std::array<Interval, 6>& lengths,
                                                   const Corners& kinds) {
  const EdgeForms forms = edge_forms(lengths, kinds);
  for (const auto& [a, b] : ends_of_edge)
    if (!less(Interval(0), forms.s[a][b].value) || !less(Interval(0), forms.w[a][b].value))
      return std::nullopt;
  std::array<Dual, 6> angles;
  for (int v = 0; v < 4; ++v) {
    std::array<int, 3> others{};
    std::size_t count = 0;
    for (int w = 0; w < 4; ++w)
      if (w != v) others[count++] = w;
    const auto corner = triangle(forms, kinds, v, others);
    if (!corner) return std::nullopt;
    for (std::size_t e = 0; e < 6; ++e)
      for (std::size_t k = 0; k < 3; ++k)
        if (ends_of_edge[e] == std::array{std::min(v, others[k]), std::max(v, others[k])})
          angles[e] = (*corner)[k];
  }
  return angles;
}

namespace {

/// Clausen's function by its series around 0, which converges for |x| < 2 pi:
///   Cl(x) = x - x log|x| + sum over n >= 1 of zeta(2n) / (n (2n+1)) x (x / 2 pi)^(2n).
/// Used for |x| <= pi, where a term is at most a quarter of the one before.
class Clausen {
public:
  explicit Clausen(const StillWanted& ask) {
    const int terms = static_cast<int>(Interval::bits) / 2 + 2;
    // (n + 1/2) zeta(2n) = sum over 0 < k < n of zeta(2k) zeta(2n - 2k).
    std::vector<Interval> zeta{0, Interval::pi() * Interval::pi() / 6};
    for (int n = 2; n <= terms; ++n) {
      ask();
      Interval sum;
      for (int k = 1; k < n; ++k) sum = sum + zeta[k] * zeta[n - k];
      zeta.push_back(2 * sum / (2 * n + 1));
    }
    for (int n = 1; n <= terms; ++n) coefficients_.push_back(zeta[n] / (n * (2 * n + 1)));
  }

  /// Of all numbers in the interval. Cl is odd and concave where it rises, so that |Cl(x+e) - Cl(x)| is at
  /// most 2 Cl(e/2), which is less than e (2 + |log e|).
  Interval operator()(const Interval& x) const {
    const Interval turn = 2 * Interval::pi();
    const double turns = std::round(x.nearest_double() / turn.nearest_double());
    const Interval reduced = x - turns * turn;
    const Interval value = at_point(reduced.middle());
    return value + around_zero(bound(abs(reduced.rest()).upper_end()));
  }

private:
  static Interval bound(const Interval& e) {
    return less(Interval(0), e) ? e * (2 + abs(log(e))) : Interval(0);
  }
  static Interval around_zero(const Interval& e) { return hull(-e, e); }

  Interval at_point(const Interval& x) const {
    if (!less(Interval(0), abs(x))) return 0;
    const Interval ratio = x / (2 * Interval::pi());
    const Interval square = ratio * ratio;
    Interval power = x * square;
    Interval sum = x - x * log(abs(x));
    for (const Interval& c : coefficients_) {
      sum = sum + c * power;
      power = power * square;
    }
    return sum + around_zero(abs(power));
  }

  std::vector<Interval> coefficients_;
};

/// sin A sin D + sin B sin E + sin C sin F, and the square root of minus the Gram determinant of the angles.
struct Roots {
  Interval s, r;
};

/// Rows 0 to 3 of G: 1 on the diagonal, else -cos of the angle between the two faces.
Interval minus_determinant(const std::array<Interval, 6>& angles) {
  std::array<std::array<Interval, 4>, 4> g;
  for (int k = 0; k < 4; ++k) g[k][k] = 1;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [k, l] = ends_of_edge[5 - e];
    g[k][l] = g[l][k] = -cos(angles[e]);
  }
  std::array<int, 4> p{0, 1, 2, 3};
  Interval determinant;
  do {
    int inversions = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) inversions += p[j] > p[i] ? 1 : 0;
    const Interval product = g[0][p[0]] * g[1][p[1]] * g[2][p[2]] * g[3][p[3]];
    determinant = inversions % 2 == 0 ? determinant + product : determinant - product;
  } while (std::next_permutation(p.begin(), p.end()));
  return -determinant;
}

Roots roots(const std::array<Interval, 6>& angles) {
  Interval s;
  for (std::size_t e = 0; e < 3; ++e) s = s + sin(angles[e]) * sin(angles[5 - e]);
  return {s, sqrt(minus_determinant(angles))};
}

/// Imaginary part of U(exp(i zeta)), twice.
Interval twice_u(const Clausen& cl, const std::array<Interval, 6>& angles, const Interval& zeta,
                 const StillWanted& ask) {
  const auto& [a, b, c, f, e, d] = angles; // the formula's letters: D, E, F at 23, 13, 12
  Interval sum = cl(zeta);
  for (const Interval& four : {a + b + d + e, a + c + d + f, b + c + e + f}) {
    ask();
    sum = sum + cl(zeta + four);
  }
  for (const Interval& three : {a + b + c, a + e + f, b + d + f, c + d + e}) {
    ask();
    sum = sum - cl(zeta + Interval::pi() + three);
  }
  return sum;
}

/// Lobachevsky's sum, for which opposite angles of an ideal tetrahedron are equal.
Interval ideal_volume(const Clausen& cl, const std::array<Interval, 6>& angles) {
  return (cl(2 * angles[0]) + cl(2 * angles[1]) + cl(2 * angles[2])) / 2;
}

} // namespace

Interval volume(const std::array<Interval, 6>& angles, const Corners& kinds, const StillWanted& ask) {
  static thread_local mpfr_prec_t bits = 0;
  static thread_local std::optional<Clausen> clausen;
  if (bits != Interval::bits || !clausen) {
    clausen.reset();
    bits = Interval::bits;
    clausen.emplace(ask);
  }
  if (kinds == Corners{}) return ideal_volume(*clausen, angles);
  const auto& [a, b, c, f, e, d] = angles;
  Interval re;
  Interval im;
  for (const Interval& x :
       {a + d, b + e, c + f, a + b + f, a + c + e, b + c + d, d + e + f, a + b + c + d + e + f}) {
    re = re + cos(x);
    im = im + sin(x);
  }
  // z = -2 (s -+ i r) / (re + i im), and both have modulus 1.
  const Roots root = roots(angles);
  const Interval half = atan2(root.r, root.s);
  const Interval phase = less(Interval(0), re) ? Interval::pi() - atan2(im, re) : -atan2(-im, -re);
  return abs(twice_u(*clausen, angles, phase - half, ask) - twice_u(*clausen, angles, phase + half, ask)) / 4;
}

} // namespace tetrarch::checker
