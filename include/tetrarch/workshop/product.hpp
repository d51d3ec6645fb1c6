// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A handlebody as a product of a disk with holes and an interval, and hexahedra in it: from the partition of
/// its boundary to coordinates, measured and described in one call.
///
///     const SolidProduct found = solid_product(solid_of(open_mesh("plate.mesh")));
///     if (found.verdict() == Verdict::yes) use(found.fibered->coordinates->of.uvw);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/critical.hpp"
#include "tetrarch/product/field.hpp"
#include "tetrarch/product/floor_map.hpp"
#include "tetrarch/product/product.hpp"
#include "tetrarch/solid/split_edges.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/solid_hexahedra.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::format {
struct MeshDocument;
struct Soup;
} // namespace tetrarch::format

namespace tetrarch::workshop {

/// A solid whose boundary is divided.
struct PartitionedSolid {
  product::Solid solid; ///< perhaps with edges split; old vertices keep their numbers
  product::Partition partition;
  std::string how;                      ///< it was found, in words
  std::vector<solid::EdgePoint> splits; ///< as in `product::Automatic`
};

/// By the search of product/automatic.hpp; nothing if it finds none, which proves nothing.
std::optional<PartitionedSolid> searched_partition(const product::Solid& solid, int threads = 1,
                                                   const Progress& progress = {});

/// Images of a solid's vertices on a surface of cubes. Those of vertices inside the solid are used where no
/// tetrahedron is flipped.
struct PolycubeImage {
  std::string name;                  ///< what errors call it
  std::vector<product::Point> image; ///< of each vertex
  double step = 1;                   ///< of the lattice of the polycube's corners
  int cells = 4;                     ///< hexahedra along a step
};

struct ProductOptions {
  std::string name; ///< what errors call the solid

  /// Says where floor and ceiling are, and may throw InputError. Null: they are searched for.
  std::function<PartitionedSolid(product::Solid)> partition;
  /// Whether somebody pointed them out: then there has to be a partition, even where cubes need none.
  bool is_partition_given = false;
  bool wants_coordinates = false; ///< even where cubes need none

  /// What the floor's image is, asked once there is a floor: corners are vertices of its rim. May throw
  /// InputError. Null: a disk with holes. Hexahedra across the floor make it a rectangle.
  std::function<product::FloorOptions(const product::SplitSolid&)> floor;
  double height = 0; ///< of the domain; 0: the one that keeps the floor's aspect ratio
  enum class Weights : std::uint8_t {
    automatic, ///< cotangents, and where they leave critical points clamped ones
    cotangent,
    clamped
  } weights = Weights::automatic;
  product::Direction follow = product::Direction::smoothed;
  bool passes_critical_points = false; ///< goes on in spite of them
  int fibers = 60;                     ///< that are kept, to be drawn

  int across = 0; ///< hexahedra across the floor's rectangle; 0: none between floor and ceiling
  int layers = 0; ///< of them; 0: as high as wide
  std::optional<PolycubeImage> polycube;
  HexahedraOptions hexahedra;

  int threads = 1; ///< they make no difference to what is found
};

/// How large a solid is, and how its boundary is divided.
struct SolidSides {
  int tetrahedra = 0;         ///< those of edges split by the search for a partition included
  std::string how;            ///< the partition was found, in words
  std::vector<int> triangles; ///< of floor, ceiling and walls; empty: there is no partition

  bool is_divided() const { return !triangles.empty(); }
  int holes() const { return static_cast<int>(triangles.size()) - product::first_wall - 1; }
};

/// A solid with a map of its floor and a field, and the fibers that join them.
struct FiberedSolid {
  product::SplitSolid at; ///< vertices made by splits have the numbers after those of the input
  product::FloorMap floor;
  product::HarmonicField field;
  double height = 0;
  bool clamped = false; ///< the weights of the field
  product::CriticalPlaces critical;

  struct Coordinates {
    product::Coordinates of;
    product::Quality quality;
    product::Confirmation confirmation;
    std::vector<std::vector<product::Point>> fibers;   ///< some, in space
    std::vector<std::vector<product::Point>> straight; ///< the same in the domain
  };
  /// Nothing where the field has critical points, unless they are passed over, or the floor has no map.
  std::optional<Coordinates> coordinates;

  /// Whether some triangle of the floor is not turned over by the map.
  bool has_map() const;
  /// Why the coordinates are none to rely on, a clause each; empty: the solid is a product, and they show it.
  /// Throws PreconditionError if there are none.
  std::vector<std::string> doubts() const;
};

/// What was found. It owns all that it speaks of.
struct SolidProduct {
  SolidSides sides;
  std::string
      why_undivided; ///< why cubes have to do without a partition; empty: none was needed, or is there
  std::optional<FiberedSolid> fibered; ///< nothing without a partition
  std::optional<MeasuredHexahedra> hexahedra;
  double seconds = 0;

  /// Whether the hexahedra come from a polycube: then they are the result, whatever else there is.
  bool is_of_polycube() const { return hexahedra && !hexahedra->grid; }
  /// A proved no where the field has critical points: no product with this partition. Undecided where the
  /// floor's map was not found, or there are doubts.
  Verdict verdict() const;
  /// Why coordinates and hexahedra are not to be relied on, a clause each.
  std::vector<std::string> doubts() const;
};

/// Throws InputError that names the solid, or the polycube, if there is no partition, the floor or the grid
/// does not come out, or the image is no polycube; PreconditionError for a polycube and hexahedra across the
/// floor at once; Stopped if the progress says so. O(n^1.33) for n tetrahedra, besides the partition: about a
/// second for 10,000.
SolidProduct solid_product(product::Solid solid, const ProductOptions& options = {},
                           const Progress& progress = {});

/// Solid and partition; floor, field and coordinates; hexahedra, those of a polycube before the floor.
Rows rows_of(const SolidProduct& found);

/// The hexahedra with their scaled Jacobians; or the tetrahedra with their coordinates in the domain (`uvw`)
/// and the boundary's triangles with tags, 1 floor, 2 ceiling, 3 and on walls. Throws PreconditionError if
/// there are neither hexahedra nor coordinates. O(n).
format::MeshDocument document_of(const SolidProduct& found);
/// These tetrahedra, and triangles with tags.
format::Soup labelled_mesh(const product::SplitSolid& solid);

template <>
const FieldList<SolidSides>& fields_of<SolidSides>();
template <>
const FieldList<FiberedSolid>& fields_of<FiberedSolid>();
/// What a product has besides the fields of its parts.
template <>
const FieldList<SolidProduct>& fields_of<SolidProduct>();
/// The fields of the parts, in the order of the rows, and these.
template <>
Tree tree_of<SolidProduct>(const SolidProduct& found);
template <>
std::vector<FieldNote> notes_of<SolidProduct>();

} // namespace tetrarch::workshop
