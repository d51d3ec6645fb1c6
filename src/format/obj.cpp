// SPDX-License-Identifier: GPL-2.0-or-later
#include "mesh_text.hpp"

#include "tetrarch/format/surface_files.hpp"

namespace tetrarch::format {
namespace {

/// "7", "7/1", "7//2" or "7/1/2": the point, counted from 0; -1 is the last of `points` so far.
int corner_of(MeshCursor& in, std::string_view token, std::size_t points) {
  const auto number = parse_integer(token.substr(0, token.find('/')));
  if (!number || *number == 0 || *number > most_elements || *number < -most_elements)
    in.fail(token, "the number of a vertex");
  return static_cast<int>(*number > 0 ? *number - 1 : static_cast<std::int64_t>(points) + *number);
}

void read_face(MeshCursor& in, Soup& soup) {
  const int line = in.line();
  TextCursor corners(in.rest_of_line(), soup.source);
  std::array<int, 3> triangle{};
  for (int& corner : triangle) {
    const std::string_view token = corners.peek();
    if (token.empty()) throw InputError(Place{soup.source, line}, "the line ends, expected three vertices");
    corner = corner_of(in, corners.token(""), soup.points.size());
  }
  if (!corners.at_end() && corners.next_char() != '#')
    throw InputError(Place{soup.source, line}, found_expected(corners.peek(), "a face of three vertices"));
  soup.triangles.push_back(triangle);
  note(soup.triangle_labels, static_cast<int>(soup.triangles.size()), line);
}

} // namespace

Soup read_obj(std::string_view text, const std::string& source) {
  Soup soup;
  soup.source = source;
  soup.first_number = 1;
  MeshCursor in(text, source, '#');
  while (!in.at_end()) {
    const std::string_view keyword = in.token("a keyword");
    if (keyword == "v") {
      soup.points.push_back(in.point());
      note(soup.point_labels, static_cast<int>(soup.points.size()), in.line());
      in.rest_of_line();
    } else if (keyword == "f") {
      read_face(in, soup);
    } else if (keyword.front() >= 'A' && keyword.front() <= 'z') {
      in.rest_of_line();
    } else {
      in.fail(keyword, "a keyword, like v or f");
    }
  }
  return soup;
}

std::string write_obj(const Soup& soup) {
  std::string out;
  for (const auto& p : soup.points) {
    out += "v ";
    append_line(out, p, "\n");
  }
  for (const auto& corners : soup.triangles) {
    out += "f ";
    append_line(out, corners, "\n", 1);
  }
  return out;
}

} // namespace tetrarch::format
