// SPDX-License-Identifier: GPL-2.0-or-later
#include "hexahedra_facts.hpp"

#include "tetrarch/workshop/text.hpp"

#include <algorithm>

namespace tetrarch::workshop {

std::string text_of(const product::Point& p) {
  return "(" + rounded(p[0]) + ", " + rounded(p[1]) + ", " + rounded(p[2]) + ")";
}

std::string text_of(const product::BadHexahedron& bad) {
  return "h" + std::to_string(bad.hexahedron) + " " + fixed(bad.scaled_jacobian, 4) + " at " +
         text_of(bad.center);
}

std::string text_of(const std::vector<product::BadHexahedron>& bad) {
  std::vector<std::string> texts;
  texts.reserve(bad.size());
  for (const product::BadHexahedron& b : bad) texts.push_back(text_of(b));
  return joined(texts, ", ");
}

Tree tree_of(const std::vector<product::BadHexahedron>& bad) {
  Tree list = Tree::array();
  for (const product::BadHexahedron& b : bad)
    list.push_back({{"hexahedron", b.hexahedron}, {"scaled_jacobian", b.scaled_jacobian}, {"at", b.center}});
  return list;
}

Type bad_hexahedra_type() {
  return type::list(type::object({{"hexahedron", type::integer},
                                  {"scaled_jacobian", type::number},
                                  {"at", type::list(type::number, 3)}}));
}

long long count_below_good(const product::HexQuality& quality) {
  constexpr double good = 0.2;
  return std::count_if(quality.scaled_jacobian.begin(), quality.scaled_jacobian.end(),
                       [](double j) { return j < good; });
}

format::MeshDocument document_of(const product::HexMesh& mesh, const std::vector<double>& scaled_jacobian) {
  format::MeshDocument document;
  document.soup.points = mesh.points;
  document.hexahedra = mesh.hexahedra;
  document.fields = {field_of("scaled_jacobian", format::MeshField::On::hexahedra, scaled_jacobian)};
  return document;
}

} // namespace tetrarch::workshop
