// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra that fill a solid of any genus.
///
///      .-''-.        +-+-+-+        .-----.     A grid is laid over the solid, with planes where flat sides
///     (      )  -->  +-+-+-+  -->  (|--|--|)    lie, and its cells inside are taken. They are drawn to the
///      '-..-'        +-+-+-+        '-----'     surface by the energy of the room `unfold`; ridges and
///                                               corners are found again on them. Where a hexahedron would
///      have two sides on a smooth surface, a layer is put below all of it, and a layer around each patch
///      that leaves its squares no room. Last, single points move where the worst hexahedra are.
///
/// Nothing is proved of the result; all of it is measured. Source: after Marechal, "Advances in octree-based
/// all-hexahedral mesh generation" (2009), and Gao, Shen and Panozzo, "Feature preserving octree-based
/// hexahedral meshing" (2019).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hex/deviation.hpp"
#include "tetrarch/hex/grid.hpp"
#include "tetrarch/product/hex_mesh.hpp"
#include "tetrarch/product/solid.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace tetrarch::hex {

struct FillOptions {
  std::optional<double> edge{};        ///< wanted length of edges
  std::optional<std::int64_t> cells{}; ///< wanted number of hexahedra; without either, `usual_cells`
  double sharp = 40;                   ///< degrees between normals, from which an edge is kept as a ridge
  double volume_tolerance = 0.01;      ///< relative
  double hausdorff_tolerance = 0.01;   ///< in terms of the diagonal of the solid's box
  /// No grid is made finer for which `bytes_for_edge` tells more.
  double most_bytes = std::numeric_limits<double>::infinity();
  /// No grid is made finer if all grids together would have more hexahedra than so many times those of the
  /// first, by `cells_for`, and none is fitted that has more by itself and more than 10,000, as grids of
  /// needles have. A count, so that the same comes out on each machine.
  double most_effort = 32;
};

/// What `FillOptions::cells` is where nobody said.
constexpr std::int64_t usual_cells = 4000;

struct Filling {
  product::HexMesh mesh;
  product::HexQuality quality;
  Deviation deviation;
  double volume = 0;
  double solid_volume = 0;
  double edge = 0;         ///< of the grid
  int refinements = 0;     ///< how often the grid was too coarse for the solid
  int ridges = 0;          ///< kept
  int ridges_of_solid = 0; ///< found
  bool has_layer = false;  ///< below the whole surface

  /// Relative.
  double volume_ratio() const { return volume / solid_volume; }
  /// No scaled Jacobian below 0.2, and volume and distance within the tolerances.
  bool is_good(const FillOptions& options) const;
};

/// Why no finer grid was tried.
enum class Ending : std::uint8_t {
  good,   ///< the result is good
  finest, ///< edges would be shorter than a third of the first ones
  effort, ///< `most_effort`
  memory  ///< `most_bytes`
};

/// The best of some grids.
struct Search {
  std::optional<Filling> best{}; ///< none where no grid has the solid's genus
  int genus = 0;                 ///< of the solid
  int grids = 0;                 ///< tried
  double finest_edge = 0;        ///< of the last one
  Ending ending = Ending::good;
};

/// About how many hexahedra fill a solid with edges of this length: those inside, and a layer.
double cells_for(const product::Solid& solid, double edge);
/// The length of edges with which about so many hexahedra fill a solid.
double edge_for(const product::Solid& solid, std::int64_t cells);
/// Bytes that `fill` takes at most for edges of this length, roughly. In double, so that nothing overflows.
double bytes_for_edge(const product::Solid& solid, double edge);

/// Hexahedra near the surface of a solid, with edges of about this length, from which a filling begins;
/// nothing where there are none.
using Start = std::function<std::optional<SizedHexahedra>(double edge, const Progress&)>;

/// Where the result is not good the grid is made finer, by a factor of 0.8 to 0.6 each time and 0.3 in all;
/// the best result is kept. Throws Stopped.
[[nodiscard]] Search search(const product::Solid& solid, const FillOptions& options = {},
                            const Progress& progress = {});
/// The same from other hexahedra than cells of a grid; they must be a manifold of the solid's genus.
[[nodiscard]] Search search(const product::Solid& solid, const Start& start, const FillOptions& options,
                            const Progress& progress = {});
/// The best result of the first `search`.
[[nodiscard]] std::optional<Filling> fill(const product::Solid& solid, const FillOptions& options = {},
                                          const Progress& progress = {});

} // namespace tetrarch::hex
