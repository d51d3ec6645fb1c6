// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/mesh_files.hpp"

#include "mesh_cursor.hpp"

#include "tetrarch/format/gmsh.hpp"
#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/new_files.hpp"
#include "tetrarch/format/surface_files.hpp"
#include "tetrarch/format/tetgen.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/format/vtk.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace tetrarch::format {
namespace {

/// A declaration and comments may stand before the first element of an XML file, but not more than this.
constexpr std::size_t xml_head = 4096;

constexpr std::string_view any_mesh =
    "a mesh: MEDIT, Gmsh, TetGen, VTK, VTU, OBJ, OFF, STL, PLY or Tetrarch JSON";

struct Row {
  MeshFormat format;
  std::string_view name;
  std::string_view extension;
};
constexpr std::array<Row, 12> format_rows{{{MeshFormat::medit, "medit", ".mesh"},
                                           {MeshFormat::meshb, "meshb", ".meshb"},
                                           {MeshFormat::gmsh, "gmsh", ".msh"},
                                           {MeshFormat::tetgen, "tetgen", ".node"},
                                           {MeshFormat::tetgen, "tetgen", ".ele"},
                                           {MeshFormat::vtk, "vtk", ".vtk"},
                                           {MeshFormat::vtu, "vtu", ".vtu"},
                                           {MeshFormat::vtu, "vtu", ".vtp"},
                                           {MeshFormat::obj, "obj", ".obj"},
                                           {MeshFormat::off, "off", ".off"},
                                           {MeshFormat::stl, "stl", ".stl"},
                                           {MeshFormat::ply, "ply", ".ply"}}};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "OFF", letters that say what points have besides before it, a number glued to it.
bool is_off_header(std::string_view word) {
  const std::size_t at = word.find("OFF");
  if (at == std::string_view::npos) return false;
  return word.substr(0, at).find_first_not_of("STCNn4") == std::string_view::npos &&
         word.substr(at + 3).find_first_not_of("0123456789") == std::string_view::npos;
}

std::optional<MeshFormat> recognise_word(std::string_view word) {
  if (word == "MeshVersionFormatted") return MeshFormat::medit;
  if (is_one_of(word, {"$MeshFormat", "$Comments", "$NOD"})) return MeshFormat::gmsh;
  if (word == "ply") return MeshFormat::ply;
  if (capitals(word) == "SOLID") return MeshFormat::stl;
  if (is_off_header(word)) return MeshFormat::off;
  if (is_one_of(word, {"v", "vn", "vt", "o", "g", "s", "mtllib", "usemtl"})) return MeshFormat::obj;
  return std::nullopt;
}

/// The first word that is no comment; empty if there is none.
std::string_view first_mesh_word(std::string_view text) {
  TextCursor in(text, "");
  while (!in.at_end() && in.next_char() == '#') in.rest_of_line();
  return in.peek();
}

/// A mesh or a shape of a kind that is not read here, by how its text begins; nothing: of no kind that is
/// known.
std::optional<std::string_view> kind_that_is_not_read(std::string_view text) {
  struct Kind {
    std::string_view beginning;
    std::string_view name;
  };
  constexpr std::array kinds{Kind{"(0 ", "a Fluent mesh"},
                             Kind{"(2 ", "a Fluent mesh"},
                             Kind{"*HEADING", "an Abaqus input file"},
                             Kind{"*NODE", "an Abaqus input file"},
                             Kind{"*KEYWORD", "an LS-DYNA keyword file"},
                             Kind{"BEGIN BULK", "a Nastran bulk data file"},
                             Kind{"CEND", "a Nastran bulk data file"},
                             Kind{"GRID", "a Nastran bulk data file"},
                             Kind{"ISO-10303-21", "a STEP file"},
                             Kind{"\x89HDF", "an HDF5 file, such as Exodus, CGNS or MED"},
                             Kind{"CDF", "a netCDF file, such as Exodus"},
                             Kind{"glTF", "a binary glTF file"}};
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const std::string head = capitals(text.substr(std::min(start, text.size()), 16));
  for (const Kind& kind : kinds)
    if (head.starts_with(capitals(kind.beginning))) return kind.name;
  return std::nullopt;
}

/// The paths of both files, whichever is given.
struct TetgenPaths {
  std::string node;
  std::string ele;
  std::string face;
};
TetgenPaths tetgen_paths(const std::string& path) {
  const std::string stem = path.substr(0, path.rfind('.'));
  if (has_extension(path, ".ele")) return {stem + ".node", path, stem + ".face"};
  return {path, stem + ".ele", stem + ".face"};
}

} // namespace

std::string name_of(MeshFormat format) {
  for (const Row& row : format_rows)
    if (row.format == format) return std::string(row.name);
  if (format == MeshFormat::json) return "json";
  throw PreconditionError("no such mesh format");
}

std::optional<MeshFormat> mesh_format_for_extension(std::string_view path) {
  for (const Row& row : format_rows)
    if (has_extension(path, row.extension)) return row.format;
  return std::nullopt;
}

std::optional<MeshFormat> recognise_mesh(std::string_view text, const std::string& source) {
  if (is_binary_stl(text)) return MeshFormat::stl;
  if (is_binary_medit(text)) return MeshFormat::meshb;
  text = without_byte_order_mark(text);
  constexpr std::string_view vtk_mark = "# vtk DataFile";
  if (text.substr(0, vtk_mark.size()) == vtk_mark) return MeshFormat::vtk;
  if (text.substr(0, xml_head).find("<VTKFile") != std::string_view::npos) return MeshFormat::vtu;
  const std::string_view word = first_mesh_word(text);
  if (const auto format = recognise_word(word)) return format;
  // Not by the extension, which is that of triangulations too.
  if (!word.empty() && word.front() == '{')
    return looks_like_mesh_json(text) ? std::optional(MeshFormat::json) : std::nullopt;
  if (kind_that_is_not_read(text)) return std::nullopt;
  return mesh_format_for_extension(source);
}

static Soup soup_in(std::string_view text, const std::string& source) {
  const std::optional<MeshFormat> format = recognise_mesh(text, source);
  if (!format) {
    if (const auto kind = kind_that_is_not_read(text))
      throw InputError(Place{source, 1}, "this is " + std::string(*kind) + ", which is not read; expected " +
                                             std::string(any_mesh));
    throw InputError(Place{source, 1}, found_expected(first_mesh_word(text), any_mesh));
  }
  text = without_byte_order_mark(text);
  switch (*format) {
  case MeshFormat::medit:
  case MeshFormat::meshb:
    return read_medit(text, source);
  case MeshFormat::gmsh:
    return read_gmsh(text, source);
  case MeshFormat::tetgen:
    throw InputError(Place{source, 0},
                     "this is half a mesh: TetGen's .node and .ele are read together, as files");
  case MeshFormat::vtk:
    return read_vtk(text, source);
  case MeshFormat::vtu:
    return read_vtu(text, source);
  case MeshFormat::obj:
    return read_obj(text, source);
  case MeshFormat::off:
    return read_off(text, source);
  case MeshFormat::stl:
    return read_stl(text, source);
  case MeshFormat::ply:
    return read_ply(text, source);
  case MeshFormat::json:
    return read_mesh_json(text, source).soup;
  }
  throw PreconditionError("no such mesh format");
}

static Soup soup_in_file(const std::string& path) {
  const std::string source = source_name(path);
  if (mesh_format_for_extension(path) != MeshFormat::tetgen) return read_soup(read_file(path), source);
  const TetgenPaths paths = tetgen_paths(path);
  const bool has_face = std::filesystem::is_regular_file(paths.face);
  return read_tetgen({read_file(paths.node), read_file(paths.ele), paths.node, paths.ele,
                      has_face ? read_file(paths.face) : std::string(), paths.face});
}

namespace {

/// Writers trust indices; a soup promises nothing.
template <class Elements>
void require_in_range(const Soup& soup, const Elements& elements, const Labels& labels,
                      const std::string& name) {
  for (std::size_t k = 0; k < elements.size(); ++k)
    for (const int index : elements[k])
      if (index < 0 || static_cast<std::size_t>(index) >= soup.points.size())
        throw InputError(Place{soup.source, labels.line(static_cast<std::int64_t>(k))},
                         name + " " +
                             std::to_string(labels.number(static_cast<std::int64_t>(k), soup.first_number)) +
                             " names vertex " + std::to_string(point_number(soup, index)) +
                             ", which is none of the " + std::to_string(soup.points.size()) + " there are");
}

bool holds_surfaces_only(MeshFormat format) {
  return format == MeshFormat::obj || format == MeshFormat::off || format == MeshFormat::stl ||
         format == MeshFormat::ply;
}

} // namespace

std::string write_soup(const Soup& soup, MeshFormat format) {
  require_finite(soup);
  require_in_range(soup, soup.tetrahedra, soup.tetrahedron_labels, "tetrahedron");
  require_in_range(soup, soup.triangles, soup.triangle_labels, "triangle");
  if (holds_surfaces_only(format) && soup.triangles.empty() && !soup.tetrahedra.empty())
    throw InputError(Place{soup.source, 0},
                     "there are no triangles, and " + name_of(format) + " holds nothing else");
  switch (format) {
  case MeshFormat::medit:
    return write_medit(soup);
  case MeshFormat::meshb:
    return write_meshb(soup);
  case MeshFormat::gmsh:
    return write_gmsh(soup);
  case MeshFormat::tetgen:
    throw InputError("TetGen's format is two files, .node and .ele, and not one text");
  case MeshFormat::vtk:
    return write_vtk(soup);
  case MeshFormat::vtu:
    return write_vtu(soup);
  case MeshFormat::obj:
    return write_obj(soup);
  case MeshFormat::off:
    return write_off(soup);
  case MeshFormat::stl:
    return write_stl(soup);
  case MeshFormat::ply:
    return write_ply(soup);
  case MeshFormat::json:
    return write_mesh_json(mesh_document_of(soup));
  }
  throw PreconditionError("no such mesh format");
}

Ledger not_held(const Soup& soup, MeshFormat format) {
  Ledger ledger;
  const auto labels = [&ledger](const std::vector<int>& tags, const char* what, bool negative_ones_only) {
    ledger.note(what, std::count_if(tags.begin(), tags.end(), [negative_ones_only](int tag) {
                  return negative_ones_only ? tag < 0 : tag != 0;
                }));
  };
  if (holds_surfaces_only(format)) {
    ledger.note("tetrahedron", static_cast<std::int64_t>(soup.tetrahedra.size()));
    labels(soup.triangle_tags, "label of a triangle", false);
    labels(soup.tetrahedron_tags, "label of a tetrahedron", false);
  } else if (format == MeshFormat::gmsh) {
    labels(soup.triangle_tags, "negative label of a triangle", true);
    labels(soup.tetrahedron_tags, "negative label of a tetrahedron", true);
  }
  return ledger;
}

void write_soup_file(const Soup& soup, const std::string& path) {
  require_finite(soup);
  const std::optional<MeshFormat> format = mesh_format_for_extension(path);
  if (!format)
    throw InputError(Place{path, 0}, "the extension names no mesh format, expected one like .mesh");
  if (*format != MeshFormat::tetgen) return write_file_atomically(path, write_soup(soup, *format));
  const TetgenPaths paths = tetgen_paths(path);
  const TetgenFiles files = write_tetgen(soup);
  std::vector<NewFile> together{{paths.node, files.node}, {paths.ele, files.ele}};
  if (!files.face.empty()) together.push_back({paths.face, files.face});
  write_files_atomically(together);
}

// Whatever the format: what every reader would have to ask is asked once.
Soup read_soup(std::string_view text, const std::string& source) {
  Soup soup = soup_in(text, source);
  require_finite(soup);
  return soup;
}

Soup read_soup_file(const std::string& path) {
  Soup soup = soup_in_file(path);
  require_finite(soup);
  return soup;
}

} // namespace tetrarch::format
