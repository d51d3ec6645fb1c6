// SPDX-License-Identifier: GPL-2.0-or-later
#include "carried_cubes.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/product/polycube.hpp"
#include "tetrarch/product/polycube_pullback.hpp"
#include "tetrarch/workshop/in_file.hpp"
#include "tetrarch/workshop/text.hpp"

#include <limits>
#include <utility>

namespace tetrarch::workshop {
namespace {

using Images = std::vector<product::Point>;

/// Of each vertex of the solid's boundary.
Images boundary_images(const product::Solid& solid, const Images& image, const std::string& name) {
  Images result;
  result.reserve(solid.vertex.size());
  for (const int v : solid.vertex) {
    if (v >= static_cast<int>(image.size()))
      throw InputError({name, 0}, "the polycube has no image of vertex v" + std::to_string(v) +
                                      ": the file has " +
                                      counted(static_cast<long long>(image.size()), "vertex"));
    result.push_back(image[v]);
  }
  return result;
}

product::PolycubeOptions lattice_of(const PolycubeImage& polycube, int threads) {
  product::PolycubeOptions result;
  result.step = polycube.step;
  result.cells = polycube.cells;
  result.threads = threads;
  return result;
}

/// Taken if better: fewer left out, or as many and of better quality.
void offer(CarriedCubes& best, product::SolidHexahedra found, const char* how) {
  product::HexQuality quality = product::quality(found.mesh);
  if (best.hexahedra &&
      (found.left_out > best.hexahedra->left_out ||
       (found.left_out == best.hexahedra->left_out && !product::is_better(quality, best.quality))))
    return;
  best.hexahedra = std::move(found);
  best.quality = std::move(quality);
  best.how = how;
}

/// The images with those of the points that were put into edges since.
Images images_with_splits(Images image, const PartitionedSolid& start) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  image.resize(start.solid.mesh.points.size() - start.splits.size(), {none, none, none});
  for (const solid::EdgePoint& s : start.splits) {
    product::Point p = image[s.from];
    for (std::size_t a = 0; a < 3; ++a) p[a] += s.part * (image[s.to][a] - p[a]);
    image.push_back(p);
  }
  return image;
}

} // namespace

bool CarriedCubes::is_good() const {
  // Above 0.2 solvers are content; below, another way may do better.
  constexpr double content = 0.2;
  return hexahedra && hexahedra->left_out == 0 && quality.bad.empty() && quality.minimum >= content;
}

CarriedCubes carried_by_map(const product::Solid& solid, const PolycubeImage& polycube, int threads,
                            const Progress& progress) {
  const Images boundary = boundary_images(solid, polycube.image, polycube.name);
  CarriedCubes best;
  const auto try_map = [&](const Images& image, const char* how) {
    if (!product::folded(solid, image).empty()) return;
    product::PolycubeHexahedra found = in_file(polycube.name, [&] {
      return product::pulled_back(solid, image, lattice_of(polycube, threads), progress);
    });
    offer(best, std::move(found.solid), how);
  };
  const std::size_t count = solid.mesh.points.size();
  if (polycube.image.size() >= count)
    try_map({polycube.image.begin(), polycube.image.begin() + static_cast<std::ptrdiff_t>(count)},
            "the map in the file");
  for (const bool clamped : {false, true}) {
    if (best.is_good()) break;
    if (const auto image = product::harmonic_image(solid, boundary, clamped))
      try_map(*image, clamped ? "a harmonic map, with clamped weights" : "a harmonic map");
  }
  if (!best.is_good())
    if (const auto start = product::harmonic_image(solid, boundary, true))
      if (const auto image = product::unfolded_image(solid, *start, progress))
        try_map(*image, "an unfolded map");
  return best;
}

void try_fibers(CarriedCubes& carried, const PartitionedSolid& start, const PolycubeImage& polycube,
                int threads, const Progress& progress) {
  const Images image = images_with_splits(polycube.image, start);
  std::vector<int> base;
  base.reserve(start.partition.patch.size());
  for (const int patch : start.partition.patch) base.push_back(patch < product::first_wall ? patch : -1);
  try {
    product::PolycubeHexahedra found = in_file(polycube.name, [&] {
      return product::polycube_hexahedra(start.solid, boundary_images(start.solid, image, polycube.name),
                                         base, lattice_of(polycube, threads), progress);
    });
    offer(carried, std::move(found.solid), "fibers");
  } catch (const InputError&) { // the partition does not fit the lattice: what there is has to do
    if (!carried.hexahedra) throw;
  }
}

} // namespace tetrarch::workshop
