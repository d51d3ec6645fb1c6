// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/identify/identify.hpp"

#include "famous.hpp"
#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/catalogue/cusped.hpp"
#include "tetrarch/catalogue/graphs.hpp"
#include "tetrarch/catalogue/prove.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/identify/recognise.hpp"
#include "tetrarch/moves/simplify.hpp"
#include "tetrarch/reasons/reason.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace tetrarch::identify {
namespace {

using By = Identification::By;

struct Known {
  std::string name;
  std::optional<catalogue::Manifold> manifold;
};

/// What has this isometry signature; nothing if no table holds it.
std::optional<Known> known_manifold(const std::string& isometry_signature, const IdentifyOptions& options) {
  for (const detail::Famous& f : detail::famous)
    if (f.isometry_signature == isometry_signature) return Known{std::string(f.name), {}};
  if (auto m = catalogue::find_by_isometry_signature(isometry_signature)) {
    std::string name = m->name.empty() ? m->signature : m->name;
    return Known{std::move(name), std::move(m)};
  }
  if (const auto cusped = catalogue::find_cusped_by_isometry_signature(isometry_signature))
    return Known{std::string(cusped->name), {}};
  const auto called = [](const catalogue::Manifold& m) { return m.name.empty() ? m.signature : m.name; };
  for (const catalogue::Manifold& m : options.table)
    if (m.canonical_signature == isometry_signature) return Known{called(m), m};
  if (options.database)
    if (const auto m = options.database->by_isometry_signature(isometry_signature))
      return Known{called(*m), m};
  return std::nullopt;
}

/// The number of tetrahedra of the last one, of orientable manifolds or of the others.
int largest_table(bool orientable) {
  std::vector<catalogue::TableKey> tables = catalogue::stored_tables();
  if (const catalogue::Database* file = catalogue::installed_database())
    for (const catalogue::TableKey table : file->tables()) tables.push_back(table);
  int largest = 0;
  for (const catalogue::TableKey table : tables)
    if (table.orientable == orientable) largest = std::max(largest, table.tetrahedra);
  return largest;
}

/// 20000 as "20,000".
std::string grouped(int n) {
  std::string text = std::to_string(n);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

std::string tetrahedra(int n) {
  return grouped(n) + (n == 1 ? " tetrahedron" : " tetrahedra");
}

std::string volume_text(double volume) {
  std::array<char, 40> buffer{};
  constexpr int decimals = 10;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), volume, std::chars_format::fixed, decimals);
  return {buffer.data(), end.ptr};
}

class Identifier {
public:
  Identifier(const Triangulation& given, const IdentifyOptions& options, const Progress& progress)
      : given_(given), options_(options), progress_(progress) {}

  Identification run() {
    hyperbolic::SearchOptions search;
    search.seed = options_.seed;
    search.attempts = options_.attempts;
    std::optional<reasons::Reason> why_not;
    search.has_none = [&](const Triangulation& simple) {
      why_not = reasons::quick_reason(simple, given_, options_.seed, progress_);
      return why_not.has_value();
    };
    const hyperbolic::Search found = find_structure(given_, search, progress_);
    say_how_simplified(found.triangulation);
    say(why_not ? "not hyperbolic: " + why_not->text : describe(found));
    if (found.structure.outcome == hyperbolic::Outcome::geometric) {
      say_what_was_filled();
      by_structure(found);
    } else {
      by_recognition();
    }
    return std::move(out_);
  }

private:
  void say(std::string sentence) { out_.tried.push_back(std::move(sentence)); }

  void say_how_simplified(const Triangulation& to) {
    if (to.size() < given_.size())
      say("simplified from " + grouped(given_.size()) + " to " + tetrahedra(to.size()));
  }

  void say_what_was_filled() {
    int spheres = 0;
    for (const BoundaryComponent& b : boundary_components(given_, Skeleton(given_)))
      spheres += b.type.is_sphere();
    if (spheres > 0)
      say(std::to_string(spheres) + (spheres == 1 ? " boundary sphere was" : " boundary spheres were") +
          " filled in: the structure is that of the filled manifold");
  }

  void by_structure(const hyperbolic::Search& found) {
    out_.volume = found.structure.volume;
    out_.triangulation = found.triangulation;
    canonical::CanonizeOptions how;
    how.seed = options_.seed;
    canonical::Canonical cells = canonical::canonize(found.triangulation, found.structure, how, progress_);
    if (cells.outcome != canonical::Canonical::Outcome::canonical) {
      say("no canonical decomposition was found after " + std::to_string(cells.restarts) +
          " changes of the triangulation, so there is no isometry signature to look up: volume " +
          volume_text(*out_.volume));
      return;
    }
    if (cells.has_flat_faces) catalogue::prove_cells(cells, progress_);
    out_.confirmed_only = cells.has_flat_faces && !cells.proof.certified;
    const canonical::CellsProof proof = std::move(cells.proof);
    const std::vector<std::string> graphs = catalogue::graphs_with_structure(cells.isometry_signature);
    look_up(std::move(cells.isometry_signature));
    say_what_is_flat(proof);
    look_up_graphs(graphs, By::isometry_signature);
  }

  void look_up(std::string isometry_signature) {
    std::optional<Known> known = known_manifold(isometry_signature, options_);
    if (!known) {
      say("isometry signature " + isometry_signature + " is in no table: volume " +
          volume_text(*out_.volume) + ", tables hold manifolds with geodesic boundary of up to " +
          tetrahedra(largest_table(Skeleton(given_).is_orientable())) + " and " +
          grouped(catalogue::cusped_count()) + " cusped ones");
    } else {
      out_.by = By::isometry_signature;
      out_.name = std::move(known->name);
      out_.manifold = std::move(known->manifold);
      say("isometry signature " + isometry_signature + " is that of " + out_.name);
    }
    out_.isometry_signature = std::move(isometry_signature);
  }

  void say_what_is_flat(const canonical::CellsProof& proof) {
    if (out_.confirmed_only)
      say("a face of the canonical decomposition is flat to 30 digits of 60, which is not a proof: the "
          "isometry signature rests on it (" +
          proof.why_not + ")");
    else if (proof.certified)
      say("the flat faces of the canonical decomposition are proved flat");
  }

  /// Graphs in space with this exterior give it a name where no table does.
  void look_up_graphs(const std::vector<std::string>& graphs, By by) {
    if (graphs.empty()) return;
    std::string names;
    for (const std::string& graph : graphs) names += (names.empty() ? "" : ", ") + graph;
    say(std::string("it is the exterior in S^3 of the graph") + (graphs.size() > 1 ? "s " : " ") + names);
    if (out_.by != By::nothing) return;
    out_.by = by;
    out_.name = "exterior of " + names;
  }

  void by_recognition() {
    moves::SimplifyOptions how;
    how.seed = options_.seed;
    out_.triangulation = moves::simplified(given_, how, progress_);
    const Recognition seen = recognise(out_.triangulation, progress_);
    out_.name = seen.name;
    if (seen.by == Recognition::By::triangulation) out_.by = By::triangulation;
    if (seen.by == Recognition::By::group) out_.by = By::group;
    say((seen ? seen.name + ": " : "not recognised: ") + seen.because);
    if (!seen) look_up_graphs(graphs_met(), By::triangulation);
  }

  /// Graphs whose exterior has, in the table, one of the small triangulations that this manifold is met with.
  std::vector<std::string> graphs_met() const {
    constexpr std::uint64_t seeds = 8;
    moves::SimplifyOptions how;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      how.seed = options_.seed + seed;
      std::vector<std::string> graphs = catalogue::graphs_with_triangulation(
          signature(moves::simplified(out_.triangulation, how, progress_)));
      if (!graphs.empty()) return graphs;
    }
    return {};
  }

  const Triangulation& given_;
  const IdentifyOptions& options_;
  const Progress& progress_;
  Identification out_;
};

} // namespace

std::string to_string(Identification::By by) {
  switch (by) {
  case By::isometry_signature:
    return "isometry signature";
  case By::triangulation:
    return "triangulation";
  case By::group:
    return "group";
  case By::nothing:
    break;
  }
  return "nothing";
}

Identification identify(const Triangulation& tri, const IdentifyOptions& options, const Progress& progress) {
  return Identifier(tri, options, progress).run();
}

} // namespace tetrarch::identify
