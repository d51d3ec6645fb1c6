// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes as other programs write them. The counts are by hand: mostly one tetrahedron, and its boundary.
#include "expect.hpp"
#include "meshes.hpp"
#include "tetrarch/format/gmsh.hpp"
#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/surface_files.hpp"
#include "tetrarch/format/tetgen.hpp"
#include "tetrarch/format/vtk.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

using Triangles = std::vector<std::array<int, 3>>;
using Tetrahedra = std::vector<std::array<int, 4>>;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string in_capitals(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

/// The bytes of a number, the last one first if `big`.
template <class T>
std::string bytes(T value, bool big) {
  std::string raw(sizeof(T), '\0');
  std::memcpy(raw.data(), &value, sizeof(T));
  if (big == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
  return raw;
}

double volume(const Soup& soup) {
  double total = 0;
  for (const auto& t : soup.tetrahedra) {
    std::array<std::array<double, 3>, 3> e{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        e[k][axis] = soup.points.at(static_cast<std::size_t>(t[k + 1]))[axis] -
                     soup.points.at(static_cast<std::size_t>(t[0]))[axis];
    total += (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
              e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
              e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
             6;
  }
  return total;
}

/// Twice the area of a surface in the plane z = 0, counterclockwise counted positive; and that no triangle
/// is turned.
double doubled_area(const Soup& soup) {
  double total = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    const auto& p = soup.points.at(static_cast<std::size_t>(a));
    const auto& q = soup.points.at(static_cast<std::size_t>(b));
    const auto& r = soup.points.at(static_cast<std::size_t>(c));
    const double area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    CHECK(area >= 0);
    total += area;
  }
  return total;
}

std::string ledger(const Soup& soup) {
  return soup.passed_over.sentence();
}

const std::string medit_head = "MeshVersionFormatted 2\nDimension 3\n";
const std::string medit_points = "Vertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";

/// Eight points of the unit cube, bottom and top counterclockwise.
const std::string cube_points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";

} // namespace

TEST_CASE("a byte order mark is passed over in every text format", "[variants]") {
  for (const MeshFormat format : solid_formats) {
    INFO(name_of(format));
    CHECK(read_soup("\xEF\xBB\xBF" + write_soup(two_tetrahedra(), format), "f").tetrahedra.size() == 2);
  }
  for (const MeshFormat format : surface_formats) {
    INFO(name_of(format));
    CHECK(read_soup("\xEF\xBB\xBF" + write_soup(one_boundary(), format), "f").triangles.size() == 4);
  }
  TetgenFiles files = write_tetgen(two_tetrahedra());
  files.node = "\xEF\xBB\xBF" + files.node;
  files.ele = "\xEF\xBB\xBF" + files.ele;
  CHECK(read_tetgen(files).tetrahedra.size() == 2);
}

TEST_CASE("lines may end in all three ways, and errors still name them", "[variants]") {
  std::vector<MeshFormat> all = solid_formats;
  all.insert(all.end(), surface_formats.begin(), surface_formats.end());
  for (const MeshFormat format : all)
    for (const std::string end : {"\r\n", "\r"}) {
      INFO(name_of(format) << " " << end.size());
      const bool is_surface = format >= MeshFormat::obj;
      const std::string text = write_soup(is_surface ? one_boundary() : two_tetrahedra(), format);
      const Soup plain = read_soup(text, "f");
      const Soup other = read_soup(replaced(text, "\n", end), "f");
      CHECK(other.points == plain.points);
      CHECK(other.triangles == plain.triangles);
      CHECK(other.tetrahedra == plain.tetrahedra);
      CHECK(other.point_labels == plain.point_labels);
      CHECK(other.triangle_labels == plain.triangle_labels);
      CHECK(other.tetrahedron_labels == plain.tetrahedron_labels);
    }
  CHECK(error_of([] { read_obj("# one\rv 0 0 0\rv 1 x 0\r", "f"); }) ==
        "f:3: found 'x', expected a coordinate");
}

TEST_CASE("numbers as C, Fortran and others print them", "[variants]") {
  const auto x_of = [](const std::string& number) {
    return read_soup("OFF 1 0 0\n" + number + " 0 0\n", "f").points.at(0)[0];
  };
  CHECK(x_of("+1.0") == 1);
  CHECK(x_of("1.0D+00") == 1);
  CHECK(x_of("-2.5d-01") == -0.25);
  CHECK(x_of("+.5E0") == 0.5);
  CHECK(x_of("1e-400") == 0);
  CHECK(std::signbit(x_of("-1.0E-400")));
  CHECK(x_of("0." + std::string(400, '0') + "1") == 0);
  // Numbers that are none are read as such, and a mesh refuses them.
  const std::vector<std::pair<std::string, std::string>> not_finite{
      {"1e400", "inf"}, {"-1D400", "-inf"}, {"1.#INF", "inf"}, {"-1.#IND", "nan"}, {"nan", "nan"}};
  for (const auto& [number, value] : not_finite)
    CHECK(error_of([&, n = number] { x_of(n); }) ==
          "f:2: coordinate x of vertex 0 is " + value + ", expected a finite number");
  for (const std::string bad : {"1.0DD0", "++1", "+-1", "1,5", "D5", "0x10", "1e", "+"})
    CHECK(error_of([&] { x_of(bad); }) == "f:2: found '" + bad + "', expected a coordinate");
}

TEST_CASE("ASCII STL of several solids, in capitals, without end, with anything behind it", "[variants]") {
  const std::string one = write_stl(one_boundary());
  const std::string body = one.substr(one.find('\n') + 1);
  const std::string facets = body.substr(0, body.find("endsolid"));
  const auto counts = [](const std::string& text) {
    const Soup soup = read_soup(text, "f.stl");
    return std::pair(soup.points.size(), soup.triangles.size());
  };
  const std::pair<std::size_t, std::size_t> right{4, 4};
  CHECK(counts("SOLID X\n" + in_capitals(facets) + "ENDSOLID X\n") == right);
  CHECK(counts("solid\n" + facets) == right);
  CHECK(counts("solid a\n" + facets + "end solid a\n") == right);
  CHECK(counts("  solid a\n" + facets + "endsolid") == right);
  // The boundary in two halves: the labels say which.
  const std::size_t half = facets.find("facet", facets.find("endfacet", facets.find("endfacet") + 1) + 8);
  const std::string text =
      "solid a\n" + facets.substr(0, half) + "endsolid a\nsolid b\n" + facets.substr(half) + "endsolid b\n";
  CHECK(counts(text) == right);
  CHECK(read_soup(text, "f.stl").triangle_tags == std::vector<int>{0, 0, 1, 1});
  CHECK(read_soup(one + std::string(7, '\0'), "f.stl").triangles.size() == 4);
  CHECK(ledger(read_soup(one + "trailing", "f.stl")) == "passed over: byte after the facets (8)");
  CHECK(error_of([&] {
          read_soup("solid a\n" + facets + "facte", "f.stl");
        }).ends_with("found 'facte', expected facet, endsolid or solid"));
}

TEST_CASE("binary STL with bytes behind it, with a text for a head, cut off", "[variants]") {
  std::string text = "solid" + std::string(75, ' ') + bytes(std::uint32_t{4}, false);
  const Soup boundary = one_boundary();
  for (const auto& corners : boundary.triangles) {
    text += std::string(12, '\0');
    for (const int v : corners)
      for (const double x : boundary.points[static_cast<std::size_t>(v)])
        text += bytes(static_cast<float>(x), false);
    text += std::string("\x07\0", 2);
  }
  CHECK(read_soup(text, "f").triangles.size() == 4);
  CHECK(ledger(read_soup(text, "f")) == "passed over: attribute of a facet (4)");
  const Soup soup = read_soup(text + "0123456789", "f.stl");
  CHECK(soup.triangles.size() == 4);
  CHECK(ledger(soup) == "passed over: attribute of a facet (4), byte after the facets (10)");
  CHECK(error_of([&] { read_soup(text.substr(0, text.size() - 60), "f.stl"); }) ==
        "f.stl: the data end after 2 facets, expected 4");
}

TEST_CASE("PLY's triangle strips, with restarts, as text and bytes", "[variants]") {
  const std::string head = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                           "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const Soup soup =
      read_ply("ply\nformat ascii 1.0\n" + head + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n8 0 2 1 3 -1 0 3 2\n", "f");
  // Every other triangle is turned: 2 1 3 is written 1 2 3.
  CHECK(soup.triangles == Triangles{{0, 2, 1}, {1, 2, 3}, {0, 3, 2}});
  CHECK(ledger(soup) == "passed over: strip, cut into triangles (2)");
  std::string binary = "ply\nformat binary_big_endian 1.0\n" + head;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) binary += bytes(x, true);
  for (const std::int32_t n : {8, 0, 2, 1, 3, -1, 0, 3, 2}) binary += bytes(n, true);
  CHECK(read_ply(binary, "f").triangles == soup.triangles);
}

TEST_CASE("polygons are cut into triangles, concave ones too, and the ledger counts them", "[variants]") {
  // An L of area 3 whose reflex corner is the fourth of six, behind a triangle.
  const std::string l = "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
  const Soup soup = read_obj(l + "f 1 2 3\nf 4 5 6 7 8 9\nf 1 2 3\n", "f");
  CHECK(soup.triangles.size() == 6);
  CHECK(soup.triangles.front() == std::array<int, 3>{0, 1, 2});
  CHECK(soup.triangles.back() == std::array<int, 3>{0, 1, 2});
  CHECK(soup.triangle_labels.numbers[4] == 2);
  CHECK(soup.triangle_labels.lines[4] == 11);
  CHECK(doubled_area(soup) == Approx(6 + 2));
  CHECK(ledger(soup) == "passed over: polygon, cut into triangles");
  // The same from its other corners, and seen from behind.
  for (const std::string face : {"5 6 7 8 9 4", "7 8 9 4 5 6", "9 4 5 6 7 8"})
    CHECK(doubled_area(read_obj(l + "f " + face + "\n", "f")) == Approx(6));
  // A dart: the diagonal must start at its reflex corner, which is not the smallest.
  CHECK(doubled_area(read_off("OFF 4 1 0\n0 0 0\n2 -1 0\n1 0 0\n2 1 0\n4 0 1 2 3\n", "f")) == Approx(2));
  // A square with a vertex amid a side: no triangle is flat.
  const Soup five = read_off("OFF 5 1 0\n1 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 0\n5 0 1 2 3 4\n", "f");
  CHECK(five.triangles.size() == 3);
  for (const auto& corners : five.triangles) {
    Soup alone = five;
    alone.triangles = {corners};
    CHECK(doubled_area(alone) > 0);
  }
  // A comb of a thousand teeth: the area is that of the back and the teeth.
  std::string comb = "v 0 0 0\nv 1000 0 0\n";
  for (int tooth = 999; tooth >= 0; --tooth)
    comb += "v " + std::to_string(tooth + 1) + " 2 0\nv " + std::to_string(tooth + 0.5) + " 1 0\n";
  comb += "v 0 2 0\nf";
  for (int v = 1; v <= 2003; ++v) comb += " " + std::to_string(v);
  const Soup teeth = read_obj(comb + "\n", "f");
  CHECK(teeth.triangles.size() == 2001);
  CHECK(doubled_area(teeth) == Approx(2 * (1000 + 500)));
  // Faces of two corners are edges.
  CHECK(ledger(read_off("OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n", "f")) ==
        "passed over: face of fewer than three corners");
  // Not a number: as many triangles as ever.
  CHECK(read_off("OFF 5 1 0\nnan 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n5 0 1 2 3 4\n", "f").triangles.size() == 3);
}

TEST_CASE("OBJ's continued lines, groups, colors", "[variants]") {
  const std::string text =
      "v 0 0 0\nv 1 \\\n0 0\nv 0 1 0 0.5 0.5 0.5\nv 0 0 1\ng a\nvn 0 0 \\\n1\nf 1 3\\\r\n2\n"
      "f 1 2 \\  \n 4\nl 1 2 \\\n3\nf 1 4 3 # c\nf 2 3 4\n";
  const Soup soup = read_obj(text, "f.obj");
  CHECK(soup.triangles == Triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  CHECK(soup.triangle_labels.lines[3] == 16); // counted by hand: four lines are continued
  CHECK(ledger(soup) == "passed over: color of a vertex, name of a group, normal, line element");
  CHECK(error_of([&] { read_obj(text + "f 1 2 \\\n x\n", "f"); }) ==
        "f:18: found 'x', expected the number of a vertex");
}

TEST_CASE("OFF with a glued or missing head, without edges, binary, colored", "[variants]") {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  for (const std::string head : {"OFF4 4 6\n", "OFF 4 4 6\n", "OFF\n4 4\n", "OFF 4 4\n",
                                 "OFF\n# c\n4 4 6 # d\n", "OFF\n4\n4\n6\n", "nOFF 3\n4 4 6\n"}) {
    INFO(head);
    CHECK(read_soup(head + body, "f").triangles.size() == 4);
  }
  CHECK(read_soup("4 4 6\n" + body, "f.off").triangles.size() == 4);
  CHECK(error_of([&] { read_soup("4OFF 4 4 6\n" + body, "f"); }) ==
        "f:1: found '4OFF', expected points of three dimensions");
  // Each point has a normal of three numbers and a color of four.
  std::string binary = "CNOFF BINARY\n";
  for (const std::int32_t n : {4, 2, 5}) binary += bytes(n, true);
  for (const std::array<float, 2> p : {std::array<float, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    for (const float x : {p[0], p[1], 0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 0.0F, 0.0F, 1.0F})
      binary += bytes(x, true);
  for (const std::int32_t n : {4, 0, 1, 2, 3, 1}) binary += bytes(n, true);
  binary += bytes(0.5F, true);
  for (const std::int32_t n : {3, 0, 1, 2, 0}) binary += bytes(n, true);
  const Soup soup = read_soup(binary, "f");
  CHECK(soup.triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  CHECK(soup.points[2] == std::array<double, 3>{1, 1, 0});
  CHECK(ledger(soup) == "passed over: normal of a vertex (4), color of a vertex (4), quadrilateral, cut into "
                        "triangles, color of a face");
}

TEST_CASE("TetGen's and Triangle's files with short heads, in the plane, of second order", "[variants]") {
  const std::string points = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
  CHECK(read_tetgen({"4 3\n" + points, "1 4\n1 1 2 3 4\n", "n", "e"}).tetrahedra == Tetrahedra{{0, 1, 2, 3}});
  CHECK(read_tetgen({"4\n" + points, "1\n1 1 2 3 4\n", "n", "e"}).tetrahedra == Tetrahedra{{0, 1, 2, 3}});
  const Soup flat = read_tetgen(
      {"4 2 1 1\n1 0 0 7 1\n2 1 0 7 1\n3 1 1 7 1\n4 0 1 7 0\n", "2 3 1\n1 1 2 3 5\n2 1 3 4 6\n", "n", "e"});
  CHECK(flat.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(flat.triangle_tags == std::vector<int>{5, 6});
  CHECK(flat.points[2] == std::array<double, 3>{1, 1, 0});
  CHECK(ledger(flat) == "passed over: attribute of a point (4), marker of a point (3)");
  std::string ten = "10 3 0 0\n";
  for (int v = 1; v <= 10; ++v) ten += std::to_string(v) + " " + std::to_string(v) + " 0 0\n";
  const Soup linear = read_tetgen({ten, "1 10 0\n1 1 2 3 4 5 6 7 8 9 10\n", "n", "e"});
  CHECK(linear.tetrahedra == Tetrahedra{{0, 1, 2, 3}});
  CHECK(linear.points.size() == 4);
  CHECK(ledger(linear) == "passed over: midside node (6)");
  // Triangle's second order: corners, then the midpoints opposite them.
  const Soup six = read_tetgen(
      {"6 2 0 0\n1 0 0\n2 2 0\n3 0 2\n4 1 1\n5 0 1\n6 1 0\n", "1 6 0\n1 1 2 3 4 5 6\n", "n", "e"});
  CHECK(six.triangles == Triangles{{0, 1, 2}});
  CHECK(six.points.size() == 3);
  const Soup labelled =
      read_tetgen({"4 3\n" + points, "1 4 1\n1 1 2 3 4 9\n", "n", "e", "2 1\n1 1 3 2 -1\n2 1 2 4 8\n", "f"});
  CHECK(labelled.tetrahedron_tags == std::vector<int>{9});
  CHECK(labelled.triangles == Triangles{{0, 2, 1}, {0, 1, 3}});
  CHECK(labelled.triangle_tags == std::vector<int>{-1, 8});
}

TEST_CASE("MEDIT in the plane, with quadrilaterals and volume cells, of second order", "[variants]") {
  const Soup flat =
      read_medit("MeshVersionFormatted 2\nDimension\n2\nVertices\n4\n0 0 3\n1 0 3\n1 1 3\n0 1 3\n"
                 "Edges\n1\n1 2 1\nTriangles\n1\n1 2 3 4\nQuadrilaterals\n1\n1 2 3 4 -5\nEnd\n",
                 "f");
  CHECK(flat.triangles == Triangles{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}});
  CHECK(flat.triangle_tags == std::vector<int>{4, -5, -5});
  CHECK(ledger(flat) ==
        "passed over: reference of a vertex (4), line element, quadrilateral, cut into triangles");
  const auto cells = [](const std::string& text) {
    std::string points = "Vertices\n8\n" + replaced(cube_points, "\n", " 0\n");
    return read_medit(medit_head + points + text + "End\n", "f");
  };
  // A cube of one hexahedron, and of two prisms; the pyramid on its bottom is a third of it.
  CHECK(volume(cells("Hexahedra\n1\n1 2 3 4 5 6 7 8 3\n")) == Approx(1));
  CHECK(cells("Hexahedra\n1\n1 2 3 4 5 6 7 8 3\n").tetrahedron_tags == std::vector<int>(6, 3));
  CHECK(volume(cells("Prisms\n2\n1 2 3 5 6 7 0\n1 3 4 5 7 8 0\n")) == Approx(1));
  CHECK(volume(cells("Pyramids\n1\n1 2 3 4 5 0\n")) == Approx(1.0 / 3));
  CHECK(ledger(cells("Pyramids\n1\n1 2 3 4 5 0\n")) == "passed over: pyramid, cut into tetrahedra");
  // A hexahedron with an edge collapsed is a prism: three tetrahedra.
  CHECK(cells("Hexahedra\n1\n1 2 3 3 5 6 7 7 0\n").tetrahedra.size() == 3);
  CHECK(volume(cells("Hexahedra\n1\n1 2 3 3 5 6 7 7 0\n")) == Approx(0.5));
  const Soup p2 = read_medit(medit_head + "Vertices\n10\n" + replaced(cube_points, "\n", " 0\n") +
                                 "2 0 0 0\n2 1 0 0\nTetrahedraP2\n1\n1 2 4 5 3 6 7 8 9 10 4\nEnd\n",
                             "f");
  CHECK(p2.tetrahedra == Tetrahedra{{0, 1, 2, 3}});
  CHECK(p2.tetrahedron_tags == std::vector<int>{4});
  CHECK(ledger(p2) == "passed over: midside node (6)");
  CHECK(point_number(p2, 2) == 4); // the numbers of the file stay
  CHECK(ledger(read_medit(medit_head + medit_points + "Corners 2\n1\n2\nTetrahedra 1\n1 2 3 4 0\n", "f")) ==
        "passed over: entry of Corners (2)");
}

TEST_CASE("MEDIT's binary form, in all versions and both byte orders", "[variants]") {
  for (const bool big : {false, true})
    for (const int version : {1, 2, 3, 4}) {
      INFO(big << " " << version);
      const auto i4 = [&](int n) { return bytes(static_cast<std::int32_t>(n), big); };
      const auto integer = [&](int n) {
        return version >= 4 ? bytes(static_cast<std::int64_t>(n), big) : i4(n);
      };
      const auto position = [&](std::size_t at) {
        return version >= 3 ? bytes(static_cast<std::int64_t>(at), big) : i4(static_cast<int>(at));
      };
      const auto real = [&](double x) {
        return version >= 2 ? bytes(x, big) : bytes(static_cast<float>(x), big);
      };
      std::string text = i4(1) + i4(version);
      const auto section = [&](int code, const std::string& body) {
        const std::size_t next = text.size() + 4 + position(0).size() + body.size();
        text += i4(code) + position(next) + body;
      };
      section(3, i4(3).substr(0, version >= 4 ? 0 : 4) + (version >= 4 ? integer(3) : ""));
      std::string body = integer(4);
      for (const std::array<double, 3>& p :
           {std::array<double, 3>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}})
        body += real(p[0]) + real(p[1]) + real(p[2]) + integer(0);
      section(4, body);
      section(77, "whatever");
      section(8, integer(1) + integer(1) + integer(2) + integer(3) + integer(4) + integer(-7));
      text += i4(54) + position(0);
      const Soup soup = read_soup(text, "f");
      CHECK(soup.tetrahedra == Tetrahedra{{0, 1, 2, 3}});
      CHECK(soup.tetrahedron_tags == std::vector<int>{-7});
      CHECK(soup.points.at(3) == std::array<double, 3>{0, 0, 1.5});
      CHECK(ledger(soup) == "passed over: entry of keyword 77");
      for (std::size_t size = 0; size < text.size(); ++size)
        error_of([&] { read_soup(text.substr(0, size), "f"); });
    }
}

TEST_CASE("Gmsh's versions 1 and 4.0, parametric nodes, comments first", "[variants]") {
  const std::string format = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
  const std::string element = "$Elements\n1\n1 4 2 10 1 1 2 3 4\n$EndElements\n";
  CHECK(read_soup("$Comments\nanything\n$EndComments\n" + format + nodes + element, "f").tetrahedra.size() ==
        1);
  const Soup one =
      read_soup("$NOD\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$ENDNOD\n$ELM\n2\n1 2 7 7 3 1 3 2\n"
                "2 4 9 9 4 1 2 3 4\n$ENDELM\n",
                "f");
  CHECK(one.triangles == Triangles{{0, 2, 1}});
  CHECK(one.tetrahedron_tags == std::vector<int>{9});
  CHECK(read_soup(format +
                      "$ParametricNodes\n4\n1 0 0 0 2 5 0.5 0.5\n2 1 0 0 1 5 0.5\n3 0 1 0 0 5\n4 0 0 1 3 5\n"
                      "$EndParametricNodes\n" +
                      element,
                  "f")
            .tetrahedra.size() == 1);
  const Soup four =
      read_soup("$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n1 0 1 1\n9 0 0 0 0 0 0 0\n"
                "5 0 0 0 1 1 1 1 8 0\n1 0 0 0 1 1 1 2 30 31 0\n$EndEntities\n$Nodes\n2 4\n5 2 1 1\n"
                "1 0 0 0 0.5 0.5\n1 3 0 3\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n2 2\n"
                "5 2 2 1\n1 1 3 2\n1 3 4 1\n2 1 2 3 4\n$EndElements\n",
                "f");
  CHECK(four.tetrahedra == Tetrahedra{{0, 1, 2, 3}});
  CHECK(four.tetrahedron_tags == std::vector<int>{30});
  CHECK(four.triangle_tags == std::vector<int>{8});
  CHECK(ledger(four) == "passed over: further physical group of an element");
}

TEST_CASE("Gmsh's partitions keep the groups of the whole, and entities are not taken for groups",
          "[variants]") {
  const std::string nodes = "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n";
  const std::string format = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  // Part 7 of surface 5 says its group itself, part 2 of volume 1 leaves that to the volume.
  const Soup part =
      read_gmsh(format +
                    "$Entities\n0 0 1 1\n5 0 0 0 1 1 1 1 101 0\n1 0 0 0 1 1 1 1 10 1 5\n$EndEntities\n"
                    "$PartitionedEntities\n1\n1\n3 1\n0 0 1 1\n7 2 5 1 1 0 0 0 1 1 1 1 101 0\n2 3 1 1 1 0 0 "
                    "0 1 1 1 0 1 7\n"
                    "$EndPartitionedEntities\n" +
                    nodes + "$Elements\n2 2 1 9\n2 7 2 1\n1 1 3 2\n3 2 4 1\n9 1 2 3 4\n$EndElements\n",
                "f");
  CHECK(part.triangle_tags == std::vector<int>{101});
  CHECK(part.tetrahedron_tags == std::vector<int>{10});
  // Group 6 of surface 5, and surface 6 in no group.
  const std::string elements = "$Elements\n2 2 1 2\n2 5 2 1\n1 1 3 2\n2 6 2 1\n2 1 2 4\n$EndElements\n";
  const Soup collision =
      read_gmsh(format + "$Entities\n0 0 2 0\n5 0 0 0 1 1 1 1 6 0\n6 0 0 0 1 1 1 0 0\n$EndEntities\n" +
                    nodes + elements,
                "f");
  CHECK(collision.triangle_tags == std::vector<int>{6, 0});
  CHECK(ledger(collision) == "passed over: entity of a triangle in no physical group");
  // Without any group, the entities are the labels.
  CHECK(read_gmsh(format + nodes + elements, "f").triangle_tags == std::vector<int>{5, 6});
}

TEST_CASE("Gmsh's elements of every shape and order are read by their corners", "[variants]") {
  struct Row {
    int type;
    int nodes;
    std::size_t triangles;
    std::size_t tetrahedra;
  };
  // Corners from Gmsh's manual: a quadrilateral is 2 triangles, a pyramid 2 tetrahedra, a prism 3, a
  // hexahedron 6 when it is a cone from its smallest vertex.
  for (const Row& row : {Row{2, 3, 1, 0},
                         {3, 4, 2, 0},
                         {4, 4, 0, 1},
                         {5, 8, 0, 6},
                         {6, 6, 0, 3},
                         {7, 5, 0, 2},
                         {9, 6, 1, 0},
                         {10, 9, 2, 0},
                         {11, 10, 0, 1},
                         {12, 27, 0, 6},
                         {13, 18, 0, 3},
                         {14, 14, 0, 2},
                         {16, 8, 2, 0},
                         {17, 20, 0, 6},
                         {18, 15, 0, 3},
                         {19, 13, 0, 2},
                         {21, 10, 1, 0},
                         {29, 20, 0, 1}}) {
    INFO(row.type);
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(row.nodes) + "\n";
    for (int v = 1; v <= row.nodes; ++v)
      text += std::to_string(v) + " " + std::to_string(v) + " " + std::to_string(v * v) + " 0\n";
    text += "$EndNodes\n$Elements\n1\n1 " + std::to_string(row.type) + " 0";
    for (int v = 1; v <= row.nodes; ++v) text += " " + std::to_string(v);
    const Soup soup = read_gmsh(text + "\n$EndElements\n", "f");
    CHECK(soup.triangles.size() == row.triangles);
    CHECK(soup.tetrahedra.size() == row.tetrahedra);
  }
}

TEST_CASE("cells of different shapes that share a face cut it alike", "[variants]") {
  // Two cubes side by side, one a hexahedron and one two prisms; and a pyramid on top of the first. Every
  // face that two tetrahedra do not share must lie on the outside: 10 squares of the boundary are 20
  // triangles, less the one under the pyramid, more its four sides.
  const std::string text = medit_head + "Vertices\n13\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 "
                                        "0\n1 1 1 0\n0 1 1 0\n2 0 0 0\n2 1 0 0\n"
                                        "2 0 1 0\n2 1 1 0\n0.5 0.5 2 0\nHexahedra\n1\n7 8 5 6 3 4 1 2 "
                                        "0\nPrisms\n2\n2 9 10 6 11 12 0\n2 10 3 6 12 7 0\n"
                                        "Pyramids\n1\n6 7 8 5 13 0\nEnd\n";
  const Soup soup = read_medit(text, "f");
  CHECK(soup.tetrahedra.size() == 6 + 3 + 3 + 2);
  CHECK(volume(soup) ==
        Approx(-1 + 1 + 1.0 / 3)); // the hexahedron is written upside down, and so is inverted
  std::map<std::array<int, 3>, int> faces;
  for (const auto& t : soup.tetrahedra)
    for (std::size_t f = 0; f < 4; ++f) {
      std::array<int, 3> face{t[(f + 1) % 4], t[(f + 2) % 4], t[(f + 3) % 4]};
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  CHECK(std::count_if(faces.begin(), faces.end(), [](const auto& f) { return f.second == 1; }) == 22);
  CHECK(std::none_of(faces.begin(), faces.end(), [](const auto& f) { return f.second > 2; }));
}

TEST_CASE("VTK's legacy files with ids, strings, bits and data of all kinds", "[variants]") {
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const std::string mesh =
      "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 9\n4 0 1 2 3\n3 0 2 1\nCELL_TYPES 2\n10\n5\n";
  const Soup words = read_vtk(head +
                                  "FIELD FieldData 3\ntitle 1 1 string\ntwo%20words\nnone 1 2 bit\n1 0\n"
                                  "ids 1 3 vtkIdType\n7 8 9\n" +
                                  mesh,
                              "f");
  CHECK(words.tetrahedra == Tetrahedra{{0, 1, 2, 3}});
  CHECK(ledger(words) == "passed over: field array title, field array none, field array ids");
  const Soup data =
      read_vtk(head + mesh +
                   "POINT_DATA 4\nSCALARS t float\nLOOKUP_TABLE default\n1 2 3 4\nVECTORS v double\n"
                   "0 0 0 0 0 0 0 0 0 0 0 0\nLOOKUP_TABLE c 2\n0 0 0 1 1 1 1 1\nMETADATA\nINFORMATION 0\n\n"
                   "CELL_DATA 2\nTENSORS s float\n1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9\n"
                   "FIELD FieldData 2\nregion 1 2 int\n3 4\nmedit:ref 1 2 vtktypeint64\n-5 6\n",
               "f");
  CHECK(data.tetrahedron_tags == std::vector<int>{-5});
  CHECK(data.triangle_tags == std::vector<int>{6});
  CHECK(ledger(data) ==
        "passed over: point array t, point array v, lookup table, cell array s, cell array region");
  std::string binary = "# vtk DataFile Version 4.2\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 3\n"
                       "ids 1 3 vtkIdType\n";
  for (const std::int32_t n : {7, 8, 9}) binary += bytes(n, true);
  binary += "\nb 1 9 bit\n" + std::string("\xff\x80", 2) + "\ntitle 1 2 string\n" + "\xc3" + "abc" +
            std::string("\x80\x05", 2) + "hello\nPOINTS 4 float\n";
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) binary += bytes(x, true);
  binary += "\nCELLS 1 5\n";
  for (const std::int32_t n : {4, 0, 1, 2, 3}) binary += bytes(n, true);
  binary += "\nCELL_TYPES 1\n" + bytes(std::int32_t{10}, true) +
            "\nCELL_DATA 1\nSCALARS label short 1\nLOOKUP_TABLE "
            "default\n" +
            bytes(std::int16_t{-9}, true) + "\n";
  const Soup bits = read_vtk(binary, "f");
  CHECK(bits.tetrahedra == Tetrahedra{{0, 1, 2, 3}});
  CHECK(bits.tetrahedron_tags == std::vector<int>{-9});
}

TEST_CASE("VTK's polygons, strips, pixels, voxels, wedges of either convention, second order", "[variants]") {
  const std::string poly =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\n";
  const Soup strips =
      read_vtk(poly + "LINES 1 3\n2 0 1\nTRIANGLE_STRIPS 1 5\n4 0 1 3 2\nPOLYGONS 1 5\n4 0 1 2 3\n"
                      "CELL_DATA 3\nSCALARS label int\nLOOKUP_TABLE default\n1 2 3\n",
               "f");
  CHECK(doubled_area(strips) == Approx(4)); // twice the square
  // Data count lines first, then polygons, then strips, wherever they stand.
  CHECK(strips.triangle_tags == std::vector<int>{2, 2, 3, 3});
  const auto grid = [](int type, const std::string& cell) {
    const long count = std::count(cell.begin(), cell.end(), ' ') + 1;
    return read_vtk("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" +
                        cube_points + "CELLS 1 " + std::to_string(count + 1) + "\n" + std::to_string(count) +
                        " " + cell + "\nCELL_TYPES 1\n" + std::to_string(type) + "\n",
                    "f");
  };
  CHECK(doubled_area(grid(8, "0 1 3 2")) == Approx(2));
  CHECK(doubled_area(grid(9, "0 1 2 3")) == Approx(2));
  CHECK(volume(grid(11, "0 1 3 2 4 5 7 6")) == Approx(1));
  CHECK(volume(grid(12, "0 1 2 3 4 5 6 7")) == Approx(1));
  CHECK(volume(grid(14, "0 1 2 3 4")) == Approx(1.0 / 3));
  // As VTK documents a wedge, and as meshio and others write it.
  CHECK(volume(grid(13, "0 2 1 4 6 5")) == Approx(0.5));
  CHECK(volume(grid(13, "0 1 2 4 5 6")) == Approx(0.5));
  CHECK(grid(22, "0 1 2 4 5 6").triangles == Triangles{{0, 1, 2}});
  CHECK(ledger(grid(22, "0 1 2 4 5 6")) == "passed over: midside node (3)");
  CHECK(error_of([&] { grid(43, "0 1 2 3"); }).find("found a cell of type 43") != std::string::npos);
}

TEST_CASE("VTK's PolyData and pieces in XML", "[variants]") {
  const std::string points =
      "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 "
      "0 1 0</DataArray></Points>";
  const auto array = [](const std::string& name, const std::string& numbers) {
    return "<DataArray type=\"Int64\" Name=\"" + name + "\" format=\"ascii\">" + numbers + "</DataArray>";
  };
  const Soup soup =
      read_soup("<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" "
                "byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"4\" "
                "NumberOfVerts=\"0\" NumberOfLines=\"1\" NumberOfStrips=\"1\" NumberOfPolys=\"1\">" +
                    points + "<PointData>" + array("id", "1 2 3 4") + "</PointData><CellData>" +
                    array("label", "7 8 9") + "</CellData><Lines>" + array("connectivity", "0 1") +
                    array("offsets", "2") + "</Lines><Strips>" + array("connectivity", "0 1 3 2") +
                    array("offsets", "4") + "</Strips><Polys>" + array("connectivity", "0 1 2 3") +
                    array("offsets", "4") + "</Polys></Piece></PolyData></VTKFile>",
                "f");
  CHECK(doubled_area(soup) == Approx(4));
  CHECK(soup.triangle_tags == std::vector<int>{8, 8, 9, 9});
  CHECK(ledger(soup) ==
        "passed over: point array id, line element, quadrilateral, cut into triangles, strip, cut into "
        "triangles");
  const std::string piece = "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">" + points + "<Cells>" +
                            array("connectivity", "0 1 2") + array("offsets", "3") + array("types", "5") +
                            "</Cells></Piece>";
  const Soup two = read_soup("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>" + piece + piece +
                                 "</UnstructuredGrid></VTKFile>",
                             "f");
  CHECK(two.triangles == Triangles{{0, 1, 2}, {4, 5, 6}});
  CHECK(ledger(two) == "passed over: division into pieces");
}

TEST_CASE("labels go through every pair of formats that hold them", "[variants]") {
  Soup soup = two_tetrahedra();
  soup.triangles.push_back({0, 2, 1});
  soup.triangle_tags = {4, 0};
  soup.tetrahedron_tags = {2, 7};
  const std::vector<MeshFormat> formats{MeshFormat::medit, MeshFormat::meshb, MeshFormat::gmsh,
                                        MeshFormat::vtk,   MeshFormat::vtu,   MeshFormat::json,
                                        MeshFormat::tetgen};
  const Scratch scratch;
  const auto through = [&](const Soup& given, MeshFormat format) {
    if (format == MeshFormat::json) return read_soup(write_soup(given, format), "f");
    const std::string path = scratch / ("m." + std::string(format == MeshFormat::medit    ? "mesh"
                                                           : format == MeshFormat::gmsh   ? "msh"
                                                           : format == MeshFormat::tetgen ? "ele"
                                                                                          : name_of(format)));
    write_soup_file(given, path);
    return read_soup_file(path);
  };
  // Gmsh's files have elements by labels, so that orders differ: labels are compared element by element.
  const auto by_corners = [](const auto& elements, const std::vector<int>& tags) {
    std::map<std::vector<int>, int> out;
    for (std::size_t k = 0; k < elements.size(); ++k)
      out[{elements[k].begin(), elements[k].end()}] = tags.empty() ? 0 : tags[k];
    return out;
  };
  for (const MeshFormat first : formats)
    for (const MeshFormat second : formats) {
      INFO(name_of(first) << " " << name_of(second));
      const Soup back = through(through(soup, first), second);
      CHECK(by_corners(back.triangles, back.triangle_tags) == by_corners(soup.triangles, soup.triangle_tags));
      CHECK(by_corners(back.tetrahedra, back.tetrahedron_tags) ==
            by_corners(soup.tetrahedra, soup.tetrahedron_tags));
    }
}
