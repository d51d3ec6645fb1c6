// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/filling.hpp"

#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace tetrarch::workshop {
namespace {

using Found = const FilledSolid&;

/// Solvers are content above this scaled Jacobian.
constexpr double good = 0.2;

std::string text_of(const product::Point& p) {
  return "(" + rounded(p[0]) + ", " + rounded(p[1]) + ", " + rounded(p[2]) + ")";
}

std::string text_of(const product::BadHexahedron& h) {
  return "h" + std::to_string(h.hexahedron) + " " + fixed(h.scaled_jacobian, 4) + " at " + text_of(h.center);
}

long long below(const product::HexQuality& quality, double least) {
  return std::count_if(quality.scaled_jacobian.begin(), quality.scaled_jacobian.end(),
                       [&](double j) { return j < least; });
}

bool is_there(Found f) {
  return f.filling.has_value();
}

Tree places(const std::vector<product::BadHexahedron>& list) {
  Tree result = Tree::array();
  for (const product::BadHexahedron& h : list)
    result.push_back(
        {{"hexahedron", h.hexahedron}, {"scaled_jacobian", h.scaled_jacobian}, {"at", h.center}});
  return result;
}

} // namespace

std::vector<std::string> FilledSolid::doubts() const {
  if (!filling) return {"no grid has the shape of the solid: parts or gaps of it are thinner than the cells"};
  std::vector<std::string> result;
  const auto& quality = filling->quality;
  if (!quality.bad.empty())
    result.push_back(counted(static_cast<long long>(quality.bad.size()), "hexahedron") +
                     " inverted or flat, the worst " + text_of(quality.worst.front()));
  if (!(std::abs(filling->volume_ratio() - 1) <= options.volume_tolerance))
    result.push_back("the volume is " + rounded(filling->volume) + " and that of the solid " +
                     rounded(filling->solid_volume) + ", off by more than the tolerance of " +
                     rounded(options.volume_tolerance));
  if (!(filling->deviation.relative() <= options.hausdorff_tolerance))
    result.push_back("the surface is " + rounded(filling->deviation.relative()) +
                     " of the diagonal away at " + text_of(filling->deviation.at()) +
                     ", more than the tolerance of " + rounded(options.hausdorff_tolerance));
  return result;
}

Verdict FilledSolid::verdict() const {
  return doubts().empty() ? Verdict::yes : Verdict::undecided;
}

FilledSolid filled_solid(const product::Solid& solid, const hex::FillOptions& options,
                         const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  FilledSolid result{hex::fill(solid, options, progress), options, 0};
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Rows rows_of(const FilledSolid& found) {
  if (!found.filling) return {{"hexahedra", "none"}};
  const hex::Filling& f = *found.filling;
  std::vector<std::string> worst;
  for (const product::BadHexahedron& h : f.quality.worst) worst.push_back(text_of(h));
  return {{"hexahedra", std::to_string(f.mesh.hexahedra.size())},
          {"inverted", std::to_string(f.quality.bad.size())},
          {"scaled Jacobian", "least " + fixed(f.quality.minimum, 4) + ", mean " + fixed(f.quality.mean, 4) +
                                  ", below 0.2: " + std::to_string(below(f.quality, good))},
          {"volume", rounded(f.volume) + ", of the solid " + rounded(f.solid_volume) + ", ratio " +
                         fixed(f.volume_ratio(), 6)},
          {"Hausdorff distance",
           scientific(f.deviation.relative(), 2) + " of the diagonal, at " + text_of(f.deviation.at())},
          {"edge", rounded(f.edge)},
          {"ridges", std::to_string(f.ridges) + " kept of " + std::to_string(f.ridges_of_solid)},
          {"worst", joined(worst, ", ")}};
}

template <>
const FieldList<FilledSolid>& fields_of<FilledSolid>() {
  static const FieldList<FilledSolid> fields{
      {{"hexahedra", "", "how many; 0: none were made"},
       [](Found f) -> Tree { return f.filling ? f.filling->mesh.hexahedra.size() : 0; }},
      {{"inverted", "", "hexahedra of scaled Jacobian 0 or less"},
       [](Found f) -> Tree { return f.filling->quality.bad.size(); },
       is_there},
      {{"min_scaled_jacobian", "", "the least of all hexahedra, in [-1, 1]"},
       [](Found f) -> Tree { return f.filling->quality.minimum; },
       is_there},
      {{"mean_scaled_jacobian", "", "the mean over all hexahedra"},
       [](Found f) -> Tree { return f.filling->quality.mean; },
       is_there},
      {{"below_0.2", "", "hexahedra of lesser scaled Jacobian"},
       [](Found f) -> Tree { return below(f.filling->quality, good); },
       is_there},
      {{"histogram", "", "hexahedra of scaled Jacobian in [-1, -0.9), ... [0.9, 1]"},
       [](Found f) -> Tree { return f.filling->quality.histogram; },
       is_there},
      {{"worst", "", "the ten of least scaled Jacobian: hexahedron, scaled_jacobian, at"},
       [](Found f) { return places(f.filling->quality.worst); },
       is_there},
      {{"volume_ratio", "", "volume of the hexahedra over that of the solid"},
       [](Found f) -> Tree { return f.filling->volume_ratio(); },
       is_there},
      {{"hausdorff", "diagonal of the box", "greatest distance between the surfaces, either way; sampled"},
       [](Found f) -> Tree { return f.filling->deviation.relative(); },
       is_there},
      {{"hausdorff_from_hexahedra", "diagonal of the box", "the same from the hexahedra to the solid"},
       [](Found f) -> Tree { return f.filling->deviation.from_hexahedra / f.filling->deviation.diagonal; },
       is_there},
      {{"hausdorff_from_solid", "diagonal of the box", "the same from the solid to the hexahedra"},
       [](Found f) -> Tree { return f.filling->deviation.from_solid / f.filling->deviation.diagonal; },
       is_there},
      {{"hausdorff_at", "", "the point where the distance is greatest"},
       [](Found f) -> Tree { return f.filling->deviation.at(); },
       is_there},
      {{"edge", "", "distance of the planes of the grid"},
       [](Found f) -> Tree { return f.filling->edge; },
       is_there},
      {{"ridges", "", "sharp ridges of the solid that edges of hexahedra follow"},
       [](Found f) -> Tree { return f.filling->ridges; },
       is_there},
      {{"ridges_of_solid", "", "sharp ridges that the solid has"},
       [](Found f) -> Tree { return f.filling->ridges_of_solid; },
       is_there},
      {{"doubts", "", "why the status is 4, one text each"}, [](Found f) -> Tree { return f.doubts(); }},
      {{"seconds", "seconds", "time taken"}, [](Found f) -> Tree { return f.seconds; }},
  };
  return fields;
}

} // namespace tetrarch::workshop
