// SPDX-License-Identifier: GPL-2.0-or-later
#include "gluings_partial.hpp"

#include <bitset>

namespace tetrarch::enumeration {
namespace {

std::uint64_t bit(int position) {
  return position < 64 ? std::uint64_t{1} << position : 0;
}

/// The smaller end of the edge of a face that is off one of its vertices.
constexpr int low_end(int face, int off) {
  return face != 0 && off != 0 ? 0 : face != 1 && off != 1 ? 1 : 2;
}

} // namespace

GluingRules::GluingRules(const GluingOptions& options)
    : tetrahedra(options.tetrahedra),
      orientable_only(options.orientability == GluingOptions::Orientability::orientable),
      nonorientable_only(options.orientability == GluingOptions::Orientability::nonorientable),
      ideal(options.ideal), min_valence(options.min_valence), allow_invalid(options.allow_invalid),
      links_limited(options.links.has_value()) {
  if (!links_limited) {
    orientable_links = nonorientable_links = ~std::uint64_t{0};
    return;
  }
  for (const int g : options.links->genera)
    if (g >= 0 && g < 32) orientable_links |= bit(2 * g);
  for (const int k : options.links->crosscaps)
    if (k >= 1) nonorientable_links |= bit(k);
  for (int e = 0; e < 64; ++e)
    if (((orientable_links | nonorientable_links) & bit(e)) != 0) max_euler_genus = e;
}

void PartialGluing::add_tetrahedron(int handedness) {
  const int tet = tets_++;
  TetPart& part = part_[tet];
  part.target.fill(open);
  part.perm.fill(Perm4());
  part.handedness = static_cast<std::int8_t>(handedness);
  for (int v = 0; v < 4; ++v) {
    part.link[v] = LinkTriangle();
    part.link[v].parent = static_cast<std::uint8_t>(4 * tet + v);
  }
  // The edge of face f off vertex v is the edge of face v off vertex f.
  for (int f = 0; f < 4; ++f)
    for (int v = 0; v < 4; ++v) part.chain[4 * f + v] = {static_cast<std::uint8_t>(16 * tet + 4 * v + f), 2};
}

void PartialGluing::copy_from(const PartialGluing& source) {
  tets_ = source.tets_;
  glued_ = source.glued_;
  orientable_ = source.orientable_;
  has_ideal_vertex_ = source.has_ideal_vertex_;
  std::copy_n(source.part_.begin(), tets_, part_.begin());
}

PartialGluing::Root PartialGluing::root(int vertex) const {
  int against = 0;
  while (link(vertex).parent != vertex) {
    against ^= link(vertex).against_parent;
    vertex = link(vertex).parent;
  }
  return {vertex, against};
}

/// Glues one open arc of the triangle at a to one of the triangle at b.
void PartialGluing::join_links(int a, int b, int against) {
  Root r = root(a);
  Root s = root(b);
  against ^= r.against ^ s.against;
  if (r.triangle != s.triangle) {
    if (link(r.triangle).triangles < link(s.triangle).triangles) std::swap(r, s);
    LinkTriangle& big = link(r.triangle);
    LinkTriangle& small = link(s.triangle);
    small.parent = static_cast<std::uint8_t>(r.triangle);
    small.against_parent = static_cast<std::uint8_t>(against);
    big.triangles += small.triangles;
    big.open_arcs += small.open_arcs;
    big.inner_vertices += small.inner_vertices;
    big.nonorientable |= small.nonorientable;
  } else if (against != 0) {
    link(r.triangle).nonorientable = 1;
  }
  link(r.triangle).open_arcs -= 2;
}

/// Ties the chains that end at two slots; `against`: the t-edges there are glued head to tail.
bool PartialGluing::tie(int slot, int other_slot, int against, const GluingRules& rules) {
  const ChainEnd here = chain(slot);
  const ChainEnd there = chain(other_slot);
  if (here.other != other_slot) {
    const int length = (here.length & ~1) + (there.length & ~1);
    const auto joined = static_cast<std::uint8_t>(length | ((here.length ^ there.length ^ against) & 1));
    chain(here.other) = {there.other, joined};
    chain(there.other) = {here.other, joined};
    return true;
  }
  const bool reversed = ((here.length ^ against) & 1) != 0;
  if (reversed && !rules.allow_invalid) return false;
  if (here.length >> 1 < rules.min_valence) return false;
  // A vertex of the link at each end of the edge; the ends of a reversed edge are one.
  const int tet = slot >> 4;
  const int face = slot >> 2 & 3;
  const int off = slot & 3;
  const int from = low_end(face, off);
  ++link(root(4 * tet + from).triangle).inner_vertices;
  if (!reversed) ++link(root(4 * tet + 6 - face - off - from).triangle).inner_vertices;
  return true;
}

bool PartialGluing::glue(int face, int other, Perm4 p, const GluingRules& rules) {
  const int tet = face >> 2;
  const int f = face & 3;
  const int image = 4 * other + p[f];
  part_[tet].target[f] = static_cast<std::uint8_t>(image);
  part_[tet].perm[f] = p;
  part_[other].target[p[f]] = static_cast<std::uint8_t>(face);
  part_[other].perm[p[f]] = p.inverse();
  ++glued_;
  const bool odd = p.sign() < 0;
  if (odd != (handedness(tet) == handedness(other))) orientable_ = false;
  for (const int v : face_vertex[f]) join_links(4 * tet + v, 4 * other + p[v], odd ? 0 : 1);
  for (const int off : face_vertex[f]) {
    const int a = low_end(f, off);
    const int b = 6 - f - off - a;
    if (!tie(4 * face + off, 4 * image + p[off], p[a] > p[b] ? 1 : 0, rules)) return false;
  }
  return links_are_allowed(tet, f, rules);
}

/// Looks at the links that the gluing of this face has changed.
bool PartialGluing::links_are_allowed(int tet, int face, const GluingRules& rules) {
  for (const int v : face_vertex[face]) {
    const LinkTriangle& piece = link(root(4 * tet + v).triangle);
    if (piece.open_arcs != 0) {
      if (piece.nonorientable != 0 && rules.nonorientable_links == 0) return false;
      continue;
    }
    const int euler_genus = 2 - piece.inner_vertices + piece.triangles / 2;
    if (!rules.allows_link(euler_genus, piece.nonorientable == 0)) return false;
    if (euler_genus > 0) has_ideal_vertex_ = true;
  }
  return !rules.links_limited || open_links_are_allowed(rules);
}

/// A surface never loses handles or crosscaps by growing, so a link that has too many before it is closed is
/// given up. The holes are counted by walking round each of them, from open arc to open arc.
bool PartialGluing::open_links_are_allowed(const GluingRules& rules) const {
  std::array<std::uint8_t, static_cast<std::size_t>(4) * max_tets> holes{};
  std::bitset<static_cast<std::size_t>(16) * max_tets> seen;
  for (int first = 0; first < 16 * tets_; ++first) {
    const int home = first >> 2;
    if ((home & 3) == (first & 3) || !is_open(home) || seen[first]) continue;
    ++holes[root((home & ~3) + (first & 3)).triangle];
    // The arc of face `arc >> 2` at corner `arc & 3`; we leave it by the edge off vertex `off`.
    int arc = first;
    int off = face_vertex[home & 3][(first & 3) == face_vertex[home & 3][0] ? 1 : 0];
    do {
      seen.set(arc);
      const int corner = arc & 3;
      const int partner = 6 - (arc >> 2 & 3) - off - corner; // the other end of the edge that we leave by
      const ChainEnd end = chain((arc & ~3) + off);
      const int face = end.other >> 2;
      const int away = end.other & 3;
      const int low = low_end(face & 3, away);
      const int high = 6 - (face & 3) - away - low;
      const bool at_low = (corner < partner) != ((end.length & 1) != 0);
      arc = 4 * face + (at_low ? low : high);
      off = at_low ? high : low; // we came in by the edge off `away`, and the corner is no choice
    } while (arc != first);
  }
  for (int v = 0; v < 4 * tets_; ++v) {
    const LinkTriangle& piece = link(v);
    if (piece.parent != v || piece.open_arcs == 0) continue;
    const int twice_euler = 2 * piece.inner_vertices + piece.open_arcs - piece.triangles;
    if (2 - twice_euler / 2 - holes[v] > rules.max_euler_genus) return false;
  }
  return true;
}

Triangulation PartialGluing::triangulation() const {
  Triangulation tri(tets_);
  for (int face = 0; face < 4 * tets_; ++face)
    if (target(face) != open && target(face) > face)
      tri.glue({face >> 2, face & 3}, target(face) >> 2, perm(face));
  return tri;
}

} // namespace tetrarch::enumeration
