// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/quads.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "full_turn.hpp"
#include "quad_points.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tetrarch::slit {
namespace {

using namespace numeric;

/// Lines nearer than this are one.
constexpr double same_line = 1e-9;
constexpr double most_quads = 5e7;

std::vector<double> merged(std::vector<double> lines) {
  std::sort(lines.begin(), lines.end());
  const auto same = [](double a, double b) { return b - a < same_line; };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  return lines;
}

/// The line next to an angle or a height; `period` 0: none.
std::size_t line_at(const std::vector<double>& lines, double value, double period) {
  const auto away = [&](double line) {
    return std::abs(period > 0 ? std::remainder(line - value, period) : line - value);
  };
  const auto nearest =
      std::min_element(lines.begin(), lines.end(), [&](double a, double b) { return away(a) < away(b); });
  return static_cast<std::size_t>(nearest - lines.begin());
}

/// Lines and their spaces: `least[k]` parts at least after line k. The last one is not filled beyond.
std::vector<double> filled(const std::vector<double>& forced, const std::vector<long>& least,
                           double spacing) {
  std::vector<double> lines;
  for (std::size_t k = 0; k + 1 < forced.size(); ++k) {
    const double gap = forced[k + 1] - forced[k];
    const long parts = std::max(least[k], std::lround(gap / spacing));
    for (long part = 0; part < parts; ++part)
      lines.push_back(forced[k] + gap * static_cast<double>(part) / static_cast<double>(parts));
  }
  lines.push_back(forced.back());
  return lines;
}

std::vector<double> horizontal_lines(const SlitMap& map, double spacing) {
  std::vector<double> forced{0.0, map.modulus};
  for (const Slit& s : map.slits) forced.push_back(-std::log(s.radius));
  forced = merged(std::move(forced));
  return filled(forced, std::vector<long>(forced.size(), 1), spacing);
}

std::vector<double> vertical_lines(const SlitMap& map, double spacing) {
  std::vector<double> forced;
  for (const Slit& s : map.slits) {
    forced.push_back(wrapped(s.start));
    forced.push_back(wrapped(s.end));
  }
  if (forced.empty()) forced.push_back(0);
  forced = merged(std::move(forced));
  if (forced.back() > forced.front() + full_turn - same_line) forced.pop_back();
  // With no line between its ends a slit would be closed.
  std::vector<long> least(forced.size(), 1);
  for (const Slit& s : map.slits) {
    const std::size_t first = line_at(forced, s.start, full_turn);
    if (line_at(forced, s.end, full_turn) == (first + 1) % forced.size()) least[first] = 2;
  }
  forced.push_back(forced.front() + full_turn);
  std::vector<double> lines = filled(forced, least, spacing);
  lines.pop_back();
  return lines;
}

[[noreturn]] void refuse_slit(const Slit& slit, const char* why) {
  throw InputError("no quads can be made: the slit of loop " + std::to_string(slit.loop) + " is " + why);
}

double thinnest(const QuadMesh& mesh, double spacing) {
  double least = mesh.angles.front() + full_turn - mesh.angles.back();
  for (const auto* lines : {&mesh.angles, &mesh.heights})
    for (std::size_t k = 0; k + 1 < lines->size(); ++k)
      least = std::min(least, (*lines)[k + 1] - (*lines)[k]);
  return least / spacing;
}

/// The crossings of a mesh, and which vertex each is: on slits two, as seen from below and from above.
class Crossings {
public:
  explicit Crossings(QuadMesh& mesh) : mesh_(mesh), is_on_slit_(columns() * mesh.heights.size(), 0) {
    for (std::size_t k = 0; k < is_on_slit_.size(); ++k) {
      below_.push_back(static_cast<int>(k));
      mesh_.places.push_back({mesh_.angles[k % columns()], mesh_.heights[k / columns()]});
    }
    above_ = below_;
  }

  /// The points of a whole line.
  void set_line(std::size_t row, const std::vector<SpacePoint>& points) {
    for (std::size_t j = 0; j < columns(); ++j) mesh_.points[row * columns() + j] = points[j];
  }
  void open(const OneForms& forms, const SlitMap& map, const Slit& slit) {
    const std::size_t row = line_at(mesh_.heights, -std::log(slit.radius), 0);
    const std::size_t first = line_at(mesh_.angles, slit.start, full_turn);
    const std::size_t last = line_at(mesh_.angles, slit.end, full_turn);
    std::vector<std::size_t> inside;
    std::vector<double> angles;
    for (std::size_t j = (first + 1) % columns(); first != last && j != last; j = (j + 1) % columns()) {
      inside.push_back(row * columns() + j);
      angles.push_back(slit.start + wrapped(mesh_.angles[j] - mesh_.angles[first]));
    }
    const SlitPoints points = slit_points(forms, map, slit, angles);
    put(row * columns() + first, slit, row, points.start);
    put(row * columns() + last, slit, row, points.end);
    for (std::size_t k = 0; k < inside.size(); ++k) {
      put(inside[k], slit, row, points.below[k]);
      above_[inside[k]] = static_cast<int>(mesh_.points.size());
      mesh_.points.push_back(points.above[k]);
      mesh_.places.push_back(mesh_.places[inside[k]]);
    }
  }
  void make_quads() {
    for (std::size_t row = 0; row + 1 < mesh_.heights.size(); ++row)
      for (std::size_t j = 0; j < columns(); ++j) {
        const std::size_t here = row * columns() + j;
        const std::size_t right = row * columns() + (j + 1) % columns();
        mesh_.quads.push_back(
            {above_[here], above_[right], below_[right + columns()], below_[here + columns()]});
      }
  }

private:
  std::size_t columns() const { return mesh_.angles.size(); }
  void put(std::size_t crossing, const Slit& slit, std::size_t row, const SpacePoint& point) {
    const bool is_rim = row == 0 || row + 1 == mesh_.heights.size();
    if (is_on_slit_[crossing] || is_rim)
      refuse_slit(slit, "too short or too near another loop, so vertices would coincide");
    is_on_slit_[crossing] = 1;
    mesh_.points[crossing] = point;
  }

  QuadMesh& mesh_;
  std::vector<char> is_on_slit_; ///< of each crossing
  std::vector<int> below_;
  std::vector<int> above_;
};

double warp(const std::array<SpacePoint, 4>& p) {
  const SpacePoint a = p[2] - p[0];
  const SpacePoint b = p[3] - p[1];
  const SpacePoint normal = cross(a, b);
  if (length(normal) == 0) return 0;
  return std::abs(dot(normal, p[1] - p[0])) / length(normal) * 2 / (length(a) + length(b));
}

} // namespace

QuadMesh quads(const OneForms& forms, const SlitMap& map, int around) {
  for (const Slit& s : map.slits)
    if (!(s.end - s.start < full_turn)) refuse_slit(s, "longer than a full turn");
  if (around < 3) throw PreconditionError("a quad mesh needs at least three quads around the ring");
  const double spacing = full_turn / around;
  if (around * std::max(1.0, map.modulus / spacing) > most_quads)
    throw InputError("there would be more than " + std::to_string(static_cast<int>(most_quads)) + " quads");
  QuadMesh mesh;
  mesh.angles = vertical_lines(map, spacing);
  mesh.heights = horizontal_lines(map, spacing);
  mesh.thinnest = thinnest(mesh, spacing);
  CrossingPoints inside = crossing_points(forms.mesh(), map, mesh.angles, mesh.heights);
  mesh.outside = inside.outside;
  mesh.points.resize(mesh.angles.size());
  mesh.points.insert(mesh.points.end(), inside.points.begin(), inside.points.end());
  mesh.points.resize(mesh.points.size() + mesh.angles.size());
  Crossings crossings(mesh);
  crossings.set_line(0, rim_points(forms, map, map.outer, mesh.angles));
  crossings.set_line(mesh.heights.size() - 1, rim_points(forms, map, map.inner, mesh.angles));
  for (const Slit& s : map.slits) crossings.open(forms, map, s);
  crossings.make_quads();
  return mesh;
}

std::vector<QuadEdge> edges(const QuadMesh& mesh) {
  std::vector<QuadEdge> result;
  for (const auto& quad : mesh.quads)
    for (std::size_t c = 0; c < 4; ++c) {
      const auto [from, to] = std::minmax(quad[c], quad[(c + 1) % 4]);
      result.push_back({from, to, c % 2 == 0 ? Line::horizontal : Line::vertical});
    }
  const auto ends = [](const QuadEdge& e) { return std::array{e.from, e.to}; };
  std::sort(result.begin(), result.end(),
            [&](const QuadEdge& a, const QuadEdge& b) { return ends(a) < ends(b); });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < result.size();) {
    const bool is_inside = k + 1 < result.size() && ends(result[k]) == ends(result[k + 1]);
    result[kept] = result[k];
    if (!is_inside) result[kept].line = Line::boundary;
    ++kept;
    k += is_inside ? 2 : 1;
  }
  result.resize(kept);
  return result;
}

double quads_around(const surface::TriangleMesh& mesh, const SlitMap& map, double edge) {
  double area = 0;
  for (const auto& t : mesh.surface.triangles())
    area += length(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]])) / 2;
  // n around, n modulus / 2 pi along.
  return std::sqrt(full_turn * area / map.modulus) / edge;
}

QuadQuality quality(const QuadMesh& mesh) {
  QuadQuality result;
  result.min_edge = distance(mesh.points[mesh.quads[0][0]], mesh.points[mesh.quads[0][1]]);
  for (const auto& quad : mesh.quads) {
    std::array<SpacePoint, 4> p{};
    for (std::size_t c = 0; c < 4; ++c) p[c] = mesh.points[quad[c]];
    for (std::size_t c = 0; c < 4; ++c) {
      const SpacePoint next = p[(c + 1) % 4] - p[c];
      const SpacePoint previous = p[(c + 3) % 4] - p[c];
      const double angle = std::atan2(length(cross(next, previous)), dot(next, previous));
      const double error = std::abs(angle - full_turn / 4);
      result.mean_angle_error += error;
      result.max_angle_error = numeric::maximum(result.max_angle_error, error);
      result.min_edge = std::min(result.min_edge, length(next));
      result.max_edge = numeric::maximum(result.max_edge, length(next));
      result.mean_edge += length(next);
    }
    result.mean_warp += warp(p);
    result.max_warp = numeric::maximum(result.max_warp, warp(p));
  }
  const auto quads = static_cast<double>(mesh.quads.size());
  result.mean_angle_error /= 4 * quads;
  result.mean_edge /= 4 * quads;
  result.mean_warp /= quads;
  return result;
}

} // namespace tetrarch::slit
