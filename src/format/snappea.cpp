// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/snappea.hpp"

#include "gluing_lines.hpp"

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace tetrarch::format {
namespace {

constexpr std::int64_t many = std::numeric_limits<int>::max();

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

/// The cusps; returns how many there are. Fillings are passed over.
std::int64_t read_cusps(TextCursor& in, Ledger& passed_over) {
  const std::int64_t torus = in.integer("the number of torus cusps", 0, many);
  const std::int64_t klein = in.integer("the number of Klein bottle cusps", 0, many);
  for (std::int64_t c = 0; c < torus + klein; ++c) {
    word(in, cusp_kinds, "torus or Klein, the kind of cusp " + std::to_string(c));
    const double m = in.number("the filling of cusp " + std::to_string(c) + ", two numbers");
    const double l = in.number("the filling of cusp " + std::to_string(c) + ", two numbers");
    if (m != 0 || l != 0)
      passed_over.note("Dehn filling (" + to_text(m) + "," + to_text(l) + ") of cusp " + std::to_string(c) +
                       ", which is open here");
  }
  return torus + klein;
}

/// What follows the gluings of one tetrahedron: checked, and not kept. True if a peripheral curve crosses it.
bool skip_tetrahedron_data(TextCursor& in, std::int64_t cusps, const std::string& whose) {
  // Where no cusp was stated, SnapPea finds them itself and the indices mean nothing.
  const std::int64_t last_cusp = cusps > 0 ? cusps - 1 : many;
  bool crossed = false;
  for (int v = 0; v < 4; ++v) in.integer("a cusp index of " + whose, -1, last_cusp);
  for (int k = 0; k < 64; ++k)
    if (in.integer("64 integers, the peripheral curves of " + whose, -many, many) != 0) crossed = true;
  for (int k = 0; k < 2; ++k) in.number("the shape of " + whose + ", two numbers", false);
  return crossed;
}

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

} // namespace

Document read_snappea(std::string_view text, const std::string& source) {
  TextCursor in(text, source);
  const std::string expected_header = "\"" + std::string(snappea_header) + "\"";
  const std::string_view first = in.peek();
  const std::string_view header = in.at_end() ? first : in.rest_of_line();
  if (header != snappea_header) in.fail_at(header, expected_header);
  Document document;
  document.name = read_name(in);
  skip_solution(in);
  const std::int64_t cusps = read_cusps(in, document.passed_over);
  const std::int64_t tetrahedra = in.integer("the number of tetrahedra, at least 1", 1, many);
  GluingLines gluings(in);
  bool has_curves = false;
  for (std::int64_t t = 0; t < tetrahedra; ++t) {
    gluings.read_one(tetrahedra);
    if (skip_tetrahedron_data(in, cusps, "tetrahedron " + std::to_string(t))) has_curves = true;
  }
  if (has_curves) document.passed_over.note("peripheral curve", 2 * cusps);
  if (!in.at_end()) in.fail_at(in.peek(), "the end after " + std::to_string(tetrahedra) + " tetrahedra");
  document.triangulation = gluings.checked();
  return document;
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
