// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A proof as a file: what another program needs to check it, and nothing else.
///
///     {
///       "format": "tetrarch-certificate",
///       "version": 1,
///       "gluings": [ ... ],                                          as in a triangulation's file
///       "bits": 53,
///       "radius": "0x1p-48",
///       "edges": [ {"tetrahedron": 0, "edge": 0, "length": "0x1.8p+0", "fixed": false}, ... ],
///       "claims": { "orientable": true, "links": [-2], "volume": ["6.4519902708", "6.4519902709"] },
///       "cells": { "cusp_area": null, "faces": [ {"tetrahedron": 0, "face": 0, "flat": null}, ... ] }
///     }
///
/// It says: the gluing carries exactly one hyperbolic structure whose edges have lengths within `radius` of
/// those given (exactly so where `fixed`: these choose the horospheres and the places of finite vertices),
/// and the claims hold. `links` are the Euler characteristics of the vertex links in increasing order. Exact
/// numbers are integers times powers of two. `cells` is there if the tetrahedra are said to subdivide the
/// canonical cells: of each face whether it is a wall between two cells, strictly convex, or else flat, and
/// by which criterion (canonical/certify.hpp); each cusp has a cross-section of area `cusp_area`, if any. The
/// checker of such files is in checker/check.hpp; the schema is census/schema/certificate.schema.json.

#include "tetrarch/verified/structure.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::verified {

/// What is claimed of canonical cells.
struct CellClaims {
  std::string cusp_area; ///< in decimal; without cusps it does not matter
  /// Of each face of each tetrahedron the criterion that proves it flat; empty: a wall.
  std::vector<std::array<std::string, 4>> flat;
};

/// The text of the file. `skeleton` is that of `tri`, and `proof` is a proof for it. O(n).
std::string certificate(const Triangulation& tri, const Skeleton& skeleton, const StructureProof& proof,
                        const std::optional<CellClaims>& cells = {});

/// The SHA-256 of a text, in hexadecimal: what `sha256sum` says of the file. Source: FIPS 180-4.
std::string digest(std::string_view text);

} // namespace tetrarch::verified
