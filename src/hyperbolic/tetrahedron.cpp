// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/tetrahedron.hpp"

#include "kernel.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/instantiate.hpp"

namespace tetrarch::hyperbolic {
namespace {

/// G_kk = 1, G_kl = -cos theta_ij: the Gram matrix of the outward face normals.
template <class Scalar>
numeric::Matrix4<Scalar> normal_gram_matrix(const SixNumbers<Scalar>& angles) {
  using std::cos;
  numeric::Matrix4<Scalar> g;
  for (int k = 0; k < 4; ++k) g[k][k] = 1;
  for (int e = 0; e < 6; ++e) {
    const auto [k, l] = edge_vertex[opposite_edge(e)];
    g[k][l] = -cos(angles[e]);
    g[l][k] = g[k][l];
  }
  return g;
}

} // namespace

const char* to_string(VertexType type) {
  constexpr std::array<const char*, 3> names{"finite", "ideal", "hyperideal"};
  return names[static_cast<std::size_t>(type)];
}

template <class Scalar>
Scalar inner_product(VertexType a, VertexType b, const Scalar& length) {
  return kernel::edge_form(a, b, length).w;
}

template <class Scalar>
Scalar signed_length(VertexType a, VertexType b, const Scalar& w) {
  using std::acosh;
  using std::asinh;
  using std::log;
  if (a == VertexType::ideal || b == VertexType::ideal) {
    if (!(w < 0)) throw PreconditionError("signed_length: an inner product with an ideal vertex is negative");
    return log(a == b ? Scalar(-w / 2) : Scalar(-w));
  }
  if (a != b) return asinh(Scalar(-w));
  return w < -1 ? Scalar(acosh(Scalar(-w))) : Scalar(0);
}

template <class Scalar>
numeric::Matrix4<Scalar> gram_matrix(const SixNumbers<Scalar>& lengths, const VertexTypes& types) {
  return kernel::gram(kernel::edge_forms(lengths, types), types);
}

template <class Scalar>
bool exists(const SixNumbers<Scalar>& lengths, const VertexTypes& types) {
  return dihedral_angles(lengths, types).has_value();
}

template <class Scalar>
std::optional<SixNumbers<Scalar>> dihedral_angles(const SixNumbers<Scalar>& lengths,
                                                  const VertexTypes& types) {
  const auto form = kernel::edge_forms(lengths, types);
  const kernel::Shape<Scalar> shape(kernel::gram(form, types));
  if (!shape.exists) return std::nullopt;
  for (const auto& edge : form)
    if (!(edge.g > 0)) return std::nullopt; // two truncating planes that touch or cross
  return kernel::angles(shape, form);
}

template <class Scalar>
SixNumbers<Scalar> extended_dihedral_angles(const SixNumbers<Scalar>& lengths, const VertexTypes& types) {
  const auto form = kernel::edge_forms(lengths, types);
  return kernel::angles(kernel::Shape<Scalar>(kernel::gram(form, types)), form);
}

template <class Scalar>
std::array<SixNumbers<Scalar>, 6> angle_jacobian(const SixNumbers<Scalar>& lengths,
                                                 const VertexTypes& types) {
  const auto form = kernel::edge_forms(lengths, types);
  const kernel::Shape<Scalar> shape(kernel::gram(form, types));
  if (shape.exists) return kernel::jacobian(shape, form);
  std::array<SixNumbers<Scalar>, 6> zero;
  for (auto& row : zero) row.fill(Scalar(0));
  return zero;
}

template <class Scalar>
VertexTypes vertex_types_of_angles(const SixNumbers<Scalar>& angles, const Scalar& tolerance) {
  VertexTypes types{};
  for (int v = 0; v < 4; ++v) {
    Scalar excess = -numeric::pi<Scalar>();
    for (int w = 0; w < 4; ++w)
      if (w != v) excess += angles[edge_number[v][w]];
    types[v] = excess < -tolerance  ? VertexType::hyperideal
               : excess > tolerance ? VertexType::finite
                                    : VertexType::ideal;
  }
  return types;
}

template <class Scalar>
std::optional<SixNumbers<Scalar>> lengths_from_angles(const SixNumbers<Scalar>& angles,
                                                      const VertexTypes& types) {
  using std::abs;
  using std::sqrt;
  const numeric::Matrix4<Scalar> g = normal_gram_matrix(angles);
  const numeric::Minors<Scalar> minors(g);
  if (!(minors.determinant() < 0)) return std::nullopt;
  const numeric::Matrix4<Scalar> b = numeric::adjugate(g, minors);
  std::array<Scalar, 4> scale;
  for (int i = 0; i < 4; ++i) {
    if (types[i] != VertexType::ideal && !(b[i][i] * norm(types[i]) < 0)) return std::nullopt;
    scale[i] = types[i] == VertexType::ideal ? Scalar(1) : Scalar(1 / sqrt(abs(b[i][i])));
  }
  SixNumbers<Scalar> lengths;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    const Scalar w = -b[i][j] * scale[i] * scale[j];
    const bool signed_case = norm(types[i]) * norm(types[j]) < 0;
    if (!signed_case && !(w < 0)) return std::nullopt;
    lengths[e] = signed_length(types[i], types[j], w);
  }
  return lengths;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Scalar inner_product(VertexType, VertexType, const Scalar&);                                      \
  template numeric::Matrix4<Scalar> gram_matrix(const SixNumbers<Scalar>&, const VertexTypes&);              \
  template bool exists(const SixNumbers<Scalar>&, const VertexTypes&);                                       \
  template std::optional<SixNumbers<Scalar>> dihedral_angles(const SixNumbers<Scalar>&, const VertexTypes&); \
  template std::array<SixNumbers<Scalar>, 6> angle_jacobian(const SixNumbers<Scalar>&, const VertexTypes&);
TETRARCH_FOR_EACH_FORMULA(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Scalar signed_length(VertexType, VertexType, const Scalar&);                                      \
  template SixNumbers<Scalar> extended_dihedral_angles(const SixNumbers<Scalar>&, const VertexTypes&);       \
  template VertexTypes vertex_types_of_angles(const SixNumbers<Scalar>&, const Scalar&);                     \
  template std::optional<SixNumbers<Scalar>> lengths_from_angles(const SixNumbers<Scalar>&,                  \
                                                                 const VertexTypes&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
