// SPDX-License-Identifier: GPL-2.0-or-later
// Mesh files of every format but TetGen's: what was read survives writing and reading, validation survives
// anything, what is repaired needs no more repair, and what is valid can be triangulated; of surfaces
// likewise, and their boundary loops can be told.
#include "fuzz.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/doctor/validate.hpp"
#include "tetrarch/doctor/validate_surface.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/surface/boundary_loops.hpp"

#include <algorithm>

namespace {

using namespace tetrarch;

/// Gmsh's files have elements by their labels, and so in another order.
bool are_equal(const format::Soup& a, const format::Soup& b, bool in_order) {
  if (in_order) return a.tetrahedra == b.tetrahedra && a.triangles == b.triangles;
  const auto sorted = [](auto cells) {
    std::sort(cells.begin(), cells.end());
    return cells;
  };
  return sorted(a.tetrahedra) == sorted(b.tetrahedra) && sorted(a.triangles) == sorted(b.triangles);
}

void require_round_trips(const format::Soup& soup) {
  using enum format::MeshFormat;
  for (const format::MeshFormat form : {medit, gmsh, vtk, vtu}) {
    const std::string text = format::write_soup(soup, form);
    try {
      const format::Soup back = format::read_soup(text, "written");
      fuzz::require(are_equal(back, soup, form != gmsh) && format::write_soup(back, form) == text,
                    "read(write(soup)) == soup", text);
    } catch (const InputError& error) {
      // Gmsh's files cannot name a point that is not there.
      fuzz::require(form == gmsh, "what was written can be read", text, error.what());
    }
  }
}

void check_surface(const format::Soup& soup) {
  const doctor::Report report = doctor::validate_surface(soup);
  const doctor::Repaired repaired = doctor::repair(soup);
  fuzz::require(report.count(doctor::Kind::index_out_of_range) > 0 ||
                    doctor::validate_surface(repaired.soup).count(doctor::Severity::repairable) == 0,
                "what is repaired needs no more repair");
  const surface::TriangleMesh made = doctor::build_surface(repaired.soup);
  fuzz::require(static_cast<int>(surface::boundary_loops(made).size()) ==
                    surface::type_of(made.surface).boundary_curves,
                "every boundary curve is a loop");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const format::Soup soup = format::read_soup(fuzz::as_text(data, size), "fuzz");
    require_round_trips(soup);
    if (soup.tetrahedra.empty()) {
      check_surface(soup);
      return 0;
    }
    const doctor::Report report = doctor::validate(soup);
    const doctor::Repaired repaired = doctor::repair(soup);
    fuzz::require(report.count(doctor::Kind::index_out_of_range) > 0 ||
                      doctor::validate(repaired.soup).count(doctor::Severity::repairable) == 0,
                  "what is repaired needs no more repair");
    const Triangulation tri = solid::triangulation_of(doctor::build(repaired.soup));
    fuzz::require(is_valid(Skeleton(tri)), "what is valid becomes a manifold");
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
  return 0;
}
