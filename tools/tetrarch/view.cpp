// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "embedding.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/show/page.hpp"

#include <memory>
#include <numbers>

namespace tetrarch::program {
namespace {

using scene::InfoTable;
using workshop::Placement;

struct ViewArguments {
  std::string input;
  std::string output;
  std::int64_t copies = 300;
  double cusp_area = embed::DomainOptions{}.cusp_area;
};

InfoTable manifold_table(const Placement& e) {
  return {
      "Manifold",
      {},
      {{"signature", signature(e.triangulation())},
       {"volume", fixed(e.search.structure.volume, 12)},
       {"tetrahedra", std::to_string(e.triangulation().size())},
       {"orientable", e.skeleton.is_orientable() ? "yes" : "no"},
       {"homology", algebra::homology(e.triangulation(), e.skeleton, 1).str()},
       {"group", e.domain.group.presentation.generators <= 26 ? simplified(e.domain.group.presentation).str()
                                                              : "of more than 26 generators"}}};
}

InfoTable boundary_table(const Placement& e) {
  InfoTable table{"Boundary", {"vertex", "surface", "area"}, {}};
  for (const VertexId v : all<VertexId>(e.skeleton.vertex_count())) {
    const SurfaceType& link = e.skeleton.link(v);
    table.rows.push_back({std::to_string(v.value), link.euler == 0 ? link.str() + " (cusp)" : link.str(),
                          link.euler == 0 ? "0" : fixed(-2 * std::numbers::pi * link.euler, 6)});
  }
  return table;
}

InfoTable edge_table(const Placement& e) {
  InfoTable table{"Edges", {"edge", "length", "valence"}, {}};
  const auto types = hyperbolic::vertex_types(e.skeleton);
  for (const EdgeId edge : all<EdgeId>(e.skeleton.edge_count())) {
    const auto [p, q] = e.skeleton.ends(edge);
    const bool infinite =
        types[p] == hyperbolic::VertexType::ideal || types[q] == hyperbolic::VertexType::ideal;
    table.rows.push_back({std::to_string(edge.value),
                          infinite ? "infinite" : fixed(e.search.structure.lengths[edge], 10),
                          std::to_string(e.skeleton.valence(edge))});
  }
  return table;
}

InfoTable angle_table(const Placement& e) {
  InfoTable table{"Dihedral angles", {"tet", "01", "02", "03", "12", "13", "23"}, {}};
  for (std::size_t t = 0; t < e.search.structure.dihedral_angles.size(); ++t) {
    auto& row = table.rows.emplace_back(1, std::to_string(t));
    for (const double angle : e.search.structure.dihedral_angles[t]) row.push_back(fixed(angle, 6));
  }
  return table;
}

Result run_view(const ViewArguments& options, const Context& context) {
  if (options.copies < 1)
    throw InputError("--copies " + std::to_string(options.copies) + ": expected at least 1");
  constexpr std::int64_t most_copies = 20'000; // what a browser turns smoothly
  if (options.copies > most_copies)
    throw InputError("--copies " + std::to_string(options.copies) + ": a page shows at most " +
                     std::to_string(most_copies) + "; 'tetrarch embed' writes more copies to a file");
  const PlacedInput input = placed(options.input, options.cusp_area, context);
  const Placement& e = input.placement;
  // A piece by word length has gaps near by that farther copies would fill: of more, the nearest are kept.
  const embed::PieceBounds bounds{8 * options.copies, 0, 0};
  show::Page page{e.name, {manifold_table(e), boundary_table(e), edge_table(e), angle_table(e)}, {}};
  page.bodies.push_back(show::body_of(e.triangulation(), e.skeleton, e.domain,
                                      universal_cover(e.domain, bounds, context.progress)));
  for (const auto& lift : boundary_lifts(e.triangulation(), e.skeleton, e.domain))
    page.bodies.push_back(
        show::body_of(e.skeleton, lift, group_piece(lift.pairings, lift.size, bounds, context.progress)));
  for (auto& body : page.bodies) keep_nearest(body, static_cast<std::size_t>(options.copies));
  Result result;
  result.warnings = input.warnings;
  for (const std::string& remark : e.remarks()) result.warnings.push_back(remark);
  Json bodies = Json::array();
  for (const auto& body : page.bodies)
    bodies.push_back({{"name", body.name}, {"copies", body.copies.size()}});
  result.files.push_back({options.output, write_page(page)});
  result.json = {{"page", options.output}, {"bytes", result.files.back().content.size()}, {"bodies", bodies}};
  result.text = "wrote " + options.output + ": " +
                counted(static_cast<long long>(page.bodies.size()), "view") + ", " +
                std::to_string(result.files.back().content.size() / 1000) + " kB\n";
  return result;
}

} // namespace

fields::List fields::of_view() {
  namespace type = workshop::type;
  return {{"page", "", "the file written", type::text},
          {"bytes", "bytes", "its size", type::integer},
          {"bodies", "", "what can be looked at: name, and copies",
           type::list(type::object({{"name", type::text}, {"copies", type::integer}}))}};
}

Run declare_view(OptionTable& table) {
  const auto o = std::make_shared<ViewArguments>();
  table.add("X", o->input, "a hyperbolic manifold; the structure is found first, as by hyperbolize")
      .required();
  table.add("-o,--output", o->output, "write the page to this file")
      .output_file(with_extension(".html"))
      .required();
  table.add("--copies", o->copies, "greatest number of copies of the domain on the page").with_default();
  table.add("--cusp-area", o->cusp_area, "area of the cross-section that cuts a cusp off").with_default();
  return [o](const Context& context) { return run_view(*o, context); };
}

} // namespace tetrarch::program
