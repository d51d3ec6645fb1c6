// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/verify.hpp"

#include "tetrarch/workshop/text.hpp"

namespace tetrarch::workshop {
namespace {

using checker::Report;

bool is_accepted(const Report& r) {
  return r.accepted;
}
bool is_refused(const Report& r) {
  return !r.accepted;
}

std::string links_text(const Report& r) {
  std::vector<std::string> links;
  for (const int euler : r.links) links.push_back(std::to_string(euler));
  return joined(links, ", ");
}

} // namespace

Rows rows_of(const Report& r) {
  if (!r.accepted) return {{"refused", r.why_not}};
  return {{"accepted", "a hyperbolic structure exists, and only one near the lengths given"},
          {"tetrahedra", std::to_string(r.tetrahedra)},
          {"edges", std::to_string(r.edges)},
          {"orientable", r.orientable ? "yes" : "no"},
          {"links", "Euler characteristic " + links_text(r)},
          {"volume in", "[" + r.volume[0] + ", " + r.volume[1] + "]"}};
}

template <>
const FieldList<Report>& fields_of<Report>() {
  using R = const Report&;
  static const FieldList<Report> fields{
      {{"accepted", "", "whether the certificate proves what it claims", type::truth},
       [](R r) -> Tree { return r.accepted; }},
      {{"reason", "", "the first thing that is not proved", type::text},
       [](R r) -> Tree { return r.why_not; },
       is_refused},
      {{"tetrahedra", "", "number of tetrahedra", type::integer}, [](R r) -> Tree { return r.tetrahedra; }},
      {{"edges", "", "number of edge classes", type::integer},
       [](R r) -> Tree { return r.edges; },
       is_accepted},
      {{"cusps", "", "number of cusps", type::integer}, [](R r) -> Tree { return r.cusps; }, is_accepted},
      {{"orientable", "", "whether the manifold is orientable", type::truth},
       [](R r) -> Tree { return r.orientable; },
       is_accepted},
      {{"links", "", "Euler characteristics of the vertex links, increasing", type::list(type::integer)},
       [](R r) -> Tree { return r.links; },
       is_accepted},
      {{"volume_interval", "curvature -1", "two decimal numbers, as texts, between which the volume lies",
        type::list(type::text, 2)},
       [](R r) -> Tree {
         return {r.volume[0], r.volume[1]};
       },
       is_accepted},
      {{"bits", "", "binary digits that the proof was found with; the check takes 128 more", type::integer},
       [](R r) -> Tree { return r.bits; }}};
  return fields;
}

} // namespace tetrarch::workshop
