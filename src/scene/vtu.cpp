// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"
#include "writers.hpp"

#include "tetrarch/core/error.hpp"

#include <functional>
#include <limits>

namespace tetrarch::scene {
namespace {

// VTK's numbers of the types of cells.
constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_polyline = 4;
constexpr std::uint8_t vtk_tetrahedron = 10;
constexpr std::uint8_t vtk_hexahedron = 12;

/// A DataArray: what is said of it in the text, and how its numbers are appended.
struct Array {
  const char* section;
  std::string attributes;
  std::size_t bytes;
  std::function<void(std::string&)> append;
};

/// Calls `visit(type, corners)` for every cell of an element.
template <class Visit>
void for_each_cell(const Surface& surface, Visit visit) {
  for (const auto& corners : surface.triangles) visit(vtk_triangle, corners);
}
template <class Visit>
void for_each_cell(const Tubes& tubes, Visit visit) {
  std::vector<int> corners;
  for (std::size_t k = 0; k < part_count(tubes); ++k) {
    corners.clear();
    for (int p = tubes.starts[k]; p < tubes.starts[k + 1]; ++p) corners.push_back(p);
    visit(vtk_polyline, corners);
  }
}
template <class Visit>
void for_each_cell(const Cells& cells, Visit visit) {
  for (const auto& corners : cells.tetrahedra) visit(vtk_tetrahedron, corners);
  for (const auto& corners : cells.hexahedra) visit(vtk_hexahedron, corners);
}

const std::vector<double>& radii_of(const Tubes& tubes) {
  return tubes.radii;
}
template <class Element>
std::vector<double> radii_of(const Element&) {
  return {};
}
template <class Element>
const auto& textures_of(const Element& element) {
  return element.textures;
}
std::vector<std::array<double, 2>> textures_of(const Tubes&) {
  return {};
}

class VtuWriter {
public:
  explicit VtuWriter(const Scene& scene) : scene_(scene) {
    count();
    declare_point_data();
    declare_fields("PointData", FieldOn::points, points_);
    for (const std::string& name : data_names(scene)) declare_data(name);
    declare_fields("CellData", FieldOn::cells, cells_);
    declare_element();
    declare_geometry();
  }

  std::string write() const {
    std::string out = text();
    std::size_t bytes = out.size() + tail.size();
    for (const Array& array : arrays_) bytes += sizeof(std::uint64_t) + array.bytes;
    out.reserve(bytes);
    for (const Array& array : arrays_) {
      append_little(out, static_cast<std::uint64_t>(array.bytes));
      array.append(out);
    }
    out += tail;
    return out;
  }

private:
  static constexpr std::string_view tail = "\n</AppendedData>\n</VTKFile>\n";

  void count() {
    for_each_element(scene_, [&](const auto& element) {
      points_ += element.points.size();
      cells_ += part_count(element);
      for_each_cell(element, [&](std::uint8_t, const auto& corners) { corners_ += corners.size(); });
      with_radii_ = with_radii_ || !radii_of(element).empty();
      with_textures_ = with_textures_ || !textures_of(element).empty();
    });
    if (points_ > std::numeric_limits<int>::max()) throw PreconditionError("VTU holds fewer points");
  }

  /// `append(out, element)` appends the numbers of one element.
  template <class Append>
  void declare(const char* section, const char* type, const std::string& name, std::size_t components,
               std::size_t bytes, Append append) {
    std::string attributes = std::string("type=\"") + type + "\" Name=\"" + name + "\"";
    if (components > 1) attributes += " NumberOfComponents=\"" + std::to_string(components) + "\"";
    arrays_.push_back({section, std::move(attributes), bytes, [this, append](std::string& out) {
                         Append fresh = append; // it may count as it goes
                         for_each_element(scene_, [&](const auto& element) { fresh(out, element); });
                       }});
  }

  void declare_point_data() {
    if (with_radii_)
      declare("PointData", "Float64", "radius", 1, 8 * points_, [](std::string& out, const auto& element) {
        const auto& radii = radii_of(element);
        for (std::size_t p = 0; p < element.points.size(); ++p)
          append_little(out, radii.empty() ? 0.0 : radii[p]);
      });
    if (with_textures_)
      declare("PointData", "Float64", "texture", 3, 24 * points_, [](std::string& out, const auto& element) {
        const auto& textures = textures_of(element);
        for (std::size_t p = 0; p < element.points.size(); ++p)
          for (std::size_t i = 0; i < 3; ++i)
            append_little(out, textures.empty() || i >= textures[p].size() ? 0.0 : textures[p][i]);
      });
  }

  void declare_data(const std::string& name) {
    declare("CellData", "Int32", name, 1, 4 * cells_, [name](std::string& out, const auto& element) {
      const auto* values = columns_of(element.data, {name}).front();
      for (std::size_t k = 0; k < part_count(element); ++k)
        append_little(out, values ? (*values)[k] : no_value);
    });
  }

  void declare_fields(const char* section, FieldOn on, std::size_t count) {
    for (const std::string& name : field_names(scene_, on))
      declare(section, "Float64", name, 1, 8 * count, [name, on](std::string& out, const auto& element) {
        const auto* values = columns_of(fields_of(element, on), {name}).front();
        const std::size_t length = on == FieldOn::points ? element.points.size() : part_count(element);
        for (std::size_t k = 0; k < length; ++k) append_little(out, values ? (*values)[k] : no_number);
      });
  }

  void declare_element() {
    declare("CellData", "Int32", "element", 1, 4 * cells_,
            [number = 0](std::string& out, const auto& element) mutable {
              for (std::size_t k = 0; k < part_count(element); ++k) append_little(out, number);
              ++number;
            });
  }

  void declare_geometry() {
    declare("Points", "Float64", "points", 3, 24 * points_, [](std::string& out, const auto& element) {
      for (const Point& point : element.points)
        for (const double x : point) append_little(out, x);
    });
    declare("Cells", "Int32", "connectivity", 1, 4 * corners_,
            [first = 0](std::string& out, const auto& element) mutable {
              for_each_cell(element, [&](std::uint8_t, const auto& corners) {
                for (const int corner : corners) append_little(out, corner + first);
              });
              first += static_cast<int>(element.points.size());
            });
    declare("Cells", "Int64", "offsets", 1, 8 * cells_,
            [end = std::int64_t{0}](std::string& out, const auto& element) mutable {
              for_each_cell(element, [&](std::uint8_t, const auto& corners) {
                end += static_cast<std::int64_t>(corners.size());
                append_little(out, end);
              });
            });
    declare("Cells", "UInt8", "types", 1, cells_, [](std::string& out, const auto& element) {
      for_each_cell(element, [&](std::uint8_t type, const auto&) { append_little(out, type); });
    });
  }

  /// Everything before the first byte of the appended data.
  std::string text() const {
    std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                      "<Piece NumberOfPoints=\"" +
                      std::to_string(points_) + "\" NumberOfCells=\"" + std::to_string(cells_) + "\">\n";
    std::size_t offset = 0;
    for (std::size_t i = 0; i < arrays_.size(); ++i) {
      const std::string section = arrays_[i].section;
      if (i == 0 || section != arrays_[i - 1].section) out += "<" + section + ">\n";
      out += "<DataArray " + arrays_[i].attributes + " format=\"appended\" offset=\"" +
             std::to_string(offset) + "\"/>\n";
      if (i + 1 == arrays_.size() || section != arrays_[i + 1].section) out += "</" + section + ">\n";
      offset += sizeof(std::uint64_t) + arrays_[i].bytes;
    }
    return out + "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  }

  const Scene& scene_;
  std::size_t points_ = 0;
  std::size_t cells_ = 0;
  std::size_t corners_ = 0;
  bool with_radii_ = false;
  bool with_textures_ = false;
  std::vector<Array> arrays_;
};

} // namespace

std::string write_vtu(const Scene& scene) {
  return VtuWriter(scene).write();
}

} // namespace tetrarch::scene
