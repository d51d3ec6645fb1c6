// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/tetgen/fill.hpp"

#include "support/soups.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/doctor/closed_surface.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace tetrarch;
using namespace tetrarch::tetgen;
using namespace tetrarch::doctor;
using namespace tetrarch::solid;
using namespace tetrarch::support::soups;
using support::error_of;

namespace {

using Triangles = std::vector<std::array<int, 3>>;

std::string complaint(const Triangles& triangles) {
  return error_of([&] { require_closed_surface(soup_of(cube_points(), {}, triangles)); });
}

Triangles with_first(const std::array<int, 3>& triangle) {
  Triangles surface = cube_surface();
  surface[0] = triangle;
  return surface;
}

bool has_tetgen() {
  return std::system("command -v tetgen >/dev/null 2>&1") == 0;
}

} // namespace

TEST_CASE("what is no closed surface is refused", "[fill]") {
  CHECK(complaint(cube_surface()).empty());
  CHECK(complaint({}) == "f: the surface has no triangles");
  CHECK(complaint(with_first({0, 1, 9})) ==
        "f:15: triangle 1 names vertex 10, which is none of the 8 there are");
  CHECK(complaint(with_first({0, 1, 1})) == "f:15: triangle 1 names vertex 2 twice");
  CHECK(complaint(with_first({0, 3, 1})) ==
        "f:15: triangle 1 is turned against its neighbor 12 at the edge on vertices 2, 4");
  Triangles open = cube_surface();
  open.erase(open.begin());
  CHECK(complaint(open) ==
        "f:19: triangle 5 is alone at the edge on vertices 1, 2: the surface is not closed");
  Triangles three = cube_surface();
  three.push_back({0, 1, 6});
  CHECK(complaint(three) == "f:27: the edge on vertices 1, 2 is shared by 3 triangles, among them 1, 6, 13 "
                            "(and 1 more)");
}

TEST_CASE("surfaces that touch, or of several components, are refused", "[fill]") {
  // Two tetrahedra's boundaries, with one vertex in common or none.
  const auto boundary = [](int a, int b, int c, int d) {
    return Triangles{{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
  };
  Triangles touching = boundary(0, 1, 2, 4);
  for (const auto& triangle : boundary(0, 3, 5, 6)) touching.push_back(triangle);
  CHECK(complaint(touching) ==
        "f:5: the triangles around vertex 1 fall apart into 2 fans, among them those of "
        "triangle 1 and 5 (and 1 more)");
  Triangles apart = boundary(0, 1, 2, 4);
  for (const auto& triangle : boundary(7, 3, 5, 6)) apart.push_back(triangle);
  CHECK(complaint(apart) ==
        "f:19: the surface falls apart into 2 components: triangle 5 is not connected with "
        "triangle 1");
}

TEST_CASE("a missing program is named, with its package", "[fill]") {
  const format::Soup cube = soup_of(cube_points(), {}, cube_surface());
  CHECK(error_of([&] { fill(cube, {}, {"no-such-tetgen"}); }) ==
        "f: a surface is filled by the program 'no-such-tetgen', which is not installed (Debian package "
        "tetgen)");
  CHECK(error_of([&] { fill(cube, {}, {"false"}); }) ==
        "f: the program 'false' failed on the surface, which may meet itself: ''");
  CHECK(error_of([&] { fill(cube, {}, {"true"}); }) == "f: the program 'true' gave no tetrahedra: ''");
}

namespace {

/// A program in the place of TetGen, while it lives.
class Script {
public:
  explicit Script(const std::string& does)
      : path_(std::filesystem::temp_directory_path() / ("tetrarch-mesh-" + std::to_string(::getpid()))) {
    std::ofstream(path_) << "#!/bin/sh\n" << does << "\n";
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all);
  }
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;
  ~Script() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  std::string name() const { return path_.string(); }

private:
  std::filesystem::path path_;
};

} // namespace

TEST_CASE("stopping ends the filling, and the program with it", "[fill]") {
  const Script script("exec sleep 60");
  std::stop_source stop;
  stop.request_stop();
  const format::Soup cube = soup_of(cube_points(), {}, cube_surface());
  const auto start = std::chrono::steady_clock::now();
  CHECK_THROWS_AS(fill(cube, Progress({}, stop.get_token()), {script.name()}), Stopped);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  CHECK(seconds.count() < 30);
}

TEST_CASE("a program that does not end by itself is ended", "[fill]") {
  const Script script("while :; do :; done");
  const format::Soup cube = soup_of(cube_points(), {}, cube_surface());
  CHECK(error_of([&] {
          fill(cube, {}, {script.name(), 1});
        }) == "f: the program '" + script.name() + "' did not end within 1 s: the surface may meet itself");
}

TEST_CASE("TetGen fills a cube, if it is installed", "[fill]") {
  if (!has_tetgen()) {
    WARN("tetgen is not installed: nothing was filled");
    return;
  }
  const Triangulation ball = triangulation_of(build(fill(soup_of(cube_points(), {}, cube_surface()))));
  const Skeleton skeleton(ball);
  CHECK(skeleton.component_count() == 1);
  CHECK(skeleton.boundary_face_count() == 12); // the surface stays as it is
  CHECK(skeleton.vertex_count() - skeleton.edge_count() + skeleton.face_count() - ball.size() == 1);
}
