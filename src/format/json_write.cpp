// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/json.hpp"

#include "json_text.hpp"

#include "tetrarch/core/error.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace tetrarch::format {
namespace {

std::string gluings_text(const Triangulation& tri) {
  return array_text(static_cast<std::size_t>(tri.size()), 1, [&tri](std::size_t tet) {
    const int t = static_cast<int>(tet);
    std::string line = "[";
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (f > 0) line += ", ";
      line += g.tet < 0 ? "null" : "[" + std::to_string(g.tet) + ", \"" + g.perm.str() + "\"]";
    }
    return line + "]";
  });
}

std::string number_text(const Number& number) {
  return number.is_text() ? "\"" + number.text() + "\"" : number.text();
}

std::string number_text(const std::optional<Number>& number) {
  return number ? number_text(*number) : "null";
}

template <class T>
std::optional<std::string> per_edge_text(const std::vector<PerEdge<T>>& list) {
  return list_text(list, 2, [](const PerEdge<T>& six) {
    return row_text(six, [](const T& entry) { return number_text(entry); });
  });
}

/// Lists of one entry per tetrahedron; an empty one is left out.
class SizeCheck {
public:
  SizeCheck(const char* what, int tetrahedra) : what_(what), tetrahedra_(tetrahedra) {}
  template <class List>
  const List& operator()(const List& list) const {
    if (!list.empty() && list.size() != static_cast<std::size_t>(tetrahedra_))
      throw PreconditionError(std::string(what_) + " of " + std::to_string(list.size()) +
                              " tetrahedra on a triangulation of " + std::to_string(tetrahedra_));
    return list;
  }

private:
  const char* what_;
  int tetrahedra_;
};

std::optional<std::string> marks_text(const Document& document) {
  return list_text(document.marks, 1, [](const EdgeMark& mark) {
    const auto [i, j] = edge_vertex[mark.edge.edge];
    return "[" + std::to_string(mark.edge.tet) + ", \"" + std::to_string(i) + std::to_string(j) + "\", " +
           double_text(mark.order) + "]";
  });
}

std::optional<std::string> metric_text(const Document& document) {
  if (!document.metric) return std::nullopt;
  const Metric& metric = *document.metric;
  const SizeCheck sized("a metric", document.triangulation.size());
  std::optional<std::string> volume;
  if (metric.volume) volume = number_text(*metric.volume);
  return object_text(metric.members,
                     {{"edge_lengths", per_edge_text(sized(metric.edge_lengths))},
                      {"dihedral_angles", per_edge_text(sized(metric.dihedral_angles))},
                      {"volume", volume}},
                     1);
}

std::string flat_text(const std::array<bool, 4>& flat) {
  std::vector<int> faces;
  for (int f = 0; f < 4; ++f)
    if (flat[f]) faces.push_back(f);
  return row_text(faces, [](int face) { return std::to_string(face); });
}

std::optional<std::string> canonical_text(const Document& document) {
  if (!document.canonical) return std::nullopt;
  const CanonicalCells& canonical = *document.canonical;
  const SizeCheck sized("canonical cells", document.triangulation.size());
  std::optional<std::string> signature;
  if (!canonical.isometry_signature.empty()) signature = dumped(Json(canonical.isometry_signature), 0);
  return object_text(
      canonical.members,
      {{"cells", dumped(Json(canonical.cells), 2)},
       {"cell_of", list_text(sized(canonical.cell_of), 2, [](int cell) { return std::to_string(cell); })},
       {"flat_faces", list_text(sized(canonical.flat_faces), 2, flat_text)},
       {"isometry_signature", signature}},
      1);
}

std::optional<std::string> bundle_text(const Document& document) {
  if (!document.bundle) return std::nullopt;
  const FiberCoordinates& bundle = *document.bundle;
  const SizeCheck sized("fiber coordinates", document.triangulation.size());
  const auto point_text = [](const std::array<double, 3>& point) {
    return row_text(point, [](double x) { return double_text(x); });
  };
  const std::string euler = bundle.euler_number ? std::to_string(*bundle.euler_number) : "null";
  return object_text(bundle.members,
                     {{"fiber", std::to_string(bundle.fiber)},
                      {"euler_number", euler},
                      {"base_vertices", list_text(bundle.base_vertices, 2, point_text)},
                      {"base_triangles", integer_rows_text(bundle.base_triangles, 2)},
                      {"triangle_of", list_text(sized(bundle.triangle_of), 2,
                                                [](int triangle) { return std::to_string(triangle); })},
                      {"vertices", integer_rows_text(sized(bundle.vertices), 2)},
                      {"levels", integer_rows_text(sized(bundle.levels), 2)}},
                     1);
}

} // namespace

std::string write_json(const Document& document) {
  std::vector<JsonMember> members = first_members(json_format_tag, json_format_version, document.name);
  members.push_back({"tetrahedra", std::to_string(document.triangulation.size())});
  members.push_back({"gluings", gluings_text(document.triangulation)});
  members.push_back({"marks", marks_text(document)});
  members.push_back({"metric", metric_text(document)});
  members.push_back({"canonical", canonical_text(document)});
  members.push_back({"bundle", bundle_text(document)});
  members.push_back(provenance_member(document.provenance));
  return object_text(document.members, std::move(members), 0) + "\n";
}

} // namespace tetrarch::format
