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
///       "claims": { "orientable": true, "links": [-2], "volume": ["6.4519902708", "6.4519902709"] }
///     }
///
/// It says: the gluing carries exactly one hyperbolic structure whose edges have lengths within `radius` of
/// those given (exactly so where `fixed`: these choose the horospheres and the places of finite vertices),
/// and the claims hold. `links` are the Euler characteristics of the vertex links in increasing order. Exact
/// numbers are integers times powers of two. The checker of such files is in checker/check.hpp; the schema
/// is census/schema/certificate.schema.json.

#include "tetrarch/verified/structure.hpp"

#include <string>
#include <string_view>

namespace tetrarch::verified {

/// The text of the file. `skeleton` is that of `tri`, and `proof` is a proof for it. O(n).
std::string certificate(const Triangulation& tri, const Skeleton& skeleton, const StructureProof& proof);

/// The SHA-256 of a text, in hexadecimal: what `sha256sum` says of the file. Source: FIPS 180-4.
std::string digest(std::string_view text);

} // namespace tetrarch::verified
