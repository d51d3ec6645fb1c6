// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_openings.hpp"

#include "text.hpp"
#include "vertex_names.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/mesh/open_handles.hpp"
#include "tetrarch/mesh/punch.hpp"
#include "tetrarch/mesh/slice.hpp"

#include <cmath>
#include <optional>
#include <string_view>

namespace tetrarch::program {
namespace {

mesh::RoundHole round_hole(const std::string& word) {
  const std::size_t colon = word.find(':');
  const auto vertex = vertex_in(std::string_view(word).substr(0, colon));
  const auto radius = colon == std::string::npos
                          ? std::nullopt
                          : format::parse_double(std::string_view(word).substr(colon + 1));
  if (!vertex || !radius || !(*radius > 0) || !std::isfinite(*radius))
    throw refusal("--punch", word, "expected a vertex and a radius, such as v17:0.5");
  return {*vertex, *radius};
}

} // namespace

mesh::OpenedMesh opened(const SurfaceInput& surface, const Openings& openings, const Progress& progress) {
  std::vector<long long> numbers;
  numbers.reserve(surface.mesh.points.size());
  for (int v = 0; v < surface.mesh.surface.vertex_count(); ++v)
    numbers.push_back(format::point_number(surface.labels, v) - surface.labels.first_number);
  mesh::OpenedMesh result(surface.mesh, std::move(numbers));
  std::vector<mesh::RoundHole> holes;
  for (const std::string& word : openings.punch) holes.push_back(round_hole(word));
  if (!holes.empty()) result = mesh::punch(result, holes);
  std::vector<std::vector<long long>> paths;
  for (const std::string& word : openings.slice) paths.push_back(vertices_in("--slice", word));
  if (!paths.empty()) result = mesh::slice(result, paths);
  if (openings.open_handles) result = mesh::open_handles(result, progress).opened;
  return result;
}

int loop_named(const std::string& name, const char* option, const mesh::OpenedMesh& surface,
               const std::vector<mesh::BoundaryLoop>& loops) {
  const auto number = vertex_in(name);
  if (!number)
    throw refusal(option, name, "expected the number of a loop, or v17 for the loop through vertex 17");
  if (!name.starts_with('v')) {
    if (*number < static_cast<long long>(loops.size())) return static_cast<int>(*number);
    throw refusal(option, name,
                  "there is no such loop; the surface has " +
                      counted(static_cast<long long>(loops.size()), "boundary loop") + ", counted from 0");
  }
  // A vertex that was cut through is there twice, on two loops perhaps: the first one is meant.
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (const mesh::SideEnd e : loops[k].sides)
      if (surface.number[surface.mesh.surface.vertex(e)] == *number) return static_cast<int>(k);
  throw refusal(option, name, "no boundary loop runs through this vertex");
}

int vertex_named(const std::string& name, const char* option, const mesh::OpenedMesh& surface) {
  const auto number = name.starts_with('v') ? vertex_in(name) : std::nullopt;
  if (!number) throw refusal(option, name, "expected a vertex, such as v17");
  return mesh::vertex_numbered(surface, *number);
}

} // namespace tetrarch::program
