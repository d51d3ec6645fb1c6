// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/surface.hpp"

#include "tetrarch/bundle/twist.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/format/text.hpp"

#include <map>
#include <utility>

namespace tetrarch::workshop {
namespace {

using NumberedEdge = std::pair<long long, long long>;

/// The values by direction: u v value also says v u -value.
class ValueTable {
public:
  ValueTable(const NumberedSurface& surface, const std::vector<bundle::Side>& sides) {
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const long long u = surface.vertex_number(surface.mesh.surface.from(sides[k]));
      const long long v = surface.vertex_number(surface.mesh.surface.to(sides[k]));
      side_of_[{u, v}] = {k, 1};
      side_of_[{v, u}] = {k, -1};
    }
    values_.resize(sides.size(), 0);
  }

  void set(NumberedEdge edge, int value, const Place& place) {
    const std::string name =
        "the edge on vertices " + std::to_string(edge.first) + " and " + std::to_string(edge.second);
    const auto found = side_of_.find(edge);
    if (found == side_of_.end()) throw InputError(place, name + " is no boundary edge");
    const auto [k, sign] = found->second;
    if (values_[k] != 0) throw InputError(place, name + " has a value already");
    values_[k] = sign * value;
  }

  const bundle::BoundaryValues& values() const { return values_; }

private:
  std::map<NumberedEdge, std::pair<std::size_t, int>> side_of_;
  bundle::BoundaryValues values_;
};

std::string uncommented(std::string text) {
  bool comment = false;
  for (char& c : text) {
    comment = c == '#' || (comment && c != '\n');
    if (comment) c = ' ';
  }
  return text;
}

} // namespace

long long NumberedSurface::triangle_number(int triangle) const {
  return labels.triangle_labels.number(triangle, labels.first_number);
}

long long NumberedSurface::vertex_number(int vertex) const {
  return format::point_number(labels, vertex);
}

NumberedSurface surface_of(format::Soup soup, const Doctor& doctor) {
  if (soup.triangles.empty())
    throw InputError({soup.source, 0}, "there are no triangles (expected a surface)");
  soup.tetrahedra.clear();
  NumberedSurface surface;
  for (const std::string& done : mend(soup, doctor)) surface.warnings.push_back("repaired: " + done);
  surface.labels = soup;
  surface.labels.points = {};
  surface.labels.triangles = {};
  surface.mesh = doctor::build_surface(std::move(soup));
  return surface;
}

bundle::BoundaryValues read_boundary_values(const std::string& path, const NumberedSurface& surface) {
  const std::string text = uncommented(format::read_file(path));
  const std::vector<bundle::Side> sides = bundle::boundary_sides(surface.mesh.surface);
  ValueTable table(surface, sides);
  format::TextCursor cursor(text, format::source_name(path));
  while (!cursor.at_end()) {
    const Place place = cursor.here();
    const long long u = cursor.integer("the number of a vertex", 0, 1LL << 40);
    const long long v = cursor.integer("the number of a vertex", 0, 1LL << 40);
    const std::string_view value = cursor.token("a value, +1 or -1");
    if (value != "1" && value != "+1" && value != "-1") cursor.fail_at(value, "a value, +1 or -1");
    table.set({u, v}, value == "-1" ? -1 : 1, place);
  }
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (table.values()[k] == 0)
      throw InputError(
          {format::source_name(path), 0},
          "the boundary edge on vertices " +
              std::to_string(surface.vertex_number(surface.mesh.surface.from(sides[k]))) + " and " +
              std::to_string(surface.vertex_number(surface.mesh.surface.to(sides[k]))) + " has no value");
  return table.values();
}

} // namespace tetrarch::workshop
