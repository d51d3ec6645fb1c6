// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/snappea.hpp"

#include "gluing_lines.hpp"

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace tetrarch::format {
namespace {

constexpr std::int64_t largest_count = std::numeric_limits<int>::max();

using Words = std::span<const std::string_view>;

bool one_of(std::string_view token, Words words) {
  return std::find(words.begin(), words.end(), token) != words.end();
}

/// The token must be one of the words.
std::string_view word(TextCursor& in, Words words, std::string_view expected) {
  const std::string_view token = in.token(expected);
  if (!one_of(token, words)) in.fail_at(token, expected);
  return token;
}

constexpr std::array<std::string_view, 8> solution_types{
    "not_attempted",       "geometric_solution", "nongeometric_solution", "flat_solution",
    "degenerate_solution", "other_solution",     "no_solution",           "externally_computed"};
constexpr std::array<std::string_view, 3> orientabilities{"oriented_manifold", "nonorientable_manifold",
                                                          "unknown_orientability"};
constexpr std::array<std::string_view, 2> invariant_words{"CS_known", "CS_unknown"};
constexpr std::array<std::string_view, 2> cusp_kinds{"torus", "Klein"};

/// Whether a line is that after the name: a solution type and the volume.
bool is_solution(std::string_view line) {
  TextCursor in(line, "");
  if (!one_of(in.peek(), solution_types)) return false;
  in.token("");
  return parse_double(in.peek()).has_value();
}

/// The line after the header. Some writers leave blank lines before it, and some leave it blank.
std::string read_name(TextCursor& in) {
  if (in.at_end()) return {};
  TextCursor ahead = in;
  if (is_solution(ahead.rest_of_line())) return {};
  std::string name = clean_line(in.rest_of_line());
  return name == snappea_no_name ? std::string() : name;
}

/// Everything between the name and the cusps: checked, and not kept.
void skip_solution(TextCursor& in) {
  word(in, solution_types, "a solution type such as not_attempted");
  in.number("the volume", false);
  word(in, orientabilities, "oriented_manifold, nonorientable_manifold or unknown_orientability");
  if (word(in, invariant_words, "CS_known or CS_unknown") == "CS_known")
    in.number("the Chern-Simons invariant", false);
}

/// A cusp's slope: 0, 0 of a complete one.
struct Slope {
  double meridians = 0;
  double longitudes = 0;
  bool is_complete() const { return meridians == 0 && longitudes == 0; }
  std::string named(std::size_t cusp) const {
    return std::string(dehn_filling) + " (" + to_text(meridians) + "," + to_text(longitudes) + ") of cusp " +
           std::to_string(cusp);
  }
};

/// More turns than a curve has that anybody fills along; products with curves stay far from overflow.
constexpr double most_turns = 100'000;

/// Whether a manifold is meant, not a cone manifold.
bool is_curve(const Slope& slope) {
  const auto whole = [](double x) { return std::abs(x) <= most_turns && x == std::floor(x); };
  return whole(slope.meridians) && whole(slope.longitudes) &&
         std::gcd(static_cast<int>(slope.meridians), static_cast<int>(slope.longitudes)) == 1;
}

std::vector<Slope> read_cusps(TextCursor& in) {
  const std::int64_t torus = in.integer("the number of torus cusps", 0, largest_count);
  const std::int64_t klein = in.integer("the number of Klein bottle cusps", 0, largest_count);
  std::vector<Slope> slopes;
  for (std::int64_t c = 0; c < torus + klein; ++c) {
    word(in, cusp_kinds, "torus or Klein, the kind of cusp " + std::to_string(c));
    Slope& slope = slopes.emplace_back();
    slope.meridians = in.number("the filling of cusp " + std::to_string(c) + ", two numbers");
    slope.longitudes = in.number("the filling of cusp " + std::to_string(c) + ", two numbers");
  }
  return slopes;
}

/// What follows the gluings of one tetrahedron, as far as it is kept.
struct TetrahedronData {
  std::array<std::int64_t, 4> cusp{};
  /// Meridian and longitude, at each vertex across each face, on both sheets together.
  std::array<std::array<std::array<std::int64_t, 4>, 4>, 2> curve{};
};

TetrahedronData read_tetrahedron_data(TextCursor& in, std::size_t cusps, const std::string& whose) {
  // Where no cusp was stated, SnapPea finds them itself and the indices mean nothing.
  const std::int64_t last_cusp = cusps > 0 ? static_cast<std::int64_t>(cusps) - 1 : largest_count;
  TetrahedronData data;
  for (std::int64_t& cusp : data.cusp) cusp = in.integer("a cusp index of " + whose, -1, last_cusp);
  for (auto& curve : data.curve)
    for (int sheet = 0; sheet < 2; ++sheet)
      for (auto& corner : curve)
        for (std::int64_t& crossings : corner)
          crossings +=
              in.integer("64 integers, the peripheral curves of " + whose, -largest_count, largest_count);
  for (int k = 0; k < 2; ++k) in.number("the shape of " + whose + ", two numbers", false);
  return data;
}

/// The peripheral curves, and the fillings made of them.
class Curves {
public:
  explicit Curves(std::vector<Slope> slopes) : slopes_(std::move(slopes)), crossed_(slopes_.size(), false) {
    for (const Slope& slope : slopes_) any_slope_ |= !slope.is_complete();
  }

  void add(const TetrahedronData& data) {
    auto& made = any_slope_ ? fillings_.curves.emplace_back() : unused_;
    for (int v = 0; v < 4; ++v)
      for (int f = 0; f < 4; ++f) {
        const std::int64_t m = data.curve[0][v][f];
        const std::int64_t l = data.curve[1][v][f];
        any_curve_ |= m != 0 || l != 0;
        made[v][f] = 0;
        if (data.cusp[v] < 0 || static_cast<std::size_t>(data.cusp[v]) >= slopes_.size()) continue;
        const auto cusp = static_cast<std::size_t>(data.cusp[v]);
        if (!is_curve(slopes_[cusp])) continue;
        made[v][f] = static_cast<std::int64_t>(slopes_[cusp].meridians) * m +
                     static_cast<std::int64_t>(slopes_[cusp].longitudes) * l;
        if (made[v][f] != 0) crossed_[cusp] = true;
      }
  }

  void note_in(Ledger& passed_over) const {
    for (std::size_t c = 0; c < slopes_.size(); ++c)
      if (!slopes_[c].is_complete()) passed_over.note(slopes_[c].named(c) + ", which is open here");
    if (any_curve_) passed_over.note("peripheral curve", 2 * static_cast<std::int64_t>(slopes_.size()));
  }

  DehnFillings fillings() && {
    for (std::size_t c = 0; c < slopes_.size(); ++c) {
      if (slopes_[c].is_complete()) continue;
      (crossed_[c] ? fillings_.named : fillings_.left).push_back(slopes_[c].named(c));
    }
    if (fillings_.named.empty()) fillings_.curves.clear();
    return std::move(fillings_);
  }

private:
  std::vector<Slope> slopes_;
  std::vector<bool> crossed_; ///< by the curve that is filled along
  bool any_slope_ = false;
  bool any_curve_ = false;
  DehnFillings fillings_;
  std::array<std::array<std::int64_t, 4>, 4> unused_{};
};

std::vector<std::string> warnings_about(const Skeleton& skeleton) {
  std::vector<std::string> warnings;
  std::vector<SurfaceType> links;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    const SurfaceType& link = links.emplace_back(skeleton.link(v));
    if (link.euler < 0 || (link.euler == 1 && link.is_closed()))
      warnings.push_back("the link of vertex " + std::to_string(v.value) + " is a surface (" + link.str() +
                         ") that is neither sphere, torus nor Klein bottle: SnapPy will refuse this file");
  }
  if (std::none_of(links.begin(), links.end(), [](const SurfaceType& link) { return link.euler <= 0; }))
    warnings.push_back("there is no cusp: SnapPea's kernel fails on such a file");
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (skeleton.is_reversed(e))
      warnings.push_back("edge " + std::to_string(e.value) +
                         " is identified with itself backwards: SnapPy will refuse this file");
  if (!skeleton.is_connected())
    warnings.push_back("there are " + std::to_string(skeleton.component_count()) +
                       " components: SnapPy expects one");
  return warnings;
}

void require_closed(const Triangulation& tri) {
  if (tri.size() == 0)
    throw InputError("a SnapPea file has at least one tetrahedron, this triangulation none");
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (tri.is_boundary({t, f}))
        throw InputError("a SnapPea file cannot hold boundary faces, such as face " + std::to_string(f) +
                         " of tetrahedron " + std::to_string(t));
}

std::string header_text(const std::string& name) {
  std::string text = std::string(snappea_header) + "\n";
  text += name.empty() ? std::string(snappea_no_name) : name;
  // No cusp is stated and every vertex is called finite, so that SnapPea finds the cusps and chooses
  // peripheral curves. Stating the cusps and leaving the curves zero was tried: the kernel then solves for a
  // wrong structure (volume 0.18 instead of 3.66 for the Whitehead link).
  return text + "\nnot_attempted 0.0\nunknown_orientability\nCS_unknown\n0 0\n";
}

/// Everything in the file; the document's ledger notes what is not in the document.
struct Everything {
  Document document;
  DehnFillings fillings;
};

Everything read_everything(std::string_view text, const std::string& source) {
  TextCursor in(text, source);
  const std::string expected_header = "\"" + std::string(snappea_header) + "\"";
  const std::string_view first = in.peek();
  const std::string_view header = in.at_end() ? first : in.rest_of_line();
  if (header != snappea_header) in.fail_at(header, expected_header);
  Document document;
  document.name = read_name(in);
  skip_solution(in);
  std::vector<Slope> slopes = read_cusps(in);
  const std::size_t cusps = slopes.size();
  Curves curves(std::move(slopes));
  const std::int64_t tetrahedra = in.integer("the number of tetrahedra, at least 1", 1, largest_count);
  GluingLines gluings(in);
  for (std::int64_t t = 0; t < tetrahedra; ++t) {
    gluings.read_one(tetrahedra);
    curves.add(read_tetrahedron_data(in, cusps, "tetrahedron " + std::to_string(t)));
  }
  curves.note_in(document.passed_over);
  if (!in.at_end()) in.fail_at(in.peek(), "the end after " + std::to_string(tetrahedra) + " tetrahedra");
  document.triangulation = gluings.checked();
  return {std::move(document), std::move(curves).fillings()};
}

} // namespace

Document read_snappea(std::string_view text, const std::string& source) {
  return read_everything(text, source).document;
}

DehnFillings read_dehn_fillings(std::string_view text, const std::string& source) {
  return read_everything(text, source).fillings;
}

Written write_snappea(const Document& document) {
  const Triangulation& tri = document.triangulation;
  require_closed(tri);
  Written out;
  out.warnings = warnings_about(Skeleton(tri));
  const std::string name = clean_line(document.name);
  if (name != document.name)
    out.warnings.push_back("the name was changed to fit on a line: " + in_quotes(name));
  out.text = header_text(name) + std::to_string(tri.size()) + "\n";
  std::string data = "  -1   -1   -1   -1\n";
  for (int curve = 0; curve < 4; ++curve) data += "  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n";
  data += "0.0 0.0\n";
  for (int t = 0; t < tri.size(); ++t) out.text += gluing_lines_of(tri, t) + data;
  return out;
}

} // namespace tetrarch::format
