// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"
#include "tetrarch/embed/domain.hpp"
#include "tetrarch/numeric/real50.hpp"

namespace tetrarch::embed {
namespace {

using numeric::Real50;

Vector4<double> rounded(const Vector4<Real50>& v) {
  Vector4<double> r;
  for (int i = 0; i < 4; ++i) r[i] = static_cast<double>(v[i]);
  return r;
}

Matrix4<double> rounded(const Matrix4<Real50>& m) {
  Matrix4<double> r;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) r[i][j] = static_cast<double>(m[i][j]);
  return r;
}

Domain<double> rounded(Domain<Real50>&& precise) {
  Domain<double> domain;
  domain.types = std::move(precise.types);
  domain.entrance = std::move(precise.entrance);
  domain.order = std::move(precise.order);
  domain.gluable = std::move(precise.gluable);
  domain.group = std::move(precise.group);
  for (const auto& vertices : precise.vertices)
    domain.vertices.push_back(
        {rounded(vertices[0]), rounded(vertices[1]), rounded(vertices[2]), rounded(vertices[3])});
  for (auto& face : precise.faces)
    domain.faces.push_back({std::move(face.hexagons), face.partner, rounded(face.pairing)});
  for (const auto& g : precise.holonomy) domain.holonomy.push_back(rounded(g));
  domain.half_space = rounded(precise.half_space);
  return domain;
}

} // namespace

Domain<double> fundamental_domain(const Triangulation& tri, const Skeleton& skeleton,
                                  const hyperbolic::Hyperbolization<double>& found,
                                  const DomainOptions& options, const Progress& progress) {
  skeleton.require_current(tri);
  if (found.outcome != hyperbolic::Outcome::geometric)
    throw PreconditionError("fundamental_domain: the structure is not geometric");
  if (skeleton.edge_count() > most_precise_edges)
    return fundamental_domain(tri, skeleton, found.lengths, options);
  const auto precise = hyperbolic::refine<Real50>(skeleton, found, progress);
  return rounded(fundamental_domain(tri, skeleton, precise.lengths, options));
}

} // namespace tetrarch::embed
