// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/json.hpp"

#include "json_members.hpp"
#include "json_tree.hpp"

#include <algorithm>
#include <limits>

namespace tetrarch::format {
namespace {

constexpr int most = std::numeric_limits<int>::max();

/// A member that is an object with lists about tetrahedra. Those lists are read by their members' names, and
/// are empty where there is no such member.
class Part {
public:
  Part(Json& object, std::string name, const Triangulation& tri)
      : object_(object), path_{JsonStep(std::move(name))}, tri_(tri) {
    if (!object.is_object()) fail_found(path_, object, "an object");
  }

  Json* find(const char* key) { return member(object_, key); }
  Json& need(const char* key) { return required(object_, key, path_); }
  JsonPath path(const char* key) const { return below(path_, key); }
  const Triangulation& triangulation() const { return tri_; }

  template <class Read>
  auto list(const char* key, std::optional<std::size_t> count, const char* entries, Read read) {
    Json* const found = find(key);
    return found == nullptr ? decltype(take_list(*found, path_, count, entries, read)){}
                            : take_list(*found, path(key), count, entries, read);
  }
  template <class Read>
  auto per_tetrahedron(const char* key, Read read) {
    return list(key, static_cast<std::size_t>(tri_.size()), "entries, one per tetrahedron", read);
  }

private:
  Json& object_;
  JsonPath path_;
  const Triangulation& tri_;
};

template <class T, class Read>
std::vector<PerEdge<T>> read_per_edge(Part& metric, const char* key, Read read) {
  return metric.per_tetrahedron(key, [&read](const Json& six, const JsonPath& path) {
    // Its own words, as the order of the edges is what one gets wrong.
    if (!six.is_array() || six.size() != 6)
      fail(path, "expected an array of six numbers, for the edges 01,02,03,12,13,23");
    return read_array<6>(six, path, "numbers", read);
  });
}

/// "01", "02", ..., "23", in either order of the two digits.
int read_edge(const Json& value, const JsonPath& path) {
  const std::string text = value.is_string() ? value.get<std::string>() : std::string();
  const auto vertex = [&text](std::size_t k) { return text[k] >= '0' && text[k] <= '3' ? text[k] - '0' : 0; };
  if (text.size() != 2 || vertex(0) == vertex(1) || edge_number[vertex(0)][vertex(1)] < 0)
    fail_found(path, value, "an edge like \"01\"");
  return edge_number[vertex(0)][vertex(1)];
}

Marks read_marks(Json& root, const Triangulation& tri) {
  Json* const list = member(root, "marks");
  if (list == nullptr) return {};
  const JsonPath path{JsonStep("marks")};
  const int last = tri.size() - 1;
  Marks marks = take_list(*list, path, std::nullopt, "marks", [last](const Json& mark, const JsonPath& at) {
    require_array(mark, at, 3, "entries: a tetrahedron, an edge, an order");
    const int tet =
        read_integer(mark[0], below(at, 0), 0, last, "a tetrahedron, 0 to " + std::to_string(last));
    const EdgeMark read{{tet, read_edge(mark[1], below(at, 1))}, read_double(mark[2], below(at, 2))};
    if (!is_edge_order(read.order)) fail_found(below(at, 2), mark[2], "0, 1 or a number above 1");
    return read;
  });
  if (marks.empty()) return marks;
  if (const std::string fault = fault_of(marks, Skeleton(tri)); !fault.empty()) fail(path, fault);
  return marks;
}

std::optional<Number> read_length(const Json& value, const JsonPath& path) {
  if (value.is_null()) return std::nullopt;
  return read_number(value, path);
}

Metric read_metric(Part part) {
  Metric metric;
  metric.edge_lengths = read_per_edge<std::optional<Number>>(part, "edge_lengths", read_length);
  metric.dihedral_angles = read_per_edge<Number>(part, "dihedral_angles", read_number);
  if (const Json* const volume = part.find("volume"))
    metric.volume = read_number(*volume, part.path("volume"));
  return metric;
}

/// The faces that a list names.
std::array<bool, 4> read_flat(const Json& list, const JsonPath& path) {
  require_array(list, path, std::nullopt, "faces");
  std::array<bool, 4> flat{};
  int least = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const int face = read_integer(list[k], below(path, k), least, 3, "a face, 0 to 3, in increasing order");
    flat[static_cast<std::size_t>(face)] = true;
    least = face + 1;
  }
  return flat;
}

/// A face is flat from both sides.
void check_flat(const CanonicalCells& canonical, const Part& part) {
  const Triangulation& tri = part.triangulation();
  for (std::size_t t = 0; t < canonical.flat_faces.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      if (!canonical.flat_faces[t][f]) continue;
      const Gluing g = tri.gluing({static_cast<int>(t), f});
      if (g.tet < 0 || !canonical.flat_faces[g.tet][g.perm[f]])
        fail(below(part.path("flat_faces"), t),
             "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) +
                 (g.tet < 0 ? " is flat, but on the boundary" : " is flat, but not from its other side"));
    }
}

CanonicalCells read_canonical(Part part) {
  CanonicalCells canonical;
  part.need("cells");
  canonical.cells = part.list("cells", std::nullopt, "names", [](const Json& name, const JsonPath& path) {
    if (!name.is_string()) fail_found(path, name, "the name of a cell");
    return name.get<std::string>();
  });
  const int last = static_cast<int>(canonical.cells.size()) - 1;
  canonical.cell_of = part.per_tetrahedron("cell_of", [last](const Json& cell, const JsonPath& path) {
    return read_integer(cell, path, 0, last, "a cell, 0 to " + std::to_string(last));
  });
  canonical.flat_faces = part.per_tetrahedron("flat_faces", read_flat);
  check_flat(canonical, part);
  if (const Json* const signature = part.find("isometry_signature")) {
    if (!signature->is_string()) fail_found(part.path("isometry_signature"), *signature, "a string");
    canonical.isometry_signature = signature->get<std::string>();
  }
  return canonical;
}

/// Reads arrays of `size` integers from 0 to `last`; `many` and `one` are what they are called.
template <std::size_t size>
auto rows(int last, const char* many, const char* one) {
  const std::string wish = std::string(one) + ", 0 to " + std::to_string(last);
  return [last, many, wish](const Json& row, const JsonPath& path) {
    return read_array<size>(row, path, many, [last, &wish](const Json& value, const JsonPath& at) {
      return read_integer(value, at, 0, last, wish);
    });
  };
}

FiberCoordinates read_bundle(Part part) {
  FiberCoordinates bundle;
  bundle.fiber = read_integer(part.need("fiber"), part.path("fiber"), 1, most, "the edges of a fiber");
  if (const Json* const euler = part.find("euler_number"); euler != nullptr && !euler->is_null())
    bundle.euler_number = read_integer(*euler, part.path("euler_number"), -most, most, "an integer or null");
  bundle.base_vertices =
      part.list("base_vertices", std::nullopt, "points", [](const Json& point, const JsonPath& path) {
        return read_array<3>(point, path, "coordinates", read_double);
      });
  const int vertices = static_cast<int>(bundle.base_vertices.size());
  bundle.base_triangles =
      part.list("base_triangles", std::nullopt, "triangles", rows<3>(vertices - 1, "vertices", "a vertex"));
  const int triangles = static_cast<int>(bundle.base_triangles.size());
  bundle.triangle_of = part.per_tetrahedron("triangle_of", [triangles](const Json& t, const JsonPath& path) {
    return read_integer(t, path, 0, triangles - 1, "a triangle of the base");
  });
  bundle.vertices = part.per_tetrahedron("vertices", rows<4>(vertices - 1, "vertices", "a vertex"));
  bundle.levels = part.per_tetrahedron("levels", rows<4>(bundle.fiber, "levels", "a level"));
  return bundle;
}

/// The member of that name, if there is one, as `read` reads it; what `read` leaves of it is kept.
template <class Read>
auto read_part(Json& root, const char* name, const Triangulation& tri, Read read) {
  std::optional<decltype(read(Part(root, name, tri)))> result;
  Json* const value = member(root, name);
  if (value == nullptr) return result;
  result = read(Part(*value, name, tri));
  result->members = std::exchange(*value, nullptr);
  return result;
}

void check_count(const Json& count, std::size_t tetrahedra) {
  if (!count.is_number_unsigned()) fail_found({JsonStep("tetrahedra")}, count, "the number of tetrahedra");
  if (count.get<std::uint64_t>() != tetrahedra)
    fail_found({JsonStep("tetrahedra")}, count,
               std::to_string(tetrahedra) + ", the number of entries of \"gluings\"");
}

Document to_document(JsonTree tree) {
  Document document;
  const Json& count = required(tree.root, "tetrahedra");
  required(tree.root, "gluings");
  check_count(count, tree.gluings.size());
  if (const std::optional<GluingFault> fault = find_fault(tree.gluings))
    fail({JsonStep("gluings"), JsonStep(static_cast<std::size_t>(fault->at.tet)),
          JsonStep(static_cast<std::size_t>(fault->at.face))},
         fault->what);
  document.triangulation = build(tree.gluings);
  document.name = read_text(tree.root, "name");
  const Triangulation& tri = document.triangulation;
  document.marks = read_marks(tree.root, tri);
  document.metric = read_part(tree.root, "metric", tri, read_metric);
  document.canonical = read_part(tree.root, "canonical", tri, read_canonical);
  document.bundle = read_part(tree.root, "bundle", tri, read_bundle);
  document.provenance = take_object(tree.root, "provenance");
  document.members = std::move(tree.root);
  return document;
}

} // namespace

Document read_json(std::string_view text, const std::string& source) {
  return read_tree(text, source, {json_format_tag, json_format_version, true}, to_document);
}

} // namespace tetrarch::format
