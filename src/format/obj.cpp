// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"
#include "mesh_text.hpp"

#include "tetrarch/format/surface_files.hpp"

namespace tetrarch::format {
namespace {

/// "7", "7/1", "7//2" or "7/1/2": the point, counted from 0; -1 is the last of `points` so far.
int corner_of(MeshCursor& in, std::string_view token, std::size_t points) {
  const auto number = lenient_integer(token.substr(0, token.find('/')));
  if (!number || *number == 0 || *number > most_elements || *number < -most_elements)
    in.fail(token, "the number of a vertex");
  return static_cast<int>(*number > 0 ? *number - 1 : static_cast<std::int64_t>(points) + *number);
}

struct Statement {
  std::string_view keyword;
  std::string_view what;
};
/// What the ledger calls statements that make neither points nor faces.
constexpr std::array<Statement, 14> others{{{"vt", "texture coordinate"},
                                            {"vn", "normal"},
                                            {"vp", "parameter point"},
                                            {"l", "line element"},
                                            {"p", "point element"},
                                            {"g", "name of a group"},
                                            {"o", "name of an object"},
                                            {"usemtl", "use of a material"},
                                            {"mtllib", "library of materials"},
                                            {"curv", "free-form curve"},
                                            {"curv2", "free-form curve"},
                                            {"surf", "free-form surface"},
                                            {"s", ""},
                                            {"end", ""}}};

class ObjReader {
public:
  ObjReader(std::string_view text, const std::string& source) : in_(text, source, '#') {
    soup_.source = source;
    soup_.first_number = 1;
    in_.join_lines_at_backslashes();
  }

  Soup read() && {
    while (!in_.at_end()) {
      const std::string_view keyword = in_.token("a keyword");
      if (keyword == "v") {
        read_point();
      } else if (keyword == "f" || keyword == "fo") {
        read_face();
      } else if ((keyword.front() >= 'A' && keyword.front() <= 'Z') ||
                 (keyword.front() >= 'a' && keyword.front() <= 'z')) {
        pass_over(keyword);
      } else {
        in_.fail(keyword, "a keyword, like v or f");
      }
    }
    cells_.finish();
    return std::move(soup_);
  }

private:
  void read_point() {
    soup_.points.push_back(in_.point());
    note(soup_.point_labels, static_cast<int>(soup_.points.size()), in_.line());
    int more = 0;
    for (; in_.line_goes_on(); ++more) in_.token("");
    if (more >= 3) soup_.passed_over.note("color of a vertex");
  }

  void read_face() {
    const int line = in_.line();
    corners_.clear();
    while (in_.line_goes_on()) {
      const std::string_view token = in_.token("");
      corners_.push_back(corner_of(in_, token, soup_.points.size()));
    }
    if (corners_.size() < 3)
      throw InputError(Place{soup_.source, line}, "the line ends, expected three vertices or more");
    cells_.add_polygon(corners_, {++faces_, line, 0});
  }

  void pass_over(std::string_view keyword) {
    in_.rest_of_line();
    for (const Statement& other : others)
      if (other.keyword == keyword) {
        if (!other.what.empty()) soup_.passed_over.note(other.what);
        return;
      }
    soup_.passed_over.note("statement " + std::string(keyword));
  }

  MeshCursor in_;
  Soup soup_;
  Cells cells_{soup_};
  std::vector<int> corners_;
  int faces_ = 0;
};

} // namespace

Soup read_obj(std::string_view text, const std::string& source) {
  return ObjReader(text, source).read();
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
