// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/planar.hpp"

#include "tetrarch/core/error.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <numbers>

namespace tetrarch::surface {

std::vector<std::array<double, 2>> tutte_embedding(const Surface& disk) {
  const auto curves = boundary_curves(disk);
  if (curves.size() != 1 || parts(disk).count != 1)
    throw PreconditionError("a connected surface with one boundary curve is needed");
  const auto vertices = static_cast<std::size_t>(disk.vertex_count());
  std::vector<std::array<double, 2>> point(vertices);
  std::vector<int> unknown(vertices, 0);
  const double step = 2 * std::numbers::pi / static_cast<double>(curves[0].size());
  for (std::size_t k = 0; k < curves[0].size(); ++k) {
    const int v = disk.vertex(curves[0][k]);
    const double angle = step * static_cast<double>(k);
    point[v] = {std::cos(angle), std::sin(angle)};
    unknown[v] = -1;
  }
  int count = 0;
  for (int& number : unknown)
    if (number == 0) number = count++;
  if (count == 0) return point;

  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * static_cast<std::size_t>(disk.side_count()));
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, 2);
  for (int k = 0; k < disk.side_count(); ++k) {
    // Each inner edge has two sides, one in either direction; a boundary edge has no unknown end.
    const int v = disk.from(Side(k));
    const int w = disk.to(Side(k));
    if (disk.is_turned(Side(k))) throw PreconditionError("the surface has turned mates");
    if (unknown[v] < 0) continue;
    entries.emplace_back(unknown[v], unknown[v], 1);
    if (unknown[w] >= 0)
      entries.emplace_back(unknown[v], unknown[w], -1);
    else
      sums.row(unknown[v]) += Eigen::RowVector2d(point[w][0], point[w][1]);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixXd solution = solver.solve(sums);
  for (std::size_t v = 0; v < vertices; ++v)
    if (unknown[v] >= 0) point[v] = {solution(unknown[v], 0), solution(unknown[v], 1)};
  return point;
}

} // namespace tetrarch::surface
