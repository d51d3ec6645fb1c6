// SPDX-License-Identifier: GPL-2.0-or-later
#include "census.hpp"
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/moves/subdivide.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"
#include "tetrarch/workshop/identify.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

struct IdentifyOptions {
  std::string input;
  std::string table;
  int attempts = identify::IdentifyOptions().attempts;
};

Result identify(const IdentifyOptions& options, const Context& context) {
  const std::string& input = options.input;
  identify::IdentifyOptions how;
  how.seed = context.seed;
  how.attempts = options.attempts;
  if (!options.table.empty()) {
    const std::string path = located(options.table);
    if (catalogue::is_database(path))
      how.database = std::make_shared<catalogue::Database>(path);
    else
      how.table = read_table_file(path);
  }
  const format::Document document = read_triangulation(input, context);
  require_manifold(document.triangulation, input);
  workshop::require_filled(document, input);
  const identify::Identification found = identify::identify(document.triangulation, how, context.progress);
  Result result;
  result.warnings = document.warnings;
  result.status = status_of(workshop::verdict_of(found));
  result.json = workshop::tree_of(found);
  result.text = block(workshop::rows_of(found));
  if (found) result.value = std::make_shared<Value>(format::document_of(found.triangulation, found.name));
  return result;
}

struct SubdivideOptions {
  std::string input;
  std::string output;
  int barycentric = 0;
  bool one_four = false;
  bool finite = false;
};

/// A file of this many is a gigabyte.
constexpr long long most_tetrahedra = 10'000'000;

void require_few(long long tetrahedra, const std::string& input) {
  if (tetrahedra > most_tetrahedra)
    throw InputError({input, 0}, "this would make " + std::to_string(tetrahedra) + " tetrahedra (at most " +
                                     std::to_string(most_tetrahedra) + ")");
}

Triangulation subdivided(Triangulation tri, const SubdivideOptions& options, const Context& context) {
  const long long most_pieces = options.finite ? 28 : 1;
  require_few(most_pieces * tri.size(), options.input);
  if (options.finite) tri = moves::finite_model(tri).tri;
  for (int k = 0; k < options.barycentric; ++k) {
    context.progress.step("subdividing", static_cast<double>(k) / options.barycentric);
    require_few(static_cast<long long>(Perm4::count) * tri.size(), options.input);
    tri = moves::barycentric(tri).tri;
  }
  require_few((options.one_four ? 4LL : 1LL) * tri.size(), options.input);
  if (options.one_four) tri = moves::subdivided_1_4(tri).tri;
  return tri;
}

Result subdivide(const SubdivideOptions& options, const Context& context) {
  format::Document document = read_triangulation(options.input, context);
  const int before = document.triangulation.size();
  Triangulation tri = subdivided(std::move(document.triangulation), options, context);
  const Skeleton skeleton(tri);
  Result result;
  result.warnings = document.warnings;
  result.json = {{"input_tetrahedra", before},
                 {"tetrahedra", tri.size()},
                 {"faces", skeleton.face_count()},
                 {"edges", skeleton.edge_count()},
                 {"vertices", skeleton.vertex_count()},
                 {"boundary_faces", skeleton.boundary_face_count()},
                 {"output", options.output.empty() ? Json() : Json(options.output)}};
  result.text = counted(tri.size(), "tetrahedron") + ", " + counted(skeleton.vertex_count(), "vertex") +
                ", " + counted(skeleton.boundary_face_count(), "boundary face") +
                (options.output.empty() ? "\n" : " written to " + options.output + "\n");
  format::Document made = format::document_of(std::move(tri), document.name);
  if (!options.output.empty()) add_file(result, options.output, made);
  result.value = std::make_shared<Value>(std::move(made));
  return result;
}

} // namespace

Run declare_census_identify(OptionTable& table) {
  const auto options = std::make_shared<IdentifyOptions>();
  table.add("X", options->input, "a triangulation or a mesh").required();
  table.add("--attempts", options->attempts, "greatest number of triangulations to try; fewer of large ones")
      .in_range(1, 1'000'000)
      .with_default();
  table
      .add("--table", options->table,
           "look it up in this table as well, which census enumerate -o, census merge -o or census table "
           "wrote")
      .value_name("FILE");
  return [options](const Context& context) { return identify(*options, context); };
}

fields::List fields::of_subdivide() {
  namespace type = workshop::type;
  return {{"input_tetrahedra", "", "number of tetrahedra of the input", type::integer},
          {"tetrahedra", "", "number of tetrahedra", type::integer},
          {"faces", "", "number of face classes", type::integer},
          {"edges", "", "number of edge classes", type::integer},
          {"vertices", "", "number of vertex classes", type::integer},
          {"boundary_faces", "", "those of the faces that lie on the real boundary", type::integer},
          {"output", "", "the file written; null: none", type::or_null(type::text)}};
}

Run declare_subdivide(OptionTable& table) {
  const auto options = std::make_shared<SubdivideOptions>();
  table.add("X", options->input, "a triangulation or a mesh").required();
  table.add("--finite", options->finite,
            "first truncate ideal vertices, which makes their links real boundary");
  table
      .add("--barycentric", options->barycentric,
           "number of barycentric subdivisions; each makes 24 tetrahedra of one")
      .in_range(0, 5);
  table.add("--one-four", options->one_four, "finally divide each tetrahedron into 4");
  table.add("-o,--output", options->output, "the file to write (its extension names the format)")
      .output_file(require_triangulation);
  return [options](const Context& context) { return subdivide(*options, context); };
}

} // namespace tetrarch::program
