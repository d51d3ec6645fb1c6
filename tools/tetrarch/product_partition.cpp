// SPDX-License-Identifier: GPL-2.0-or-later
#include "product_partition.hpp"

#include "vertex_names.hpp"

#include "tetrarch/format/text.hpp"
#include "tetrarch/product/bases.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tetrarch::program {
namespace {

std::array<int, 2> labels_in(const std::string& word) {
  const std::size_t comma = word.find(',');
  const auto floor = format::parse_integer(std::string_view(word).substr(0, comma));
  const auto ceiling = comma == std::string::npos
                           ? std::nullopt
                           : format::parse_integer(std::string_view(word).substr(comma + 1));
  if (!floor || !ceiling || *floor == *ceiling)
    throw refusal("--labels", word, "expected the labels of floor and ceiling, such as 1,2");
  return {static_cast<int>(*floor), static_cast<int>(*ceiling)};
}

int in_solid(const product::Solid& solid, const char* option, const std::string& word, long long vertex) {
  const auto count = static_cast<long long>(solid.on_boundary.size());
  if (vertex >= count)
    throw refusal(option, word,
                  "there is no vertex v" + std::to_string(vertex) + "; the last one is v" +
                      std::to_string(count - 1));
  if (solid.on_boundary[static_cast<std::size_t>(vertex)] < 0)
    throw refusal(option, word,
                  "v" + std::to_string(vertex) + " is inside the solid and not on its boundary");
  return static_cast<int>(vertex);
}

int seed_in(const product::Solid& solid, const char* option, const std::string& word) {
  const auto vertex = vertex_in(word);
  if (!vertex) throw refusal(option, word, "expected a vertex, such as v17");
  return in_solid(solid, option, word, *vertex);
}

std::vector<std::vector<int>> walks_in(const product::Solid& solid, const char* option,
                                       const std::vector<std::string>& words) {
  std::vector<std::vector<int>> walks;
  walks.reserve(words.size());
  for (const std::string& word : words) {
    std::vector<int>& walk = walks.emplace_back();
    for (const long long v : vertices_in(option, word)) walk.push_back(in_solid(solid, option, word, v));
    if (walk.size() < 3) throw refusal(option, word, "expected a closed walk of at least three vertices");
  }
  return walks;
}

/// Empty if nobody has pointed anything out.
std::vector<int> pointed_out(const product::Solid& solid, const format::Soup& soup,
                             const PartitionOptions& options, std::string& how) {
  const int ways = static_cast<int>(!options.labels.empty()) + static_cast<int>(!options.cycles.empty()) +
                   static_cast<int>(!options.tunnels.empty()) +
                   static_cast<int>(!options.floor.empty() || !options.ceiling.empty());
  if (ways > 1) throw InputError("expected one of --labels, --cycle, --tunnel, or --floor with --ceiling");
  if (!options.labels.empty()) {
    const std::array<int, 2> labels = labels_in(options.labels);
    if (soup.triangle_tags.empty())
      throw refusal("--labels", options.labels, "the file has no triangles with labels");
    how = "labels " + std::to_string(labels[0]) + " and " + std::to_string(labels[1]);
    return product::bases_with_labels(solid, soup.triangles, soup.triangle_tags, labels);
  }
  if (!options.cycles.empty()) {
    how = "between the rims given";
    return product::bases_between_cycles(solid, walks_in(solid, "--cycle", options.cycles));
  }
  if (!options.tunnels.empty()) {
    if (!(options.extend > 0)) throw InputError("--tunnel needs a length (--extend)");
    how = "beyond the tunnels given";
    return product::bases_beyond_tunnels(solid, walks_in(solid, "--tunnel", options.tunnels), options.extend);
  }
  if (options.floor.empty() && options.ceiling.empty()) return {};
  if (options.floor.empty() || options.ceiling.empty())
    throw InputError("--floor and --ceiling need each other: expected a seed for both");
  how = "flooded from " + options.floor + " and " + options.ceiling;
  return product::bases_by_flooding(
      solid, {{seed_in(solid, "--floor", options.floor), seed_in(solid, "--ceiling", options.ceiling)},
              options.threshold});
}

/// A triangle on a wall at this vertex.
int outer_triangle(const product::Solid& solid, const std::vector<int>& base, const std::string& word) {
  if (word.empty()) return -1;
  const int vertex = seed_in(solid, "--outer", word);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      if (base[t] < 0 && solid.corner(t, c) == vertex) return t;
  throw refusal("--outer", word, "this vertex is on no wall");
}

} // namespace

bool is_given(const PartitionOptions& options) {
  return !options.labels.empty() || !options.cycles.empty() || !options.tunnels.empty() ||
         !options.floor.empty() || !options.ceiling.empty();
}

workshop::PartitionedSolid partitioned(product::Solid solid, const format::Soup& soup,
                                       const PartitionOptions& options, const Context& context) {
  workshop::PartitionedSolid result;
  std::vector<int> base = pointed_out(solid, soup, options, result.how);
  if (base.empty()) {
    auto found = workshop::searched_partition(solid, context.threads, context.progress);
    if (!found)
      throw InputError("the search found no partition, which proves nothing; give one by --labels, --cycle, "
                       "--tunnel, or --floor and --ceiling");
    if (options.outer.empty()) return std::move(*found);
    result = std::move(*found);
    for (const int patch : result.partition.patch) base.push_back(patch < product::first_wall ? patch : -1);
  } else {
    result.solid = std::move(solid);
  }
  result.partition =
      product::partition(result.solid, base, outer_triangle(result.solid, base, options.outer));
  return result;
}

} // namespace tetrarch::program
