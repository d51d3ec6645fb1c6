// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/orb.hpp"

#include "gluing_table.hpp"

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace tetrarch::format {
namespace {

/// A tetrahedron on the way round an edge: it is left through face `out`, entered through `in`.
struct Step {
  std::int64_t tet; ///< counted from 0
  int out;
  int in;
  std::string_view token;
};

/// out, in, and the ends of the edge in the order that makes the permutation even.
Perm4 frame(const Step& step) {
  return edge_frame(step.out, step.in);
}

class OrbReader {
public:
  OrbReader(std::string_view text, const std::string& source) : in_(text, source) {}

  Document read() {
    Document document;
    document.name = read_head();
    read_edges();
    document.triangulation = triangulation();
    document.marks = std::move(marks_);
    return document;
  }

  /// After `read`.
  std::optional<OrbDrawing> drawing() {
    // Of the lines before it each has the number of an edge and more.
    while (!in_.at_end()) {
      const std::string_view line = in_.rest_of_line();
      if (std::any_of(line.begin(), line.end(), is_space)) continue;
      const std::optional<std::int64_t> points = parse_integer(line);
      if (!points || *points < 0) in_.fail_at(line, "the number of points of the drawing");
      if (*points == 0) return std::nullopt;
      return drawing_of(*points);
    }
    return std::nullopt;
  }

private:
  std::string read_head() {
    const std::string_view header = in_.at_end() ? in_.peek() : in_.rest_of_line();
    if (header != orb_header) in_.fail_at(header, "\"" + std::string(orb_header) + "\"");
    std::string name = clean_line(in_.rest_of_line());
    if (in_.peek() == "SolutionType") in_.rest_of_line();
    vertices_known_ = in_.peek() == "vertices_known";
    if (vertices_known_) in_.rest_of_line();
    if (in_.at_end()) in_.fail_at(in_.peek(), "the first edge");
    return name;
  }

  /// Up to the first blank line, or the end.
  void read_edges() {
    for (std::string_view line = in_.rest_of_line(); !line.empty(); line = in_.rest_of_line())
      read_edge(line);
  }

  void read_edge(std::string_view line) {
    Tokens tokens(line);
    integer(tokens.next(), static_cast<std::int64_t>(start_.size()), "the number of an edge");
    const std::string_view curve = tokens.next();
    integer(curve, {}, "the number of a singular curve");
    const std::string_view order = tokens.next();
    const std::optional<double> value = parse_double(order);
    if (!value) fail(order, "a singular order");
    if (!is_edge_order(*value)) fail(order, "a singular order: 0, 1 or a number above 1");
    note_order(curve, *value);
    for (int i = 0; vertices_known_ && i < 2; ++i) integer(tokens.next(), {}, "the number of a vertex");
    std::string_view token = tokens.next();
    if (token.empty()) fail(token, "a tetrahedron at the edge, like 2xv");
    const std::size_t first = steps_.size();
    for (; !token.empty(); token = tokens.next()) steps_.push_back(step(token));
    // The two faces meet in the edge of the other two vertices.
    if (const Step& s = steps_[first]; *value != 1)
      marks_.push_back({{static_cast<int>(s.tet), opposite_edge(edge_number[s.out][s.in])}, *value});
    start_.push_back(steps_.size());
  }

  void note_order(std::string_view token, double order) {
    const std::int64_t curve = parse_integer(token).value();
    if (curve < 0) fail(token, "the number of a singular curve, 0 or more");
    if (curve == 0) return;
    const auto [at, fresh] = order_of_curve_.emplace(curve, order);
    if (!fresh && at->second != order) fail(token, "a curve of one order, " + to_text(at->second));
  }

  OrbDrawing drawing_of(std::int64_t points) {
    constexpr std::int64_t far = 1'000'000;
    constexpr std::int64_t most = 1'000'000;
    constexpr std::int64_t most_segments = 5'000;
    OrbDrawing out;
    for (std::int64_t k = 0; k < points; ++k) {
      in_.integer("the number of a point, " + std::to_string(k), k, k);
      const auto x = static_cast<int>(in_.integer("the x of a point", -far, far));
      out.points.push_back({x, static_cast<int>(in_.integer("the y of a point", -far, far))});
    }
    // Whoever makes a diagram of them looks at all pairs.
    const std::int64_t segments = in_.integer("the number of segments of the drawing", 0, most_segments);
    for (std::int64_t k = 0; k < segments; ++k) {
      const int line = in_.line();
      in_.integer("the number of a segment, " + std::to_string(k), k, k);
      const auto from = static_cast<int>(in_.integer("a point of the drawing", 0, points - 1));
      const std::string_view end = in_.peek();
      const auto to = static_cast<int>(in_.integer("a point of the drawing", 0, points - 1));
      if (to == from) in_.fail_at(end, "another point than that where the segment begins");
      const bool drilled = in_.integer("1 of a segment that is drilled, or 0", 0, 1) == 1;
      out.segments.push_back({from, to, drilled, line});
    }
    const std::int64_t crossings = in_.integer("the number of crossings of the drawing", 0, most);
    for (std::int64_t k = 0; k < crossings; ++k) {
      OrbDrawing::Crossing crossing;
      crossing.line = in_.line();
      in_.integer("the number of a crossing, " + std::to_string(k), k, k);
      in_.number("the x of a crossing");
      in_.number("the y of a crossing");
      crossing.over = static_cast<int>(in_.integer("a segment of the drawing", 0, segments - 1));
      crossing.under = static_cast<int>(in_.integer("a segment of the drawing", 0, segments - 1));
      crossing.along_over = in_.number("a number from 0 to 1");
      crossing.along_under = in_.number("a number from 0 to 1");
      out.crossings.push_back(crossing);
    }
    // Numbers that no edge has are left out: whoever needs all of them counts.
    for (const auto& [curve, order] : order_of_curve_) out.orders.push_back(order);
    return out;
  }

  /// The tokens of a line, then empty ones that stand at its end.
  class Tokens {
  public:
    explicit Tokens(std::string_view line) : rest_(line) {}
    std::string_view next() {
      std::size_t first = 0;
      while (first < rest_.size() && is_space(rest_[first])) ++first;
      std::size_t last = first;
      while (last < rest_.size() && !is_space(rest_[last])) ++last;
      const std::string_view token = rest_.substr(first, last - first);
      rest_.remove_prefix(last);
      return token;
    }

  private:
    std::string_view rest_;
  };

  void integer(std::string_view token, std::optional<std::int64_t> wanted,
               const std::string& expected) const {
    const std::optional<std::int64_t> value = parse_integer(token);
    if (!value || (wanted && *value != *wanted))
      fail(token, expected + (wanted ? ", " + std::to_string(*wanted) : ""));
  }

  /// `token` stands on a line of its own; if it is empty, the line ended too early.
  [[noreturn]] void fail(std::string_view token, const std::string& expected) const {
    if (token.empty()) throw InputError(in_.place_of(token), "the line ends, expected " + expected);
    in_.fail_at(token, expected);
  }

  Step step(std::string_view token) const {
    constexpr std::string_view letters = "uvwx";
    const std::size_t digits = token.size() < 3 ? 0 : token.size() - 2;
    const auto number = parse_integer(token.substr(0, digits));
    const std::size_t out = token.size() < 3 ? letters.npos : letters.find(token[digits]);
    const std::size_t in = token.size() < 3 ? letters.npos : letters.find(token[digits + 1]);
    if (!number || *number < 1 || out == letters.npos || in == letters.npos || out == in)
      in_.fail_at(token, "a tetrahedron and two of its faces, like 2xv");
    return {*number - 1, static_cast<int>(out), static_cast<int>(in), token};
  }

  Triangulation triangulation() {
    // Each tetrahedron has six edges, so there is no need to believe the numbers.
    table_.resize(steps_.size() / 6);
    for (const Step& s : steps_)
      if (static_cast<std::size_t>(s.tet) >= table_.size() || steps_.size() % 6 != 0)
        in_.fail_at(s.token, "six edges of each tetrahedron; the edges have " +
                                 std::to_string(steps_.size()) + " in all");
    for (std::size_t e = 0; e + 1 < start_.size(); ++e)
      for (std::size_t i = start_[e]; i < start_[e + 1]; ++i)
        cross(steps_[i], steps_[i + 1 < start_[e + 1] ? i + 1 : start_[e]]);
    for (const Step& s : steps_)
      if (table_[static_cast<std::size_t>(s.tet)][s.out].tet < 0)
        in_.fail_at(s.token, "a gluing of every face");
    if (const std::optional<GluingFault> fault = find_fault(table_))
      throw InputError(in_.place_of(steps_.front().token), fault->what);
    Triangulation tri = build(table_);
    const int edges = Skeleton(tri).edge_count();
    if (static_cast<std::size_t>(edges) != start_.size() - 1)
      in_.fail_at(steps_.back().token, "as many edges as the gluings make, " + std::to_string(edges));
    return tri;
  }

  /// Glues the face through which `from` is left to that through which `to` is entered. Of the frames
  /// (out, in, p, q): p and q stay the ends, the face not crossed in `from` lies opposite to that not crossed
  /// in `to`.
  void cross(const Step& from, const Step& to) {
    const Perm4 perm = frame(to) * Perm4(1, 0, 2, 3) * frame(from).inverse();
    claim(from, from.out, {static_cast<int>(to.tet), perm});
    claim(to, to.in, {static_cast<int>(from.tet), perm.inverse()});
  }

  void claim(const Step& step, int face, Gluing gluing) {
    Gluing& known = table_[static_cast<std::size_t>(step.tet)][face];
    if (known.tet >= 0 && known != gluing) in_.fail_at(step.token, "the gluing that another edge says");
    known = gluing;
  }

  TextCursor in_;
  bool vertices_known_ = false;
  std::vector<std::size_t> start_{0}; ///< in steps_, of each edge and of the end
  std::vector<Step> steps_;
  GluingTable table_;
  Marks marks_;
  std::map<std::int64_t, double> order_of_curve_;
};

} // namespace

Document read_orb(std::string_view text, const std::string& source) {
  return OrbReader(text, source).read();
}

std::optional<OrbDrawing> read_orb_drawing(std::string_view text, const std::string& source) {
  OrbReader reader(text, source);
  reader.read();
  return reader.drawing();
}

} // namespace tetrarch::format
