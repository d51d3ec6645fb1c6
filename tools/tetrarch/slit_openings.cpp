// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_openings.hpp"

#include "text.hpp"
#include "vertex_names.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace tetrarch::program {
namespace {

surface::RoundHole round_hole(const std::string& word) {
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

workshop::HoledSurface opened(const SurfaceInput& surface, const OpeningWords& words,
                              const Progress& progress) {
  workshop::Openings holes;
  for (const std::string& word : words.punch) holes.punched.push_back(round_hole(word));
  workshop::HoledSurface punched = workshop::opened(surface, holes);
  if (words.slice.empty() && !words.open_handles) return punched;
  workshop::Openings cuts;
  for (const std::string& word : words.slice) cuts.sliced.push_back(vertices_in("--slice", word));
  cuts.handles = words.open_handles;
  return workshop::opened(std::move(punched), cuts, progress);
}

int loop_named(const std::string& name, const char* option, const workshop::HoledSurface& surface) {
  const auto number = vertex_in(name);
  if (!number)
    throw refusal(option, name, "expected the number of a loop, or v17 for the loop through vertex 17");
  const std::vector<surface::BoundaryLoop>& loops = surface.loops;
  if (!name.starts_with('v')) {
    if (*number < static_cast<long long>(loops.size())) return static_cast<int>(*number);
    throw refusal(option, name,
                  "there is no such loop; the surface has " +
                      counted(static_cast<long long>(loops.size()), "boundary loop") + ", counted from 0");
  }
  // A vertex that was cut through is there twice, on two loops perhaps: the first one is meant.
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (const surface::SideEnd e : loops[k].sides)
      if (surface.opened.number[surface.mesh().surface.vertex(e)] == *number) return static_cast<int>(k);
  throw refusal(option, name, "no boundary loop runs through this vertex");
}

slit::LoopPair circles_named(const std::string& outer, const std::string& inner,
                             const workshop::HoledSurface& surface) {
  const int outer_loop = loop_named(outer.empty() ? "0" : outer, "--outer", surface);
  return {outer_loop, loop_named(inner.empty() ? "1" : inner, "--inner", surface)};
}

int vertex_named(const std::string& name, const char* option, const workshop::HoledSurface& surface) {
  const auto number = name.starts_with('v') ? vertex_in(name) : std::nullopt;
  if (!number) throw refusal(option, name, "expected a vertex, such as v17");
  return surface::vertex_numbered(surface.opened, *number);
}

} // namespace tetrarch::program
