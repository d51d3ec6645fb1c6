// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The name of a manifold, from any triangulation: with real boundary, with finite vertices, with a million
/// tetrahedra.
///
///     any triangulation --search--> one with a hyperbolic structure --canonize--> isometry signature
///                          |                                                              |
///                          | none found                                           look up |
///                          v                                                              v
///                       the input, simplified: recognize it                             name
///
/// By Mostow-Prasad rigidity the isometry signature names the manifold, up to orientation. A manifold that no
/// table holds gets no name this way, whatever its triangulation. Every step is recorded in `tried`, because
/// the first question about a manifold without a name is how the program looked for one.
/// Source: Frigerio-Petronio 2004; Weeks 1993.

#include "tetrarch/catalogue/database.hpp"
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/progress.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::identify {

struct IdentifyOptions {
  std::uint64_t seed = 1;
  int attempts = 1000;                                   ///< triangulations on which a structure is sought
  std::vector<catalogue::Manifold> table{};              ///< somebody's own, looked up after the stored ones
  std::shared_ptr<const catalogue::Database> database{}; ///< the same as a file
};

/// The name of a manifold, its evidence, and all attempts.
struct Identification {
  enum class By { nothing, isometry_signature, triangulation, group };

  /// "fmp3_17", "Whitehead link complement (m129)", or what `recognise` says, "L(7,2)"; empty: none found.
  std::string name;
  By by = By::nothing;
  std::optional<catalogue::Manifold> manifold; ///< the table's entry, where the name is a table's
  std::string isometry_signature;              ///< empty without a structure
  std::optional<double> volume;                ///< nothing without a structure
  /// Some cells that name the manifold are no tetrahedra, and rest on 60-digit numbers that are zero without
  /// proof (catalogue/prove.hpp). A name that was found is right even so, since it rests on an isomorphism of
  /// triangulations; that no table holds the manifold is in doubt.
  bool confirmed_only = false;
  /// The triangulation that carries the structure; without a structure, the simplified input.
  Triangulation triangulation;
  /// A sentence for each step and its result.
  std::vector<std::string> tried;

  explicit operator bool() const { return by != By::nothing; }
};

/// "isometry signature", "triangulation", "group"; "nothing".
std::string to_string(Identification::By by);

/// If there are other boundary components and a hyperbolic structure decides, boundary spheres count as
/// filled in with balls (`tried` says so). `recognise` takes the triangulation as it is. Throws
/// PreconditionError for an empty or invalid triangulation and for one that is not connected. Near-linear: 3
/// to 9 microseconds per tetrahedron, measured up to 770,000; 0.1 to 0.2 s more where there is no structure,
/// and what `prove_cells` takes where cells are flat. Deterministic for `options.seed`. May be called from
/// several threads.
[[nodiscard]] Identification identify(const Triangulation& tri, const IdentifyOptions& options = {},
                                      const Progress& progress = {});

} // namespace tetrarch::identify
