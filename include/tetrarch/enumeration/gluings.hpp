// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Every gluing of n tetrahedra, each once.
///
/// Lay n tetrahedra on the table and glue all 4n faces in pairs until nothing is left open and everything
/// hangs together. Two results that differ by renaming tetrahedra and their vertices (turning a tetrahedron
/// inside out included) count as one.
/// The promise: each class is found exactly once, in an order that depends on nothing but the options, and a
/// partial gluing is dropped as soon as it cannot be completed within the options.
/// Source: orderly generation (Read 1978, Faradzev 1978; McKay, "Isomorph-free exhaustive generation", 1998);
/// what can be decided about edges and vertex links of a partial gluing: Burton, "Enumeration of
/// non-orientable 3-manifolds using face-pairing graphs and union-find", 2007.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/surface.hpp"
#include "tetrarch/core/triangulation.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::enumeration {

/// A set of closed surfaces: orientable ones by genus (0 is the sphere, 1 the torus), non-orientable ones by
/// the number of crosscaps (1 is the projective plane, 2 the Klein bottle).
struct LinkSet {
  std::vector<int> genera;
  std::vector<int> crosscaps;

  bool contains(const SurfaceType& type) const;
};

/// Reads a comma-separated list as it is typed after `--links`: a number g is the orientable surface of genus
/// g, `nk` (or `Nk`) the sphere with k crosscaps. "2,3" allows only genus 2 and genus 3; "0" allows spheres,
/// so that all vertices are finite. Throws InputError with the first item that is none of these.
LinkSet parse_link_set(std::string_view text);

struct GluingOptions {
  enum class Orientability { any, orientable, nonorientable };

  int tetrahedra = 1;
  Orientability orientability = Orientability::any;
  bool ideal = false;           ///< at least one vertex link is no sphere
  std::optional<LinkSet> links; ///< every vertex link is one of these
  int min_valence = 1;          ///< every edge class has at least this many t-edges
  bool allow_invalid = false;   ///< allow edges that are identified with themselves backwards
  int threads = 1;
};

/// The greatest number of tetrahedra. In practice the number of gluings is the limit (about 4e7 orientable
/// ones of six tetrahedra).
inline constexpr int max_gluing_tetrahedra = 12;

/// Calls `visit` in the calling thread with each connected closed gluing, once up to isomorphism.
/// The order is the same for any number of threads. Throws PreconditionError unless 1 <= tetrahedra <=
/// max_gluing_tetrahedra and threads >= 1; lets `Stopped` and whatever `visit` throws pass through.
/// Cost: about a microsecond for each orientable gluing visited; memory O(1) in their number.
void enumerate_gluings(const GluingOptions& options, const std::function<void(const Triangulation&)>& visit,
                       const Progress& progress = {});

/// The same as isomorphism signatures, in the same order: nothing is kept, however many there are.
void enumerate_signatures(const GluingOptions& options, const std::function<void(const std::string&)>& visit,
                          const Progress& progress = {});

/// The isomorphism signatures of the same gluings, in ASCII order.
std::vector<std::string> gluing_signatures(const GluingOptions& options, const Progress& progress = {});

/// The number of these gluings. It builds none and is the quickest of the three functions.
std::int64_t count_gluings(const GluingOptions& options, const Progress& progress = {});

/// The same gluings in units that are found independently of each other, on whatever machine: those of a unit
/// begin alike, tetrahedron by tetrahedron. The units depend on nothing but the options, threads excepted.
class GluingUnits {
public:
  /// Finds the beginnings: a small part of the work. Throws as `enumerate_gluings` does.
  explicit GluingUnits(const GluingOptions& options, const Progress& progress = {});
  GluingUnits(GluingUnits&&) noexcept;
  ~GluingUnits();

  int size() const;
  /// The signatures of unit k, in ASCII order. Any thread.
  std::vector<std::string> signatures(int k, const Progress& progress = {}) const;

private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

} // namespace tetrarch::enumeration
