// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"
#include "mesh_text.hpp"

#include "tetrarch/format/surface_files.hpp"

namespace tetrarch::format {
namespace {

constexpr bool off_swapped = swapped_if(std::endian::big);

/// What the first word says that points have besides their three coordinates, in this order: a normal, a
/// color, a place in a texture.
struct Extras {
  bool normal = false;
  bool color = false;
  bool texture = false;
  /// Of colors, the binary form has four numbers.
  int numbers() const { return (normal ? 3 : 0) + (color ? 4 : 0) + (texture ? 2 : 0); }
};

class OffReader {
public:
  OffReader(std::string_view text, const std::string& source) : in_(text, source, '#') {
    soup_.source = source;
  }

  Soup read() && {
    read_header();
    soup_.points.reserve(in_.believable(points_, 6));
    for (std::int64_t i = 0; i < points_; ++i) read_point(static_cast<int>(i));
    soup_.triangles.reserve(in_.believable(faces_, 8));
    for (std::int64_t i = 0; i < faces_; ++i) read_face(static_cast<int>(i));
    cells_.finish();
    return std::move(soup_);
  }

private:
  /// "OFF", "OFF 4 4 6", "OFF4 4 6", "NCOFF BINARY", "4 4 6" (Geomview lets the first word out), "nOFF 3".
  void read_header() {
    const std::string_view word = in_.token("OFF");
    const std::size_t at = word.find("OFF");
    std::string_view glued = word;
    if (at != std::string_view::npos) {
      read_extras(word, word.substr(0, at));
      glued = word.substr(at + 3);
    } else if (!lenient_integer(word)) {
      in_.fail(word, "OFF");
    }
    if (glued == "BINARY" || (glued.empty() && in_.peek() == "BINARY")) {
      if (glued.empty()) in_.token("");
      in_.rest_of_line();
      binary_ = true;
    }
    if (dimension_given_) integer("3, the dimension", 3, 3);
    points_ = glued.empty() || binary_ ? integer("the number of points", 0, most_elements)
                                       : glued_count(word, glued);
    faces_ = integer("the number of faces", 0, most_elements);
    // Some programs leave out the number of edges, which nobody needs.
    if (binary_ || in_.line_goes_on() || has_edges_below()) integer("the number of edges", 0, most_elements);
  }

  std::int64_t glued_count(std::string_view word, std::string_view glued) {
    const auto count = lenient_integer(glued);
    if (!count || *count < 0 || *count > most_elements) in_.fail(word, "OFF");
    return *count;
  }

  /// Whether the next line holds one number alone, which is no point.
  bool has_edges_below() {
    MeshCursor ahead = in_;
    if (ahead.at_end()) return true; // which fails there, as it should
    ahead.token("");
    return !ahead.line_goes_on();
  }

  void read_extras(std::string_view word, std::string_view letters) {
    if (letters.starts_with("ST")) {
      extras_.texture = true;
      letters.remove_prefix(2);
    }
    for (const char c : letters) {
      if (c == 'N') {
        extras_.normal = true;
      } else if (c == 'C') {
        extras_.color = true;
      } else if (c == 'n') {
        dimension_given_ = true;
      } else {
        in_.fail(word, c == '4' ? "points of three dimensions" : "OFF");
      }
    }
  }

  std::int64_t integer(std::string_view expected, std::int64_t least, std::int64_t greatest) {
    if (!binary_) return in_.integer(expected, least, greatest);
    const std::int64_t value = load<std::int32_t>(in_.bytes(4, expected).data(), off_swapped);
    if (value < least || value > greatest) in_.fail(std::to_string(value), expected);
    return value;
  }

  void read_point(int number) {
    std::array<double, 3> p{};
    for (double& x : p)
      x = binary_ ? static_cast<double>(load<float>(in_.bytes(4, "a coordinate").data(), off_swapped))
                  : in_.number("a coordinate");
    note(soup_.point_labels, number, in_.line());
    soup_.points.push_back(p);
    if (binary_) {
      for (int k = 0; k < extras_.numbers(); ++k) in_.bytes(4, "a number of a point");
    } else {
      while (in_.line_goes_on()) in_.token("");
    }
    if (extras_.normal) soup_.passed_over.note("normal of a vertex");
    if (extras_.color) soup_.passed_over.note("color of a vertex");
    if (extras_.texture) soup_.passed_over.note("texture coordinate");
  }

  void read_face(int number) {
    const std::int64_t count = integer("the number of vertices of a face", 0, most_elements);
    const int line = in_.line();
    corners_.clear();
    corners_.reserve(in_.believable(count, 2));
    for (std::int64_t k = 0; k < count; ++k)
      corners_.push_back(
          static_cast<int>(integer("the number of a vertex", 1 - most_elements, most_elements)));
    cells_.add_polygon(corners_, {number, line, 0});
    bool colored = false;
    if (binary_) {
      const std::int64_t numbers = integer("how many numbers a color has", 0, most_elements);
      colored = numbers > 0;
      for (std::int64_t k = 0; k < numbers; ++k) in_.bytes(4, "a number of a color");
    } else {
      for (; in_.line_goes_on(); colored = true) in_.token("");
    }
    if (colored) soup_.passed_over.note("color of a face");
  }

  MeshCursor in_;
  Soup soup_;
  Cells cells_{soup_};
  Extras extras_;
  std::vector<int> corners_;
  std::int64_t points_ = 0;
  std::int64_t faces_ = 0;
  bool binary_ = false;
  bool dimension_given_ = false;
};

} // namespace

Soup read_off(std::string_view text, const std::string& source) {
  return OffReader(text, source).read();
}

std::string write_off(const Soup& soup) {
  std::string out =
      "OFF\n" + std::to_string(soup.points.size()) + " " + std::to_string(soup.triangles.size()) + " 0\n";
  append_surface(out, soup);
  return out;
}

} // namespace tetrarch::format
