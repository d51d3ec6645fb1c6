// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A sphere with holes, mapped to a domain: a ring or a cylinder with slits, a disk or a rectangle with
/// holes, or a flat shape of least distortion.
///
///     const ConformalMap found = conformal_map(opened(surface_of(open_mesh("ring.off"))));
///     if (found.verdict() == Verdict::yes) use(found.layout);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/show/slit.hpp"
#include "tetrarch/slit/balance.hpp"
#include "tetrarch/slit/quads.hpp"
#include "tetrarch/slit/quality.hpp"
#include "tetrarch/slit/unflip.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/openings.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {
struct MeshDocument;
}

namespace tetrarch::workshop {

enum class MapDomain : std::uint8_t {
  cylindric,  ///< a cylinder with slits
  parallel,   ///< its unrolling to a rectangle
  concentric, ///< a ring with slits
  circular,   ///< a disk with round holes
  rectangle,  ///< a rectangle with rectangular holes
  free,       ///< a flat shape of least distortion, in the unit of the surface
};

/// "cylindric", "parallel", ...
const char* name_of(MapDomain domain);
/// Nothing if no domain has this name.
std::optional<MapDomain> map_domain_named(std::string_view name);
/// Whether the map begins with a disk that has round holes.
bool has_round_holes(MapDomain domain);

struct MapOptions {
  std::string name = "surface"; ///< what errors call it
  MapDomain domain = MapDomain::concentric;
  bool by_ricci_flow = false; ///< round holes, by discrete Ricci flow instead of harmonic functions
  slit::LoopPair circles;     ///< the loops that become the outer and the inner circle
  /// Of a surface with one loop the vertex that goes to 0; nothing: the innermost.
  std::optional<int> center;
  /// Vertices of the outer loop that become the corners of the rectangle; nothing: the sharpest, or quarters.
  std::optional<std::array<int, 4>> corners;
  bool unflip = false;        ///< move vertices until no triangle is inverted
  bool balance = false;       ///< distort areas less at the cost of angles
  bool flips_allowed = false; ///< inverted triangles are no fault, and nothing else is tried to avoid them
  bool intrinsic = false;     ///< solve on the intrinsic Delaunay triangulation
  std::optional<int> stage;   ///< lay out the circular domain with so many slits open
  std::optional<int> basis;   ///< lay out the one-form of this loop
  int quads_around = 0;       ///< make quads, so many around the ring
  double quad_edge = 0;       ///< make quads with edges of about this length

  bool has_quads() const { return quads_around > 0 || quad_edge > 0; }
};

/// A map, and what became of the surface. It owns all that it speaks of.
struct ConformalMap {
  HoledSurface surface;
  MapDomain domain = MapDomain::concentric;
  bool flips_allowed = false;

  /// The ring or cylinder with slits, as the harmonic functions have it: vertices that are moved later do not
  /// change it.
  struct Slits {
    slit::LoopPair circles; ///< the loops
    double modulus = 0;
    double modulus_bound = 0;
    std::vector<slit::Slit> slits;
    bool on_ring = false; ///< slits have radii, else heights
  };
  std::optional<Slits> slits;

  /// The disk with round holes.
  struct Circles {
    std::vector<int> loops; ///< the outer one, the inner one, then the others
    std::vector<slit::Circle> circles;
    double circularity = 0; ///< the greatest
    int rounds = 0;
    bool found = false;
    bool by_ricci_flow = false;
  };
  std::optional<Circles> circles;

  /// The rectangle with rectangular holes.
  struct Rectangle {
    int outer = 0;                  ///< the loop
    std::vector<long long> corners; ///< vertices by number
    double height = 0;              ///< the width is 1
    struct Hole {
      int loop = 0;
      double left = 0;
      double right = 0;
      double bottom = 0;
      double top = 0;
    };
    std::vector<Hole> holes;
    double holonomy = 0; ///< of a way around a hole, the greatest
    double residual = 0; ///< of curvatures
    int rounds = 0;
    bool found = false;
  };
  std::optional<Rectangle> rectangle;

  std::optional<slit::Unflipped> unflipped; ///< where it was asked for, or vertices were moved
  std::optional<slit::Softened> softened;   ///< where vertices at ends of slits were moved
  struct Balance {
    slit::Balanced balanced;
    slit::Distortion before;
  };
  std::optional<Balance> balance;
  slit::Distortion distortion;              ///< in the end
  std::optional<int> crossings;             ///< of boundary edges of a free domain
  std::optional<slit::Residuals> residuals; ///< of the harmonic functions

  struct Quads {
    slit::QuadMesh mesh;
    slit::QuadQuality quality;
  };
  std::optional<Quads> quads;
  /// The number of quads around the ring that the edge asked for makes, where it is not possible.
  std::optional<double> impossible_quads;

  std::optional<int> center; ///< of a surface with one loop, the vertex that went to 0
  /// Triangles would be inverted, so that vertices were moved.
  struct Mended {
    std::size_t flipped_before = 0; ///< triangles
    bool intrinsic = false;         ///< solved on the intrinsic Delaunay triangulation first
  };
  std::optional<Mended> mended;

  double seconds = 0; ///< that the map took
  show::Layout layout;
  show::Fields fields; ///< numbers at vertices and triangles

  std::size_t flipped() const { return distortion.flipped.size(); } ///< triangles
  /// Whether circles became round, the energy fell no more, the rectangle closes, no boundary edges cross.
  bool found() const;
  /// Undecided where it was not found, or triangles are inverted that may not be.
  Verdict verdict() const;
  /// What is remarkable in the result, a sentence each.
  std::vector<std::string> remarks() const;
};

/// Numbers of quads around the ring that are possible.
constexpr int fewest_quads_around = 3;
constexpr int most_quads_around = 1'000'000;

/// Why a surface has no such map, a phrase: it is no sphere with a hole, or with two. Empty: it has one.
/// O(n).
std::string why_not_mapped(const surface::Surface& surface, int least_holes);

/// Obtuse triangles make harmonic maps turn some triangles over. Then either a few vertices are moved, or the
/// map of the intrinsic Delaunay triangulation, which has no such triangles, is drawn with the mesh's own
/// ones and vertices are moved then: whichever leaves fewer inverted, or else distorts less. Throws
/// InputError where the surface has no such map, or the room it needs is less than doubles can tell;
/// PreconditionError for a basis or a stage that there is not; Stopped if the progress says so. A sparse
/// factorization or some; 0.03 to 0.2 s for 10,000 triangles.
ConformalMap conformal_map(HoledSurface surface, const MapOptions& options = {},
                           const Progress& progress = {});

/// What is told of the map: circles, slits, holes, quality.
Rows map_rows(const ConformalMap& found);
/// The surface and the domain, then the same.
Rows rows_of(const ConformalMap& found);

/// The surface with its map: of each corner the place in the domain and the texture coordinates, as vertices
/// on a seam have two; and what is known at vertices and triangles. O(n).
format::MeshDocument document_of(const ConformalMap& found);

template <>
const FieldList<ConformalMap>& fields_of<ConformalMap>();
/// Each once, though a list that keeps the order of JSON has the loops of round holes last.
template <>
std::vector<FieldNote> notes_of<ConformalMap>();

} // namespace tetrarch::workshop
