// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/product.hpp"

#include "carried_cubes.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/soup.hpp"
#include "tetrarch/product/automatic.hpp"
#include "tetrarch/workshop/in_file.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace tetrarch::workshop {
namespace {

using product::Point;
using Weights = ProductOptions::Weights;

PartitionedSolid partition_by_search(const product::Solid& solid, const ProductOptions& options,
                                     const Progress& progress) {
  auto found = searched_partition(solid, options.threads, progress);
  if (!found) throw InputError("the search found no partition, which proves nothing");
  return std::move(*found);
}

PartitionedSolid partitioned(product::Solid solid, const ProductOptions& options, const Progress& progress) {
  return in_file(options.name, [&] {
    return options.partition ? options.partition(std::move(solid))
                             : partition_by_search(solid, options, progress);
  });
}

SolidSides sides_of(const PartitionedSolid& start) {
  const int patches = product::first_wall + start.partition.walls;
  SolidSides sides{start.solid.size(), start.how, std::vector<int>(static_cast<std::size_t>(patches), 0)};
  for (const int patch : start.partition.patch) ++sides.triangles[patch];
  return sides;
}

MeasuredHexahedra hexahedra_of(CarriedCubes&& carried) {
  MeasuredHexahedra result;
  result.of = std::move(*carried.hexahedra);
  result.carried_by = carried.how;
  return result;
}

/// The solid with its partition, and with the hexahedra of a polycube if there is one. Where the map alone
/// carries these well, no partition is sought that nobody asked for. Nothing where there are hexahedra and no
/// partition.
std::optional<PartitionedSolid> started(SolidProduct& found, product::Solid solid,
                                        const ProductOptions& options, const Progress& progress) {
  found.sides.tetrahedra = solid.size();
  const SolidMeasure original = options.polycube ? measure_of(solid) : SolidMeasure();
  CarriedCubes carried =
      options.polycube ? carried_by_map(solid, *options.polycube, options.threads, progress) : CarriedCubes();
  std::optional<PartitionedSolid> start;
  if (!carried.is_good() || options.is_partition_given || options.wants_coordinates) {
    try {
      start = partitioned(std::move(solid), options, progress);
      found.sides = sides_of(*start);
    } catch (const InputError& e) {
      if (!carried.hexahedra || options.is_partition_given) throw;
      found.why_undivided = e.what();
    }
  }
  if (!options.polycube) return start;
  if (start && !carried.is_good()) try_fibers(carried, *start, *options.polycube, options.threads, progress);
  found.hexahedra = hexahedra_of(std::move(carried));
  improve_and_measure(*found.hexahedra, original, options.hexahedra, progress);
  return start;
}

product::FloorMap floor_of(const product::SplitSolid& at, const ProductOptions& options,
                           const Progress& progress) {
  return in_file(options.name, [&] {
    product::FloorOptions how = options.floor ? options.floor(at) : product::FloorOptions();
    if (options.across > 0) how.domain = product::FloorDomain::rectangle;
    return product::floor_map(at.solid, at.partition, how, progress);
  });
}

/// With cotangent weights; where they leave critical places, and nobody asked for them, with clamped ones.
void solve_field(FiberedSolid& fibered, const ProductOptions& options, const Progress& progress) {
  const product::SplitSolid& at = fibered.at;
  for (const bool clamped : {false, true}) {
    if (options.weights == (clamped ? Weights::cotangent : Weights::clamped)) continue;
    fibered.field = product::harmonic_field(at.solid, at.partition,
                                            {.height = fibered.height, .clamped = clamped}, progress);
    fibered.critical = product::critical_places(at.solid, at.partition, fibered.field.w);
    fibered.clamped = clamped;
    if (fibered.critical.none()) break;
  }
}

/// Some of the fibers, from vertices of the floor that are spread over it.
void add_fibers(FiberedSolid::Coordinates& coordinates, const product::FiberField& field,
                const product::FloorMap& floor, int count) {
  const std::size_t all = floor.vertex.size();
  const std::size_t wanted = std::min(all, static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::size_t v = k * all / wanted;
    std::vector<Point> path;
    const product::Fiber fiber = field.trace(field.at_vertex(floor.vertex[v]), product::Way::up, path);
    if (path.size() < 2) continue;
    const std::complex<double> uv = floor.position[v];
    coordinates.fibers.push_back(std::move(path));
    coordinates.straight.push_back(
        {{uv.real(), uv.imag(), 0},
         {uv.real(), uv.imag(), product::value_at(field.solid(), field.w(), fiber.at)}});
  }
}

FiberedSolid::Coordinates coordinates_of(const FiberedSolid& fibered, const product::FiberField& field,
                                         const ProductOptions& options, const Progress& progress) {
  FiberedSolid::Coordinates result;
  result.of = product::coordinates(field, fibered.floor, options.threads, progress);
  result.quality = product::quality(fibered.at.solid, result.of.uvw);
  result.confirmation = product::confirm(field, options.threads, progress);
  add_fibers(result, field, fibered.floor, options.fibers);
  return result;
}

/// On a grid of the floor, along the fibers.
MeasuredHexahedra grid_hexahedra(const product::FiberField& field, const product::FloorMap& floor,
                                 const ProductOptions& options, const Progress& progress) {
  MeasuredHexahedra result;
  result.grid = product::floor_grid(floor.height, floor.rectangles, {.across = options.across});
  product::HexOptions hex;
  hex.threads = options.threads;
  hex.layers = options.layers > 0
                   ? options.layers
                   : std::max(1, static_cast<int>(std::lround(options.across * field.height())));
  result.of = product::hexahedra(field, *result.grid,
                                 product::nodes_on_floor(field.solid(), floor, *result.grid), hex, progress);
  improve_and_measure(result, measure_of(field.solid()), options.hexahedra, progress);
  return result;
}

/// Floor, field, and what hangs on the fibers. Those keep references to the solid, which has its place.
void add_fibered(SolidProduct& found, PartitionedSolid start, const ProductOptions& options,
                 const Progress& progress) {
  FiberedSolid& fibered = found.fibered.emplace();
  fibered.at = product::split_shortcuts(std::move(start.solid), std::move(start.partition));
  fibered.floor = floor_of(fibered.at, options, progress);
  fibered.height = options.height > 0
                       ? options.height
                       : product::natural_height(fibered.at.solid, fibered.at.partition, fibered.floor);
  solve_field(fibered, options, progress);
  if (!fibered.critical.none() && !options.passes_critical_points) return;
  if (!fibered.has_map()) return;
  const product::FiberField field(fibered.at.solid, fibered.at.partition, fibered.field.w, options.follow);
  fibered.coordinates = coordinates_of(fibered, field, options, progress);
  if (options.across > 0 && fibered.floor.found)
    found.hexahedra = grid_hexahedra(field, fibered.floor, options, progress);
}

} // namespace

std::optional<PartitionedSolid> searched_partition(const product::Solid& solid, int threads,
                                                   const Progress& progress) {
  auto found = product::automatic_partition(solid, {.threads = threads}, progress);
  if (!found) return std::nullopt;
  return PartitionedSolid{std::move(found->solid), std::move(found->partition), std::move(found->how),
                          std::move(found->splits)};
}

bool FiberedSolid::has_map() const {
  return floor.flipped < floor.mesh.surface.triangle_count();
}

std::vector<std::string> FiberedSolid::doubts() const {
  if (!coordinates) throw PreconditionError("doubts: there are no coordinates");
  std::vector<std::string> clauses;
  const auto doubt = [&](std::size_t count, const char* noun, const char* what) {
    if (count > 0) clauses.push_back(counted(static_cast<long long>(count), noun) + what);
  };
  const product::Confirmation& back = coordinates->confirmation;
  doubt(coordinates->quality.flipped.size(), "tetrahedron", " flipped");
  doubt(coordinates->of.stuck.size(), "fiber", " stuck");
  doubt(static_cast<std::size_t>(back.off), "vertex", " off by more than an edge, the opposite way");
  doubt(static_cast<std::size_t>(back.not_arrived), "fiber", " lost, the opposite way");
  if (!critical.none()) clauses.emplace_back("the field has critical points");
  return clauses;
}

std::vector<std::string> SolidProduct::doubts() const {
  std::vector<std::string> clauses;
  if (!is_of_polycube() && fibered && fibered->coordinates) clauses = fibered->doubts();
  if (hexahedra)
    for (std::string& doubt : hexahedra->doubts()) clauses.push_back(std::move(doubt));
  return clauses;
}

Verdict SolidProduct::verdict() const {
  if (!is_of_polycube() && fibered) {
    if (!fibered->critical.none()) return Verdict::proved_no;
    if (!fibered->floor.found) return Verdict::undecided;
  }
  return doubts().empty() ? Verdict::yes : Verdict::undecided;
}

SolidProduct solid_product(product::Solid solid, const ProductOptions& options, const Progress& progress) {
  if (options.across > 0 && options.polycube)
    throw PreconditionError("solid_product: hexahedra across the floor and of a polycube exclude each other");
  const auto begin = std::chrono::steady_clock::now();
  SolidProduct found;
  if (auto start = started(found, std::move(solid), options, progress))
    add_fibered(found, std::move(*start), options, progress);
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return found;
}

format::Soup labelled_mesh(const product::SplitSolid& solid) {
  const product::Solid& of = solid.solid;
  format::Soup soup;
  soup.points = of.mesh.points;
  soup.tetrahedra = of.mesh.tetrahedra;
  for (int t = 0; t < of.boundary.triangle_count(); ++t) {
    soup.triangles.push_back({of.corner(t, 0), of.corner(t, 1), of.corner(t, 2)});
    soup.triangle_tags.push_back(solid.partition.patch[t] + 1);
  }
  return soup;
}

} // namespace tetrarch::workshop
