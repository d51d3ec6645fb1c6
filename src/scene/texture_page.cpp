// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/scene/page.hpp"
#include "tetrarch/scene/page_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace tetrarch::scene {
namespace {

using Json = nlohmann::ordered_json;

using namespace numeric;

const Surface& textured(const Scene& scene) {
  require_sound(scene);
  if (scene.surfaces.empty() || scene.surfaces[0].textures.empty() || scene.surfaces[0].triangles.empty())
    throw PreconditionError("write_page: a scene has no surface with texture coordinates");
  return scene.surfaces[0];
}

/// The box of some points, and how they move so that it lies in the unit ball about its middle. The card
/// counts in 24 bits, which are not to be spent on where a scanner stood.
class IntoUnitBall {
public:
  explicit IntoUnitBall(const std::vector<Point>& points) {
    Point low = points.front();
    Point high = low;
    for (const Point& p : points)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    middle_ = 0.5 * low + 0.5 * high;
    const Point reach = high - middle_;
    const double radius = std::hypot(reach[0], reach[1], reach[2]);
    scale_ = radius > 0 ? 1 / radius : 1;
    flat_ = low[2] == high[2];
  }

  bool flat() const { return flat_; }

  std::string base64_of(const std::vector<Point>& points) const {
    std::vector<float> numbers;
    numbers.reserve(3 * points.size());
    for (const Point& p : points)
      for (const double x : scale_*(p - middle_)) numbers.push_back(static_cast<float>(x));
    return base64(numbers);
  }

private:
  Point middle_{};
  double scale_ = 1;
  bool flat_ = false;
};

/// Lists of arrays as one list of numbers of type To.
template <class To, class From>
std::string base64_as(const std::vector<From>& arrays) {
  std::vector<To> numbers;
  numbers.reserve(arrays.size() * std::tuple_size_v<From>);
  for (const From& array : arrays)
    for (const auto x : array) numbers.push_back(static_cast<To>(x));
  return base64(numbers);
}

Json lines_json(const Tubes& tubes, const IntoUnitBall& ball) {
  const auto columns = columns_of(tubes.data, {"loop", "fiber"});
  const std::vector<int>* loops = columns[0];
  const bool fibers = columns[1] != nullptr;
  Json names = Json::array();
  Json colors = Json::array();
  for (std::size_t k = 0; k < part_count(tubes); ++k) {
    const Color color = color_of(tubes.colors, k);
    if (!fibers) names.push_back(loops ? (*loops)[k] : static_cast<int>(k));
    colors.push_back({color.red, color.green, color.blue});
  }
  return {{"name", tubes.name},
          {"points", ball.base64_of(tubes.points)},
          {"starts", tubes.starts},
          {"numbers", names},
          {"colours", colors}};
}

/// A number for each point, or null.
Json field_json(const Surface& surface) {
  if (surface.point_fields.empty()) return nullptr;
  const Field& field = surface.point_fields.front();
  return {{"name", field.name},
          {"values", base64(std::vector<float>(field.values.begin(), field.values.end()))}};
}

/// The patch of each triangle, and of each patch its name and colour; or null.
Json patches_json(const Surface& surface) {
  const std::vector<int>* patch = columns_of(surface.data, {"patch"}).front();
  if (!patch) return nullptr;
  constexpr std::array<const char*, 2> bases{"floor", "ceiling"};
  const int first_wall = static_cast<int>(bases.size());
  std::map<int, Color> colors;
  for (std::size_t t = 0; t < patch->size(); ++t) {
    if ((*patch)[t] < 0) throw PreconditionError("write_page: a patch with a negative number");
    colors.try_emplace((*patch)[t], color_of(surface.colors, t));
  }
  Json list = Json::array();
  for (const auto& [k, color] : colors)
    list.push_back({{"number", k},
                    {"name", k < first_wall ? bases[static_cast<std::size_t>(k)]
                                            : "wall " + std::to_string(k - first_wall)},
                    {"colour", {color.red, color.green, color.blue}}});
  return {{"list", list}, {"of", base64(*patch)}};
}

Json pane(const Scene& scene, const Surface* before) {
  const Surface& surface = scene.surfaces[0];
  const IntoUnitBall ball(surface.points);
  Json json{{"name", surface.name}, {"flat", ball.flat()}, {"points", ball.base64_of(surface.points)}};
  if (!before || before->triangles != surface.triangles)
    json["triangles"] = base64_as<std::uint32_t>(surface.triangles);
  if (!before || before->textures != surface.textures) json["textures"] = base64_as<float>(surface.textures);
  const std::pair<const char*, Json (*)(const Surface&)> parts[]{{"field", field_json},
                                                                 {"patches", patches_json}};
  for (const auto& [name, make] : parts)
    if (Json part = make(surface); !before || make(*before) != part) json[name] = std::move(part);
  json["lines"] = Json::array();
  for (const Tubes& tubes : scene.tubes) json["lines"].push_back(lines_json(tubes, ball));
  return json;
}

/// How long a unit of v is to a unit of u in the domain, in the mean over its area: patterns are drawn so
/// that their squares are squares there. With e, f two sides of a triangle and (a, b), (c, d) their texture
/// coordinates, e = a U + b V and f = c U + d V; what U and V are divided by is the same for both.
double v_by_u(const Surface& domain) {
  double u = 0;
  double v = 0;
  for (const auto& [p, q, r] : domain.triangles) {
    const auto& [origin_u, origin_v] = domain.textures[p];
    const double a = domain.textures[q][0] - origin_u;
    const double b = domain.textures[q][1] - origin_v;
    const double c = domain.textures[r][0] - origin_u;
    const double d = domain.textures[r][1] - origin_v;
    const Point e = domain.points[q] - domain.points[p];
    const Point f = domain.points[r] - domain.points[p];
    const Point along_u = d * e - b * f;
    const Point along_v = a * f - c * e;
    u += std::hypot(along_u[0], along_u[1], along_u[2]);
    v += std::hypot(along_v[0], along_v[1], along_v[2]);
  }
  return u > 0 && v > 0 ? v / u : 1;
}

} // namespace

std::string page_data(const TexturePage& page) {
  const Surface& surface = textured(page.surface);
  const Surface& domain = textured(page.domain);
  return as_script({{"format", "tetrarch texture"},
                    {"version", 1},
                    {"title", page.title},
                    {"tables", as_json(page.tables)},
                    {"v_by_u", page.v_by_u.value_or(v_by_u(domain))},
                    {"lines", page.lines},
                    {"panes", {pane(page.surface, nullptr), pane(page.domain, &surface)}}});
}

std::string write_page(const TexturePage& page) {
  return filled(texture_viewer_page(), page_data(page));
}

} // namespace tetrarch::scene
