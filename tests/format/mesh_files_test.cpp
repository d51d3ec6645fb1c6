// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/mesh_files.hpp"

#include "expect.hpp"
#include "meshes.hpp"
#include "tetrarch/format/gmsh.hpp"
#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/surface_files.hpp"
#include "tetrarch/format/tetgen.hpp"
#include "tetrarch/format/vtk.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

void check_same(const Soup& found, const Soup& expected) {
  CHECK(found.points == expected.points);
  CHECK(found.triangles == expected.triangles);
  CHECK(found.tetrahedra == expected.tetrahedra);
  CHECK(found.point_labels.numbers.size() == found.points.size());
  CHECK(found.point_labels.lines.size() == found.points.size());
  CHECK(found.tetrahedron_labels.numbers.size() == found.tetrahedra.size());
  CHECK(found.tetrahedron_labels.lines.size() == found.tetrahedra.size());
  CHECK(found.triangle_labels.numbers.size() == found.triangles.size());
  CHECK(found.triangle_labels.lines.size() == found.triangles.size());
}

} // namespace

TEST_CASE("runs keep any list of integers", "[mesh]") {
  const std::vector<int> values{5, 6, 7, -2, -1, 0, 0, 2147483647, -2147483647 - 1, -2147483647, 3};
  Runs runs;
  for (const int value : values) runs.push_back(value);
  REQUIRE(runs.size() == values.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(runs[i] == values[i]);
  CHECK(runs.runs().size() == 6); // counted by hand
}

// By libMeshb's layout, counted by hand: 8 bytes of head; Dimension 12; Vertices 8 + 4 + 28 each; Tetrahedra
// 8 + 4 + 20 each; End 8.
TEST_CASE("a mesh survives as bytes of MEDIT", "[mesh]") {
  Soup soup = two_tetrahedra();
  soup.tetrahedron_tags = {7, -3};
  const std::string bytes = write_soup(soup, MeshFormat::meshb);
  const std::size_t triangles = soup.triangles.empty() ? 0 : 12 + 16 * soup.triangles.size();
  CHECK(bytes.size() == 8 + 12 + 12 + 28 * soup.points.size() + triangles + 12 + 20 * 2 + 8);
  std::int32_t next = 0;
  std::memcpy(&next, bytes.data() + 12, sizeof next); // after the code of Dimension
  CHECK(next == 20);
  CHECK(recognise_mesh(bytes, "f") == MeshFormat::meshb);
  const Soup back = read_soup(bytes, "f");
  CHECK(back.points == soup.points);
  CHECK(back.triangles == soup.triangles);
  CHECK(back.tetrahedra == soup.tetrahedra);
  CHECK(back.tetrahedron_tags == soup.tetrahedron_tags);
  CHECK(mesh_format_for_extension("x.meshb") == MeshFormat::meshb);
  CHECK(read_soup(write_soup(Soup(), MeshFormat::meshb), "f").points.empty());
}

TEST_CASE("a mesh survives every format", "[mesh]") {
  for (const MeshFormat format : solid_formats) {
    INFO(name_of(format));
    const std::string text = write_soup(two_tetrahedra(), format);
    CHECK(recognise_mesh(text, "f") == format);
    check_same(read_soup(text, "f"), two_tetrahedra());
    CHECK(write_soup(read_soup(text, "f"), format) == text);
    Soup empty;
    check_same(read_soup(write_soup(empty, format), "f"), empty);
  }
  for (const MeshFormat format : surface_formats) {
    INFO(name_of(format));
    const Soup soup = read_soup(write_soup(one_boundary(), format), "f." + name_of(format));
    CHECK(soup.triangles.size() == 4);
    CHECK(soup.points.size() == 4);
    if (format != MeshFormat::stl) check_same(soup, one_boundary()); // STL orders the points by use
  }
}

TEST_CASE("numbers survive to the last digit", "[mesh]") {
  Soup soup = two_tetrahedra();
  soup.points[0] = {0.1, -1.0 / 3, 6.02214076e23};
  soup.points[1] = {5e-324, 1.7976931348623157e308, -0.0};
  for (const MeshFormat format : solid_formats) {
    INFO(name_of(format));
    const Soup back = read_soup(write_soup(soup, format), "f");
    CHECK(back.points == soup.points);
    CHECK(std::signbit(back.points[1][2]));
  }
}

// The witness is meshio, which wrote the files (record_meshio.py).
TEST_CASE("meshio's files hold the mesh that it was given", "[mesh]") {
  for (const std::string name :
       {"medit.mesh", "gmsh22.msh", "gmsh22_binary.msh", "vtk42.vtk", "vtk42_binary.vtk", "vtk51.vtk",
        "vtk51_binary.vtk", "text.vtu", "base64.vtu", "zlib.vtu", "lzma.vtu"}) {
    INFO(name);
    check_same(read_soup_file(mesh_data("meshio_" + name)), two_tetrahedra());
  }
  Soup without_triangle = two_tetrahedra();
  without_triangle.triangles.clear();
  check_same(read_soup_file(mesh_data("meshio_tetgen.node")), without_triangle);
  check_same(read_soup_file(mesh_data("meshio_tetgen.ele")), without_triangle);
  for (const std::string name : {"obj", "off", "ply"}) {
    INFO(name);
    check_same(read_soup_file(mesh_data("meshio_surface." + name)), one_boundary());
  }
  check_same(read_soup_file(mesh_data("meshio_surface_binary.ply")), one_boundary());
  // STL repeats the corners: the points are welded in the order in which they occur.
  for (const std::string name : {"surface.stl", "surface_binary.stl"}) {
    const Soup soup = read_soup_file(mesh_data("meshio_" + name));
    CHECK(soup.points == std::vector<std::array<double, 3>>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1.5}});
    CHECK(soup.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 3}});
  }
}

// The witness is Gmsh, which meshed a solid and wrote it in all these formats (record_gmsh.py).
TEST_CASE("Gmsh's files all hold the same mesh", "[mesh]") {
  const Soup first = read_soup_file(mesh_data("gmsh_41.msh"));
  CHECK(first.points.size() == 10);
  CHECK(first.triangles.size() == 16);
  CHECK(first.tetrahedra.size() == 11);
  CHECK(first.tetrahedron_labels.numbers[10] == 27);
  CHECK(first.triangle_tags == std::vector<int>(16, 2)); // all in the physical group "skin", 2 there
  for (const std::string name :
       {"22.msh", "22_binary.msh", "41_binary.msh", "solid.mesh", "solid.vtk", "solid_binary.vtk"}) {
    INFO(name);
    const Soup soup = read_soup_file(mesh_data("gmsh_" + name));
    CHECK(soup.triangles == first.triangles);
    CHECK(soup.tetrahedra == first.tetrahedra);
    if (name.ends_with("msh")) CHECK(soup.triangle_tags == first.triangle_tags);
    for (std::size_t i = 0; i < first.points.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(soup.points[i][axis] == Approx(first.points[i][axis]).margin(1e-12)); // some have 15 digits
  }
}

TEST_CASE("elements remember their numbers and lines", "[mesh]") {
  const std::string medit = "MeshVersionFormatted 2 # a comment\nDimension\n3\n\nVertices 4\n0 0 0 7\n"
                            "1 0 0 7\n\n0 1 0 7\n0 0 1 7\nEdges 1\n1 2 5\nTetrahedra\n2\n1 2 3 4 9\n"
                            "1 2 3 12 9\n";
  const Soup soup = read_medit(medit, "f");
  CHECK(soup.point_labels.lines[1] == 7);
  CHECK(soup.point_labels.lines[2] == 9);
  CHECK(soup.tetrahedron_labels.lines[1] == 16);
  CHECK(soup.tetrahedron_labels.numbers[1] == 2);
  CHECK(soup.tetrahedra[1][3] == 11);
  CHECK(point_number(soup, 11) == 12);
}

TEST_CASE("Gmsh's node tags may be sparse and in any order", "[mesh]") {
  const std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n1 0 0 1\nanything $ at all\n"
                           "$EndComments\n$Nodes\n2 4 3 900\n2 1 1 2\n900\n7\n0 0 0 0.5 0.5\n1 0 0 0.5 0.5\n"
                           "3 1 0 2\n3\n4\n0 1 0\n0 0 1\n$EndNodes\n$Elements\n2 2 1 8\n1 1 1 1\n1 3 4\n"
                           "3 1 4 1\n8 900 7 3 4\n$EndElements\n";
  const Soup soup = read_gmsh(text, "f");
  CHECK(soup.tetrahedra == std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
  CHECK(soup.points[1] == std::array<double, 3>{1, 0, 0});
  CHECK(soup.tetrahedron_labels.numbers[0] == 8);
  CHECK(soup.tetrahedron_labels.lines[0] == 26);
  CHECK(point_number(soup, 0) == 900);
  CHECK(error_of([&] { read_gmsh(with(text, "8 900 7", "8 901 7"), "f"); }) ==
        "f:26: found '901', expected the tag of a node");
  CHECK(error_of([&] { read_gmsh(with(text, "3\n4\n0", "7\n4\n0"), "f"); }).find("several have the tag 7") !=
        std::string::npos);
}

TEST_CASE("triangles keep the patch that the file counts them to", "[mesh]") {
  Soup soup = two_tetrahedra();
  soup.triangles.push_back({0, 1, 2});
  soup.triangle_tags = {7, -3};
  const Soup back = read_medit(write_medit(soup), "f");
  CHECK(back.triangle_tags == soup.triangle_tags);
  CHECK(write_medit(back) == write_medit(soup));
  CHECK(read_medit(write_medit(two_tetrahedra()), "f").triangle_tags.empty());

  // Version 2 names the group, then the surface; of elements in no group, the group is 0. Surface 6 is no
  // group 6: its label is 0.
  const std::string nodes = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";
  const Soup two = read_gmsh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + nodes +
                                 "$Elements\n2\n1 2 2 50 4 1 2 3\n2 2 2 0 6 3 2 1\n$EndElements\n",
                             "f");
  CHECK(two.triangle_tags == std::vector<int>{50, 0});
  // Version 4.1 names the surface, and $Entities its groups: here 4 is in group 50 and 6 in none.
  const Soup four = read_gmsh("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 1 2 0\n9 0 0 0 1 77\n"
                              "5 0 0 0 1 1 1 1 88 2 9 9\n4 0 0 0 1 1 1 2 50 51 1 5\n6 0 0 0 1 1 1 0 0\n"
                              "$EndEntities\n$Nodes\n1 3 1 3\n2 4 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n"
                              "$EndNodes\n$Elements\n2 2 1 2\n2 4 2 1\n1 1 2 3\n2 6 2 1\n2 3 2 1\n"
                              "$EndElements\n",
                              "f");
  CHECK(four.triangle_tags == std::vector<int>{50, 0});
}

TEST_CASE("TetGen's files count from 0 or from 1, and comments may stand anywhere", "[mesh]") {
  TetgenFiles files{"# points\n4 3 1 1\n0  0 0 0  5 -1\n1  1 0 0  5 -1 # two\n2  0 1 0  5 1\n3  0 0 1  5 1\n",
                    "1 4 1\n0  0 1 2 3  17\n# end\n", "f.node", "f.ele"};
  const Soup from_zero = read_tetgen(files);
  CHECK(from_zero.tetrahedra == std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
  CHECK(from_zero.first_number == 0);
  CHECK(from_zero.point_labels.lines[2] == 5);
  files = write_tetgen(from_zero);
  CHECK(files.ele == "1 4 1\n1 1 2 3 4 17\n");
  check_same(read_tetgen(files), from_zero);

  const Scratch scratch;
  write_soup_file(two_tetrahedra(), scratch / "a.node");
  CHECK(scratch.count() == 3); // .face too
  CHECK(read_soup_file(scratch / "a.ele").tetrahedra == two_tetrahedra().tetrahedra);
  CHECK(error_of([&] { read_soup_file(scratch / "b.ele"); }) == scratch / "b.node: there is no such file");
}

TEST_CASE("raw appended data of VTU files", "[mesh]") {
  // Made by hand after "VTK File Formats": each array a length of four bytes and the data; bytes that look
  // like XML do no harm.
  const auto bytes = [](auto values) {
    std::string raw(sizeof(values), '\0');
    std::memcpy(raw.data(), &values, sizeof(values));
    return raw;
  };
  const auto array = [&](auto values) {
    return bytes(static_cast<std::uint32_t>(sizeof(values))) + bytes(values);
  };
  const std::string points = array(std::array<float, 12>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1.5F});
  const std::string connectivity = array(std::array<std::int32_t, 4>{0, 1, 2, 3});
  const std::string ends = array(std::array<std::int64_t, 1>{4});
  const std::string types = array(std::array<std::uint8_t, 1>{10});
  const auto offset = [](std::size_t at) {
    return "format=\"appended\" offset=\"" + std::to_string(at) + "\"/>";
  };
  std::size_t at = 0;
  std::string text = "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
                     "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float32\" " +
                     offset(at) + "</Points><Cells><DataArray Name=\"connectivity\" type=\"Int32\" ";
  text += offset(at += points.size()) + "<DataArray Name=\"offsets\" type=\"Int64\" ";
  text += offset(at += connectivity.size()) + "<DataArray Name=\"types\" type=\"UInt8\" ";
  text += offset(at += ends.size()) + "</Cells></Piece></UnstructuredGrid>";
  const std::string tail =
      "<AppendedData encoding=\"raw\">\n _" + points + connectivity + ends + types + "<&\0>";
  const Soup soup = read_vtu(text + tail + "</AppendedData></VTKFile>", "f");
  CHECK(soup.tetrahedra == std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
  CHECK(soup.points[3] == std::array<double, 3>{0, 0, 1.5});
  CHECK(error_of([&] { read_vtu(text + tail.substr(0, 60), "f"); }) == "f: the array '' ends too early");
}

TEST_CASE("meshes are known by their content, then by their extension", "[mesh]") {
  CHECK(recognise_mesh("# by hand\nMeshVersionFormatted 2", "f") == MeshFormat::medit);
  CHECK(recognise_mesh("$MeshFormat\n", "f.obj") == MeshFormat::gmsh);
  CHECK(recognise_mesh("<?xml version='1.0'?><VTKFile", "f") == MeshFormat::vtu);
  CHECK(recognise_mesh("# c\nv 0 0 0", "f") == MeshFormat::obj);
  CHECK(recognise_mesh("COFF", "f") == MeshFormat::off);
  CHECK(recognise_mesh("4 3 0 0", "f.NODE") == MeshFormat::tetgen);
  CHECK(recognise_mesh("", "a.b/f.Mesh") == MeshFormat::medit);
  for (const std::string text : {"cPcbbbiht", "% Triangulation\n", "{}", "2\n1 1 1 1\n", "", "<regina/>"})
    CHECK_FALSE(looks_like_mesh(text, "f"));
  CHECK(error_of([] { read_soup("cPcbbbiht", "f"); }) ==
        "f:1: found 'cPcbbbiht', expected a mesh: MEDIT, Gmsh, TetGen, VTK, VTU, OBJ, OFF, STL, PLY or "
        "Tetrarch JSON");
  CHECK(error_of([] { write_soup(two_tetrahedra(), MeshFormat::tetgen); }).find(".ele") != std::string::npos);
}

TEST_CASE("meshes of kinds that are not read are called by their names", "[bad][mesh]") {
  const auto complaint = [](const std::string& text, const std::string& name) {
    return error_of([&] { read_soup(text, name); });
  };
  // As Gambit, Abaqus, Nastran's manual, CAD programs, HDF5 and netCDF begin their files.
  CHECK(complaint("(0 \"GAMBIT to Fluent File\")\n(2 3)\n", "f.msh")
            .starts_with("f.msh:1: this is a Fluent mesh, which is not read"));
  CHECK(complaint("*Heading\n** made by hand\n*Node\n1, 0., 0., 0.\n", "f.inp")
            .starts_with("f.inp:1: this is an Abaqus input file"));
  CHECK(complaint("BEGIN BULK\nGRID,1,,0.,0.,0.\n", "f.bdf")
            .starts_with("f.bdf:1: this is a Nastran bulk data file"));
  CHECK(complaint("ISO-10303-21;\nHEADER;\n", "f.stp").starts_with("f.stp:1: this is a STEP file"));
  CHECK(complaint("\x89HDF\r\n\x1a\n", "f.med").starts_with("f.med:1: this is an HDF5 file, such as Exodus"));
  CHECK(complaint(std::string("CDF\x01\0\0\0\0", 8), "f.exo").starts_with("f.exo:1: this is a netCDF file"));
  // Gmsh's own files that are not right are still told as such.
  CHECK(complaint("$Nodes\n", "f.msh").find("which is not read") == std::string::npos);
}
