// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/vtk.hpp"

#include "mesh_text.hpp"
#include "vtk_cells.hpp"
#include "vtk_data.hpp"

#include <algorithm>

namespace tetrarch::format {
namespace {

/// A list of cells by their points.
struct CellList {
  std::vector<int> starts{0};
  std::vector<int> connectivity;
  Runs lines;

  std::size_t size() const { return starts.size() - 1; }
  std::span<const int> points_of(std::size_t cell) const {
    return std::span(connectivity)
        .subspan(static_cast<std::size_t>(starts[cell]),
                 static_cast<std::size_t>(starts[cell + 1] - starts[cell]));
  }
  int line(std::size_t cell) const { return cell < lines.size() ? lines[cell] : 0; }
};

/// In POLYDATA, in the order in which data count the cells, and their type.
struct PolyKind {
  std::string_view keyword;
  int type;
};
constexpr std::array<PolyKind, 4> poly_kinds{
    {{"VERTICES", 1}, {"LINES", 3}, {"POLYGONS", vtk_polygon}, {"TRIANGLE_STRIPS", vtk_strip}}};

class VtkReader {
public:
  VtkReader(std::string_view text, const std::string& source) : in_(text, source), numbers_(in_) {
    soup_.source = source;
  }

  Soup read() && {
    read_header();
    bool goes_on = true;
    while (goes_on && !in_.at_end()) goes_on = read_section(std::string(in_.token("a keyword")));
    add_cells();
    cells_.finish_turning_prisms();
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
    numbers_.binary = form == "BINARY";
    const std::string_view dataset = in_.token("DATASET");
    if (dataset != "DATASET") in_.fail(dataset, "DATASET");
    const std::string_view kind = in_.token("a kind of dataset");
    if (kind != "UNSTRUCTURED_GRID" && kind != "POLYDATA") in_.fail(kind, "UNSTRUCTURED_GRID or POLYDATA");
    polydata_ = kind == "POLYDATA";
  }

  /// False if nothing more can be read.
  bool read_section(const std::string& keyword) {
    if (keyword == "POINTS") {
      read_points();
    } else if (keyword == "CELLS") {
      read_cells(lists_[0]);
    } else if (keyword == "CELL_TYPES") {
      const std::int64_t count = in_.integer("the number of cells", 0, most_elements);
      types_ = numbers_.integers("int", count);
    } else if (keyword == "METADATA") {
      pass_over_paragraph();
    } else if (keyword == "FIELD" && data_size_ < 0) {
      read_field("", 0);
    } else if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
      of_cells_ = keyword == "CELL_DATA";
      data_size_ = in_.integer("how many there are", 0, most_elements);
    } else if (data_size_ >= 0) {
      return read_attribute(keyword);
    } else {
      read_polygons(keyword);
    }
    return true;
  }

  void read_polygons(const std::string& keyword) {
    for (std::size_t k = 0; k < poly_kinds.size(); ++k)
      if (polydata_ && poly_kinds[k].keyword == keyword) return read_cells(lists_[k]);
    in_.fail(keyword, polydata_ ? "POINTS, VERTICES, LINES, POLYGONS or TRIANGLE_STRIPS"
                                : "POINTS, CELLS or CELL_TYPES");
  }

  void pass_over_paragraph() {
    in_.rest_of_line();
    while (in_.bytes_left() > 0 && !in_.rest_of_line().empty()) {
    }
  }

  void read_points() {
    if (!soup_.points.empty()) in_.fail("POINTS", "only one list of points");
    const std::int64_t count = in_.integer("the number of points", 0, most_elements / 3);
    const VtkScalar type = numbers_.type(in_.token("a type of numbers"));
    numbers_.begin_data();
    soup_.points.reserve(in_.believable(count, numbers_.binary ? 3 * type.size : 6));
    for (std::int64_t i = 0; i < count; ++i) {
      std::array<double, 3> p{};
      for (double& x : p) x = numbers_.real(type);
      soup_.points.push_back(p);
      note(soup_.point_labels, static_cast<int>(i), in_.line());
    }
  }

  void read_cells(CellList& list) {
    const std::int64_t count = in_.integer("the number of cells", 0, most_elements);
    const std::int64_t size = in_.integer("the number of integers", 0, most_elements);
    list = CellList();
    if (in_.next_line_begins_with("OFFSETS")) return read_offsets(list, count, size);
    numbers_.begin_data();
    list.starts.reserve(in_.believable(count, 2));
    list.connectivity.reserve(in_.believable(std::max<std::int64_t>(size - count, 0), 2));
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t points = numbers_.integer("int", "the number of points in a cell", 0);
      list.lines.push_back(in_.line());
      for (std::int64_t k = 0; k < points; ++k)
        list.connectivity.push_back(
            static_cast<int>(numbers_.integer("int", "the number of a point", 1 - most_elements)));
      list.starts.push_back(static_cast<int>(list.connectivity.size()));
    }
  }

  /// Version 5: the first number is one more than there are cells, the second the length of the connectivity.
  void read_offsets(CellList& list, std::int64_t count, std::int64_t size) {
    in_.token("OFFSETS");
    list.starts = numbers_.integers(in_.token("a type"), count);
    const std::string_view keyword = in_.token("CONNECTIVITY");
    if (keyword != "CONNECTIVITY") in_.fail(keyword, "CONNECTIVITY");
    list.connectivity = numbers_.integers(in_.token("a type"), size);
    if (list.starts.empty()) list.starts.assign(1, 0);
    if (list.starts.front() != 0 || list.starts.back() != size ||
        !std::is_sorted(list.starts.begin(), list.starts.end()))
      in_.fail("offsets that do not fit", "0 to " + std::to_string(size) + " in increasing order");
  }

  /// `what`: "point array" or "cell array"; else the field belongs to the file.
  void read_field(const std::string& what, std::int64_t size) {
    in_.token("a name");
    const std::int64_t arrays = in_.integer("the number of arrays", 0, most_elements);
    for (std::int64_t a = 0; a < arrays; ++a) {
      const std::string name(in_.token("a name"));
      if (name == "METADATA") { // of the array before
        pass_over_paragraph();
        --a;
        continue;
      }
      const std::int64_t components = in_.integer("the number of components", 0, 1000);
      const std::int64_t tuples = in_.integer("the number of tuples", 0, most_elements);
      const std::string type(in_.token("a type"));
      if (is_label(name) && components == 1 && tuples == size && numbers_.are_integers(type)) {
        take_labels(name, numbers_.labels(type, tuples));
        continue;
      }
      numbers_.pass_over_array(type, components * tuples);
      std::string passed = what.empty() ? "field array" : what;
      passed.append(" ").append(name);
      soup_.passed_over.note(passed);
    }
  }

  bool is_label(const std::string& name) const {
    return of_cells_ && data_size_ >= 0 && label_rank(name) > label_rank(label_name_);
  }
  void take_labels(const std::string& name, std::vector<int> labels) {
    if (!label_name_.empty()) soup_.passed_over.note("cell array " + label_name_);
    label_name_ = name;
    labels_ = std::move(labels);
  }

  /// An attribute of points or cells, which has as many tuples as there are of them.
  bool read_attribute(const std::string& keyword) {
    const std::string what = of_cells_ ? "cell array" : "point array";
    const std::optional<VtkAttribute> attribute = read_attribute_head(in_, keyword, numbers_.binary);
    if (!attribute) {
      soup_.passed_over.note("all data from " + keyword + " on");
      return false;
    }
    const std::int64_t size = attribute->own_size >= 0 ? attribute->own_size : data_size_;
    if (is_label(attribute->name) && attribute->components == 1 && numbers_.are_integers(attribute->type)) {
      take_labels(attribute->name, numbers_.labels(attribute->type, size));
      return true;
    }
    if (attribute->is_field) {
      read_field(what, size);
      return true;
    }
    numbers_.pass_over_array(attribute->type, attribute->components * size);
    soup_.passed_over.note(attribute->own_size >= 0 ? "lookup table" : what + " " + attribute->name);
    return true;
  }

  void add_cells() {
    const std::size_t count = polydata_ ? 0 : lists_[0].size();
    if (!polydata_ && types_.size() != count)
      in_.fail(std::to_string(types_.size()) + " cell types", std::to_string(count));
    int number = 0;
    const std::size_t points = soup_.points.size(); // polyhedra may add some
    for (std::size_t k = 0; k < lists_.size(); ++k) {
      const CellList& list = lists_[k];
      for (std::size_t i = 0; i < list.size(); ++i, ++number) {
        const int type = polydata_ ? poly_kinds[k].type : types_[i];
        const auto at = static_cast<std::size_t>(number);
        const CellName name{number, list.line(i), at < labels_.size() ? labels_[at] : 0};
        const Place place{soup_.source, name.line};
        if (type == vtk_polyhedron)
          add_vtk_polyhedron(cells_, list.points_of(i), 0, points, name, place);
        else
          add_vtk_cell(cells_, soup_.passed_over, type, list.points_of(i), name, place);
      }
    }
  }

  MeshCursor in_;
  VtkNumbers numbers_;
  Soup soup_;
  Cells cells_{soup_};
  std::array<CellList, poly_kinds.size()> lists_;
  std::vector<int> types_;
  std::vector<int> labels_;
  std::string label_name_;
  std::int64_t data_size_ = -1; ///< of the points or cells that data are about; -1: there are no data yet
  bool of_cells_ = false;
  bool polydata_ = false;
};

void append_cell_labels(std::string& out, const Soup& soup) {
  const auto append = [&out](std::size_t count, const std::vector<int>& tags) {
    for (std::size_t i = 0; i < count; ++i) {
      append_number(out, tags.empty() ? 0 : tags[i]);
      out += '\n';
    }
  };
  append(soup.triangles.size(), soup.triangle_tags);
  append(soup.tetrahedra.size(), soup.tetrahedron_tags);
}

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
  if (soup.triangle_tags.empty() && soup.tetrahedron_tags.empty()) return out;
  out += "CELL_DATA " + cells + "\nSCALARS " + std::string(label_name) + " int 1\nLOOKUP_TABLE default\n";
  append_cell_labels(out, soup);
  return out;
}

} // namespace tetrarch::format
