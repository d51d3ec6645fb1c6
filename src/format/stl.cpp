// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"
#include "mesh_text.hpp"

#include "tetrarch/format/surface_files.hpp"

#include <unordered_map>

namespace tetrarch::format {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facet_size = 50; ///< a normal and three corners of floats, and two bytes
constexpr bool stl_swapped = swapped_if(std::endian::little);

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
  void add(std::span<const int> corners, int line, int tag) {
    cells_.add_polygon(corners, {facets_++, line, tag});
  }
  void pass_over(std::string_view what, std::int64_t count) { soup_.passed_over.note(what, count); }
  Soup soup() && {
    cells_.finish();
    return std::move(soup_);
  }

private:
  Soup soup_;
  Cells cells_{soup_};
  int facets_ = 0;
  std::unordered_map<Point, int, HashPoint, SamePoint> indices_;
};

/// Keywords are in small letters or in capitals. Several solids may follow each other: patches of a surface.
/// The last one may lack its end, and anything may stand behind the last end.
class TextReader {
public:
  TextReader(std::string_view text, const std::string& source) : in_(text, source), welder_(source) {}

  Soup read() && {
    while (is_next("SOLID")) read_solid();
    if (solids_ == 0) in_.fail(in_.peek(), "solid");
    if (!in_.at_end())
      welder_.pass_over("byte after the facets", static_cast<std::int64_t>(in_.bytes_left()));
    return std::move(welder_).soup();
  }

private:
  bool is_next(std::string_view word) {
    const std::string_view next = in_.peek();
    return next.size() == word.size() &&
           capitals(next) == word; // short enough to be made without an allocation
  }
  void expect(std::string_view word) {
    const std::string_view found = in_.token(word);
    if (capitals(found) != capitals(word)) in_.fail(found, word);
  }

  void read_solid() {
    in_.token("solid");
    if (!in_.rest_of_line().empty() && solids_ > 0) welder_.pass_over("name of a solid", 1);
    while (is_next("FACET")) read_facet();
    ++solids_;
    if (is_next("ENDSOLID")) {
      in_.token("");
      in_.rest_of_line();
    } else if (is_next("END")) {
      in_.token("");
      expect("solid");
      in_.rest_of_line();
    } else if (!in_.at_end() && !is_next("SOLID")) {
      in_.fail(in_.peek(), "facet, endsolid or solid");
    }
  }

  void read_facet() {
    const int line = (in_.token("facet"), in_.line());
    while (!is_next("OUTER")) in_.token("outer"); // the normal, in whatever words
    in_.token("outer");
    expect("loop");
    corners_.clear();
    while (!is_next("ENDLOOP")) {
      expect("vertex");
      const int vertex_line = in_.line();
      corners_.push_back(welder_.point(in_.point(), vertex_line));
    }
    if (corners_.size() < 3) in_.fail(in_.peek(), "vertex");
    in_.token("endloop");
    expect("endfacet");
    welder_.add(corners_, line, solids_);
  }

  MeshCursor in_;
  Welder welder_;
  std::vector<int> corners_;
  int solids_ = 0;
};

std::uint64_t facets_announced(std::string_view text) {
  return load<std::uint32_t>(text.data() + header_size, stl_swapped);
}

Soup read_binary_stl(std::string_view text, const std::string& source) {
  Welder welder(source);
  const std::uint64_t facets = facets_announced(text);
  const std::uint64_t room = (text.size() - header_size - 4) / facet_size;
  if (facets > room)
    throw InputError(Place{source, 0}, "the data end after " + std::to_string(room) + " facets, expected " +
                                           std::to_string(facets));
  std::int64_t attributes = 0;
  std::size_t at = header_size + 4;
  for (std::uint64_t f = 0; f < facets; ++f, at += facet_size) {
    std::array<int, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const char* const raw = text.data() + at + 12 * (c + 1);
      const auto x = [&](std::size_t axis) {
        return static_cast<double>(load<float>(raw + 4 * axis, stl_swapped));
      };
      corners[c] = welder.point({x(0), x(1), x(2)}, 0);
    }
    welder.add(corners, 0, 0);
    attributes += text[at + facet_size - 2] != '\0' || text[at + facet_size - 1] != '\0' ? 1 : 0;
  }
  welder.pass_over("attribute of a facet", attributes);
  welder.pass_over("byte after the facets", static_cast<std::int64_t>(text.size() - at));
  return std::move(welder).soup();
}

/// A binary file has a zero byte in its first facet, or in the number of facets; a text has none.
bool has_zero_bytes(std::string_view text) {
  return text.substr(0, header_size + 4 + facet_size).find('\0') != std::string_view::npos;
}

} // namespace

bool is_binary_stl(std::string_view text) {
  if (text.size() < header_size + 4) return false;
  return text.size() == header_size + 4 + facets_announced(text) * facet_size;
}

Soup read_stl(std::string_view text, const std::string& source) {
  if (is_binary_stl(text)) return read_binary_stl(text, source);
  text = without_byte_order_mark(text);
  const bool is_text = capitals(trimmed(text.substr(0, header_size)).substr(0, 5)) == "SOLID";
  if (text.size() >= header_size + 4 && (!is_text || has_zero_bytes(text)))
    return read_binary_stl(text, source);
  return TextReader(text, source).read();
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
