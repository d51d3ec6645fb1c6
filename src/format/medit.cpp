// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/medit.hpp"

#include "mesh_cursor.hpp"
#include "mesh_text.hpp"

namespace tetrarch::format {
namespace {

/// "0 0 0 0" and an end of line are as short as a vertex can be.
constexpr std::size_t shortest_line = 8;

bool is_word(std::string_view token) {
  const char c = token.empty() ? '\0' : token.front();
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

class MeditReader {
public:
  MeditReader(std::string_view text, const std::string& source) : in_(text, source, '#') {
    soup_.source = source;
    soup_.first_number = 1;
  }

  Soup read() && {
    if (in_.token(header) != header) in_.fail("", header);
    in_.integer("a version", 1, 4);
    while (!in_.at_end()) {
      const std::string_view keyword = in_.token("a keyword");
      if (!is_word(keyword)) in_.fail(keyword, "a keyword, like Tetrahedra");
      if (keyword == "End") break;
      read_section(keyword);
    }
    return std::move(soup_);
  }

  static constexpr std::string_view header = "MeshVersionFormatted";

private:
  void read_section(std::string_view keyword) {
    if (keyword == "Dimension") {
      in_.integer("dimension 3", 3, 3);
    } else if (keyword == "Vertices") {
      read_vertices();
    } else if (keyword == "Triangles") {
      read_elements(soup_.triangles, soup_.triangle_labels, "triangles");
    } else if (keyword == "Tetrahedra") {
      read_elements(soup_.tetrahedra, soup_.tetrahedron_labels, "tetrahedra");
    } else {
      pass_over(keyword);
    }
  }

  std::int64_t read_count(std::size_t so_far, const std::string& what) {
    if (so_far > 0) in_.fail(what, "only one list of " + what);
    return in_.integer("the number of " + what, 0, most_elements);
  }

  void read_vertices() {
    const std::int64_t count = read_count(soup_.points.size(), "vertices");
    soup_.points.reserve(in_.believable(count, shortest_line));
    for (std::int64_t i = 1; i <= count; ++i) {
      soup_.points.push_back(in_.point());
      note(soup_.point_labels, static_cast<int>(i), in_.line());
      in_.number("a reference");
    }
  }

  template <std::size_t corners>
  void read_elements(std::vector<std::array<int, corners>>& elements, Labels& labels,
                     const std::string& what) {
    const std::int64_t count = read_count(elements.size(), what);
    elements.reserve(in_.believable(count, shortest_line));
    for (std::int64_t i = 1; i <= count; ++i) {
      elements.push_back(read_corners<corners>(in_, soup_.first_number));
      note(labels, static_cast<int>(i), in_.line());
      in_.integer("a reference", std::numeric_limits<std::int64_t>::min(),
                  std::numeric_limits<std::int64_t>::max());
    }
  }

  void pass_over(std::string_view keyword) {
    const bool empty = in_.peek() == "0";
    const bool is_volume = keyword == "Hexahedra" || keyword == "Prisms" || keyword == "Pyramids" ||
                           keyword == "TetrahedraP2" || keyword == "Hexaedra";
    if (is_volume && !empty) in_.fail(keyword, "tetrahedra alone");
    if (keyword == "Quadrilaterals" && !empty)
      soup_.warnings.emplace_back("the quadrilaterals were passed over");
    while (!in_.at_end() && !is_word(in_.peek())) in_.token("");
  }

  MeshCursor in_;
  Soup soup_;
};

} // namespace

Soup read_medit(std::string_view text, const std::string& source) {
  return MeditReader(text, source).read();
}

std::string write_medit(const Soup& soup) {
  std::string out = "MeshVersionFormatted 2\nDimension 3\nVertices\n";
  out += std::to_string(soup.points.size()) + "\n";
  for (const auto& p : soup.points) append_line(out, p, " 0\n");
  const auto section = [&](const char* keyword, const auto& elements) {
    if (elements.empty()) return;
    out += keyword + std::to_string(elements.size()) + "\n";
    for (const auto& corners : elements) append_line(out, corners, " 0\n", 1);
  };
  section("Triangles\n", soup.triangles);
  section("Tetrahedra\n", soup.tetrahedra);
  return out + "End\n";
}

} // namespace tetrarch::format
