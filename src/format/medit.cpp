// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/medit.hpp"

#include "medit_sections.hpp"
#include "mesh_cursor.hpp"
#include "mesh_text.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace tetrarch::format {
namespace {

/// "0 0 0" and an end of line are as short as a vertex can be.
constexpr std::size_t shortest_medit_line = 6;

constexpr std::string_view header = "MeshVersionFormatted";

bool is_word(std::string_view token) {
  const char c = token.empty() ? '\0' : token.front();
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Numbers as text.
class TextNumbers {
public:
  explicit TextNumbers(MeshCursor& in) : in_(in) {}
  std::int64_t integer(std::string_view expected, std::int64_t least, std::int64_t greatest) {
    return in_.integer(expected, least, greatest);
  }
  double real(std::string_view expected) { return in_.number(expected); }
  int reference() { return in_.reference("a reference"); }
  std::size_t believable(std::int64_t announced) const {
    return in_.believable(announced, shortest_medit_line);
  }

private:
  MeshCursor& in_;
};

Soup read_text(std::string_view text, const std::string& source) {
  MeshCursor in(text, source, '#');
  TextNumbers numbers(in);
  MeditSections<TextNumbers> sections(in, numbers);
  if (in.token(header) != header) in.fail("", header);
  in.integer("a version", 1, 4);
  while (!in.at_end()) {
    const std::string keyword(in.token("a keyword"));
    if (!is_word(keyword)) in.fail(keyword, "a keyword, like Tetrahedra");
    if (keyword == "End") break;
    if (sections.read(keyword)) continue;
    if (const auto count = lenient_integer(in.peek()); count && *count >= 0)
      sections.pass_over(keyword, *count);
    while (!in.at_end() && !is_word(in.peek())) in.token("");
  }
  return std::move(sections).soup();
}

/// Numbers as bytes, in either order; the version says how many bytes they take.
class BinaryNumbers {
public:
  explicit BinaryNumbers(MeshCursor& in) : in_(in) {
    constexpr std::string_view expected = "the integer 1 in 4 bytes";
    const std::string_view one = in.bytes(sizeof(std::int32_t), expected);
    swapped_ = load<std::int32_t>(one.data(), false) != 1;
    if (load<std::int32_t>(one.data(), swapped_) != 1) in.fail("another number", expected);
    version_ = static_cast<int>(raw<std::int32_t>("a version"));
    if (version_ < 1 || version_ > 4) in.fail(std::to_string(version_), "a version, 1 to 4");
  }

  /// A keyword's code, which has 4 bytes in all versions.
  int code() { return raw<std::int32_t>("a keyword"); }
  std::uint64_t position() {
    return version_ >= 3 ? static_cast<std::uint64_t>(raw<std::int64_t>("the place of the next keyword"))
                         : raw<std::uint32_t>("the place of the next keyword");
  }
  std::int64_t integer(std::string_view expected, std::int64_t least, std::int64_t greatest) {
    const std::int64_t value = version_ >= 4 ? raw<std::int64_t>(expected) : raw<std::int32_t>(expected);
    if (value < least || value > greatest) in_.fail(std::to_string(value), expected);
    return value;
  }
  double real(std::string_view expected) {
    return version_ >= 2 ? raw<double>(expected) : static_cast<double>(raw<float>(expected));
  }
  int reference() {
    const std::int64_t value =
        version_ >= 4 ? raw<std::int64_t>("a reference") : raw<std::int32_t>("a reference");
    const bool fits = value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
    return fits ? static_cast<int>(value) : 0;
  }
  std::size_t believable(std::int64_t announced) const { return in_.believable(announced, 4); }

private:
  template <class T>
  T raw(std::string_view expected) {
    return load<T>(in_.bytes(sizeof(T), expected).data(), swapped_);
  }

  MeshCursor& in_;
  bool swapped_ = false;
  int version_ = 2;
};

/// The numbers that the binary form gives keywords, after libMeshb's table.
struct Code {
  int code;
  std::string_view keyword;
};
constexpr std::array<Code, 23> codes{{{3, "Dimension"},
                                      {4, "Vertices"},
                                      {5, "Edges"},
                                      {6, "Triangles"},
                                      {7, "Quadrilaterals"},
                                      {8, "Tetrahedra"},
                                      {9, "Prisms"},
                                      {10, "Hexahedra"},
                                      {13, "Corners"},
                                      {14, "Ridges"},
                                      {15, "RequiredVertices"},
                                      {16, "RequiredEdges"},
                                      {17, "RequiredTriangles"},
                                      {24, "TrianglesP2"},
                                      {25, "EdgesP2"},
                                      {27, "QuadrilateralsQ2"},
                                      {30, "TetrahedraP2"},
                                      {33, "HexahedraQ2"},
                                      {49, "Pyramids"},
                                      {54, "End"},
                                      {60, "Normals"},
                                      {86, "PrismsP2"},
                                      {87, "PyramidsP2"}}};

std::string keyword_of(int code) {
  for (const Code& row : codes)
    if (row.code == code) return std::string(row.keyword);
  return "keyword " + std::to_string(code);
}

Soup read_meshb_text(std::string_view text, const std::string& source) {
  MeshCursor in(text, source);
  BinaryNumbers numbers(in);
  MeditSections<BinaryNumbers> sections(in, numbers);
  while (in.bytes_left() > 0) {
    const std::string keyword = keyword_of(numbers.code());
    if (keyword == "End") break;
    const std::uint64_t next = numbers.position();
    const std::uint64_t here = text.size() - in.bytes_left();
    if (next != 0 && (next < here || next > text.size()))
      in.fail(std::to_string(next), "a place of the next keyword in the file and after this one");
    if (!sections.read(keyword)) sections.pass_over(keyword, 1);
    const std::uint64_t done = text.size() - in.bytes_left();
    if (next == 0) break;
    if (done > next) in.fail("data of " + keyword + " that are too long", "the next keyword before them");
    in.bytes(next - done, "the next keyword");
  }
  return std::move(sections).soup();
}

} // namespace

bool is_binary_medit(std::string_view text) {
  if (text.size() < 8) return false;
  for (const bool swapped : {false, true}) {
    const auto version = load<std::int32_t>(text.data() + 4, swapped);
    if (load<std::int32_t>(text.data(), swapped) == 1 && version >= 1 && version <= 4) return true;
  }
  return false;
}

Soup read_medit(std::string_view text, const std::string& source) {
  return is_binary_medit(text) ? read_meshb_text(text, source) : read_text(text, source);
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
  section("Tetrahedra\n", soup.tetrahedra, soup.tetrahedron_tags);
  return out + "End\n";
}

namespace {

template <class T>
void append_bytes(std::string& out, T value) {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(T));
  out.append(bytes.data(), bytes.size());
}

constexpr std::size_t integer_size = sizeof(std::int32_t);
/// Positions of 4 bytes are read as signed by some programs.
constexpr std::size_t longest_version_2 = std::numeric_limits<std::int32_t>::max();

/// Writes sections, each of which says where the next begins.
class BinarySections {
public:
  explicit BinarySections(std::size_t size) {
    wide_ = size > longest_version_2;
    out_.reserve(size);
    append_bytes<std::int32_t>(out_, 1);
    append_bytes<std::int32_t>(out_, wide_ ? 3 : 2);
  }
  /// `data` bytes will follow.
  void begin(std::string_view keyword, std::size_t data) {
    const auto row =
        std::find_if(codes.begin(), codes.end(), [&](const Code& c) { return c.keyword == keyword; });
    append_bytes<std::int32_t>(out_, row->code);
    const std::size_t next = keyword == "End" ? 0 : out_.size() + (wide_ ? 2 : 1) * integer_size + data;
    if (wide_)
      append_bytes(out_, static_cast<std::int64_t>(next));
    else
      append_bytes(out_, static_cast<std::int32_t>(next));
  }
  void integer(std::size_t value) { append_bytes(out_, static_cast<std::int32_t>(value)); }
  void reference(int value) { append_bytes<std::int32_t>(out_, value); }
  void real(double value) { append_bytes(out_, value); }
  std::string text() && { return std::move(out_); }

private:
  std::string out_;
  bool wide_ = false;
};

} // namespace

std::string write_meshb(const Soup& soup) {
  const std::size_t vertex_size = 3 * sizeof(double) + integer_size;
  constexpr std::size_t heads = 200; // bytes that all sections' heads have room in
  BinarySections out(heads + soup.points.size() * vertex_size +
                     (4 * soup.triangles.size() + 5 * soup.tetrahedra.size()) * integer_size);
  out.begin("Dimension", integer_size);
  out.integer(3);
  out.begin("Vertices", integer_size + soup.points.size() * vertex_size);
  out.integer(soup.points.size());
  for (const auto& p : soup.points) {
    for (const double x : p) out.real(x);
    out.reference(0);
  }
  const auto section = [&](const char* keyword, const auto& elements, const std::vector<int>& tags) {
    if (elements.empty()) return;
    out.begin(keyword, (1 + elements.size() * (elements.front().size() + 1)) * integer_size);
    out.integer(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      for (const int v : elements[i]) out.integer(static_cast<std::size_t>(v) + 1);
      out.reference(tags.empty() ? 0 : tags[i]);
    }
  };
  section("Triangles", soup.triangles, soup.triangle_tags);
  section("Tetrahedra", soup.tetrahedra, soup.tetrahedron_tags);
  out.begin("End", 0);
  return std::move(out).text();
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
