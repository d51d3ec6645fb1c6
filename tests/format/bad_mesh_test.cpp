// SPDX-License-Identifier: GPL-2.0-or-later
// Mesh files that are damaged, lie or hold something else.
#include "expect.hpp"
#include "meshes.hpp"
#include "tetrarch/format/gmsh.hpp"
#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/surface_files.hpp"
#include "tetrarch/format/tetgen.hpp"
#include "tetrarch/format/vtk.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

std::string soup_complaint(const std::string& text, const std::string& source = "f") {
  return error_of([&] { read_soup(text, source); });
}

/// Nothing but an InputError of one short line, or none, may come of `text`.
void require_bearable(const std::string& text, const std::string& source) {
  const std::string message = soup_complaint(text, source);
  INFO(message);
  REQUIRE(message.find('\n') == std::string::npos);
  REQUIRE(message.size() < 300);
}

const std::string medit =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "Tetrahedra\n1\n1 2 3 4 0\nEnd\n";

} // namespace

TEST_CASE("a mesh file cut off anywhere, or with any byte spoilt, is an error or a mesh", "[bad][mesh]") {
  for (const auto& entry : std::filesystem::directory_iterator(mesh_data(""))) {
    const std::string path = entry.path().string();
    INFO(path);
    if (mesh_format_for_extension(path) == MeshFormat::tetgen) continue;
    const std::string text = read_file(path);
    for (std::size_t size = 0; size < text.size(); ++size) {
      require_bearable(text.substr(0, size), path);
      for (const char c : {'\0', ' ', '9', '-', 'x', '\xff'}) {
        std::string spoilt = text;
        spoilt[size] = c;
        require_bearable(spoilt, path);
      }
    }
  }
}

TEST_CASE("TetGen's files cut off anywhere are an error", "[bad][mesh]") {
  TetgenFiles files = write_tetgen(two_tetrahedra());
  for (std::size_t size = 0; size + 1 < files.ele.size(); ++size)
    CHECK_FALSE(error_of([&] { read_tetgen({files.node, files.ele.substr(0, size), "n", "e"}); }).empty());
  for (std::size_t size = 0; size + 1 < files.node.size(); ++size)
    error_of([&] { read_tetgen({files.node.substr(0, size), files.ele, "n", "e"}); });
  const auto spoilt = [&](const std::string& from, const std::string& to) {
    return error_of([&] { read_tetgen({files.node, with(files.ele, from, to), "n", "e"}); });
  };
  CHECK(spoilt("2 1 3 2 5", "3 1 3 2 5") == "e:3: found '3', expected tetrahedron 2 next");
  CHECK(spoilt("2 4 0", "2 5 0") == "e:1: found '5', expected 4 or 10 points in a tetrahedron");
  CHECK(spoilt("2 4 0", "1 4 0") == "e:3: found '2', expected the end of the file");
  CHECK(spoilt("2 1 3 2 5\n", "") == "e:2: the text ends, expected a number");
}

TEST_CASE("wrong MEDIT files", "[bad][mesh]") {
  const auto spoilt = [](const std::string& from, const std::string& to) {
    return soup_complaint(with(medit, from, to));
  };
  CHECK(soup_complaint(medit).empty());
  CHECK(spoilt("Dimension 3", "Dimension 4") == "f:2: found '4', expected dimension 2 or 3");
  CHECK(spoilt("1 0 0 0\n0 1", "1 0 x 0\n0 1") == "f:6: found 'x', expected a coordinate");
  CHECK(spoilt("1 2 3 4 0", "1 2 3.5 4 0") == "f:11: found '3.5', expected the number of a vertex");
  CHECK(spoilt("1 2 3 4 0", "1 2 3 99999999999 0") ==
        "f:11: found '99999999999', expected the number of a vertex");
  CHECK(spoilt("Tetrahedra\n1", "Tetrahedra\n2") == "f:12: found 'End', expected the number of a vertex");
  CHECK(spoilt("Tetrahedra\n1", "Tetrahedra\n-1") == "f:10: found '-1', expected the number of tetrahedra");
  CHECK(spoilt("Vertices\n4", "Vertices\n3") == "f:8: found '0', expected a keyword, like Tetrahedra");
  CHECK(spoilt("End", "Hexahedra 1") == "f:12: the text ends, expected the number of a vertex");
  CHECK(spoilt("End", "Vertices 0") == "f:12: found 'vertices', expected only one list of vertices");
  CHECK(read_medit(with(medit, "End", "Hexahedra 0 End"), "f").tetrahedra.size() == 1);
  CHECK(read_medit(with(medit, "End", "Quadrilaterals 1 1 2 3 4 0"), "f").triangles.size() == 2);
  // What is in no range is still an integer: the soup keeps it, validation tells.
  CHECK(read_medit(with(medit, "1 2 3 4 0", "0 2 3 -7 0"), "f").tetrahedra[0] ==
        std::array<int, 4>{-1, 1, 2, -8});
  CHECK(std::isnan(read_medit(with(medit, "0 0 1 0", "0 0 nan 0"), "f").points[3][2]));
}

TEST_CASE("wrong Gmsh files", "[bad][mesh]") {
  const std::string text = write_gmsh(two_tetrahedra());
  const auto spoilt = [&](const std::string& from, const std::string& to) {
    return soup_complaint(with(text, from, to));
  };
  CHECK(spoilt("4.1 0 8", "3 0 8") == "f:2: found '3', expected version 2.x, 4.0 or 4.1");
  CHECK(spoilt("4.1 0 8", "4.1 0 4") == "f:2: found '4', expected 8 bytes in a real number");
  CHECK(spoilt("3 1 4 2", "3 1 99 2") == "f:27: found '99', expected an element type of Gmsh up to 31");
  CHECK(spoilt("3 1 0 5", "3 1 0 4").find("found") != std::string::npos);
  CHECK(spoilt("$EndNodes", "$End") == "f:22: found '$End', expected $EndNodes");
  CHECK(spoilt("$EndElements", "") == "f:29: the text ends, expected $EndElements");
}

TEST_CASE("wrong VTK files", "[bad][mesh]") {
  const std::string text = write_vtk(two_tetrahedra());
  const auto spoilt = [&](const std::string& from, const std::string& to) {
    return soup_complaint(with(text, from, to));
  };
  CHECK(spoilt("4 0 1 2 3\n", "4 0 1 2 x\n") == "f:13: found 'x', expected the number of a point");
  CHECK(spoilt("5\n10\n10\n", "5\n10\n43\n") ==
        "f:14: found a cell of type 43, expected triangles, quadrilaterals, polygons, tetrahedra, pyramids, "
        "prisms, hexahedra or polyhedra");
  CHECK(spoilt("5\n10\n10\n", "5\n10\n12\n") == "f:14: found 4 points in cell 2, expected 8");
  CHECK(spoilt("5\n10\n10\n", "10\n10\n10\n") == "f:12: found 3 points in cell 0, expected 4");
  CHECK(spoilt("CELL_TYPES 3", "CELL_TYPES 2").find("found") != std::string::npos);
  CHECK(spoilt("UNSTRUCTURED_GRID", "STRUCTURED_GRID") ==
        "f:4: found 'STRUCTURED_GRID', expected UNSTRUCTURED_GRID or POLYDATA");
  const std::string xml = write_vtu(two_tetrahedra());
  const auto spoilt_xml = [&](const std::string& from, const std::string& to) {
    return soup_complaint(with(xml, from, to));
  };
  CHECK(spoilt_xml("NumberOfPoints=\"5\"", "NumberOfPoints=\"6\"") == "f: found 15 coordinates, expected 18");
  CHECK(spoilt_xml("NumberOfCells=\"3\"", "NumberOfCells=\"-3\"") ==
        "f: found '-3', expected NumberOfCells of a piece");
  CHECK(spoilt_xml("</Points>", "</Point>").substr(0, 27) == "f:13: the text is no XML: S");
  CHECK(spoilt_xml("Name=\"types\"", "Name=\"kinds\"") ==
        "f: an array of points, connectivity, offsets or types is missing");
  CHECK(spoilt_xml("3\n7\n11\n", "3\n7\n12\n") == "f: found the offset 12, expected 7 to 11");
}

TEST_CASE("wrong surfaces", "[bad][mesh]") {
  CHECK(soup_complaint("v 0 0 0\nf 1 2", "f.obj") ==
        "f.obj:2: the line ends, expected three vertices or more");
  CHECK(soup_complaint("v 0 0 0\nf 1 0 1", "f.obj") == "f.obj:2: found '0', expected the number of a vertex");
  CHECK(soup_complaint("OFF\n4 1 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n-4 0 1 2 3\n") ==
        "f:7: found '-4', expected the number of vertices of a face");
  CHECK(soup_complaint("ply\nformat ascii 2.0\nelement face 1\nproperty list uchar int "
                       "vertex_index\nend_header\n4 0 1 2 x\n") == "f:6: found 'x', expected a number");
  CHECK(soup_complaint("ply\nformat binary_middle_endian 1.0\n").find("binary_big_endian") !=
        std::string::npos);
  CHECK(soup_complaint("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n") ==
        "f:5: found 'endloop', expected vertex");
  // Relative numbers, texture numbers and names.
  const Soup soup =
      read_obj("o thing\nv 0 0 0\nv 1 0 0 # two\nv 0 1 0 1\nusemtl a\nf -3/1 -2//2 -1/1/1 # c\n", "f");
  CHECK(soup.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}});
}

TEST_CASE("headers that announce too much fail at once, without memory", "[bad][mesh]") {
  const auto start = std::chrono::steady_clock::now();
  const std::string many = "2147483646";
  CHECK_FALSE(soup_complaint("MeshVersionFormatted 2 Dimension 3 Vertices 1000000000000").empty());
  CHECK_FALSE(soup_complaint("MeshVersionFormatted 2 Dimension 3 Vertices " + many + "\n0 0 0 0").empty());
  CHECK_FALSE(soup_complaint("MeshVersionFormatted 2 Tetrahedra " + many + "\n1 2 3 4 0").empty());
  CHECK_FALSE(soup_complaint("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n" + many + " " + many + " 1 1\n")
                  .empty());
  CHECK_FALSE(soup_complaint("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n" + many + "\n").empty());
  const std::string vtk = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  CHECK_FALSE(soup_complaint(vtk + "POINTS 715827882 double\n0").empty());
  CHECK_FALSE(soup_complaint(vtk + "CELLS " + many + " " + many + "\n0").empty());
  CHECK_FALSE(soup_complaint(vtk + "CELL_TYPES " + many + "\n0").empty());
  CHECK_FALSE(soup_complaint("OFF " + many + " " + many + " 0\n").empty());
  CHECK_FALSE(
      soup_complaint("ply\nformat ascii 1.0\nelement vertex " + many + "\nproperty float x\nend_header\n")
          .empty());
  CHECK_FALSE(error_of([&] { read_tetgen({many + " 3 0 0\n", "0 4 0", "n", "e"}); }).empty());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  CHECK(seconds.count() < 1);
}
