// SPDX-License-Identifier: GPL-2.0-or-later
#include "edge_system.hpp"

#include "tetrarch/hyperbolic/volume.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tetrarch::verified {
namespace {

using numeric::Ball;

/// Arithmetic modulo a prime: what is independent there is independent.
constexpr std::int64_t prime = 2147483647;

std::int64_t inverse(std::int64_t x) {
  std::int64_t result = 1;
  for (std::int64_t power = prime - 2; power > 0; power /= 2, x = x * x % prime)
    if (power % 2 == 1) result = result * x % prime;
  return result;
}

template <class Scalar>
void add(std::vector<typename SparseRows<Scalar>::Entry>& row, int column, const Scalar& value) {
  const auto at = std::lower_bound(row.begin(), row.end(), column,
                                   [](const auto& entry, int place) { return entry.column < place; });
  if (at != row.end() && at->column == column)
    at->value += value;
  else
    row.insert(at, {column, value});
}

using hyperbolic::VertexType;

int freedom_of(VertexType type) {
  return type == VertexType::finite ? 3 : type == VertexType::ideal ? 1 : 0;
}

int freedom_of(const Table<VertexId, VertexType>& types) {
  int sum = 0;
  for (const VertexType type : types) sum += freedom_of(type);
  return sum;
}

/// The distance of a finite vertex from a truncating plane is signed; it is to be positive.
template <class Scalar>
bool is_inside(const hyperbolic::SixNumbers<Scalar>& lengths, const hyperbolic::VertexTypes& types) {
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    if (norm(types[i]) * norm(types[j]) < 0 && !(lengths[e] > 0)) return false;
  }
  return true;
}

} // namespace

EdgeSystem::EdgeSystem(const Skeleton& skeleton)
    : skeleton_(skeleton), types_(hyperbolic::vertex_types(skeleton)), freedom_(freedom_of(types_)),
      place_(skeleton.edge_count(), 0) {
  choose_fixed();
  number_unknowns();
}

EdgeSystem::EdgeSystem(const Skeleton& skeleton, std::vector<EdgeId> fixed)
    : skeleton_(skeleton), types_(hyperbolic::vertex_types(skeleton)), freedom_(freedom_of(types_)),
      fixed_(std::move(fixed)), place_(skeleton.edge_count(), 0) {
  number_unknowns();
}

void EdgeSystem::number_unknowns() {
  for (const EdgeId e : fixed_) place_[e] = -1;
  for (int& place : place_)
    if (place == 0) place = unknowns_++;
}

EdgeSystem::EdgeSystem(const Skeleton& skeleton, const Table<EdgeId, int>& block)
    : skeleton_(skeleton), types_(hyperbolic::vertex_types(skeleton)), freedom_(freedom_of(types_)),
      place_(block) {
  for (const int place : place_) unknowns_ = std::max(unknowns_, place + 1);
}

/// Elimination on the columns (ends of e at each cusp), edge by edge: an edge is taken if its column is
/// independent of those taken before.
void EdgeSystem::choose_fixed() {
  std::vector<int> number(static_cast<std::size_t>(skeleton_.vertex_count()), -1);
  int cusps = 0;
  for (const VertexId v : all<VertexId>(skeleton_.vertex_count()))
    if (types_[v] == VertexType::ideal) number[v.value] = cusps++;
  std::vector<std::pair<int, std::vector<std::int64_t>>> taken; // leading place, and the column with 1 there
  for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
    if (static_cast<int>(taken.size()) == cusps) return;
    std::vector<std::int64_t> column(static_cast<std::size_t>(cusps), 0);
    const auto [a, b] = skeleton_.ends(e);
    for (const VertexId v : {a, b})
      if (number[v.value] >= 0) ++column[number[v.value]];
    for (const auto& [lead, other] : taken) {
      const std::int64_t times = column[lead];
      for (int c = 0; c < cusps; ++c) column[c] = (column[c] + (prime - times) * other[c]) % prime;
    }
    int lead = 0;
    while (lead < cusps && column[lead] == 0) ++lead;
    if (lead == cusps) continue;
    const std::int64_t scale = inverse(column[lead]);
    for (std::int64_t& entry : column) entry = entry * scale % prime;
    taken.emplace_back(lead, std::move(column));
    fixed_.push_back(e);
  }
}

template <class Scalar>
std::optional<hyperbolic::Metric<Scalar>>
EdgeSystem::curvature(const hyperbolic::Metric<Scalar>& lengths) const {
  hyperbolic::Metric<Scalar> k(skeleton_.edge_count(), Scalar(2 * numeric::pi<Scalar>()));
  for (int t = 0; t < skeleton_.tetrahedron_count(); ++t) {
    const auto six = hyperbolic::lengths_at(skeleton_, lengths, t);
    const auto types = hyperbolic::types_at(skeleton_, types_, t);
    const auto angles = hyperbolic::dihedral_angles(six, types);
    if (!angles || !is_inside(six, types)) return std::nullopt;
    for (int e = 0; e < 6; ++e) k[skeleton_.edge({t, e})] -= (*angles)[e];
  }
  return k;
}

template <class Scalar>
std::vector<Scalar> EdgeSystem::equations(const hyperbolic::Metric<Scalar>& curvature) const {
  std::vector<Scalar> left(static_cast<std::size_t>(unknowns_), Scalar(0));
  for (const EdgeId e : all<EdgeId>(curvature.size()))
    if (place_[e] >= 0) left[place_[e]] += curvature[e];
  return left;
}

template <class Scalar>
SparseRows<Scalar> EdgeSystem::hessian(const hyperbolic::Metric<Scalar>& lengths) const {
  SparseRows<Scalar> h;
  h.rows.resize(static_cast<std::size_t>(unknowns_));
  for (int t = 0; t < skeleton_.tetrahedron_count(); ++t) {
    const auto slopes = hyperbolic::angle_jacobian(hyperbolic::lengths_at(skeleton_, lengths, t),
                                                   hyperbolic::types_at(skeleton_, types_, t));
    for (int e = 0; e < 6; ++e) {
      const int row = place_[skeleton_.edge({t, e})];
      for (int f = 0; f < 6; ++f) {
        const int column = place_[skeleton_.edge({t, f})];
        if (row >= 0 && column >= 0) add<Scalar>(h.rows[row], column, slopes[e][f]);
      }
    }
  }
  return h;
}

std::optional<Ball> EdgeSystem::volume(const hyperbolic::Metric<Ball>& lengths,
                                       const Progress& progress) const {
  Ball sum = 0;
  for (int t = 0; t < skeleton_.tetrahedron_count(); ++t) {
    progress.step("measuring");
    const auto part = hyperbolic::volume(hyperbolic::lengths_at(skeleton_, lengths, t),
                                         hyperbolic::types_at(skeleton_, types_, t));
    if (!part) return std::nullopt;
    sum += part->value;
  }
  return sum;
}

template std::optional<hyperbolic::Metric<Ball>> EdgeSystem::curvature(const hyperbolic::Metric<Ball>&) const;
template std::vector<Ball> EdgeSystem::equations(const hyperbolic::Metric<Ball>&) const;
template SparseRows<double> EdgeSystem::hessian(const hyperbolic::Metric<double>&) const;
template SparseRows<Ball> EdgeSystem::hessian(const hyperbolic::Metric<Ball>&) const;

} // namespace tetrarch::verified
