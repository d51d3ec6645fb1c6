// SPDX-License-Identifier: GPL-2.0-or-later
#include "content.hpp"
#include "job.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/embed/domain.hpp"
#include "tetrarch/embed/mobius.hpp"
#include "tetrarch/moves/log.hpp"
#include "tetrarch/workshop/canonical.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"
#include "tetrarch/workshop/identify.hpp"
#include "tetrarch/workshop/info.hpp"
#include "tetrarch/workshop/structure.hpp"

#include <algorithm>
#include <complex>
#include <functional>
#include <pybind11/complex.h>
#include <pybind11/stl.h>

namespace tetrarch::python {
namespace {

using workshop::Cells;
using workshop::Structure;

/// Bound values are shared, so that arrays may look into them.
struct Solved {
  std::shared_ptr<const Structure> value;
};
struct Canonized {
  std::shared_ptr<const Cells> value;
};

/// "yes", "no", "undecided".
const char* word_of(workshop::Verdict verdict) {
  if (verdict == workshop::Verdict::yes) return "yes";
  return verdict == workshop::Verdict::proved_no ? "no" : "undecided";
}

void require_manifold(const Content& content, const std::string& name) {
  workshop::require_filled(document_in(content), name);
  by_size(size_of(content), [tri = triangulation_in(content), name] {
    workshop::require_manifold(*tri, name);
    return true;
  });
}

// -- structures

/// Up to so many tetrahedra Newton's method takes well below a millisecond, less than another thread takes to
/// wake.
constexpr int most_solved_at_once = 12;

Solved solved(Structure found) {
  return {std::make_shared<const Structure>(std::move(found))};
}

/// First on the given triangulation, as the search itself does. That is all for most, and is done on this
/// thread where it is short.
Solved structure(const Content& content, bool flow, bool as_given, int attempts, std::uint64_t seed,
                 const py::object& report) {
  const auto tri = triangulation_in(content);
  workshop::StructureOptions how;
  how.method = flow ? hyperbolic::Method::flow : hyperbolic::Method::newton;
  how.as_given = as_given;
  how.attempts = attempts;
  how.seed = seed;
  how.marks = document_in(content).marks;
  if (!flow && tri->size() <= most_solved_at_once && attempts >= 1) {
    auto once = how;
    once.as_given = true;
    Solved found = unlocked([&] { return solved(workshop::structure(*tri, once)); });
    if (as_given || found.value->verdict() == workshop::Verdict::yes) return found;
  }
  return interruptible(report, [tri, how](const Progress& progress) {
    return solved(workshop::structure(*tri, how, progress));
  });
}

bool is_found(const Solved& s) {
  return s.value->verdict() == workshop::Verdict::yes;
}

py::object volume(const Solved& s) {
  if (!is_found(s)) return py::none();
  return py::float_(s.value->search.structure.volume);
}

py::array dihedral_angles(const Solved& s) {
  const auto& angles = s.value->search.structure.dihedral_angles;
  const double* const first = angles.empty() ? nullptr : angles.front().data();
  return view<double>(first, {length(angles.size()), 6}, s.value);
}

py::array edge_lengths(const Solved& s) {
  const std::vector<double>& lengths = s.value->search.structure.lengths.values();
  return view<double>(lengths.data(), {length(lengths.size())}, s.value);
}

py::list cusps(const Solved& s) {
  py::list list;
  for (const hyperbolic::Cusp& cusp : s.value->cusps)
    list.append(py::make_tuple(cusp.vertex.value, cusp.orientable, cusp.shape, cusp.area));
  return list;
}

// -- cells and isometries

workshop::CanonicalOptions canonical_options(int attempts, std::uint64_t seed) {
  return {attempts, seed};
}

Canonized cells(const Content& content, int attempts, std::uint64_t seed, const py::object& report) {
  return interruptible(report, [tri = triangulation_in(content),
                                how = canonical_options(attempts, seed)](const Progress& progress) {
    return Canonized{std::make_shared<const Cells>(workshop::cells(*tri, how, progress))};
  });
}

/// (images of tetrahedra, images of their vertices).
py::tuple images_of(const Isomorphism& map) {
  py::list perms;
  for (const Perm4 p : map.perm) perms.append(py::make_tuple(p[0], p[1], p[2], p[3]));
  return py::make_tuple(py::tuple(py::cast(map.tet)), py::tuple(perms));
}

const Triangulation& canonical_triangulation(const Canonized& c) {
  if (!c.value->canonical) throw PreconditionError("there are no canonical cells");
  return c.value->canonical->canonical_triangulation;
}

py::list isometries(const Canonized& a, const Canonized& b) {
  const auto maps =
      unlocked([&] { return isomorphisms(canonical_triangulation(a), canonical_triangulation(b)); });
  py::list list;
  for (const Isomorphism& map : maps) list.append(images_of(map));
  return list;
}

py::object orientation_of(const Canonized& c) {
  return py::cast(orientation(canonical_triangulation(c)));
}

py::tuple isometry(const Content& x, const Content& y, const std::string& name_x, const std::string& name_y,
                   int attempts, std::uint64_t seed, const py::object& report) {
  const workshop::Isometry found =
      interruptible(report, [tri_x = triangulation_in(x), tri_y = triangulation_in(y), name_x, name_y,
                             how = canonical_options(attempts, seed)](const Progress& progress) {
        return workshop::isometry({*tri_x, name_x}, {*tri_y, name_y}, how, progress);
      });
  return py::make_tuple(word_of(found.verdict()), object_of(tree_of(found)), text_of(found));
}

py::tuple identify(const Content& content, int attempts, std::uint64_t seed, const py::object& report) {
  const identify::Identification found =
      interruptible(report, [tri = triangulation_in(content), attempts, seed](const Progress& p) {
        return identify::identify(*tri, {seed, attempts}, p);
      });
  return py::make_tuple(word_of(workshop::verdict_of(found)), object_of(workshop::tree_of(found)));
}

// -- algebra

workshop::Info info(const Content& content, bool brief, const py::object& report) {
  return interruptible(report, [value = content.value, brief](const Progress& progress) {
    const format::Document& document = document_in(Content{value});
    return workshop::info(document.triangulation, document.name, brief, progress);
  });
}

std::string homology(const Content& content, int k, bool relative) {
  return by_size(size_of(content), [tri = triangulation_in(content), k, relative] {
    const Skeleton skeleton(*tri);
    return relative ? algebra::relative_homology(*tri, skeleton, k).str()
                    : algebra::homology(*tri, skeleton, k).str();
  });
}

py::list fundamental_groups(const Content& content, bool as_read, const py::object& report) {
  const auto groups =
      interruptible(report, [tri = triangulation_in(content), as_read](const Progress& progress) {
        workshop::require_manifolds(*tri, "the triangulation");
        return workshop::fundamental_groups(*tri, as_read, progress);
      });
  py::list list;
  for (const workshop::ComponentGroup& g : groups)
    list.append(py::make_tuple(g.group.generators, g.group.relators));
  return list;
}

// -- combinatorics

py::array_t<int> per_tetrahedron(const Skeleton& skeleton, int width,
                                 const std::function<int(int, int)>& number) {
  std::vector<int> numbers;
  numbers.reserve(static_cast<std::size_t>(skeleton.tetrahedron_count()) * static_cast<std::size_t>(width));
  for (int t = 0; t < skeleton.tetrahedron_count(); ++t)
    for (int k = 0; k < width; ++k) numbers.push_back(number(t, k));
  return owned(std::move(numbers), {skeleton.tetrahedron_count(), width});
}

py::dict skeleton(const Content& content) {
  const auto tri = triangulation_in(content);
  const Skeleton s = by_size(size_of(content), [tri] { return Skeleton(*tri); });
  py::dict made;
  made["neighbors"] = per_tetrahedron(s, 4, [&](int t, int f) { return tri->gluing({t, f}).tet; });
  made["permutations"] = per_tetrahedron(s, 16, [&](int t, int k) {
    return tri->is_boundary({t, k / 4}) ? -1 : tri->gluing({t, k / 4}).perm[k % 4];
  });
  made["face_of"] = per_tetrahedron(s, 4, [&](int t, int f) { return s.face({t, f}).value; });
  made["edge_of"] = per_tetrahedron(s, 6, [&](int t, int e) { return s.edge({t, e}).value; });
  made["vertex_of"] = per_tetrahedron(s, 4, [&](int t, int v) { return s.vertex({t, v}).value; });
  std::vector<int> valences;
  for (const EdgeId e : all<EdgeId>(s.edge_count())) valences.push_back(s.valence(e));
  made["valences"] = owned(std::move(valences), {s.edge_count()});
  py::list links;
  for (const VertexId v : all<VertexId>(s.vertex_count())) links.append(s.link(v).str());
  made["links"] = links;
  made["faces"] = s.face_count();
  made["edges"] = s.edge_count();
  made["vertices"] = s.vertex_count();
  made["boundary_faces"] = s.boundary_face_count();
  made["components"] = s.component_count();
  made["orientable"] = s.is_orientable();
  return made;
}

/// The class numbers in the skeleton by the names in the complex.
template <class NameOf, class NumberOf>
std::vector<int> numbers_by_name(const Triangulation& tri, int width, const NameOf& name_of,
                                 const NumberOf& number_of) {
  std::vector<int> number;
  for (int t = 0; t < tri.size(); ++t)
    for (int k = 0; k < width; ++k) {
      const auto name = static_cast<std::size_t>(name_of(t, k));
      if (name >= number.size()) number.resize(name + 1, -1);
      number[name] = number_of(t, k);
    }
  return number;
}

int at(const std::vector<int>& list, int index) {
  return index >= 0 && index < static_cast<int>(list.size()) ? list[static_cast<std::size_t>(index)] : -1;
}

struct Moved {
  Triangulation tri = Triangulation();
  std::vector<int> tetrahedra, vertices, edges, made;
  std::vector<std::pair<int, int>> split_vertices, split_edges;
};

/// One move, and how everything is called after it.
std::optional<moves::Obstacle> make_move(const Triangulation& tri, const moves::Move& move, Moved& result) {
  moves::Complex complex(tri);
  if (move.kind != moves::MoveKind::pack && move.tet >= tri.size())
    throw InputError("there is no tetrahedron " + std::to_string(move.tet) + " (there are " +
                     std::to_string(tri.size()) + ")");
  const Skeleton before(tri);
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
  for (const VertexId v : all<VertexId>(before.vertex_count()))
    vertices.push_back(complex.vertex(before.preimages(v).front()));
  for (const EdgeId e : all<EdgeId>(before.edge_count())) {
    const Walk& w = before.around(e).front();
    edges.push_back(complex.edge(DirectedTetEdge{w.tet, w.from(), w.to()}));
  }
  if (const auto obstacle = moves::apply(complex, move)) return obstacle;
  const std::vector<int> gone = complex.last_change().removed_tets;
  const std::vector<int> fresh = complex.last_change().new_tets;
  const auto parted_vertices = complex.last_change().split_vertices;
  const auto parted_edges = complex.last_change().split_edges;
  const moves::Complex::Renaming names = complex.pack();
  result.tri = complex.triangulation();
  const Skeleton after(result.tri);
  for (int t = 0; t < tri.size(); ++t)
    result.tetrahedra.push_back(
        std::find(gone.begin(), gone.end(), t) != gone.end() ? -1 : names.tet[static_cast<std::size_t>(t)]);
  for (const int t : fresh) result.made.push_back(names.tet[static_cast<std::size_t>(t)]);
  const auto vertex_numbers = numbers_by_name(
      result.tri, 4,
      [&](int t, int v) {
        return complex.vertex(TetVertex{t, v}).value;
      },
      [&](int t, int v) {
        return after.vertex({t, v}).value;
      });
  const auto edge_numbers = numbers_by_name(
      result.tri, 6,
      [&](int t, int e) {
        return complex.edge(TetEdge{t, e}).value;
      },
      [&](int t, int e) {
        return after.edge({t, e}).value;
      });
  for (const VertexId v : vertices) result.vertices.push_back(at(vertex_numbers, names.vertex[v].value));
  for (const EdgeId e : edges) result.edges.push_back(at(edge_numbers, names.edge[e].value));
  for (const auto& [whole, part] : parted_vertices)
    result.split_vertices.emplace_back(at(vertex_numbers, names.vertex[whole].value),
                                       at(vertex_numbers, names.vertex[part].value));
  for (const auto& [whole, part] : parted_edges)
    result.split_edges.emplace_back(at(edge_numbers, names.edge[whole].value),
                                    at(edge_numbers, names.edge[part].value));
  return std::nullopt;
}

py::tuple moved(const Content& content, const std::string& line) {
  const auto tri = triangulation_in(content);
  Moved result;
  const auto obstacle = unlocked([&] { return make_move(*tri, moves::parse_move(line), result); });
  if (obstacle) return py::make_tuple(moves::to_string(*obstacle), content);
  return py::make_tuple(py::none(), content_of(std::move(result.tri), document_in(content).name),
                        result.tetrahedra, result.vertices, result.edges, result.made, result.split_vertices,
                        result.split_edges);
}

py::list components_of(const Content& content) {
  const auto tri = triangulation_in(content);
  py::list list;
  for (Triangulation& part : unlocked([&] { return split(*tri, components(*tri)); }))
    list.append(content_of(std::move(part)));
  return list;
}

bool same_gluings(const Content& a, const Content& b) {
  return a.value == b.value || document_in(a).triangulation == document_in(b).triangulation;
}

// -- domains

py::array matrices_of(const std::vector<numeric::Matrix4<double>>& list) {
  std::vector<double> numbers;
  for (const auto& m : list)
    for (const auto& row : m) numbers.insert(numbers.end(), row.begin(), row.end());
  return owned(std::move(numbers), {length(list.size()), 4, 4});
}

py::array mobius_matrices(const std::vector<numeric::Matrix4<double>>& list) {
  std::vector<std::complex<double>> numbers;
  for (const auto& matrix : list) {
    const embed::Mobius<double> m = embed::mobius_of(matrix);
    for (const auto& z : {m.a, m.b, m.c, m.d}) numbers.emplace_back(z.re, z.im);
  }
  return owned(std::move(numbers), {length(list.size()), 2, 2});
}

py::dict domain(const Solved& s, const py::object& report) {
  if (!is_found(s))
    throw PreconditionError("a fundamental domain needs a hyperbolic structure, and none was found");
  const embed::Domain<double> d = interruptible(report, [value = s.value](const Progress& progress) {
    return embed::fundamental_domain(value->search.triangulation, value->skeleton, value->search.structure,
                                     {}, progress);
  });
  py::dict made;
  std::vector<double> places;
  for (const auto& corners : d.vertices)
    for (const auto& v : corners) places.insert(places.end(), v.begin(), v.end());
  made["vertices"] = owned(std::move(places), {length(d.vertices.size()), 4, 4});
  std::vector<numeric::Matrix4<double>> pairings;
  py::list faces;
  for (const auto& face : d.faces) {
    pairings.push_back(face.pairing);
    py::list hexagons;
    for (const TetFace f : face.hexagons) hexagons.append(py::make_tuple(f.tet, f.face));
    faces.append(py::make_tuple(hexagons, face.partner));
  }
  made["pairings"] = matrices_of(pairings);
  made["faces"] = faces;
  made["holonomy"] = matrices_of(d.holonomy);
  made["sl2c"] = mobius_matrices(d.holonomy);
  std::vector<bool> reverses;
  for (const auto& matrix : d.holonomy) reverses.push_back(embed::mobius_of(matrix).reverses);
  made["reverses"] = reverses;
  made["generators"] = d.group.presentation.generators;
  made["relators"] = d.group.presentation.relators;
  return made;
}

} // namespace

void bind_topology(py::module_& module) {
  py::class_<Solved>(module, "Solved")
      .def_property_readonly("verdict", [](const Solved& s) { return word_of(s.value->verdict()); })
      .def_property_readonly("volume", volume)
      .def_property_readonly("dihedral_angles", dihedral_angles)
      .def_property_readonly("edge_lengths", edge_lengths)
      .def_property_readonly("cusps", cusps)
      .def("tree", [](const Solved& s) { return object_of(workshop::tree_of(*s.value)); })
      .def("document", [](const Solved& s) { return content_of(workshop::document_of(*s.value)); })
      .def("domain", domain);
  py::class_<Canonized>(module, "Canonized")
      .def_property_readonly("verdict", [](const Canonized& c) { return word_of(c.value->verdict()); })
      .def("tree", [](const Canonized& c) { return object_of(workshop::tree_of(*c.value)); })
      .def("triangulation", [](const Canonized& c) { return content_of(canonical_triangulation(c)); })
      .def("orientation", orientation_of)
      .def("isometries_to", isometries);
  module.def("require_manifold", require_manifold);
  module.def("structure", structure);
  module.def("cells", cells);
  module.def("isometry", isometry);
  module.def("identify", identify);
  module.def("info", [](const Content& c, bool brief, const py::object& report) {
    return object_of(workshop::tree_of(info(c, brief, report)));
  });
  module.def("homology", homology);
  module.def("fundamental_groups", fundamental_groups);
  module.def("skeleton", skeleton);
  module.def("moved", moved);
  module.def("components", components_of);
  module.def("same_gluings", same_gluings);
  module.def("stored_tables", [](bool orientable) {
    std::vector<int> found;
    for (const catalogue::TableKey table : catalogue::stored_tables())
      if (table.orientable == orientable) found.push_back(table.tetrahedra);
    return found;
  });
  module.def("table_text", [](int tetrahedra, bool orientable) {
    catalogue::require_table({tetrahedra, orientable});
    return std::string(catalogue::stored_table_text({tetrahedra, orientable}));
  });
}

} // namespace tetrarch::python
