// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/medit.hpp"

#include "mesh_cursor.hpp"
#include "mesh_text.hpp"

#include "tetrarch/core/error.hpp"

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
    drop_empty_tags(soup_);
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
      read_elements(soup_.triangles, soup_.triangle_labels, "triangles", &soup_.triangle_tags);
    } else if (keyword == "Tetrahedra") {
      read_elements(soup_.tetrahedra, soup_.tetrahedron_labels, "tetrahedra", nullptr);
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

  /// References are written to `tags`, if there is such a list.
  template <std::size_t corners>
  void read_elements(std::vector<std::array<int, corners>>& elements, Labels& labels, const std::string& what,
                     std::vector<int>* tags) {
    const std::int64_t count = read_count(elements.size(), what);
    elements.reserve(in_.believable(count, shortest_line));
    for (std::int64_t i = 1; i <= count; ++i) {
      elements.push_back(read_corners<corners>(in_, soup_.first_number));
      note(labels, static_cast<int>(i), in_.line());
      const std::int64_t reference =
          in_.integer("a reference", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
      if (tags != nullptr) tags->push_back(static_cast<int>(reference));
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
  const auto section = [&](const char* keyword, const auto& elements, const std::vector<int>& tags) {
    if (elements.empty()) return;
    out += keyword + std::to_string(elements.size()) + "\n";
    for (std::size_t i = 0; i < elements.size(); ++i)
      append_line(out, elements[i], " " + std::to_string(tags.empty() ? 0 : tags[i]) + "\n", 1);
  };
  section("Triangles\n", soup.triangles, soup.triangle_tags);
  section("Tetrahedra\n", soup.tetrahedra, {});
  return out + "End\n";
}

std::string write_medit_hexahedra(const std::vector<std::array<double, 3>>& points,
                                  const std::vector<std::array<int, 8>>& hexahedra,
                                  const std::vector<int>& references) {
  if (!references.empty() && references.size() != hexahedra.size())
    throw PreconditionError("write_medit_hexahedra: references and hexahedra differ in number");
  std::string out = "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(points.size()) + "\n";
  for (const auto& p : points) append_line(out, p, " 0\n");
  out += "Hexahedra\n" + std::to_string(hexahedra.size()) + "\n";
  for (std::size_t k = 0; k < hexahedra.size(); ++k) {
    for (const int v : hexahedra[k])
      if (v < 0 || static_cast<std::size_t>(v) >= points.size())
        throw PreconditionError("write_medit_hexahedra: hexahedron " + std::to_string(k) + " names vertex " +
                                std::to_string(v) + " of " + std::to_string(points.size()));
    const int reference = references.empty() ? 0 : references[k];
    append_line(out, hexahedra[k], " " + std::to_string(reference) + "\n", 1);
  }
  return out + "End\n";
}

} // namespace tetrarch::format
