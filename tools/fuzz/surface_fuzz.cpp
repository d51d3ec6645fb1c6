// SPDX-License-Identifier: GPL-2.0-or-later
// Whole commands on surfaces: bytes bend, tear and glue a small ring, torus or disk with holes, which is then
// checked, mended, mapped and made the base of a circle bundle. Whatever the surface, there is a result of
// numbers, a reason why there is none, or one line of error; triangles said to be turned over are those that
// are.
#include "fuzz.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/doctor/validate_surface.hpp"
#include "tetrarch/workshop/bundle.hpp"
#include "tetrarch/workshop/openings.hpp"
#include "tetrarch/workshop/slit.hpp"
#include "tetrarch/workshop/surface.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace tetrarch;

/// Bytes one after the other, then zeros.
class Bytes {
public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  bool empty() const { return left_ == 0; }
  int next() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  int below(std::size_t count) { return (next() + 256 * next()) % static_cast<int>(count); }

private:
  const std::uint8_t* data_;
  std::size_t left_;
};

/// A grid of squares, cut in two: closed around both ways, around one, or with three squares missing.
format::Soup base(int kind) {
  constexpr int rows = 5;
  constexpr int columns = 6;
  const bool around = kind != 2;
  const int lines = kind == 1 ? rows : rows + 1;
  const int sectors = around ? columns : columns + 1;
  format::Soup soup;
  soup.source = "fuzz";
  for (int i = 0; i < lines; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double t = 2 * std::numbers::pi * j / columns;
      const double s = 2 * std::numbers::pi * i / rows;
      if (kind == 1)
        soup.points.push_back(
            {(3 + std::cos(s)) * std::cos(t), (3 + std::cos(s)) * std::sin(t), std::sin(s)});
      else if (around)
        soup.points.push_back({(1 + i) * std::cos(t), (1 + i) * std::sin(t), 0});
      else
        soup.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
    }
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      if (kind == 2 && (i == 1 || i == 3) && (j == 1 || (j == 4 && i == 1))) continue;
      const auto at = [&](int x, int y) { return x % lines * sectors + y % sectors; };
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return soup;
}

/// One change a time, of a point or of a triangle.
void change(format::Soup& soup, Bytes& bytes) {
  const int what = bytes.next() % 7;
  std::array<double, 3>& point = soup.points[static_cast<std::size_t>(bytes.below(soup.points.size()))];
  std::array<int, 3>& triangle = soup.triangles[static_cast<std::size_t>(bytes.below(soup.triangles.size()))];
  const int amount = bytes.next();
  switch (what) {
  case 0: // moved along an axis
    point[static_cast<std::size_t>(amount % 3)] += (bytes.next() - 128) / 64.0;
    break;
  case 1: // to the place of another, or next to it
    point = soup.points[static_cast<std::size_t>(bytes.below(soup.points.size()))];
    point[0] += std::ldexp(1.0, -amount);
    break;
  case 2: // far away
    point[static_cast<std::size_t>(amount % 3)] = std::ldexp(1.0, (bytes.next() - 128) * 4);
    break;
  case 3: // everything in another unit, or flattened
    for (std::array<double, 3>& p : soup.points)
      p[static_cast<std::size_t>(amount % 3)] *= std::ldexp(1.0, bytes.next() - 128);
    break;
  case 4: // glued to another vertex
    triangle[static_cast<std::size_t>(amount % 3)] = bytes.below(soup.points.size());
    break;
  case 5: // gone
    if (soup.triangles.size() > 1) {
      triangle = soup.triangles.back();
      soup.triangles.pop_back();
    }
    break;
  default: // turned over
    std::swap(triangle[0], triangle[1]);
  }
}

void require_numbers(const workshop::ConformalMap& found) {
  for (const auto& place : found.layout.places)
    for (const double x : place) fuzz::require(std::isfinite(x), "places are numbers");
  fuzz::require(std::isfinite(found.distortion.mean_angle_error), "distortions are numbers");
  std::size_t turned = 0;
  for (const std::array<int, 3>& corners : found.layout.corners) {
    const auto at = [&](int k) {
      return found.layout.places[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
    };
    const auto [a, b, c] = std::array{at(0), at(1), at(2)};
    turned += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0;
  }
  const std::size_t flipped = found.flipped();
  fuzz::require(turned <= flipped + static_cast<std::size_t>(found.distortion.ears),
                "triangles turned over are told");
  fuzz::require(flipped == 0 || found.verdict() != workshop::Verdict::yes, "flips are no yes");
}

void map_it(const workshop::NumberedSurface& surface, Bytes& bytes) {
  using enum workshop::MapDomain;
  constexpr std::array domains{cylindric, parallel, concentric, circular, free};
  workshop::MapOptions options;
  options.domain = domains[static_cast<std::size_t>(bytes.next()) % domains.size()];
  options.intrinsic = bytes.next() % 4 == 1;
  require_numbers(workshop::conformal_map(workshop::opened(surface), options));
}

void run(Bytes& bytes) {
  format::Soup soup = base(bytes.next() % 3);
  const int job = bytes.next();
  workshop::Doctor doctor;
  doctor.repair = job / 2 % 2 == 1;
  Bytes options = bytes;
  options.next();
  for (int k = bytes.next() % 8; k > 0 && !bytes.empty(); --k) change(soup, bytes);
  doctor::validate_surface(soup);
  const workshop::NumberedSurface surface = workshop::surface_of(std::move(soup), doctor);
  if (job % 2 == 0)
    map_it(surface, options);
  else if (const auto found = workshop::circle_bundle(surface); found.made)
    fuzz::require(workshop::text_of(found).find("nan") == std::string::npos, "no nan is told");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  try {
    run(bytes);
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
  return 0;
}
