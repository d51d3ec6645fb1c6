// SPDX-License-Identifier: GPL-2.0-or-later
#include "mesh_text.hpp"

#include "tetrarch/format/surface_files.hpp"

#include <unordered_map>

namespace tetrarch::format {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facet_size = 50; ///< a normal and three corners of floats, and two bytes
constexpr bool swapped = swapped_if(std::endian::little);

using Point = std::array<double, 3>;

struct HashPoint {
  std::size_t operator()(const Point& p) const {
    std::uint64_t hash = 0;
    for (const double x : p) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

/// Same numbers, also where they are none: NaN must not be a new point each time.
struct SamePoint {
  bool operator()(const Point& p, const Point& q) const {
    return std::bit_cast<std::array<std::uint64_t, 3>>(p) == std::bit_cast<std::array<std::uint64_t, 3>>(q);
  }
};

/// Gathers corners into points, in the order in which they first occur.
class Welder {
public:
  explicit Welder(const std::string& source) { soup_.source = source; }

  int point(Point p, int line) {
    for (double& x : p) x += 0.0; // -0 and 0 are the same place
    const auto [at, is_new] = indices_.try_emplace(p, static_cast<int>(soup_.points.size()));
    if (is_new) {
      note(soup_.point_labels, at->second, line);
      soup_.points.push_back(p);
    }
    return at->second;
  }
  void add(const std::array<int, 3>& corners, int line) {
    soup_.triangles.push_back(corners);
    note(soup_.triangle_labels, static_cast<int>(soup_.triangles.size()) - 1, line);
  }
  Soup soup() && { return std::move(soup_); }

private:
  Soup soup_;
  std::unordered_map<Point, int, HashPoint, SamePoint> indices_;
};

void expect(MeshCursor& in, std::string_view word) {
  const std::string_view found = in.token(word);
  if (found != word) in.fail(found, word);
}

Soup read_text(std::string_view text, const std::string& source) {
  MeshCursor in(text, source);
  Welder welder(source);
  expect(in, "solid");
  in.rest_of_line();
  while (in.peek() == "facet") {
    const int line = (in.token("facet"), in.line());
    expect(in, "normal");
    in.point();
    expect(in, "outer");
    expect(in, "loop");
    std::array<int, 3> corners{};
    for (int& corner : corners) {
      expect(in, "vertex");
      const int vertex_line = in.line();
      corner = welder.point(in.point(), vertex_line);
    }
    expect(in, "endloop");
    expect(in, "endfacet");
    welder.add(corners, line);
  }
  expect(in, "endsolid");
  return std::move(welder).soup();
}

Soup read_binary(std::string_view text, const std::string& source) {
  Welder welder(source);
  for (std::size_t at = header_size + 4; at + facet_size <= text.size(); at += facet_size) {
    std::array<int, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const char* const raw = text.data() + at + 12 * (c + 1);
      const auto x = [&](std::size_t axis) {
        return static_cast<double>(load<float>(raw + 4 * axis, swapped));
      };
      corners[c] = welder.point({x(0), x(1), x(2)}, 0);
    }
    welder.add(corners, 0);
  }
  return std::move(welder).soup();
}

} // namespace

bool is_binary_stl(std::string_view text) {
  if (text.size() < header_size + 4) return false;
  const std::uint64_t facets = load<std::uint32_t>(text.data() + header_size, swapped);
  return text.size() == header_size + 4 + facets * facet_size;
}

Soup read_stl(std::string_view text, const std::string& source) {
  return is_binary_stl(text) ? read_binary(text, source) : read_text(text, source);
}

std::string write_stl(const Soup& soup) {
  std::string out = "solid tetrarch\n";
  for (const auto& corners : soup.triangles) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : corners) {
      out += "vertex ";
      append_line(out, soup.points.at(static_cast<std::size_t>(corner)), "\n");
    }
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid tetrarch\n";
}

} // namespace tetrarch::format
