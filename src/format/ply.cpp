// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"
#include "mesh_text.hpp"

#include "tetrarch/format/surface_files.hpp"

#include <map>
#include <optional>

namespace tetrarch::format {
namespace {

enum class Scalar : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

const std::map<std::string_view, Scalar> scalar_names{
    {"char", Scalar::int8},      {"int8", Scalar::int8},       {"uchar", Scalar::uint8},
    {"uint8", Scalar::uint8},    {"short", Scalar::int16},     {"int16", Scalar::int16},
    {"ushort", Scalar::uint16},  {"uint16", Scalar::uint16},   {"int", Scalar::int32},
    {"int32", Scalar::int32},    {"uint", Scalar::uint32},     {"uint32", Scalar::uint32},
    {"float", Scalar::float32},  {"float32", Scalar::float32}, {"double", Scalar::float64},
    {"float64", Scalar::float64}};

struct Property {
  std::string name;
  Scalar type = Scalar::float32;
  std::optional<Scalar> count; ///< the type of the length, of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
public:
  PlyReader(std::string_view text, const std::string& source) : in_(text, source) { soup_.source = source; }

  Soup read() && {
    read_header();
    for (const PlyElement& element : elements_) {
      if (!is_vertex(element) && !is_face(element) && !is_strip(element))
        soup_.passed_over.note("element " + element.name, element.count);
      if (element.properties.empty()) continue;
      for (std::int64_t i = 0; i < element.count; ++i) read_one(element, static_cast<int>(i));
      if (element.count > 0) note_properties(element);
    }
    cells_.finish();
    return std::move(soup_);
  }

private:
  void read_header() {
    if (in_.token("ply") != "ply") in_.fail("another first word", "ply");
    for (;;) {
      const std::string_view keyword = in_.token("end_header");
      if (keyword == "format") {
        read_format();
      } else if (keyword == "element") {
        const std::string name(in_.token("a name"));
        elements_.push_back({name, in_.integer("how many there are", 0, most_elements), {}});
      } else if (keyword == "property") {
        if (elements_.empty()) in_.fail(keyword, "element");
        elements_.back().properties.push_back(read_property());
      } else if (keyword != "comment" && keyword != "obj_info" && keyword != "end_header") {
        in_.fail(keyword, "element, property or end_header");
      }
      in_.rest_of_line();
      if (keyword == "end_header") return;
    }
  }

  void read_format() {
    const std::string_view form = in_.token("a form");
    binary_ = form != "ascii";
    if (form == "binary_big_endian") {
      swapped_ = swapped_if(std::endian::big);
    } else if (form == "binary_little_endian") {
      swapped_ = swapped_if(std::endian::little);
    } else if (binary_) {
      in_.fail(form, "ascii, binary_little_endian or binary_big_endian");
    }
  }

  Scalar scalar(std::string_view name) {
    const auto found = scalar_names.find(name);
    if (found == scalar_names.end()) in_.fail(name, "a type of numbers, like float");
    return found->second;
  }

  Property read_property() {
    Property property;
    std::string_view type = in_.token("a type");
    if (type == "list") {
      property.count = scalar(in_.token("the type of a length"));
      type = in_.token("a type");
    }
    property.type = scalar(type);
    property.name = in_.token("a name");
    return property;
  }

  static bool is_vertex(const PlyElement& element) { return element.name == "vertex"; }
  static bool is_face(const PlyElement& element) { return element.name == "face"; }
  static bool is_strip(const PlyElement& element) { return element.name == "tristrips"; }
  static bool lists_vertices(const Property& property) {
    return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
  }
  static bool is_coordinate(const Property& property) {
    return !property.count && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
  }

  /// Those of vertices and faces that nobody reads.
  void note_properties(const PlyElement& element) {
    for (const Property& property : element.properties)
      if ((is_vertex(element) && !is_coordinate(property)) || (is_face(element) && !lists_vertices(property)))
        soup_.passed_over.note("property " + property.name + " of a " + element.name, element.count);
  }

  void read_one(const PlyElement& element, int number) {
    std::array<double, 3> point{};
    for (const Property& property : element.properties) {
      if (lists_vertices(property) && (is_face(element) || is_strip(element))) {
        read_list(property, is_strip(element), number);
      } else if (property.count) {
        for (std::int64_t n = whole(*property.count, "a length", 0); n > 0; --n) value(property.type);
      } else {
        const double x = value(property.type);
        if (is_coordinate(property)) point[static_cast<std::size_t>(property.name[0] - 'x')] = x;
      }
    }
    if (!is_vertex(element)) return;
    soup_.points.push_back(point);
    note(soup_.point_labels, number, in_.line());
  }

  void read_list(const Property& property, bool is_strip, int number) {
    const std::int64_t count = whole(*property.count, "how many vertices follow", 0);
    corners_.clear();
    corners_.reserve(in_.believable(count, binary_ ? 1 : 2));
    for (std::int64_t k = 0; k < count; ++k)
      corners_.push_back(static_cast<int>(whole(property.type, "the number of a vertex", -most_elements)));
    if (is_strip) {
      cells_.add_strip(corners_, {number, in_.line(), 0});
    } else {
      cells_.add_polygon(corners_, {number, in_.line(), 0});
    }
  }

  std::int64_t whole(Scalar type, std::string_view expected, std::int64_t least) {
    const double x = value(type);
    const bool fits = x >= static_cast<double>(least) && x <= static_cast<double>(most_elements);
    if (!fits || x != static_cast<double>(static_cast<std::int64_t>(x))) in_.fail(to_text(x), expected);
    return static_cast<std::int64_t>(x);
  }

  /// Every type that PLY knows fits into a double.
  double value(Scalar type) {
    if (!binary_) return in_.number("a number");
    switch (type) {
    case Scalar::int8:
      return raw<std::int8_t>();
    case Scalar::uint8:
      return raw<std::uint8_t>();
    case Scalar::int16:
      return raw<std::int16_t>();
    case Scalar::uint16:
      return raw<std::uint16_t>();
    case Scalar::int32:
      return raw<std::int32_t>();
    case Scalar::uint32:
      return raw<std::uint32_t>();
    case Scalar::float32:
      return static_cast<double>(raw<float>());
    case Scalar::float64:
      return raw<double>();
    }
    throw PreconditionError("no such type of numbers");
  }
  template <class T>
  T raw() {
    return load<T>(in_.bytes(sizeof(T), "a number").data(), swapped_);
  }

  MeshCursor in_;
  Soup soup_;
  Cells cells_{soup_};
  std::vector<int> corners_;
  std::vector<PlyElement> elements_;
  bool binary_ = false;
  bool swapped_ = false;
};

} // namespace

Soup read_ply(std::string_view text, const std::string& source) {
  return PlyReader(text, source).read();
}

std::string write_ply(const Soup& soup) {
  std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(soup.points.size()) +
                    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                    std::to_string(soup.triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  append_surface(out, soup);
  return out;
}

} // namespace tetrarch::format
