// SPDX-License-Identifier: GPL-2.0-or-later
/// Surfaces against themselves, transformed at random by what no conformal number may notice: renumbered,
/// divided, turned, scaled, inverted in a sphere.
#include "support/planar_domains.hpp"
#include "support/random.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/surface/refine.hpp"
#include "tetrarch/workshop/fingerprint.hpp"
#include "tetrarch/workshop/open.hpp"
#include "tetrarch/workshop/registration.hpp"
#include "tetrarch/workshop/surface.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace tetrarch;
using namespace tetrarch::workshop;
using numeric::Point;
using numeric::Vector;
using numeric::operator+;
using numeric::operator-;
using numeric::operator*;

namespace {

HoledSurface with_holes(surface::TriangleMesh mesh) {
  NumberedSurface surface;
  surface.mesh = std::move(mesh);
  return opened(surface);
}

surface::TriangleMesh ring_with_holes() {
  return surface_of(open_mesh(TETRARCH_SOURCE_DIR "/tests/data/mesh/ring_two_holes.off")).mesh;
}

/// A cylinder with two cracks, bent to a piece of a torus whose tube grows: nothing about it is flat or
/// symmetric.
surface::TriangleMesh bent_tube() {
  support::CylinderGrid grid;
  grid.sectors = 36;
  grid.rings = 12;
  grid.height = 2;
  grid.cracks = {{3, 2, 9}, {8, 20, 6}};
  return support::cracked_cylinder(grid,
                                   [](const support::OnCylinder& p) {
                                     const double tube = 1 + 0.3 * p.height;
                                     const double radius = 4 + tube * std::cos(p.angle);
                                     return Point{radius * std::cos(p.height), radius * std::sin(p.height),
                                                  tube * std::sin(p.angle)};
                                   })
      .mesh;
}

struct Box {
  Point center{};
  double diameter = 0;
};
Box box_of(const surface::TriangleMesh& mesh) {
  Point least = mesh.points.front();
  Point most = least;
  for (const Point& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]);
      most[k] = std::max(most[k], p[k]);
    }
  return {least + 0.5 * (most - least), numeric::length(most - least)};
}

Vector random_direction(support::Random& random) {
  for (;;) {
    const Vector v{2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1};
    const double size = numeric::length(v);
    if (size > 0.1 && size < 1) return (1 / size) * v;
  }
}

/// The mirror image in a plane; two of them turn.
void reflect(surface::TriangleMesh& mesh, const Vector& normal) {
  for (Point& p : mesh.points) p = p + (-2 * numeric::dot(p - Point{}, normal)) * normal;
}

/// In a sphere one diameter away at least, followed by a mirror image, so that orientations stay.
void invert(surface::TriangleMesh& mesh, support::Random& random) {
  const Box box = box_of(mesh);
  const Point center = box.center + ((1 + random.uniform()) * box.diameter) * random_direction(random);
  for (Point& p : mesh.points) {
    const Vector away = p - center;
    p = center + (box.diameter * box.diameter / numeric::dot(away, away)) * away;
  }
  reflect(mesh, random_direction(random));
}

struct Transformed {
  surface::TriangleMesh mesh;
  std::vector<int> name; ///< of each vertex: its number there
};

Transformed transformed(const surface::TriangleMesh& mesh, support::Random& random, bool divided,
                        bool inverted) {
  surface::TriangleMesh moved = divided ? surface::refined(mesh) : mesh;
  if (inverted) invert(moved, random);
  reflect(moved, random_direction(random));
  reflect(moved, random_direction(random));
  const double scale = std::pow(10.0, 6 * random.uniform() - 3);
  for (Point& p : moved.points)
    for (double& x : p) x = scale * (x + 1);
  std::vector<int> name(moved.points.size());
  std::iota(name.begin(), name.end(), 0);
  random.shuffle(name);
  format::Soup soup;
  soup.points.resize(name.size());
  for (std::size_t v = 0; v < name.size(); ++v) soup.points[name[v]] = moved.points[v];
  soup.triangles = moved.surface.triangles();
  random.shuffle(soup.triangles);
  for (auto& triangle : soup.triangles) {
    for (int& v : triangle) v = name[v];
    std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
  }
  return {doctor::build_surface(std::move(soup)), std::move(name)};
}

} // namespace

TEST_CASE("the conformal type of a surface stays, whatever it is transformed by", "[workshop]") {
  FingerprintOptions coarse;
  coarse.most_triangles = 30'000;
  const std::array<surface::TriangleMesh, 2> surfaces{ring_with_holes(), bent_tube()};
  std::array<ConformalType, 2> types{conformal_type(with_holes(surfaces[0]), coarse),
                                     conformal_type(with_holes(surfaces[1]), coarse)};
  for (unsigned seed = 1; seed <= 16; ++seed) {
    support::Random random(seed);
    const auto which = static_cast<std::size_t>(seed % 2);
    const bool divided = random.below(2) == 0;
    const bool inverted = random.below(2) == 0;
    INFO("seed " << seed << (divided ? " divided" : "") << (inverted ? " inverted" : ""));
    const Transformed other = transformed(surfaces[which], random, divided, inverted);
    const ConformalType found = conformal_type(with_holes(other.mesh), coarse);
    const auto compared = comparison(types[which], found);
    CHECK(compared.distance < 1e-3);
    UNSCOPED_INFO("distance " << compared.distance);
    CHECK(compared.second_distance.value_or(1) > 0.01);
  }
}

TEST_CASE("a surface is registered with itself, whatever it is transformed by", "[workshop]") {
  // Fine enough: a triangulation and a finer one of it are not the same to harmonic functions.
  const std::array<surface::TriangleMesh, 2> surfaces{surface::refined(ring_with_holes()),
                                                      surface::refined(bent_tube())};
  for (unsigned seed = 1; seed <= 8; ++seed) {
    support::Random random(seed);
    const surface::TriangleMesh& mesh = surfaces[seed % 2];
    const bool divided = seed > 4;
    INFO("seed " << seed);
    const Transformed other = transformed(mesh, random, divided, false);
    const SurfaceRegistration found = registration(with_holes(mesh), with_holes(other.mesh));
    CHECK(found.verdict() == Verdict::yes);
    CHECK(found.points.flipped.empty());
    double sum = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      sum += numeric::length(found.points.resampled[v] - other.mesh.points[other.name[v]]);
    CHECK(sum / static_cast<double>(mesh.points.size()) < 1e-3 * box_of(other.mesh).diameter);
  }
}
