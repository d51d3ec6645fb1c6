// SPDX-License-Identifier: GPL-2.0-or-later

/// Shapes of cusps in balls: those known by hand, and those of another program by another way.

#include "certified.hpp"

#include "tetrarch/hyperbolic/cusp.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <complex>
#include <fstream>
#include <sstream>

using namespace tetrarch;
using numeric::Ball;
using support::Certified;
using Shape = hyperbolic::CuspShape<Ball>;

namespace {

/// In the arithmetic of the proof.
std::vector<Shape> shapes_of(const Certified& c) {
  const numeric::WorkingPrecision precision(c.result.proof->bits);
  return hyperbolic::cusp_shapes(c.tri, c.skeleton, c.result.proof->lengths);
}

bool is_narrow(const Ball& x, double width) {
  return radius(x) < Ball(width);
}

/// The double is one of the ball, but for its own rounding.
bool meets(const Ball& x, double value) {
  return overlap(x, widened(Ball(value), Ball(1e-15 * (1 + std::abs(value)))));
}

/// Of one lattice: on the rim of the region that shapes are taken from, several are.
bool are_same(const Shape& shape, std::complex<double> z) {
  for (const std::complex<double> turned : {z, -1.0 / z})
    for (const double shift : {-1.0, 0.0, 1.0})
      if (meets(shape.real, turned.real() + shift) && meets(shape.imaginary, turned.imag())) return true;
  return false;
}

std::complex<double> mirrored(std::complex<double> z) {
  return -std::conj(z);
}

/// "re im,re im".
std::vector<std::complex<double>> read_shapes(const std::string& text) {
  std::vector<std::complex<double>> list;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t space = part.find(' ');
    list.emplace_back(std::stod(part), std::stod(part.substr(space)));
  }
  return list;
}

/// Each once, in some order.
bool are_same(std::vector<Shape> shapes, const std::vector<std::complex<double>>& known, bool mirror) {
  for (const std::complex<double>& z : known) {
    const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& shape) {
      return are_same(shape, mirror ? mirrored(z) : z);
    });
    if (found == shapes.end()) return false;
    shapes.erase(found);
  }
  return shapes.empty();
}

/// Each cusp has one of the shapes or its mirror image, and each shape is some cusp's.
bool are_covered(const std::vector<Shape>& shapes, const std::vector<std::complex<double>>& known) {
  const auto fit = [](const Shape& shape, std::complex<double> z) {
    return are_same(shape, z) || are_same(shape, mirrored(z));
  };
  return std::all_of(shapes.begin(), shapes.end(),
                     [&](const Shape& shape) {
                       return std::any_of(known.begin(), known.end(),
                                          [&](const auto& z) { return fit(shape, z); });
                     }) &&
         std::all_of(known.begin(), known.end(), [&](const auto& z) {
           return std::any_of(shapes.begin(), shapes.end(),
                              [&](const Shape& shape) { return fit(shape, z); });
         });
}

} // namespace

TEST_CASE("balls hold the shapes known by hand", "[verified]") {
  // As in tests/hyperbolic/cusp_test.cpp, with the witnesses there. The figure-eight knot: the longitude is
  // 2 sqrt(3) i times the meridian (Thurston's notes, chapter 4); the Gieseking manifold's Klein bottle is
  // covered by this torus. Squared parts, so that they are rational.
  const struct {
    const char* signature;
    std::size_t count;
    double twice_real, squared_imaginary;
  } known[] = {{"cPcbbbiht", 1, 0, 12},
               {"bkaaid", 1, 0, 12},
               {"cPcbbbdxm", 1, 1, 0.75},
               {"eLPkbdcddhgggb", 2, 0, 4},
               {"gvLQQcdeffeffffaafa", 3, 1, 1.75}};
  for (const auto& k : known)
    for (const int bits : {53, 106, 400}) {
      CAPTURE(k.signature, bits);
      const Certified c(k.signature, {bits, bits, false});
      REQUIRE(c.result.proof);
      const std::vector<Shape> shapes = shapes_of(c);
      CHECK(shapes.size() == k.count);
      const numeric::WorkingPrecision beyond(500);
      const double width = 1e6 * numeric::to_double(c.result.proof->radius) + std::ldexp(1.0, 20 - bits);
      CAPTURE(width);
      for (const Shape& shape : shapes) {
        CHECK(contains(shape.real, Ball(k.twice_real / 2)));
        CHECK(contains(shape.imaginary, sqrt(Ball(k.squared_imaginary))));
        CHECK(is_narrow(shape.real, width));
        CHECK(is_narrow(shape.imaginary, width));
      }
    }
}

TEST_CASE("balls that know little of the lengths hold the shape, too", "[verified]") {
  const Certified c("dLQbcccdero"); // 5_2: SnapPy's documentation prints the shape
  REQUIRE(c.result.proof);
  hyperbolic::Metric<Ball> lengths = c.result.proof->lengths;
  for (Ball& length : lengths) length = widened(length, Ball(1e-7));
  const auto wide = hyperbolic::cusp_shapes(c.tri, c.skeleton, lengths).at(0);
  const auto narrow = shapes_of(c).at(0);
  CHECK(contains(wide.real, narrow.real));
  CHECK(contains(wide.imaginary, narrow.imaginary));
  CHECK(!is_narrow(wide.real, 1e-7));
  CHECK(is_narrow(wide.real, 1e-3));
  CHECK(std::abs(numeric::to_double(narrow.real) + 0.49024466751) < 1e-11);
  CHECK(std::abs(numeric::to_double(narrow.imaginary) - 2.97944706648) < 1e-11);
}

TEST_CASE("shapes in balls hold those that SnapPea's gluing equations give", "[verified]") {
  std::ifstream lines(TETRARCH_SOURCE_DIR "/tests/oracle/snappea_cusp_shapes.txt");
  int count = 0;
  int non_orientable = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    CAPTURE(line);
    const std::size_t first = line.find('|');
    const std::size_t second = line.find('|', first + 1);
    const Certified c(line.substr(first + 1, second - first - 1), {117, 212, false});
    REQUIRE(c.result.proof);
    const std::vector<Shape> shapes = shapes_of(c);
    const auto known = read_shapes(line.substr(second + 1));
    if (c.skeleton.is_orientable())
      CHECK((are_same(shapes, known, false) || are_same(shapes, known, true)));
    else
      CHECK(are_covered(shapes, known));
    for (const Shape& shape : shapes)
      CHECK((is_narrow(shape.real, 1e-20) && is_narrow(shape.imaginary, 1e-20)));
    ++count;
    non_orientable += c.skeleton.is_orientable() ? 0 : 1;
  }
  CHECK(count == 203);
  CHECK(non_orientable == 40);
}
