// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A manifold in hyperbolic space: its fundamental domain, its holonomy, copies of the domain or of a
/// boundary component.
///
///     Placement found = placement(from_signature("cPcbbbihq"));
///     if (found.verdict() == Verdict::yes) use(embedding(std::move(found)).at.domain);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/embed/boundary.hpp"
#include "tetrarch/embed/cover.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

struct PlacementOptions {
  std::string name; ///< of the manifold
  std::uint64_t seed = 1;
  double cusp_area = embed::DomainOptions{}.cusp_area; ///< of the cross-section that cuts a cusp off
};

/// A manifold put into hyperbolic space, or why it is not. It owns all that it speaks of.
struct Placement {
  std::string name;
  hyperbolic::Search search; ///< the structure and the triangulation that carries it
  Skeleton skeleton;         ///< of that triangulation
  embed::Domain<double> domain;

  const Triangulation& triangulation() const { return search.triangulation; }
  /// Undecided where no structure was found.
  Verdict verdict() const;
  /// Why there is none, a phrase; empty: there is one.
  std::string why_not() const;
  /// In what this is not the triangulation given, a sentence each.
  std::vector<std::string> remarks() const;
  /// Vertex classes that are not finite: geodesic boundary and cusps.
  int boundary_count() const;
};

/// The structure is searched for as by `structure`. Throws PreconditionError unless `tri` is a connected
/// manifold of at least one tetrahedron; Stopped if the progress says so. 20 milliseconds for three
/// tetrahedra, 5 seconds for 100 edge classes.
Placement placement(const Triangulation& tri, const PlacementOptions& options = {},
                    const Progress& progress = {});

struct EmbedOptions {
  embed::PieceBounds bounds{1, 0, 0}; ///< of the piece; by default the domain alone
  std::optional<int> boundary;        ///< this one of the boundary components, unrolled; nothing: the domain
};

/// A piece of the universal cover, or of a boundary component's. It owns all that it speaks of.
struct Embedding {
  Placement at;
  embed::Residuals residuals; ///< of the domain
  std::optional<embed::BoundaryLift> lift;
  embed::Piece piece; ///< copies of the lift if there is one, else of the domain

  /// Those of the placement, and whether the domain is too large for double precision.
  std::vector<std::string> remarks() const;
};

/// Throws PreconditionError unless `at` was found, has such a boundary component, and there is a bound;
/// Stopped if the progress says so. About 2 microseconds a copy.
Embedding embedding(Placement at, const EmbedOptions& options = {}, const Progress& progress = {});

Rows rows_of(const Embedding& found);

template <>
const FieldList<Embedding>& fields_of<Embedding>();

} // namespace tetrarch::workshop
