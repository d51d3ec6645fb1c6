// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/marked_isomorphism.hpp"

#include "tetrarch/core/signature.hpp"

#include <algorithm>

namespace tetrarch {
namespace {

/// The order of every t-edge.
std::vector<std::array<double, 6>> orders_at(const MarkedView& marked) {
  const Skeleton skeleton(marked.tri);
  const EdgeOrders orders = edge_orders(skeleton, marked.marks);
  std::vector<std::array<double, 6>> at(static_cast<std::size_t>(marked.tri.size()));
  for (int t = 0; t < marked.tri.size(); ++t)
    for (int e = 0; e < 6; ++e) at[t][e] = orders[skeleton.edge({t, e})];
  return at;
}

int image_of(Perm4 perm, int edge) {
  const auto [a, b] = edge_vertex[edge];
  return edge_number[perm[a]][perm[b]];
}

/// The marks after a labeling, as text. Classes are named by their first t-edges there.
std::string marks_text(const MarkedView& marked, const Isomorphism& labelling) {
  const Triangulation after = relabelled(marked.tri, labelling);
  const Skeleton skeleton(after);
  Marks moved;
  moved.reserve(marked.marks.size());
  for (const EdgeMark& mark : marked.marks)
    moved.push_back({{labelling.tet[mark.edge.tet], image_of(labelling.perm[mark.edge.tet], mark.edge.edge)},
                     mark.order});
  std::string text;
  for (const EdgeMark& mark : marks_of(skeleton, edge_orders(skeleton, moved))) text += "_" + to_string(mark);
  return text;
}

/// First a, then b.
Isomorphism composed(const Isomorphism& a, const Isomorphism& b) {
  Isomorphism out = a;
  for (std::size_t t = 0; t < a.tet.size(); ++t) {
    out.tet[t] = b.tet[a.tet[t]];
    out.perm[t] = b.perm[a.tet[t]] * a.perm[t];
  }
  return out;
}

} // namespace

bool respects_marks(const Isomorphism& iso, const MarkedView& a, const MarkedView& b) {
  const auto here = orders_at(a);
  const auto there = orders_at(b);
  for (int t = 0; t < a.tri.size(); ++t)
    for (int e = 0; e < 6; ++e)
      if (here[t][e] != there[iso.tet[t]][image_of(iso.perm[t], e)]) return false;
  return true;
}

std::vector<Isomorphism> marked_isomorphisms(const MarkedView& a, const MarkedView& b) {
  std::vector<Isomorphism> found = isomorphisms(a.tri, b.tri);
  if (a.marks.empty() && b.marks.empty()) return found;
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const Isomorphism& iso) { return !respects_marks(iso, a, b); }),
              found.end());
  return found;
}

std::optional<Isomorphism> find_marked_isomorphism(const MarkedView& a, const MarkedView& b) {
  if (a.marks.empty() && b.marks.empty()) return find_isomorphism(a.tri, b.tri);
  std::vector<Isomorphism> found = marked_isomorphisms(a, b);
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

std::string marked_signature(const MarkedView& marked) {
  if (marked.marks.empty()) return signature(marked.tri);
  const CanonicalLabelling labelled = canonical_labelling(marked.tri);
  std::string best;
  for (const Isomorphism& automorphism : automorphisms(marked.tri)) {
    const std::string text = marks_text(marked, composed(automorphism, labelled.labelling));
    if (best.empty() || text < best) best = text;
  }
  return labelled.text + best;
}

} // namespace tetrarch
