// SPDX-License-Identifier: GPL-2.0-or-later
#include "mesh_text.hpp"
#include "vtk_cells.hpp"
#include "vtu_array.hpp"
#include "xml.hpp"

#include "tetrarch/format/vtk.hpp"

namespace tetrarch::format {
namespace {

constexpr std::string_view appended_element = "<AppendedData";

/// The text up to the appended section, which may hold raw bytes and so is no XML, with its end mended; and
/// where the data of the section begin.
struct Parts {
  std::string xml;
  std::string_view appended;
  bool base64 = false;
};

Parts parts_of(std::string_view text, const std::string& source) {
  const std::size_t at = text.find(appended_element);
  if (at == std::string_view::npos) return {std::string(text), {}, false};
  Parts parts{std::string(text.substr(0, at)) + "</VTKFile>", {}, false};
  const std::size_t open = text.find('>', at);
  const std::size_t mark = open == std::string_view::npos ? open : text.find('_', open);
  if (mark == std::string_view::npos)
    throw InputError(Place{source, 0}, "the appended data have no beginning, an underscore");
  parts.base64 = text.substr(at, open - at).find("base64") != std::string_view::npos;
  parts.appended = text.substr(mark + 1);
  return parts;
}

class VtuReader {
public:
  VtuReader(std::string_view text, const std::string& source) : parts_(parts_of(text, source)) {
    soup_.source = source;
    storage_.source = source;
    storage_.appended = parts_.appended;
    storage_.appended_base64 = parts_.base64;
  }

  Soup read() && {
    const pugi::xml_document document = parse_xml(parts_.xml, soup_.source);
    parts_.xml = std::string(); // the tree has its own copy
    const pugi::xml_node file = document.child("VTKFile");
    read_storage(file);
    const pugi::xml_node grid = file.child(is_polydata_ ? "PolyData" : "UnstructuredGrid");
    for (const pugi::xml_node& field : grid.child("FieldData").children())
      soup_.passed_over.note("field array " + std::string(field.attribute("Name").value()));
    for (const pugi::xml_node& piece : grid.children("Piece")) read_piece(piece);
    if (pieces_ > 1) soup_.passed_over.note("division into pieces");
    cells_.finish_turning_prisms();
    return std::move(soup_);
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(Place{soup_.source, 0}, what); }

  void read_storage(const pugi::xml_node& file) {
    const std::string_view type = file.attribute("type").value();
    if (type != "UnstructuredGrid" && type != "PolyData")
      fail("found a VTK file of type " + in_quotes(type) + ", expected UnstructuredGrid or PolyData");
    is_polydata_ = type == "PolyData";
    const std::string_view order = file.attribute("byte_order").value();
    storage_.swapped = swapped_if(order == "BigEndian" ? std::endian::big : std::endian::little);
    storage_.wide_header = std::string_view(file.attribute("header_type").value()) == "UInt64";
    const std::string_view compressor = file.attribute("compressor").value();
    if (compressor.empty()) return;
    const auto packing = packing_named(compressor);
    if (!packing)
      fail("the data are compressed by " + in_quotes(compressor) +
           ", expected vtkZLibDataCompressor, vtkLZ4DataCompressor, vtkLZMADataCompressor or none");
    storage_.packing = *packing;
  }

  std::size_t size_of(const pugi::xml_node& piece, const char* name) const {
    const std::string_view text = piece.attribute(name).value();
    const auto size = parse_integer(text);
    if (!size || *size < 0 || *size > most_elements)
      fail("found " + in_quotes(text) + ", expected " + name + " of a piece");
    return static_cast<std::size_t>(*size);
  }

  void require_size(std::size_t found, std::size_t expected, const char* what) const {
    if (found != expected)
      fail("found " + std::to_string(found) + " " + what + ", expected " + std::to_string(expected));
  }

  void read_piece(const pugi::xml_node& piece) {
    const std::size_t points = size_of(piece, "NumberOfPoints");
    ++pieces_;
    const int first_point = static_cast<int>(soup_.points.size());
    if (points > 0) {
      const std::vector<double> x = read_reals(storage_, piece.child("Points").child("DataArray"));
      require_size(x.size(), 3 * points, "coordinates");
      for (std::size_t i = 0; i < points; ++i) {
        soup_.points.push_back({x[3 * i], x[3 * i + 1], x[3 * i + 2]});
        note(soup_.point_labels, static_cast<int>(soup_.points.size()) - 1, 0);
      }
    }
    note_arrays(piece.child("PointData"), "point array");
    if (is_polydata_) {
      read_polydata(piece, first_point);
      return;
    }
    const std::size_t cells = size_of(piece, "NumberOfCells");
    const std::vector<int> labels = read_labels(piece.child("CellData"), cells);
    if (cells == 0) return;
    const pugi::xml_node node = piece.child("Cells");
    const std::vector<int> types = array(node, "types");
    require_size(types.size(), cells, "types");
    read_cells(node, cells, first_point, labels, 0, [&types](std::size_t i) { return types[i]; });
  }

  struct PolyKind {
    const char* element;
    const char* count;
    int type;
  };

  /// Data count the cells in this order.
  void read_polydata(const pugi::xml_node& piece, int first_point) {
    constexpr std::array<PolyKind, 4> kinds{{{"Verts", "NumberOfVerts", 1},
                                             {"Lines", "NumberOfLines", 3},
                                             {"Strips", "NumberOfStrips", vtk_strip},
                                             {"Polys", "NumberOfPolys", vtk_polygon}}};
    // Strips are written before polygons, but counted after them.
    constexpr std::array<std::size_t, 4> order{0, 1, 3, 2};
    std::size_t all = 0;
    for (const PolyKind& kind : kinds)
      if (piece.attribute(kind.count)) all += size_of(piece, kind.count);
    const std::vector<int> labels = read_labels(piece.child("CellData"), all);
    std::size_t before = 0;
    for (const std::size_t k : order) {
      const PolyKind& kind = kinds[k];
      const std::size_t cells = piece.attribute(kind.count) ? size_of(piece, kind.count) : 0;
      if (cells == 0) continue;
      read_cells(piece.child(kind.element), cells, first_point, labels, before,
                 [&kind](std::size_t) { return kind.type; });
      before += cells;
    }
  }

  void note_arrays(const pugi::xml_node& data, const char* what) {
    for (const pugi::xml_node& array : data.children("DataArray"))
      soup_.passed_over.note(std::string(what) + " " + array.attribute("Name").value());
  }

  /// Of the arrays of integers whose names are those of labels, the best; none if there is none.
  std::vector<int> read_labels(const pugi::xml_node& data, std::size_t cells) {
    pugi::xml_node best;
    const auto rank = [](const pugi::xml_node& array) {
      const std::string_view type = array.attribute("type").value();
      const std::string_view components = array.attribute("NumberOfComponents").value();
      const bool fits = type.find("Int") != std::string_view::npos &&
                        (components.empty() || components == "1" || components == "0");
      return fits ? label_rank(array.attribute("Name").value()) : 0;
    };
    for (const pugi::xml_node& array : data.children())
      if (rank(array) > (best ? rank(best) : 0)) best = array;
    for (const pugi::xml_node& array : data.children())
      if (array != best) soup_.passed_over.note("cell array " + std::string(array.attribute("Name").value()));
    if (!best || cells == 0) return {};
    std::vector<int> labels = read_integers(storage_, best);
    require_size(labels.size(), cells, "labels");
    return labels;
  }

  std::vector<int> array(const pugi::xml_node& cells, const char* name) const {
    return read_integers(storage_, cells.find_child_by_attribute("DataArray", "Name", name));
  }

  /// The faces of cells, as VTK has them up to its version 9.3.
  struct Polyhedra {
    std::vector<int> faces;
    std::vector<std::pair<int, int>> range; ///< of each cell in `faces`
    std::span<const int> of(std::size_t cell) const {
      if (cell >= range.size()) return {};
      const auto [begin, end] = range[cell];
      return std::span(faces).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    }
  };
  Polyhedra read_polyhedra(const pugi::xml_node& node, std::size_t cells) const {
    Polyhedra found;
    if (!node.find_child_by_attribute("DataArray", "Name", "faceoffsets")) return found;
    found.faces = array(node, "faces");
    const std::vector<int> ends = array(node, "faceoffsets");
    require_size(ends.size(), cells, "offsets of faces");
    int last = 0;
    for (const int end : ends) { // -1: this cell is none
      if (end >= 0 && (end < last || static_cast<std::size_t>(end) > found.faces.size()))
        fail("found the offset of faces " + std::to_string(end) + ", expected " + std::to_string(last) +
             " to " + std::to_string(found.faces.size()));
      found.range.emplace_back(last, end < 0 ? last : end);
      last = found.range.back().second;
    }
    return found;
  }

  /// `labels` begin at the place `before`.
  template <class TypeOf>
  void read_cells(const pugi::xml_node& node, std::size_t cells, int first_point,
                  const std::vector<int>& labels, std::size_t before, TypeOf type_of) {
    const Polyhedra polyhedra = read_polyhedra(node, cells);
    const std::size_t all_points = soup_.points.size(); // polyhedra may add some
    const std::vector<int> ends = array(node, "offsets");
    std::vector<int> points = array(node, "connectivity");
    require_size(ends.size(), cells, "offsets");
    for (int& p : points) {
      if (p > most_elements - first_point)
        fail("found the point " + std::to_string(p) + ", which does not exist");
      p += first_point;
    }
    int start = 0;
    for (std::size_t i = 0; i < cells; ++i) {
      if (ends[i] < start || static_cast<std::size_t>(ends[i]) > points.size())
        fail("found the offset " + std::to_string(ends[i]) + ", expected " + std::to_string(start) + " to " +
             std::to_string(points.size()));
      const auto corners = std::span<const int>(points).subspan(static_cast<std::size_t>(start),
                                                                static_cast<std::size_t>(ends[i] - start));
      const int label = labels.empty() ? 0 : labels[before + i];
      const CellName name{number_++, 0, label};
      if (type_of(i) == vtk_polyhedron)
        add_vtk_polyhedron(cells_, polyhedra.of(i), first_point, all_points, name, {soup_.source, 0});
      else
        add_vtk_cell(cells_, soup_.passed_over, type_of(i), corners, name, {soup_.source, 0});
      start = ends[i];
    }
  }

  Parts parts_;
  VtuStorage storage_;
  Soup soup_;
  Cells cells_{soup_};
  int number_ = 0; ///< of cells in all pieces so far
  int pieces_ = 0;
  bool is_polydata_ = false;
};

void append_array(std::string& out, const char* type, const char* name, std::string_view numbers) {
  out += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"ascii\">\n";
  out += numbers;
  out += "</DataArray>\n";
}

void append_labels(std::string& out, const Soup& soup) {
  if (soup.triangle_tags.empty() && soup.tetrahedron_tags.empty()) return;
  std::string labels;
  const auto append = [&labels](std::size_t count, const std::vector<int>& tags) {
    for (std::size_t i = 0; i < count; ++i) {
      append_number(labels, tags.empty() ? 0 : tags[i]);
      labels += '\n';
    }
  };
  append(soup.triangles.size(), soup.triangle_tags);
  append(soup.tetrahedra.size(), soup.tetrahedron_tags);
  out += std::string("<CellData Scalars=\"") + label_name + "\">\n";
  append_array(out, "Int32", label_name, labels);
  out += "</CellData>\n";
}

} // namespace

Soup read_vtu(std::string_view text, const std::string& source) {
  return VtuReader(text, source).read();
}

std::string write_vtu(const Soup& soup) {
  const std::size_t triangles = soup.triangles.size();
  const std::size_t tetrahedra = soup.tetrahedra.size();
  std::string out = "<?xml version=\"1.0\"?>\n"
                    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                    "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                    std::to_string(soup.points.size()) + "\" NumberOfCells=\"" +
                    std::to_string(triangles + tetrahedra) + "\">\n<Points>\n" +
                    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const auto& p : soup.points) append_line(out, p, "\n");
  out += "</DataArray>\n</Points>\n<Cells>\n";
  std::string connectivity;
  std::string offsets;
  std::string types;
  for (const auto& corners : soup.triangles) append_line(connectivity, corners, "\n", 0);
  for (const auto& corners : soup.tetrahedra) append_line(connectivity, corners, "\n", 0);
  for (std::size_t i = 1; i <= triangles + tetrahedra; ++i) {
    append_number(offsets, i <= triangles ? 3 * i : 3 * triangles + 4 * (i - triangles));
    offsets += '\n';
    types += i <= triangles ? "5\n" : "10\n";
  }
  append_array(out, "Int32", "connectivity", connectivity);
  append_array(out, "Int64", "offsets", offsets);
  append_array(out, "UInt8", "types", types);
  out += "</Cells>\n";
  append_labels(out, soup);
  return out + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace tetrarch::format
