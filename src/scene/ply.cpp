// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "writers.hpp"

#include "tetrarch/core/error.hpp"

#include <limits>

namespace tetrarch::scene {
namespace {

using namespace numeric;

class PlyWriter {
public:
  explicit PlyWriter(const Scene& scene)
      : surfaces_(scene), names_(data_names(scene)), cell_fields_(field_names(scene, FieldOn::cells)),
        point_fields_(field_names(scene, FieldOn::points)) {
    for (const Surface* surface : surfaces_.all) {
      points_ += surface->points.size();
      triangles_ += surface->triangles.size();
      with_normals_ = with_normals_ || !surface->normals.empty();
      with_colors_ = with_colors_ || !surface->colors.empty();
    }
    if (points_ > std::numeric_limits<int>::max()) throw PreconditionError("PLY holds fewer points");
  }

  std::string write() {
    append_header();
    const std::size_t point_bytes = (with_normals_ ? 36 : 24) + 8 * point_fields_.size();
    const std::size_t triangle_bytes =
        13 + (with_colors_ ? 4 : 0) + 4 + 4 * names_.size() + 8 * cell_fields_.size();
    out_.reserve(out_.size() + points_ * point_bytes + triangles_ * triangle_bytes);
    for (const Surface* surface : surfaces_.all) append_points(*surface);
    int first_point = 0;
    for (std::size_t k = 0; k < surfaces_.all.size(); ++k) {
      append_triangles(*surfaces_.all[k], static_cast<int>(k), first_point);
      first_point += static_cast<int>(surfaces_.all[k]->points.size());
    }
    return std::move(out_);
  }

private:
  void append_header() {
    out_ = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points_) +
           "\nproperty double x\nproperty double y\nproperty double z\n";
    if (with_normals_) out_ += "property float nx\nproperty float ny\nproperty float nz\n";
    for (const std::string& name : point_fields_) out_ += "property double " + name + "\n";
    out_ += "element face " + std::to_string(triangles_) + "\nproperty list uchar int vertex_indices\n";
    if (with_colors_)
      out_ += "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
    out_ += "property int element\n";
    for (const std::string& name : names_) out_ += "property int " + name + "\n";
    for (const std::string& name : cell_fields_) out_ += "property double " + name + "\n";
    out_ += "end_header\n";
  }

  void append_points(const Surface& surface) {
    const bool lacks_normals = with_normals_ && surface.normals.empty();
    const std::vector<Point> made = lacks_normals ? mean_normals(surface) : std::vector<Point>();
    const std::vector<Point>& normals = lacks_normals ? made : surface.normals;
    const auto fields = columns_of(surface.point_fields, point_fields_);
    for (std::size_t p = 0; p < surface.points.size(); ++p) {
      for (const double x : surface.points[p]) append_little(out_, x);
      if (with_normals_)
        for (const double x : normals[p]) append_little(out_, static_cast<float>(x));
      for (const auto* field : fields) append_little(out_, field ? (*field)[p] : no_number);
    }
  }

  void append_triangles(const Surface& surface, int element, int first_point) {
    const auto columns = columns_of(surface.data, names_);
    const auto fields = columns_of(surface.cell_fields, cell_fields_);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      append_little(out_, std::uint8_t{3});
      for (const int corner : surface.triangles[t]) append_little(out_, corner + first_point);
      if (with_colors_) append_color(color_of(surface.colors, t));
      append_little(out_, element);
      for (const auto* column : columns) append_little(out_, column ? (*column)[t] : no_value);
      for (const auto* field : fields) append_little(out_, field ? (*field)[t] : no_number);
    }
  }

  void append_color(Color color) {
    for (const std::uint8_t part : {color.red, color.green, color.blue, color.alpha})
      append_little(out_, part);
  }

  AllSurfaces surfaces_;
  std::vector<std::string> names_; ///< of data
  std::vector<std::string> cell_fields_;
  std::vector<std::string> point_fields_;
  std::size_t points_ = 0;
  std::size_t triangles_ = 0;
  bool with_normals_ = false;
  bool with_colors_ = false;
  std::string out_;
};

} // namespace

std::string write_ply(const Scene& scene) {
  return PlyWriter(scene).write();
}

} // namespace tetrarch::scene
