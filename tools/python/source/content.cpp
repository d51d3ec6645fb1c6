// SPDX-License-Identifier: GPL-2.0-or-later
#include "content.hpp"

#include "job.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/signature_text.hpp"
#include "tetrarch/format/snappea.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <pybind11/stl.h>

namespace tetrarch::python {
namespace {

using format::MeshDocument;
using format::MeshField;

/// Made when the module is, never released.
py::handle loads;
py::handle numpy_lock;

/// Throws what Python shows as ValueError.
[[noreturn]] void refuse(const std::string& message) {
  throw InputError(message);
}

std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t k = 0; k < array.ndim(); ++k) text += (k > 0 ? ", " : "") + std::to_string(array.shape(k));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

/// Lists and the like become arrays.
py::array array_from(const py::object& given, const std::string& name) {
  if (given.is_none()) refuse(name + ": None is no array of numbers");
  need_numpy();
  py::array array = py::array::ensure(given);
  if (!array) {
    PyErr_Clear();
    refuse(name + ": this is no array of numbers (its rows differ in length?)");
  }
  return array;
}

void require_kind(const py::array& array, const std::string& kinds, const std::string& name,
                  const char* expected) {
  const char kind = array.dtype().kind();
  if (kinds.find(kind) == std::string::npos)
    refuse(name + ": an array of " + std::string(py::str(array.dtype())) + " (expected " + expected + ")");
}

/// Copies the rows of any array of numbers, whatever its order in memory. A copy in double precision is made
/// on the way only where the numbers are of another type.
std::vector<std::array<double, 3>> points_from(const py::object& given, const std::string& name) {
  const py::array array = array_from(given, name);
  if (array.ndim() != 2 || (array.shape(1) != 2 && array.shape(1) != 3))
    refuse(name + ": an array of shape " + shape_of(array) +
           " (expected (n, 3), or (n, 2) for points of a plane)");
  require_kind(array, "fiu", name, "real numbers");
  if (array.shape(0) > std::numeric_limits<int>::max()) refuse(name + ": more than 2147483647 points");
  const auto numbers = py::array_t<double>::ensure(array);
  if (!numbers) {
    PyErr_Clear();
    refuse(name + ": these numbers do not fit into doubles");
  }
  const auto row = numbers.unchecked<2>();
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(row.shape(0)));
  for (py::ssize_t k = 0; k < row.shape(0); ++k)
    points[static_cast<std::size_t>(k)] = {row(k, 0), row(k, 1), row.shape(1) == 3 ? row(k, 2) : 0.0};
  return points;
}

template <class T, std::size_t width>
void copy_rows(const py::array& array, std::vector<std::array<int, width>>& rows, const std::string& name) {
  const auto numbers = py::array_t<T>(array);
  const auto row = numbers.template unchecked<2>();
  for (py::ssize_t k = 0; k < row.shape(0); ++k)
    for (std::size_t c = 0; c < width; ++c) {
      const T value = row(k, length(c));
      if constexpr (sizeof(T) > sizeof(int))
        if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
          refuse(name + ": row " + std::to_string(k) + " has the index " + std::to_string(value) +
                 " (expected at most 2147483647)");
      rows[static_cast<std::size_t>(k)][c] = static_cast<int>(value);
    }
}

void require_integers(const py::array& array, const std::string& name) {
  require_kind(array, "iu", name, "integers");
  if (array.dtype().kind() == 'u' && array.itemsize() == 8 && array.size() > 0 &&
      array.attr("max")().cast<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    refuse(name + ": an index is greater than 2147483647");
}

/// Rows of indices; an empty array of any type has none.
template <std::size_t width>
std::vector<std::array<int, width>> indices_from(const py::object& given, const std::string& name) {
  std::vector<std::array<int, width>> rows;
  if (given.is_none()) return rows;
  const py::array array = array_from(given, name);
  if (array.size() == 0) return rows;
  if (array.ndim() != 2 || array.shape(1) != length(width))
    refuse(name + ": an array of shape " + shape_of(array) + " (expected (m, " + std::to_string(width) +
           "))");
  require_integers(array, name);
  if (array.shape(0) > std::numeric_limits<int>::max() / 4) refuse(name + ": more than 536870911 rows");
  rows.resize(static_cast<std::size_t>(array.shape(0)));
  if (array.itemsize() <= 4 && array.dtype().kind() == 'i')
    copy_rows<std::int32_t>(array, rows, name);
  else
    copy_rows<std::int64_t>(array, rows, name);
  return rows;
}

std::vector<int> tags_from(const py::object& given, const std::string& name, std::size_t count) {
  std::vector<int> tags;
  if (given.is_none()) return tags;
  const py::array array = array_from(given, name);
  if (array.ndim() != 1 || array.shape(0) != length(count))
    refuse(name + ": an array of shape " + shape_of(array) + " (expected (" + std::to_string(count) + ",))");
  require_integers(array, name);
  const auto numbers = py::array_t<std::int64_t>(array);
  const auto at = numbers.unchecked<1>();
  for (py::ssize_t k = 0; k < at.shape(0); ++k) {
    if (at(k) < std::numeric_limits<int>::min() || at(k) > std::numeric_limits<int>::max())
      refuse(name + ": the tag " + std::to_string(at(k)) + " is too large");
    tags.push_back(static_cast<int>(at(k)));
  }
  return tags;
}

Content mesh_from_arrays(const py::object& points, const py::object& triangles, const py::object& tetrahedra,
                         const py::object& triangle_tags, const py::object& tetrahedron_tags,
                         const std::string& source) {
  format::Soup soup;
  soup.source = source;
  soup.points = points_from(points, "points");
  soup.triangles = indices_from<3>(triangles, "triangles");
  soup.tetrahedra = indices_from<4>(tetrahedra, "tetrahedra");
  soup.triangle_tags = tags_from(triangle_tags, "triangle_tags", soup.triangles.size());
  soup.tetrahedron_tags = tags_from(tetrahedron_tags, "tetrahedron_tags", soup.tetrahedra.size());
  auto made = std::make_shared<workshop::Content>(format::mesh_document_of(std::move(soup)));
  return {made, made};
}

Perm4 perm_from(const py::handle& given) {
  const auto images = py::cast<std::array<int, 4>>(given);
  int seen = 0;
  for (const int i : images) {
    if (i < 0 || i > 3)
      refuse("gluings: a permutation has the image " + std::to_string(i) + " (expected 0 to 3)");
    seen |= 1 << i;
  }
  if (seen != 15) refuse("gluings: a permutation has an image twice");
  return {images[0], images[1], images[2], images[3]};
}

/// A row of four for each tetrahedron: None, or (the other tetrahedron, where the vertices go).
Content triangulation_from_gluings(const py::sequence& rows, const std::string& name) {
  constexpr std::size_t most = 100'000'000;
  if (rows.size() > most) refuse("gluings: too many tetrahedra");
  Triangulation tri(static_cast<int>(rows.size()));
  for (int t = 0; t < tri.size(); ++t) {
    const py::sequence faces = rows[static_cast<std::size_t>(t)];
    if (faces.size() != 4)
      refuse("gluings: tetrahedron " + std::to_string(t) + " has " + std::to_string(faces.size()) +
             " faces (expected 4)");
    for (int f = 0; f < 4; ++f) {
      const py::object face = faces[static_cast<std::size_t>(f)];
      if (face.is_none()) continue;
      const py::sequence gluing = face;
      if (gluing.size() != 2) refuse("gluings: a face is None or (tetrahedron, permutation)");
      const auto other = py::cast<long long>(gluing[0]);
      const Perm4 perm = perm_from(gluing[1]);
      if (other < 0 || other >= tri.size())
        refuse("gluings: tetrahedron " + std::to_string(t) + " is glued to " + std::to_string(other) +
               " (there are " + std::to_string(tri.size()) + ")");
      const TetFace here{t, f};
      if (tri.is_boundary(here))
        tri.glue(here, static_cast<int>(other), perm);
      else if (tri.gluing(here) != Gluing{static_cast<int>(other), perm})
        refuse("gluings: face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) +
               " is glued otherwise from its other side");
    }
  }
  return content_of(std::move(tri), name);
}

workshop::OpenOptions open_options(std::optional<double> weld, std::optional<int> component, bool repair) {
  return {{weld, component, repair}};
}

/// A name or a signature is read in microseconds, a file may be a mesh of millions of tetrahedra.
bool is_quick(const std::string& text) {
  constexpr std::size_t most = 100;
  return text.size() < most && text != "-" && !workshop::is_file(text) && text.find('#') == std::string::npos;
}

template <class Job>
auto opened(bool quick, const py::object& report, const Job& job) {
  if (quick) return unlocked([&] { return job(Progress()); });
  return interruptible(report, job);
}

Content open_triangulation(const std::string& text, std::optional<double> weld, std::optional<int> component,
                           bool repair, const py::object& report) {
  return opened(is_quick(text), report,
                [text, options = open_options(weld, component, repair)](const Progress& progress) {
                  return content_of(workshop::open_triangulation(text, options, progress));
                });
}

Content open_any(const std::string& text, const py::object& report) {
  return opened(is_quick(text), report, [text](const Progress&) {
    return Content{
        std::make_shared<const workshop::Content>(workshop::open(text, open_options({}, {}, false)))};
  });
}

Content open_mesh(const std::string& text, const py::object& report) {
  return interruptible(report, [text](const Progress&) {
    return Content{std::make_shared<const workshop::Content>(
        format::mesh_document_of(workshop::open_mesh(text, open_options({}, {}, false))))};
  });
}

Content triangulated(const Content& content, std::optional<double> weld, std::optional<int> component,
                     bool repair, const std::string& name, const py::object& report) {
  if (std::holds_alternative<format::Document>(*content.value)) return content;
  return interruptible(report, [value = content.value, name,
                                doctor = workshop::Doctor{weld, component, repair}](const Progress& p) {
    return content_of(workshop::triangulation_of(name, *value, doctor, p));
  });
}

py::object array_of(const Content& content, const std::string& which) {
  const MeshDocument& mesh = mesh_in(content);
  const auto rows = [&](const auto& list) {
    using Row = typename std::decay_t<decltype(list)>::value_type;
    using Number = typename Row::value_type;
    const auto* const first = list.empty() ? nullptr : list.front().data();
    return view<Number>(first, {length(list.size()), length(std::tuple_size_v<Row>)}, content.value);
  };
  if (which == "points") return rows(mesh.soup.points);
  if (which == "triangles") return rows(mesh.soup.triangles);
  if (which == "tetrahedra") return rows(mesh.soup.tetrahedra);
  if (which == "hexahedra") return rows(mesh.hexahedra);
  const auto tags = [&](const std::vector<int>& list) {
    return view<int>(list.data(), {length(list.size())}, content.value);
  };
  return which == "triangle_tags" ? tags(mesh.soup.triangle_tags) : tags(mesh.soup.tetrahedron_tags);
}

const char* name_of(MeshField::On on) {
  switch (on) {
  case MeshField::On::vertices:
    return "vertices";
  case MeshField::On::triangles:
    return "triangles";
  case MeshField::On::tetrahedra:
    return "tetrahedra";
  case MeshField::On::hexahedra:
    return "hexahedra";
  case MeshField::On::triangle_corners:
    return "triangle corners";
  case MeshField::On::tetrahedron_corners:
    return "tetrahedron corners";
  }
  return "";
}

/// Name, place and numbers of each field; those at corners as (triangles, 3, ...).
py::list fields_of(const Content& content) {
  py::list list;
  for (const MeshField& field : mesh_in(content).fields) {
    std::vector<py::ssize_t> shape{length(field.values.size()) / field.components};
    const py::ssize_t corners = field.on == MeshField::On::triangle_corners      ? 3
                                : field.on == MeshField::On::tetrahedron_corners ? 4
                                                                                 : 1;
    if (corners > 1) shape = {shape[0] / corners, corners};
    if (field.components > 1) shape.push_back(field.components);
    list.append(py::make_tuple(field.name, name_of(field.on),
                               view<double>(field.values.data(), shape, content.value)));
  }
  return list;
}

/// The per-vertex numbers of a field at the corners of triangles: of each vertex those at the last of its
/// corners.
py::object at_vertices(const Content& content, const std::string& name) {
  const MeshDocument& mesh = mesh_in(content);
  const MeshField* const field = format::find_field(mesh, name);
  if (field == nullptr || field->on != MeshField::On::triangle_corners) return py::none();
  const std::size_t width = static_cast<std::size_t>(field->components);
  std::vector<double> values(mesh.soup.points.size() * width, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t t = 0; t < mesh.soup.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < width; ++k)
        values[static_cast<std::size_t>(mesh.soup.triangles[t][c]) * width + k] =
            field->values[(3 * t + c) * width + k];
  return owned(std::move(values), {length(mesh.soup.points.size()), length(width)});
}

std::string written(const Content& content, const std::string& format) {
  return by_size(size_of(content), [content, is_json = format == "json"] {
    const format::Document& document = document_in(content);
    return is_json ? format::write_json(document) : format::write_snappea(document).text;
  });
}

std::string signature_of(const Content& content) {
  return by_size(size_of(content), [tri = triangulation_in(content)] { return signature(*tri); });
}

/// What pickles keep: the text of a file.
std::string text_of(const Content& content) {
  if (const auto* const mesh = std::get_if<MeshDocument>(content.value.get())) return write_mesh_json(*mesh);
  if (const auto* const group = std::get_if<format::GroupDocument>(content.value.get()))
    return write_group_json(*group);
  return format::write_json(document_in(content));
}

/// The content of a file: JSON of any kind, or a triangulation in any other format.
Content content_from(const std::string& text) {
  return by_size(text.size() / 16, [text] { // a file takes so many bytes and more for a tetrahedron
    if (text.starts_with("{"))
      return Content{std::make_shared<const workshop::Content>(workshop::open(text))};
    return content_of(workshop::with_fillings(format::read_any(text, "<text>"), text, "<text>"));
  });
}

py::tuple group_in(const Content& content) {
  if (const auto* const group = std::get_if<format::GroupDocument>(content.value.get()))
    return py::make_tuple(group->generators, group->relators);
  throw InputError("this is a " + workshop::kind_of(*content.value) + " (expected a group)", Cause::kind);
}

std::string content_name(const Content& content) {
  return std::visit([](const auto& held) { return held.name; }, *content.value);
}

py::object warnings_of(const Content& content) {
  const auto* const document = std::get_if<format::Document>(content.value.get());
  std::vector<std::string> list;
  if (document == nullptr) return py::cast(list);
  list = document->warnings;
  if (!document->passed_over.empty()) list.insert(list.begin(), document->passed_over.sentence());
  return py::cast(list);
}

} // namespace

std::size_t size_of(const Content& content) {
  return static_cast<std::size_t>(document_in(content).triangulation.size());
}

Content content_of(format::Document document) {
  return {std::make_shared<const workshop::Content>(std::move(document))};
}

Content content_of(Triangulation triangulation, std::string name) {
  return content_of(format::document_of(std::move(triangulation), std::move(name)));
}

const format::Document& document_in(const Content& content) {
  if (const auto* const document = std::get_if<format::Document>(content.value.get())) return *document;
  throw InputError("this is a " + workshop::kind_of(*content.value) + " (expected a triangulation)",
                   Cause::kind);
}

const format::MeshDocument& mesh_in(const Content& content) {
  if (const auto* const mesh = std::get_if<MeshDocument>(content.value.get())) return *mesh;
  throw InputError("this is a " + workshop::kind_of(*content.value) + " (expected a mesh)", Cause::kind);
}

std::shared_ptr<const Triangulation> triangulation_in(const Content& content) {
  return {content.value, &document_in(content).triangulation};
}

py::object object_of(const Tree& tree) {
  return loads(py::str(tree.dump()));
}

void need_numpy() {
  static std::atomic<bool> is_there{false};
  if (is_there) return;
  numpy_lock.attr("acquire")(); // lets go of the interpreter's lock while it waits
  try {
    py::detail::npy_api::get();
  } catch (...) {
    numpy_lock.attr("release")();
    throw;
  }
  is_there = true;
  numpy_lock.attr("release")();
}

void bind_content(py::module_& module) {
  loads = py::object(py::module_::import("json").attr("loads")).release();
  numpy_lock = py::module_::import("_thread").attr("allocate_lock")().release();
  py::class_<Content>(module, "Content")
      .def_property_readonly("kind", [](const Content& c) { return workshop::kind_of(*c.value); })
      .def_property_readonly("name", content_name)
      .def_property_readonly("warnings", warnings_of)
      .def("array", [](const Content& c, const std::string& which) { return array_of(c, which); })
      .def("fields", fields_of)
      .def("group", group_in)
      .def("at_vertices", at_vertices)
      .def("written", written)
      .def("signature", signature_of)
      .def_property_readonly("size", [](const Content& c) { return document_in(c).triangulation.size(); })
      .def(py::pickle([](const Content& c) { return text_of(c); },
                      [](const std::string& text) { return content_from(text); }));
  module.def("content_from", content_from);
  module.def("mesh_from_arrays", mesh_from_arrays);
  module.def("triangulation_from_gluings", triangulation_from_gluings);
  module.def("open_triangulation", open_triangulation);
  module.def("open_any", open_any);
  module.def("open_mesh", open_mesh);
  module.def("triangulated", triangulated);
}

} // namespace tetrarch::python
