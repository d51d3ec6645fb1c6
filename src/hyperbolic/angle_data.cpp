// SPDX-License-Identifier: GPL-2.0-or-later
#include "angle_data.hpp"

#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetrarch::hyperbolic {
namespace {

/// A number of which only the size counts: differences add up. A formula evaluated in it bounds the sum of
/// the sizes of all its terms.
template <class Scalar>
struct Size {
  Scalar x = 0;
  friend Size operator+(const Size& a, const Size& b) { return {a.x + b.x}; }
  friend Size operator-(const Size& a, const Size& b) { return {a.x + b.x}; }
  friend Size operator*(const Size& a, const Size& b) { return {a.x * b.x}; }
  friend Size operator-(const Size& a) { return a; }
};

template <class Scalar>
numeric::Matrix4<Size<Scalar>> sizes(const numeric::Matrix4<Scalar>& w) {
  using std::abs;
  numeric::Matrix4<Size<Scalar>> m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j].x = abs(w[i][j]);
  return m;
}

/// Determinant and adjugate with bounds of their errors: entries of W err by four units, a minor by ten of
/// the sum of its terms' sizes, the adjugate by eighteen, the determinant by twenty-seven.
template <class Scalar>
struct BoundedShape {
  kernel::Shape<Scalar> shape;
  Scalar square;         ///< D
  Scalar relative_error; ///< of D
  numeric::Matrix4<Scalar> a_error;

  explicit BoundedShape(const numeric::Matrix4<Scalar>& w) : shape(w), square(shape.s * shape.s) {
    const numeric::Matrix4<Size<Scalar>> size = sizes(w);
    const numeric::Minors<Size<Scalar>> minors(size);
    const numeric::Matrix4<Size<Scalar>> a = numeric::adjugate(size, minors);
    relative_error = 30 * numeric::unit<Scalar>() * minors.determinant().x / square;
    for (int k = 0; k < 4; ++k)
      for (int l = 0; l < 4; ++l) a_error[k][l] = 20 * numeric::unit<Scalar>() * a[k][l].x;
  }
};

/// theta_e = atan2(y, x), and a bound of its error: the turn of the vector (x, y) by its own error.
template <class Scalar>
void set_angle(AngleData<Scalar>& data, int e, const BoundedShape<Scalar>& bounded, const Scalar& g) {
  using std::abs;
  using std::atan2;
  using std::sqrt;
  const auto [k, l] = edge_vertex[opposite_edge(e)];
  const Scalar x = bounded.shape.a[k][l];
  const Scalar y = g * bounded.shape.s;
  data.turns[e] = x < 0 ? 1 : 0;
  data.rest[e] = x < 0 ? Scalar(-atan2(y, Scalar(-x))) : Scalar(atan2(y, x));
  const Scalar x_error = bounded.a_error[k][l];
  const Scalar y_error = y * (bounded.relative_error + 8 * numeric::unit<Scalar>());
  const Scalar square = x * x + y * y;
  const bool drowned = bounded.relative_error > Scalar(0.1) || 16 * (x_error * x_error) > square;
  data.rest_error[e] = drowned ? std::numeric_limits<Scalar>::infinity()
                               : Scalar(Scalar(1.5) * (abs(x) * y_error + y * x_error) / square +
                                        4 * numeric::unit<Scalar>() * abs(data.rest[e]));
}

} // namespace

template <class Scalar>
std::optional<AngleData<Scalar>> angle_data(const std::array<kernel::EdgeForm<Scalar>, 6>& form,
                                            const VertexTypes& types, const kernel::NullEdges& null) {
  using std::atan2;
  const BoundedShape<Scalar> bounded(kernel::gram(form, types));
  if (!bounded.shape.exists) return std::nullopt;
  AngleData<Scalar> data;
  Scalar products = 0;
  for (int e = 0; e < 6; ++e) {
    if (!null[e] && !(form[e].g > 0)) return std::nullopt; // two truncating planes that touch or cross
    set_angle(data, e, bounded, form[e].g);
    if (e < 3) products += form[e].g * form[opposite_edge(e)].g;
  }
  data.spread = atan2(bounded.shape.s, products);
  data.spread_error = data.spread * (bounded.relative_error + 16 * numeric::unit<Scalar>());
  return data;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template std::optional<AngleData<Scalar>> angle_data(const std::array<kernel::EdgeForm<Scalar>, 6>&,       \
                                                       const VertexTypes&, const kernel::NullEdges&);
TETRARCH_FOR_EACH_FORMULA(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
