// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/vtk.hpp"

#include "mesh_text.hpp"
#include "vtk_cells.hpp"

#include <algorithm>
#include <map>

namespace tetrarch::format {
namespace {

struct ScalarType {
  std::size_t size;
  bool real;
};

/// The names that the legacy format gives its number types.
const std::map<std::string_view, ScalarType> scalar_types{
    {"char", {1, false}},           {"unsigned_char", {1, false}}, {"short", {2, false}},
    {"unsigned_short", {2, false}}, {"int", {4, false}},           {"unsigned_int", {4, false}},
    {"long", {8, false}},           {"unsigned_long", {8, false}}, {"vtktypeint64", {8, false}},
    {"vtktypeuint64", {8, false}},  {"vtkIdType", {8, false}},     {"float", {4, true}},
    {"double", {8, true}}};

class VtkReader {
public:
  VtkReader(std::string_view text, const std::string& source) : in_(text, source) { soup_.source = source; }

  Soup read() && {
    read_header();
    while (!in_.at_end()) {
      const std::string_view keyword = in_.token("a keyword");
      if (keyword == "POINT_DATA" || keyword == "CELL_DATA") break; // nothing but data from here on
      read_section(keyword);
    }
    if (!polydata_) add_cells();
    return std::move(soup_);
  }

private:
  void read_header() {
    constexpr std::string_view mark = "# vtk DataFile Version";
    const std::string_view first = in_.rest_of_line();
    if (first.substr(0, mark.size()) != mark) in_.fail(first, "\"" + std::string(mark) + "\"");
    in_.rest_of_line();
    const std::string_view form = in_.token("ASCII or BINARY");
    if (form != "ASCII" && form != "BINARY") in_.fail(form, "ASCII or BINARY");
    binary_ = form == "BINARY";
    const std::string_view dataset = in_.token("DATASET");
    if (dataset != "DATASET") in_.fail(dataset, "DATASET");
    const std::string_view kind = in_.token("a kind of dataset");
    if (kind != "UNSTRUCTURED_GRID" && kind != "POLYDATA") in_.fail(kind, "UNSTRUCTURED_GRID or POLYDATA");
    polydata_ = kind == "POLYDATA";
  }

  void read_section(std::string_view keyword) {
    if (keyword == "POINTS") {
      read_points();
    } else if (keyword == "CELLS" || (polydata_ && (keyword == "POLYGONS" || keyword == "TRIANGLE_STRIPS" ||
                                                    keyword == "LINES" || keyword == "VERTICES"))) {
      read_cells();
      if (keyword == "POLYGONS") add_polygons();
      if (keyword == "TRIANGLE_STRIPS" && cell_count() > 0)
        soup_.warnings.emplace_back("triangle strips were passed over");
    } else if (keyword == "CELL_TYPES") {
      const std::int64_t count = in_.integer("the number of cells", 0, most_elements);
      types_ = read_integers("int", count);
    } else if (keyword == "METADATA") {
      in_.rest_of_line();
      while (in_.bytes_left() > 0 && !in_.rest_of_line().empty()) {
      }
    } else if (keyword == "FIELD") {
      pass_over_field();
    } else {
      in_.fail(keyword, "POINTS, CELLS or CELL_TYPES");
    }
  }

  void read_points() {
    if (!soup_.points.empty()) in_.fail("POINTS", "only one list of points");
    const std::int64_t count = in_.integer("the number of points", 0, most_elements / 3);
    const ScalarType type = read_type();
    soup_.points.reserve(in_.believable(count, binary_ ? 3 * type.size : 6));
    for (std::int64_t i = 0; i < count; ++i) {
      std::array<double, 3> p{};
      for (double& x : p) x = binary_ ? binary_real(type) : in_.number("a coordinate");
      soup_.points.push_back(p);
      note(soup_.point_labels, static_cast<int>(i), in_.line());
    }
  }

  /// Fills starts_ and connectivity_ and, where each cell has a line, lines_.
  void read_cells() {
    const std::int64_t count = in_.integer("the number of cells", 0, most_elements);
    const std::int64_t size = in_.integer("the number of integers", 0, most_elements);
    lines_ = Runs();
    starts_.assign(1, 0);
    connectivity_.clear();
    if (in_.next_line_begins_with("OFFSETS")) return read_offsets(count, size);
    if (binary_) in_.rest_of_line();
    starts_.reserve(in_.believable(count, 2));
    connectivity_.reserve(in_.believable(std::max<std::int64_t>(size - count, 0), 2));
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t points = integer("int", "the number of points in a cell", 0);
      lines_.push_back(in_.line());
      for (std::int64_t k = 0; k < points; ++k)
        connectivity_.push_back(static_cast<int>(integer("int", "the number of a point", 1 - most_elements)));
      starts_.push_back(static_cast<int>(connectivity_.size()));
    }
  }

  /// Version 5: the first number is one more than there are cells, the second the length of the connectivity.
  void read_offsets(std::int64_t count, std::int64_t size) {
    in_.token("OFFSETS");
    starts_ = read_integers(in_.token("a type"), count);
    const std::string_view keyword = in_.token("CONNECTIVITY");
    if (keyword != "CONNECTIVITY") in_.fail(keyword, "CONNECTIVITY");
    connectivity_ = read_integers(in_.token("a type"), size);
    if (starts_.empty()) starts_.assign(1, 0);
    if (starts_.front() != 0 || starts_.back() != size || !std::is_sorted(starts_.begin(), starts_.end()))
      in_.fail("offsets that do not fit", "0 to " + std::to_string(size) + " in increasing order");
  }

  std::size_t cell_count() const { return starts_.size() - 1; }
  std::span<const int> points_of(std::size_t cell) const {
    return std::span(connectivity_)
        .subspan(static_cast<std::size_t>(starts_[cell]),
                 static_cast<std::size_t>(starts_[cell + 1] - starts_[cell]));
  }
  Place place_of(std::size_t cell) const { return {soup_.source, cell < lines_.size() ? lines_[cell] : 0}; }

  void add_cells() {
    if (types_.size() != cell_count())
      in_.fail(std::to_string(types_.size()) + " cell types", std::to_string(cell_count()));
    for (std::size_t i = 0; i < cell_count(); ++i)
      add_vtk_cell(soup_, types_[i], points_of(i), static_cast<int>(i), place_of(i));
  }

  void add_polygons() {
    for (std::size_t i = 0; i < cell_count(); ++i)
      add_vtk_cell(soup_, vtk_triangle, points_of(i), static_cast<int>(i), place_of(i));
  }

  void pass_over_field() {
    in_.token("a name");
    const std::int64_t arrays = in_.integer("the number of arrays", 0, most_elements);
    for (std::int64_t a = 0; a < arrays; ++a) {
      const std::string_view name = in_.token("a name");
      if (name == "METADATA") in_.fail(name, "an array");
      const std::int64_t components = in_.integer("the number of components", 0, 1000);
      const std::int64_t tuples = in_.integer("the number of tuples", 0, most_elements);
      const std::string_view type_name = in_.token("a type");
      if (type_name == "string") in_.fail(type_name, "an array of numbers");
      const ScalarType type = scalar_type(type_name);
      if (binary_) in_.rest_of_line();
      for (std::int64_t i = 0; i < components * tuples; ++i) {
        if (binary_) {
          in_.bytes(type.size, "an array");
        } else {
          in_.number("a number");
        }
      }
    }
  }

  ScalarType scalar_type(std::string_view name) const {
    const auto found = scalar_types.find(name);
    if (found == scalar_types.end()) in_.fail(name, "a type of numbers, like double");
    return found->second;
  }

  /// The type that ends a line; binary numbers begin on the next.
  ScalarType read_type() {
    const ScalarType type = scalar_type(in_.token("a type of numbers"));
    if (binary_) in_.rest_of_line();
    return type;
  }

  double binary_real(ScalarType type) {
    constexpr bool swapped = swapped_if(std::endian::big);
    const char* const raw = in_.bytes(type.size, "a coordinate").data();
    if (!type.real) in_.fail("integer coordinates", "float or double");
    return type.size == 4 ? static_cast<double>(load<float>(raw, swapped)) : load<double>(raw, swapped);
  }

  std::int64_t integer(std::string_view type_name, std::string_view expected, std::int64_t least) {
    if (!binary_) return in_.integer(expected, least, most_elements);
    const ScalarType type = scalar_type(type_name);
    constexpr bool swapped = swapped_if(std::endian::big);
    const char* const raw = in_.bytes(type.size, expected).data();
    std::int64_t value = least - 1;
    if (!type.real && type.size == 4) value = load<std::int32_t>(raw, swapped);
    if (!type.real && type.size == 8) value = load<std::int64_t>(raw, swapped);
    if (value < least || value > most_elements) in_.fail(std::to_string(value), expected);
    return value;
  }

  std::vector<int> read_integers(std::string_view type, std::int64_t count) {
    if (binary_) in_.rest_of_line();
    std::vector<int> out;
    out.reserve(in_.believable(count, 2));
    for (std::int64_t i = 0; i < count; ++i)
      out.push_back(static_cast<int>(integer(type, "an integer", 1 - most_elements)));
    return out;
  }

  MeshCursor in_;
  Soup soup_;
  std::vector<int> starts_{0};
  std::vector<int> connectivity_;
  std::vector<int> types_;
  Runs lines_;
  bool binary_ = false;
  bool polydata_ = false;
};

} // namespace

Soup read_vtk(std::string_view text, const std::string& source) {
  return VtkReader(text, source).read();
}

std::string write_vtk(const Soup& soup) {
  const std::size_t triangles = soup.triangles.size();
  const std::size_t tetrahedra = soup.tetrahedra.size();
  const std::string cells = std::to_string(triangles + tetrahedra);
  std::string out = "# vtk DataFile Version 3.0\nTetrarch\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                    std::to_string(soup.points.size()) + " double\n";
  for (const auto& p : soup.points) append_line(out, p, "\n");
  out += "CELLS " + cells + " " + std::to_string(4 * triangles + 5 * tetrahedra) + "\n";
  for (const auto& corners : soup.triangles) {
    out += "3 ";
    append_line(out, corners, "\n", 0);
  }
  for (const auto& corners : soup.tetrahedra) {
    out += "4 ";
    append_line(out, corners, "\n", 0);
  }
  out += "CELL_TYPES " + cells + "\n";
  for (std::size_t i = 0; i < triangles; ++i) out += "5\n";
  for (std::size_t i = 0; i < tetrahedra; ++i) out += "10\n";
  return out;
}

} // namespace tetrarch::format
