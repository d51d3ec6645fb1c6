// SPDX-License-Identifier: GPL-2.0-or-later
#include "cusp_rows.hpp"

#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <array>

namespace tetrarch::workshop {
namespace {

using numeric::Ball;
using Interval = std::array<std::string, 2>;

std::string describe(const hyperbolic::Cusp& cusp) {
  const char* surface = cusp.orientable ? "torus, shape " : "Klein bottle, covered by a torus of shape ";
  const std::string real = fixed(cusp.shape.real(), 10);
  return surface + (real == "-0.0000000000" ? real.substr(1) : real) + " + " + fixed(cusp.shape.imag(), 10) +
         " i";
}

/// Ends in decimal with as many digits as are certain, and three more to tell them apart.
Interval interval(const Ball& x) {
  constexpr double digits_per_bit = 0.30103;
  const int digits = 3 + std::max(0, static_cast<int>(numeric::certain_bits(x) * digits_per_bit));
  return {numeric::lower_decimal(x, digits), numeric::upper_decimal(x, digits)};
}

/// Real and imaginary part.
std::array<Interval, 2> intervals(const Structure& s, std::size_t cusp) {
  const numeric::WorkingPrecision precision(s.shape_bits);
  const auto& shape = s.proved_shapes[cusp];
  return {interval(shape.real), interval(shape.imaginary)};
}

} // namespace

void add_cusps(const Structure& s, Rows& rows) {
  for (const hyperbolic::Cusp& cusp : s.cusps)
    rows.emplace_back("cusp " + std::to_string(cusp.vertex.value), describe(cusp));
}

Tree cusps_tree(const Structure& s) {
  Tree list = Tree::array();
  for (std::size_t k = 0; k < s.cusps.size(); ++k) {
    const hyperbolic::Cusp& cusp = s.cusps[k];
    Tree item{{"vertex", cusp.vertex.value},
              {"type", cusp.orientable ? "torus" : "Klein bottle"},
              {"shape", std::array{cusp.shape.real(), cusp.shape.imag()}},
              {"area", cusp.area},
              {"residual", cusp.residual}};
    if (!s.proved_shapes.empty()) item["shape_interval"] = intervals(s, k);
    list.push_back(std::move(item));
  }
  return list;
}

Type cusps_type() {
  return type::list(
      type::object({{"vertex", type::integer},
                    {"type", type::one_of({"torus", "Klein bottle"})},
                    {"shape", type::list(type::number, 2)},
                    {"area", type::number},
                    {"residual", type::number},
                    {"shape_interval", type::list(type::list(type::text, 2), 2), type::sometimes}}));
}

} // namespace tetrarch::workshop
