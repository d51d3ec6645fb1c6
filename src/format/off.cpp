// SPDX-License-Identifier: GPL-2.0-or-later
#include "mesh_text.hpp"

#include "tetrarch/format/surface_files.hpp"

namespace tetrarch::format {

Soup read_off(std::string_view text, const std::string& source) {
  Soup soup;
  soup.source = source;
  MeshCursor in(text, source, '#');
  const std::string_view header = in.token("OFF");
  if (header.size() < 3 || header.substr(header.size() - 3) != "OFF") in.fail(header, "OFF");
  if (header.find('4') != std::string_view::npos || header.find('n') != std::string_view::npos)
    in.fail(header, "points of three dimensions");
  const std::int64_t points = in.integer("the number of points", 0, most_elements);
  const std::int64_t faces = in.integer("the number of faces", 0, most_elements);
  in.integer("the number of edges", 0, most_elements);
  soup.points.reserve(in.believable(points, 6));
  for (std::int64_t i = 0; i < points; ++i) {
    soup.points.push_back(in.point());
    note(soup.point_labels, static_cast<int>(i), in.line());
    in.rest_of_line();
  }
  soup.triangles.reserve(in.believable(faces, 8));
  for (std::int64_t i = 0; i < faces; ++i) {
    in.integer("3 vertices of a face", 3, 3);
    note(soup.triangle_labels, static_cast<int>(i), in.line());
    soup.triangles.push_back(read_corners<3>(in, 0));
    in.rest_of_line();
  }
  return soup;
}

std::string write_off(const Soup& soup) {
  std::string out =
      "OFF\n" + std::to_string(soup.points.size()) + " " + std::to_string(soup.triangles.size()) + " 0\n";
  append_surface(out, soup);
  return out;
}

} // namespace tetrarch::format
