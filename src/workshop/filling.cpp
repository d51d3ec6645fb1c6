// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/filling.hpp"

#include "hexahedra_facts.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/doctor/validate.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/polycube/cells.hpp"
#include "tetrarch/tetgen/fill.hpp"
#include "tetrarch/workshop/text.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

namespace tetrarch::workshop {
namespace {

using Found = const FilledSolid&;

/// Why there is nothing better.
std::string ending_of(Found f) {
  const hex::Search& search = f.search;
  const std::string tried = counted(search.grids, f.is_from_polycube ? "polycube" : "grid") +
                            " tried, the last of edges " + rounded(search.finest_edge) + ", and none finer: ";
  if (f.has_stuck_folds) return tried + "folds of two maps stay";
  switch (search.ending) {
  case hex::Ending::good:
    break;
  case hex::Ending::finest:
    return tried + "its edges would be shorter than a third of the first " +
           (f.is_from_polycube ? "polycube's" : "grid's");
  case hex::Ending::effort:
    return tried + "it would take more than is spent on this wish; wish for more cells";
  case hex::Ending::memory:
    return tried + "it would take more memory than is allowed";
  }
  return tried + "the result is good";
}

const char* name_of(polycube::Fault::Kind kind) {
  switch (kind) {
  case polycube::Fault::Kind::opposite:
    break;
  case polycube::Fault::Kind::corner:
    return "invalid corner";
  case polycube::Fault::Kind::few_corners:
    return "chart of less than four corners";
  case polycube::Fault::Kind::turning_point:
    return "turning point";
  }
  return "opposite labels side by side";
}

const char* name_of(hex::Ending ending) {
  switch (ending) {
  case hex::Ending::good:
    break;
  case hex::Ending::finest:
    return "finest";
  case hex::Ending::effort:
    return "effort";
  case hex::Ending::memory:
    return "memory";
  }
  return "good";
}

Tree labels_tree(const polycube::Labeling& labeling) {
  const int turning_points = polycube::count(labeling.faults, polycube::Fault::Kind::turning_point);
  Tree tree = Tree::object();
  tree["charts"] = labeling.charts;
  tree["corners"] = labeling.corners;
  tree["turning_points"] = turning_points;
  tree["other_faults"] = static_cast<int>(labeling.faults.size()) - turning_points;
  return tree;
}

bool has_polycube(Found f) {
  return f.polycube.has_value();
}

/// The faults of the labels, with places.
std::string faults_text(const std::vector<polycube::Fault>& faults) {
  std::vector<std::string> texts;
  constexpr std::size_t most = 10;
  for (const polycube::Fault& fault : faults) {
    if (texts.size() == most) {
      texts.push_back("and " + std::to_string(faults.size() - most) + " more");
      break;
    }
    texts.push_back(std::string(name_of(fault.kind)) + " at " + text_of(fault.at));
  }
  return joined(texts, ", ");
}

/// Why there is no polycube to begin with.
std::vector<std::string> polycube_doubts(Found f) {
  if (!f.polycube) return {"no polycube: the equations of its map cannot be solved in double precision"};
  const SolidPolycube& p = *f.polycube;
  std::vector<std::string> result;
  if (!p.labeling.faults.empty()) result.push_back("no valid labeling: " + faults_text(p.labeling.faults));
  if (!p.polycube.flipped.empty()) {
    const auto& corners = p.polycube.labeled.solid.corners(p.polycube.flipped.front());
    result.push_back("the map to the polycube flips " +
                     counted(static_cast<long long>(p.polycube.flipped.size()), "tetrahedron") +
                     ", the first at " + text_of(p.polycube.labeled.solid.point(corners[0])));
  }
  return result;
}

/// Each hexahedron would like to be the box of its mean lengths.
hex::SizedHexahedra sized(product::HexMesh mesh) {
  hex::SizedHexahedra result{std::move(mesh), {}};
  // Edges along the first, second and third direction.
  constexpr std::array<std::array<std::array<int, 2>, 4>, 3> along{{{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}},
                                                                    {{{0, 3}, {1, 2}, {4, 7}, {5, 6}}},
                                                                    {{{0, 4}, {1, 5}, {2, 6}, {3, 7}}}}};
  for (const product::Hexahedron& h : result.mesh.hexahedra) {
    hex::Lengths& lengths = result.lengths.emplace_back();
    for (std::size_t a = 0; a < 3; ++a)
      for (const auto& [from, to] : along[a])
        lengths[a] += numeric::distance(result.mesh.points[h[from]], result.mesh.points[h[to]]) / 4;
  }
  return result;
}

bool is_there(Found f) {
  return f.search.best.has_value();
}

} // namespace

product::Solid solid_of(format::Soup soup, const Progress& progress) {
  if (soup.tetrahedra.empty() && !soup.triangles.empty()) soup = tetgen::fill(soup, progress);
  return product::solid_of(doctor::build(std::move(soup)));
}

std::vector<std::string> FilledSolid::doubts() const {
  if (!search.best && is_from_polycube) {
    std::vector<std::string> result = polycube_doubts(*this);
    result.push_back(ending_of(*this));
    return result;
  }
  if (!search.best)
    return {"no grid has the shape of the solid, genus " + std::to_string(search.genus) +
                ": parts or gaps of it are thinner than the cells",
            ending_of(*this)};
  std::vector<std::string> result;
  const hex::Filling& filling = *search.best;
  const auto& quality = filling.quality;
  if (!quality.bad.empty())
    result.push_back(counted(static_cast<long long>(quality.bad.size()), "hexahedron") +
                     " inverted or flat, the worst " + text_of(quality.worst.front()));
  if (!(std::abs(filling.volume_ratio() - 1) <= options.volume_tolerance))
    result.push_back("the volume is " + rounded(filling.volume) + " and that of the solid " +
                     rounded(filling.solid_volume) + ", off by more than the tolerance of " +
                     rounded(options.volume_tolerance));
  if (!(filling.deviation.relative() <= options.hausdorff_tolerance))
    result.push_back("the surface is " + rounded(filling.deviation.relative()) + " of the diagonal away at " +
                     text_of(filling.deviation.at()) + ", more than the tolerance of " +
                     rounded(options.hausdorff_tolerance));
  if (!result.empty()) result.push_back(ending_of(*this));
  return result;
}

Verdict FilledSolid::verdict() const {
  return doubts().empty() ? Verdict::yes : Verdict::undecided;
}

FilledSolid filled_solid(const product::Solid& solid, const hex::FillOptions& options,
                         const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  FilledSolid result{hex::search(solid, options, progress), options, 0};
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

double polycube_edge_for(const product::Solid& solid, std::int64_t cells) {
  return std::cbrt(product::volume(solid) / static_cast<double>(cells));
}

FilledSolid polycube_filled_solid(const product::Solid& solid, const hex::FillOptions& options,
                                  const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  FilledSolid result;
  result.options = options;
  if (!options.edge) result.options.edge = polycube_edge_for(solid, options.cells.value_or(hex::usual_cells));
  result.is_from_polycube = true;
  polycube::Polycubes polycubes(solid, progress);
  std::map<double, SolidPolycube> tried;
  int failures = 0;
  int scales = 0;
  double last_edge = 0;
  const auto cubes = [&](double edge, const Progress& inner) -> std::optional<hex::SizedHexahedra> {
    // Where two scales had folds that stay, others hardly do better.
    constexpr int most_failures = 2;
    if (failures == most_failures) {
      result.has_stuck_folds = true;
      return std::nullopt;
    }
    ++scales;
    last_edge = edge;
    std::optional<polycube::Polycubes::Found> found = polycubes.at(edge, inner);
    if (!found || !found->polycube.flipped.empty()) ++failures;
    if (!found) return std::nullopt;
    const SolidPolycube& made =
        tried
            .insert_or_assign(edge, SolidPolycube{*found->labeling, std::move(found->polycube), edge,
                                                  static_cast<int>(polycubes.labelings().size())})
            .first->second;
    if (!made.polycube.flipped.empty()) return std::nullopt;
    polycube::Cells cells = polycube::cells(made.polycube.labeled.solid, made.polycube.labeled.image, inner);
    return sized(std::move(cells.mesh));
  };
  result.search = hex::search(solid, cubes, result.options, progress);
  result.search.grids = scales;
  result.search.finest_edge = last_edge;
  // The last try has the shortest edges.
  if (result.search.best)
    result.polycube = std::move(tried.at(result.search.best->edge));
  else if (!tried.empty())
    result.polycube = std::move(tried.begin()->second);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Rows rows_of(const FilledSolid& found) {
  Rows rows;
  if (found.polycube) {
    const SolidPolycube& p = *found.polycube;
    rows.emplace_back("labels", counted(p.labeling.charts, "chart") + ", " +
                                    counted(p.labeling.corners, "corner") + ", " +
                                    counted(static_cast<long long>(p.labeling.faults.size()), "fault"));
    rows.emplace_back("polycube map", std::to_string(p.polycube.flipped.size()) + " flipped of " +
                                          counted(p.polycube.labeled.solid.size(), "tetrahedron"));
  }
  if (!found.search.best) {
    rows.emplace_back("hexahedra", "none");
    return rows;
  }
  const hex::Filling& f = *found.search.best;
  const Rows of_hexahedra{
      {"hexahedra", std::to_string(f.mesh.hexahedra.size())},
      {"inverted", std::to_string(f.quality.bad.size())},
      {"scaled Jacobian", "least " + fixed(f.quality.minimum, 4) + ", mean " + fixed(f.quality.mean, 4) +
                              ", below 0.2: " + std::to_string(count_below_good(f.quality))},
      {"volume", rounded(f.volume) + ", of the solid " + rounded(f.solid_volume) + ", ratio " +
                     fixed(f.volume_ratio(), 6)},
      {"Hausdorff distance",
       scientific(f.deviation.relative(), 2) + " of the diagonal, at " + text_of(f.deviation.at())},
      {"edge", rounded(f.edge)},
      {"ridges", std::to_string(f.ridges) + " kept of " + std::to_string(f.ridges_of_solid)},
      {"worst", text_of(f.quality.worst)}};
  rows.insert(rows.end(), of_hexahedra.begin(), of_hexahedra.end());
  return rows;
}

format::MeshDocument document_of(const FilledSolid& found) {
  if (!found.search.best) throw PreconditionError("document_of: there are no hexahedra");
  return document_of(found.search.best->mesh, found.search.best->quality.scaled_jacobian);
}

format::MeshDocument document_of(const SolidPolycube& polycube) {
  const polycube::LabeledSolid& labeled = polycube.polycube.labeled;
  format::Soup soup;
  soup.points = labeled.image;
  soup.tetrahedra = labeled.solid.mesh.tetrahedra;
  for (int t = 0; t < labeled.solid.boundary.triangle_count(); ++t) {
    soup.triangles.push_back(
        {labeled.solid.corner(t, 0), labeled.solid.corner(t, 1), labeled.solid.corner(t, 2)});
    soup.triangle_tags.push_back(labeled.label[t] + 1);
  }
  format::MeshDocument document = format::mesh_document_of(std::move(soup));
  document.fields.push_back(
      format::field_of("solid", format::MeshField::On::vertices, labeled.solid.mesh.points));
  return document;
}

template <>
const FieldList<FilledSolid>& fields_of<FilledSolid>() {
  static const FieldList<FilledSolid> fields{
      {{"labels", "", "axes as labels of the boundary: charts, corners, turning_points, other_faults",
        type::object({{"charts", type::integer},
                      {"corners", type::integer},
                      {"turning_points", type::integer},
                      {"other_faults", type::integer}})},
       [](Found f) { return labels_tree(f.polycube->labeling); },
       has_polycube},
      {{"flipped", "", "tetrahedra that the map to the polycube turns over", type::integer},
       [](Found f) -> Tree { return f.polycube->polycube.flipped.size(); },
       has_polycube},
      {{"hexahedra", "", "how many; 0: none were made", type::integer},
       [](Found f) -> Tree { return f.search.best ? f.search.best->mesh.hexahedra.size() : 0; }},
      {{"inverted", "", "hexahedra of scaled Jacobian 0 or less", type::integer},
       [](Found f) -> Tree { return f.search.best->quality.bad.size(); },
       is_there},
      {{"min_scaled_jacobian", "", "the least of all hexahedra, in [-1, 1]", type::number},
       [](Found f) -> Tree { return f.search.best->quality.minimum; },
       is_there},
      {{"mean_scaled_jacobian", "", "the mean over all hexahedra", type::number},
       [](Found f) -> Tree { return f.search.best->quality.mean; },
       is_there},
      {{"below_0.2", "", "hexahedra of lesser scaled Jacobian", type::integer},
       [](Found f) -> Tree { return count_below_good(f.search.best->quality); },
       is_there},
      {{"histogram", "", "hexahedra of scaled Jacobian in [-1, -0.9), ... [0.9, 1]",
        type::list(type::integer)},
       [](Found f) -> Tree { return f.search.best->quality.histogram; },
       is_there},
      {{"worst", "", "the ten of least scaled Jacobian: hexahedron, scaled_jacobian, at",
        bad_hexahedra_type()},
       [](Found f) { return tree_of(f.search.best->quality.worst); },
       is_there},
      {{"volume_ratio", "", "volume of the hexahedra over that of the solid", type::number},
       [](Found f) -> Tree { return f.search.best->volume_ratio(); },
       is_there},
      {{"hausdorff", "diagonal of the box", "greatest distance between the surfaces, either way; sampled",
        type::number},
       [](Found f) -> Tree { return f.search.best->deviation.relative(); },
       is_there},
      {{"hausdorff_from_hexahedra", "diagonal of the box", "the same from the hexahedra to the solid",
        type::number},
       [](Found f) -> Tree {
         return f.search.best->deviation.from_hexahedra / f.search.best->deviation.diagonal;
       },
       is_there},
      {{"hausdorff_from_solid", "diagonal of the box", "the same from the solid to the hexahedra",
        type::number},
       [](Found f) -> Tree {
         return f.search.best->deviation.from_solid / f.search.best->deviation.diagonal;
       },
       is_there},
      {{"hausdorff_at", "", "the point where the distance is greatest", type::list(type::number, 3)},
       [](Found f) -> Tree { return f.search.best->deviation.at(); },
       is_there},
      {{"edge", "", "distance of the planes of the grid", type::number},
       [](Found f) -> Tree { return f.search.best->edge; },
       is_there},
      {{"ridges", "", "sharp ridges of the solid that edges of hexahedra follow", type::integer},
       [](Found f) -> Tree { return f.search.best->ridges; },
       is_there},
      {{"ridges_of_solid", "", "sharp ridges that the solid has", type::integer},
       [](Found f) -> Tree { return f.search.best->ridges_of_solid; },
       is_there},
      {{"grids", "", "grids or polycubes tried, one finer than the other", type::integer},
       [](Found f) -> Tree { return f.search.grids; }},
      {{"ended_by", "",
        "why no finer grid was tried: good, finest, effort, memory, or folds of the map to a polycube",
        type::one_of({"good", "finest", "effort", "memory", "folds"})},
       [](Found f) -> Tree { return f.has_stuck_folds ? "folds" : name_of(f.search.ending); }},
      {{"doubts", "", "why the status is 4, one text each", type::list(type::text)},
       [](Found f) -> Tree { return f.doubts(); }},
      {{"seconds", "seconds", "time taken", type::number}, [](Found f) -> Tree { return f.seconds; }},
  };
  return fields;
}

} // namespace tetrarch::workshop
