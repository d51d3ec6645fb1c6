// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/filling.hpp"

#include "hexahedra_facts.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/doctor/validate.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/tetgen/fill.hpp"
#include "tetrarch/workshop/text.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace tetrarch::workshop {
namespace {

using Found = const FilledSolid&;

/// Why there is nothing better.
std::string ending_of(const hex::Search& search) {
  const std::string tried = counted(search.grids, "grid") + " tried, the last of edges " +
                            rounded(search.finest_edge) + ", and none finer: ";
  switch (search.ending) {
  case hex::Ending::good:
    break;
  case hex::Ending::finest:
    return tried + "its edges would be shorter than a third of the first grid's";
  case hex::Ending::effort:
    return tried + "it would take more than is spent on this wish; wish for more cells";
  case hex::Ending::memory:
    return tried + "it would take more memory than is allowed";
  }
  return tried + "the result is good";
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

bool is_there(Found f) {
  return f.search.best.has_value();
}

} // namespace

product::Solid solid_of(format::Soup soup, const Progress& progress) {
  if (soup.tetrahedra.empty() && !soup.triangles.empty()) soup = tetgen::fill(soup, progress);
  return product::solid_of(doctor::build(std::move(soup)));
}

std::vector<std::string> FilledSolid::doubts() const {
  if (!search.best)
    return {"no grid has the shape of the solid, genus " + std::to_string(search.genus) +
                ": parts or gaps of it are thinner than the cells",
            ending_of(search)};
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
  if (!result.empty()) result.push_back(ending_of(search));
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

Rows rows_of(const FilledSolid& found) {
  if (!found.search.best) return {{"hexahedra", "none"}};
  const hex::Filling& f = *found.search.best;
  return {{"hexahedra", std::to_string(f.mesh.hexahedra.size())},
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
}

format::MeshDocument document_of(const FilledSolid& found) {
  if (!found.search.best) throw PreconditionError("document_of: there are no hexahedra");
  return document_of(found.search.best->mesh, found.search.best->quality.scaled_jacobian);
}

template <>
const FieldList<FilledSolid>& fields_of<FilledSolid>() {
  static const FieldList<FilledSolid> fields{
      {{"hexahedra", "", "how many; 0: none were made"},
       [](Found f) -> Tree { return f.search.best ? f.search.best->mesh.hexahedra.size() : 0; }},
      {{"inverted", "", "hexahedra of scaled Jacobian 0 or less"},
       [](Found f) -> Tree { return f.search.best->quality.bad.size(); },
       is_there},
      {{"min_scaled_jacobian", "", "the least of all hexahedra, in [-1, 1]"},
       [](Found f) -> Tree { return f.search.best->quality.minimum; },
       is_there},
      {{"mean_scaled_jacobian", "", "the mean over all hexahedra"},
       [](Found f) -> Tree { return f.search.best->quality.mean; },
       is_there},
      {{"below_0.2", "", "hexahedra of lesser scaled Jacobian"},
       [](Found f) -> Tree { return count_below_good(f.search.best->quality); },
       is_there},
      {{"histogram", "", "hexahedra of scaled Jacobian in [-1, -0.9), ... [0.9, 1]"},
       [](Found f) -> Tree { return f.search.best->quality.histogram; },
       is_there},
      {{"worst", "", "the ten of least scaled Jacobian: hexahedron, scaled_jacobian, at"},
       [](Found f) { return tree_of(f.search.best->quality.worst); },
       is_there},
      {{"volume_ratio", "", "volume of the hexahedra over that of the solid"},
       [](Found f) -> Tree { return f.search.best->volume_ratio(); },
       is_there},
      {{"hausdorff", "diagonal of the box", "greatest distance between the surfaces, either way; sampled"},
       [](Found f) -> Tree { return f.search.best->deviation.relative(); },
       is_there},
      {{"hausdorff_from_hexahedra", "diagonal of the box", "the same from the hexahedra to the solid"},
       [](Found f) -> Tree {
         return f.search.best->deviation.from_hexahedra / f.search.best->deviation.diagonal;
       },
       is_there},
      {{"hausdorff_from_solid", "diagonal of the box", "the same from the solid to the hexahedra"},
       [](Found f) -> Tree {
         return f.search.best->deviation.from_solid / f.search.best->deviation.diagonal;
       },
       is_there},
      {{"hausdorff_at", "", "the point where the distance is greatest"},
       [](Found f) -> Tree { return f.search.best->deviation.at(); },
       is_there},
      {{"edge", "", "distance of the planes of the grid"},
       [](Found f) -> Tree { return f.search.best->edge; },
       is_there},
      {{"ridges", "", "sharp ridges of the solid that edges of hexahedra follow"},
       [](Found f) -> Tree { return f.search.best->ridges; },
       is_there},
      {{"ridges_of_solid", "", "sharp ridges that the solid has"},
       [](Found f) -> Tree { return f.search.best->ridges_of_solid; },
       is_there},
      {{"grids", "", "grids tried, one finer than the other"},
       [](Found f) -> Tree { return f.search.grids; }},
      {{"ended_by", "", "why no finer grid was tried: good, finest, effort or memory"},
       [](Found f) -> Tree { return name_of(f.search.ending); }},
      {{"doubts", "", "why the status is 4, one text each"}, [](Found f) -> Tree { return f.doubts(); }},
      {{"seconds", "seconds", "time taken"}, [](Found f) -> Tree { return f.seconds; }},
  };
  return fields;
}

} // namespace tetrarch::workshop
