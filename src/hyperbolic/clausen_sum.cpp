// SPDX-License-Identifier: GPL-2.0-or-later
#include "angle_data.hpp"
#include "clausen.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetrarch::hyperbolic {
namespace {

// The edges whose angles are added: of two opposite edges, of a face (face k: without vertex k), of a vertex,
// of all but two opposite edges.
constexpr std::array<std::array<int, 2>, 3> pair_edges{{{0, 5}, {1, 4}, {2, 3}}};
constexpr std::array<std::array<int, 3>, 4> face_edges{{{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}}};
constexpr std::array<std::array<int, 3>, 4> vertex_edges{{{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}}};
constexpr std::array<std::array<int, 4>, 3> cycle_edges{{{1, 4, 2, 3}, {0, 5, 2, 3}, {0, 5, 1, 4}}};
constexpr std::array<std::array<int, 6>, 1> all_edges{{{0, 5, 1, 4, 2, 3}}};

/// A sum of angles, turns pi + rest.
template <class Scalar>
struct AngleSum {
  int turns = 0;
  Scalar rest = 0;
  Scalar size = 0;  ///< of the terms
  Scalar error = 0; ///< from the angles
  int sign() const { return turns % 2 == 0 ? 1 : -1; }
};

template <class Scalar, std::size_t n>
AngleSum<Scalar> sum_over(const AngleData<Scalar>& data, const std::array<int, n>& edges) {
  using std::abs;
  AngleSum<Scalar> sum;
  for (const int e : edges) {
    sum.turns += data.turns[e];
    sum.rest += data.rest[e];
    sum.size += abs(data.rest[e]);
    sum.error += data.rest_error[e];
  }
  return sum;
}

template <class Scalar>
struct Phase {
  Scalar value;
  Scalar error;
};

/// sin x - x to all digits. The terms alternate and shrink by a factor of 80 and more: what is left out is
/// less than the last one.
template <class Scalar>
Scalar sine_less_argument(const Scalar& x, const Scalar& sine) {
  using std::abs;
  if (!(abs(x) <= Scalar(0.5))) return sine - x;
  const Scalar square = x * x;
  Scalar term = -x * square / 6;
  Scalar sum = term;
  for (int k = 4, digits = 0; digits <= numeric::bits<Scalar>(); k += 2, digits += 6) {
    term *= -square / (k * (k + 1));
    sum += term;
  }
  return numeric::widened(sum, term);
}

/// The phase of Ushijima's denominator, sum over the eight sums x of exp(i x): minus `value`. With x = pi n +
/// s the real part is sum +-1 - 2 sum +-sin^2(s/2), the whole numbers apart. The imaginary part is sum +-sin
/// s; where the signs are those of a flat tetrahedron, every angle cancels out of sum +-s, which leaves sum
/// +-(sin s - s), of third order: the sines themselves would leave their rounding, of first.
template <class Scalar>
class DenominatorPhase {
public:
  explicit DenominatorPhase(const AngleData<Scalar>& data) : data_(data) {
    add(pair_edges);
    add(face_edges);
    add(all_edges);
  }

  Phase<Scalar> phase() const {
    using std::abs;
    using std::atan2;
    const bool flat_signs = std::all_of(signs_.begin(), signs_.end(), [](int s) { return s == 0; });
    const Scalar re = whole_ - 2 * squares_;
    const Scalar im = flat_signs ? bends_ : sines_;
    const Scalar re_error = re_error_ + numeric::unit<Scalar>() * abs(whole_);
    const Scalar& im_error = flat_signs ? bends_error_ : sines_error_;
    const Scalar square = re * re + im * im;
    const Scalar value = atan2(Scalar(-im), Scalar(-re));
    if (!(16 * (re_error * re_error + im_error * im_error) < square))
      return {value, std::numeric_limits<Scalar>::infinity()};
    return {value, Scalar(1.5) * (abs(re) * im_error + abs(im) * re_error) / square +
                       2 * numeric::unit<Scalar>() * abs(value)};
  }

private:
  template <class Sets>
  void add(const Sets& sets) {
    using std::abs;
    using std::cos;
    using std::sin;
    for (const auto& edges : sets) {
      const AngleSum<Scalar> x = sum_over(data_, edges);
      const Scalar h = sin(Scalar(x.rest / 2));
      const Scalar sine = 2 * h * cos(Scalar(x.rest / 2));
      const Scalar bend = sine_less_argument(x.rest, sine);
      const int sign = x.sign();
      for (const int e : edges) signs_[e] += sign;
      whole_ += sign;
      squares_ += sign * (h * h);
      sines_ += sign * sine;
      bends_ += sign * bend;
      const Scalar error = x.error + 8 * numeric::unit<Scalar>() * x.size;
      re_error_ += abs(sine) * error + 32 * numeric::unit<Scalar>() * h * h;
      sines_error_ += error + 16 * numeric::unit<Scalar>() * abs(sine);
      bends_error_ += 2 * h * h * error + 24 * numeric::unit<Scalar>() * abs(bend);
    }
  }

  const AngleData<Scalar>& data_;
  std::array<int, 6> signs_{};
  int whole_ = 0;
  Scalar squares_ = 0, sines_ = 0, bends_ = 0;
  Scalar re_error_ = 0, sines_error_ = 0, bends_error_ = 0;
};

/// How much Cl can change between two arguments within three drifts of 0, where its slope is infinite:
/// |Cl(x)| <= |x| (1 - log |x|) for |x| <= 1. At an ideal vertex that a null edge meets, an argument is 0
/// exactly.
template <class Scalar>
Scalar beside_zero(const Scalar& drift) {
  using std::log;
  if (!(drift > 0)) return 0;
  if (!(3 * drift < 1)) return std::numeric_limits<Scalar>::infinity();
  return 6 * drift * (1 - log(Scalar(3 * drift)));
}

/// Twice Im U(exp(i zeta)) as it adds up.
template <class Scalar>
class RootSum {
public:
  RootSum(const AngleData<Scalar>& data, const VertexTypes& types, const Scalar& zeta,
          const Scalar& zeta_error)
      : zeta_(zeta), zeta_error_(zeta_error) {
    int times = 1; // at an ideal vertex Cl(pi + A + B + C + zeta) is Cl(zeta)
    for (const VertexType type : types) times -= type == VertexType::ideal ? 1 : 0;
    if (zeta != 0 && times != 0) add(AngleSum<Scalar>(), 0, times);
    for (const auto& edges : cycle_edges) add(sum_over(data, edges), 0, 1);
    for (int v = 0; v < 4; ++v)
      if (types[v] != VertexType::ideal) add(sum_over(data, vertex_edges[v]), 1, -1);
  }

  Scalar value = 0;
  Scalar error = 0;
  Scalar slopes = 0;

private:
  void add(const AngleSum<Scalar>& x, int half_turns, int times) {
    using std::abs;
    const Scalar rounding = 4 * numeric::unit<Scalar>() * (x.size + abs(zeta_));
    const ClausenTerm<Scalar> term = clausen_term(x.turns + half_turns, Scalar(x.rest + zeta_), rounding);
    const Scalar weight = times < 0 ? -times : times;
    // |Cl''(phi)| = |cot(phi/2)| / 2 <= 1 / |phi|; the segment to the exact argument stays beyond half of it.
    const Scalar drift = x.error + zeta_error_ + rounding;
    const bool beside_0 = !(2 * drift <= term.distance);
    const Scalar second = beside_0 ? beside_zero(drift) : Scalar(drift * drift / term.distance);
    value += times * term.value;
    error += weight * (term.error + second + 8 * numeric::unit<Scalar>() * abs(term.value));
    if (!beside_0) slopes += weight * static_cast<int>(x.size > 0 ? 4 : 0) * term.slope;
  }

  Scalar zeta_;
  Scalar zeta_error_;
};

} // namespace

template <class Scalar>
ClausenSum<Scalar> clausen_sum(const AngleData<Scalar>& data, const VertexTypes& types) {
  using std::abs;
  Phase<Scalar> phase{Scalar(-data.spread), data.spread_error};
  Scalar lower = 0;
  Scalar lower_error = 0;
  if (std::find(types.begin(), types.end(), VertexType::ideal) == types.end()) {
    phase = DenominatorPhase<Scalar>(data).phase();
    lower = -data.spread - phase.value;
    lower_error = data.spread_error + phase.error;
  }
  const Scalar upper_error = data.spread_error + phase.error;
  const RootSum<Scalar> minus(data, types, lower, lower_error);
  const RootSum<Scalar> plus(data, types, Scalar(data.spread - phase.value), upper_error);
  return {abs(Scalar(minus.value - plus.value)) / 4, (minus.error + plus.error) / 4,
          (minus.slopes + plus.slopes) / 4};
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template ClausenSum<Scalar> clausen_sum(const AngleData<Scalar>&, const VertexTypes&);
TETRARCH_FOR_EACH_FORMULA(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
