// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/maximum.hpp"
#include "tetrarch/product/polycube.hpp"

#include "hexahedron.hpp"
#include "polycube_sheets.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/parallel.hpp"
#include "tetrarch/product/field.hpp"
#include "tetrarch/product/product.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

/// A solid with its fibres. Not to be moved: the fibres keep references.
struct Fibered {
  Fibered(const Solid& solid, const Partition& partition, Direction direction, const Progress& progress)
      : ready(split_shortcuts(solid, partition)),
        field(ready.solid, ready.partition,
              harmonic_field(ready.solid, ready.partition, {}, progress.silent()).w, direction) {}
  Fibered(const Fibered&) = delete;
  Fibered& operator=(const Fibered&) = delete;
  ~Fibered() = default;

  SplitSolid ready;
  FiberField field;
};

Point in_steps(Point p, double step) {
  for (double& x : p) x /= step;
  return p;
}

/// The bases of M as those of the cubes: that of the triangle over the middle of each.
std::vector<int> carried_bases(const Solid& cubes, const Sheets& all, const std::vector<int>& base,
                               double step) {
  std::vector<int> result;
  for (int t = 0; t < cubes.boundary.triangle_count(); ++t) {
    Point middle{};
    for (int c = 0; c < 3; ++c)
      for (int a = 0; a < 3; ++a) middle[a] += cubes.point(cubes.corner(t, c))[a] / step / 3;
    result.push_back(base[located(all, middle).triangle]);
  }
  return result;
}

/// Where both kinds of a base have the same area, no triangle crosses the rim. `area` is of a triangle of
/// the cubes, in squares of the lattice.
void require_rims(const Sheets& all, const surface::Surface& boundary, const std::vector<Point>& image,
                  const std::vector<int>& base, const std::vector<int>& carried, double area) {
  for (const int which : {floor_patch, ceiling_patch}) {
    double wanted = 0;
    for (const auto& [facing, sheet] : all)
      for (const int t : sheet.triangles) {
        if (base[t] != which) continue;
        const auto& v = boundary.corners(t);
        const std::complex<double> origin = flat(facing, image[v[0]]);
        wanted +=
            (std::conj(flat(facing, image[v[1]]) - origin) * (flat(facing, image[v[2]]) - origin)).imag() / 2;
      }
    const double found = area * static_cast<double>(std::count(carried.begin(), carried.end(), which));
    constexpr double rounding = 1e-3;
    if (std::abs(found - wanted) > rounding * wanted)
      throw InputError("on the polycube the rim of base " + std::to_string(which) +
                       " does not follow edges of the lattice: its area is " + std::to_string(wanted) +
                       " squares, that of the faces in it " + std::to_string(found));
  }
}

/// Where a fibre comes down on the floor of the cubes, on the floor of M.
class Feet {
public:
  Feet(const Solid& before, const std::vector<Point>& image, const std::vector<Facing>& facing,
       const std::vector<int>& base, const SplitSolid& after, double step)
      : step_(step) {
    std::vector<char> wanted;
    wanted.reserve(base.size());
    for (const int b : base) wanted.push_back(static_cast<char>(b == floor_patch));
    floor_ = sheets(before.boundary, image, facing, wanted);
    // What `split_shortcuts` splits are edges that are on no base; triangles of the floor are what they were.
    std::map<std::array<int, 3>, int> number;
    for (int t = 0; t < after.solid.boundary.triangle_count(); ++t)
      if (after.partition.patch[t] == floor_patch) number[sorted(after.solid, t)] = t;
    now_.assign(base.size(), {});
    for (int t = 0; t < static_cast<int>(base.size()); ++t) {
      if (base[t] != floor_patch) continue;
      now_[t].triangle = number.at(sorted(before, t));
      for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 3; ++k)
          if (after.solid.corner(now_[t].triangle, k) == before.corner(t, c)) now_[t].corner[c] = k;
    }
  }

  FloorPoint on_floor(const Point& foot) const {
    const OnSurface there = located(floor_, in_steps(foot, step_));
    if (there.triangle < 0)
      throw InputError("the floor of the cubes is not where the image of the solid's is");
    const Now& now = now_[there.triangle];
    FloorPoint point{now.triangle, {}, there.outside * step_};
    for (int c = 0; c < 3; ++c) point.weight[now.corner[c]] = there.weight[c];
    return point;
  }

private:
  /// A triangle of M in the prepared solid.
  struct Now {
    int triangle = -1;
    std::array<int, 3> corner{};
  };
  static std::array<int, 3> sorted(const Solid& solid, int t) {
    std::array<int, 3> v{solid.corner(t, 0), solid.corner(t, 1), solid.corner(t, 2)};
    std::sort(v.begin(), v.end());
    return v;
  }

  double step_;
  Sheets floor_;
  std::vector<Now> now_; ///< of each triangle of the floor
};

/// A corner of a cube in M.
struct Image {
  Point point{};
  double miss = 0;
  bool is_stuck = false;
  StuckNode stuck;
};

Image carried(const Fibered& cubes, const Feet& feet, const Fibered& solid, int node, int vertex) {
  const Location from = cubes.field.at_vertex(vertex);
  const Fiber down = cubes.field.trace(from, Way::down);
  Image image;
  const Point foot = point_at(cubes.ready.solid, down.at);
  if (down.end != FiberEnd::base) {
    image.is_stuck = true;
    image.stuck = {node, 0, down.end, foot};
    return image;
  }
  const FloorPoint start = feet.on_floor(foot);
  image.miss = start.miss;
  const Location bottom = solid.field.on_triangle(start.triangle, start.weight);
  const double level = cubes.field.w()[vertex];
  const Fiber up = level >= cubes.field.height() ? solid.field.trace(bottom, Way::up)
                                                 : solid.field.trace_to(bottom, Way::up, level);
  image.point = point_at(solid.ready.solid, up.at);
  image.is_stuck = up.end != FiberEnd::base && up.end != FiberEnd::level;
  image.stuck = {node, 1, up.end, image.point};
  return image;
}

/// The vertex of the finer cubes at each point of the coarser ones.
std::vector<int> vertices_at(const std::vector<Point>& coarse, const std::vector<Point>& fine, double edge) {
  const auto key = [edge](const Point& p) {
    return std::array{std::lround(p[0] / edge), std::lround(p[1] / edge), std::lround(p[2] / edge)};
  };
  std::map<std::array<long, 3>, int> number;
  for (std::size_t v = 0; v < fine.size(); ++v) number[key(fine[v])] = static_cast<int>(v);
  std::vector<int> result;
  result.reserve(coarse.size());
  for (const Point& p : coarse) result.push_back(number.at(key(p)));
  return result;
}

void collect(PolycubeHexahedra& result, const std::vector<Image>& images, const Solid& cubes,
             const std::vector<int>& vertex) {
  std::vector<int> number(images.size(), -1);
  for (std::size_t node = 0; node < images.size(); ++node) {
    result.farthest = numeric::maximum(result.farthest, images[node].miss);
    if (images[node].is_stuck) {
      result.solid.stuck.push_back(images[node].stuck);
      continue;
    }
    number[node] = static_cast<int>(result.solid.mesh.points.size());
    result.solid.mesh.points.push_back(images[node].point);
    result.solid.on_boundary.push_back(static_cast<char>(cubes.on_boundary[vertex[node]] >= 0));
  }
  add_whole_cubes(result, number);
}

} // namespace

PolycubeHexahedra polycube_hexahedra(const Solid& solid, const std::vector<Point>& image,
                                     const std::vector<int>& base, const PolycubeOptions& options,
                                     const Progress& progress) {
  if (options.finer < 1)
    throw PreconditionError("the polycube's field needs at least one cell for a hexahedron");
  progress.step("polycube");
  const std::vector<Point> at = snapped(solid.boundary, image, options.step);
  const std::vector<Facing> facing = facings(solid.boundary, at);
  const Partition partition_of_solid = partition(solid, base);
  PolycubeHexahedra result;
  result.cubes = hexahedra(filled_polycube(solid.boundary, image, options.step, options.cells));

  const Polycube fine = filled_polycube(solid.boundary, image, options.step, options.cells * options.finer);
  const Solid cubes = product::solid_of(tetrahedra(fine));
  const Sheets all = sheets(solid.boundary, at, facing);
  const std::vector<int> base_of_cubes = carried_bases(cubes, all, base, options.step);
  const double squares = std::pow(fine.edge / options.step, 2);
  require_rims(all, solid.boundary, at, base, base_of_cubes, squares / 2);

  progress.step("fields");
  const Fibered from(cubes, partition(cubes, base_of_cubes), options.direction, progress);
  const Fibered to(solid, partition_of_solid, options.direction, progress);
  const Feet feet(solid, at, facing, base, to.ready, options.step);
  const std::vector<int> vertex = vertices_at(result.cubes.points, cubes.mesh.points, fine.edge);
  std::vector<Image> images(vertex.size());
  numeric::parallel_for(
      static_cast<int>(vertex.size()), {options.threads, 16},
      [&](int node) { images[node] = carried(from, feet, to, node, vertex[node]); },
      [&](double part) { progress.step("hexahedra", part); });
  collect(result, images, from.ready.solid, vertex);
  return result;
}

} // namespace tetrarch::product
