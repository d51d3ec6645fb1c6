// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "embedding.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/embed/mobius.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/show/in_model.hpp"

#include <algorithm>
#include <memory>
#include <optional>

namespace tetrarch::program {
namespace {

using embed::Piece;
using show::Body;
using show::ModelOptions;

struct EmbedArguments {
  std::string input;
  std::vector<std::string> outputs;
  std::string model = "half-space";
  std::optional<std::int64_t> copies;
  std::optional<int> word_length;
  std::optional<double> radius;
  std::optional<int> boundary;
  double chord_error = 0;
  double tube_radius = ModelOptions{}.tube_radius;
  double cusp_area = embed::DomainOptions{}.cusp_area;
  bool outside = false;
  std::string colors = "tetrahedron";
};

embed::PieceBounds wanted_bounds(const EmbedArguments& options) {
  if (options.copies && *options.copies < 1)
    throw InputError("--copies " + std::to_string(*options.copies) + ": expected at least 1");
  if (options.word_length && *options.word_length < 1)
    throw InputError("--word-length " + std::to_string(*options.word_length) + ": expected at least 1");
  if (options.radius && !(*options.radius > 0 && *options.radius <= 700))
    throw InputError("--radius " + format::to_text(*options.radius) +
                     ": expected a positive distance, at most 700");
  embed::PieceBounds bounds{options.copies.value_or(0), options.word_length.value_or(0),
                            options.radius.value_or(0)};
  if (!options.copies && !options.word_length && !options.radius) bounds.copies = 1;
  return bounds;
}

void require_output(const std::string& path) {
  require_folder(path);
  if (!format::has_extension(path, ".svg") && !scene::scene_format_for_extension(path))
    throw InputError({path, 0}, "no picture has this extension (expected .glb, .ply, .obj, .vtu or .svg)");
}

Json matrix_json(const embed::Matrix4<double>& m) {
  Json rows = Json::array();
  for (const auto& row : m) rows.push_back(row);
  return rows;
}

Json mobius_json(const embed::Matrix4<double>& m) {
  const auto mobius = embed::mobius_of(m);
  Json entries = Json::array();
  for (const auto& z : {mobius.a, mobius.b, mobius.c, mobius.d}) entries.push_back({z.re, z.im});
  return {{"matrix", entries}, {"reverses_orientation", mobius.reverses}};
}

Json residuals_json(const embed::Residuals& r) {
  return {{"seam", r.seam},
          {"relator", r.relator},
          {"relator_sl2c", r.relator_sl2c},
          {"edge_rotation", r.edge_rotation},
          {"boundary_plane", r.boundary_plane},
          {"gauss_bonnet", r.gauss_bonnet}};
}

Json domain_json(const Embedding& e) {
  Json tets = Json::array();
  for (std::size_t t = 0; t < e.domain.vertices.size(); ++t) {
    Json types = Json::array();
    for (const auto type : e.domain.types[t]) types.push_back(to_string(type));
    tets.push_back(
        {{"vertices", e.domain.vertices[t]}, {"types", types}, {"parent", e.domain.entrance[t].tet}});
  }
  Json faces = Json::array();
  for (const auto& face : e.domain.faces) {
    Json hexagons = Json::array();
    for (const TetFace f : face.hexagons) hexagons.push_back({f.tet, f.face});
    faces.push_back(
        {{"hexagons", hexagons}, {"partner", face.partner}, {"pairing", matrix_json(face.pairing)}});
  }
  Json generators = Json::array();
  for (const auto& g : e.domain.holonomy) {
    Json entry{{"so31", matrix_json(g)}, {"sl2c", mobius_json(g)}};
    generators.push_back(std::move(entry));
  }
  Json relators = Json::array();
  for (const auto& word : e.domain.group.presentation.relators)
    relators.push_back(algebra::word_str(word, e.domain.group.presentation.generators));
  return {{"half_space", matrix_json(e.domain.half_space)},
          {"tetrahedra", tets},
          {"gluable_faces", faces},
          {"generators", generators},
          {"relators", relators}};
}

Json piece_json(const Piece& piece) {
  return {{"count", piece.copies.size()},
          {"complete", piece.complete},
          {"longest_word", *std::max_element(piece.length.begin(), piece.length.end())},
          {"farthest", *std::max_element(piece.distance.begin(), piece.distance.end())},
          {"largest_duplicate_difference", piece.largest_duplicate},
          {"smallest_difference", piece.closest}};
}

/// Written out while its generators are single letters.
std::string group_text(const algebra::Presentation& group) {
  if (group.generators <= 26) return group.str();
  return counted(group.generators, "generator") + ", " +
         counted(static_cast<long long>(group.relators.size()), "relator");
}

std::vector<std::pair<std::string, std::string>> report(const Embedding& e, const embed::Residuals& r,
                                                        const Piece& piece) {
  const Json p = piece_json(piece);
  return {{"manifold", e.name},
          {"volume", fixed(e.structure.volume, 12)},
          {"tetrahedra", std::to_string(e.tri.size())},
          {"gluable faces", std::to_string(e.domain.faces.size())},
          {"group", group_text(e.domain.group.presentation)},
          {"seam error", scientific(r.seam, 1)},
          {"relators",
           scientific(r.relator, 1) + " in SO(3,1), " + scientific(r.relator_sl2c, 1) + " in SL(2,C)"},
          {"edge rotations", scientific(r.edge_rotation, 1)},
          {"boundary planes", scientific(r.boundary_plane, 1)},
          {"Gauss-Bonnet", scientific(r.gauss_bonnet, 1)},
          {"copies", std::to_string(piece.copies.size()) + ", words up to length " +
                         std::to_string(p["longest_word"].integer()) + ", up to distance " +
                         fixed(p["farthest"].number(), 3)}};
}

/// What is drawn: the domain and its copies, or one boundary component and its copies.
struct Drawn {
  Body body;
  Piece piece;
};

Drawn draw(const Embedding& e, const embed::PieceBounds& wanted, const EmbedArguments& options,
           const Context& context) {
  const embed::PieceBounds bounds = allowed_bounds(wanted, allowed_gigabytes(context));
  Drawn drawn;
  if (options.boundary) {
    const auto lifts = boundary_lifts(e.tri, e.skeleton, e.domain);
    if (*options.boundary < 0 || *options.boundary >= static_cast<int>(lifts.size()))
      throw InputError("--boundary " + std::to_string(*options.boundary) + ": " + e.name + " has " +
                       counted(static_cast<long long>(lifts.size()), "component") + ", counted from 0");
    const auto& lift = lifts[*options.boundary];
    drawn.piece = group_piece(lift.pairings, lift.size, bounds, context.progress);
    drawn.body = show::body_of(e.skeleton, lift, drawn.piece);
  } else {
    drawn.piece = universal_cover(e.domain, bounds, context.progress);
    drawn.body = show::body_of(e.tri, e.skeleton, e.domain, drawn.piece);
  }
  require_complete(drawn.piece, wanted, allowed_gigabytes(context));
  return drawn;
}

/// One of the names that are allowed.
ModelOptions::Colors colors_named(const std::string& name) {
  if (name == "face") return ModelOptions::Colors::face;
  return name == "word-length" ? ModelOptions::Colors::word_length : ModelOptions::Colors::tetrahedron;
}

ModelOptions model_options(const Body& body, const EmbedArguments& options) {
  ModelOptions how;
  how.model = *embed::model_named(options.model);
  how.chord_error = options.chord_error > 0 ? options.chord_error : extent(body, how.model) / 400;
  how.tube_radius = options.tube_radius;
  how.inner = !options.outside;
  how.colors = colors_named(options.colors);
  return how;
}

std::string picture(const std::string& path, const Body& body, const EmbedArguments& options,
                    const Context& context) {
  const ModelOptions how = model_options(body, options);
  if (format::has_extension(path, ".svg"))
    return write_svg(body.view == show::View::space ? circles_at_infinity(body) : drawing_of(body, how));
  require_memory(std::to_string(body.copies.size()) + " copies in " + path, scene_bytes(body, how),
                 allowed_gigabytes(context));
  return write_scene(in_model(body, how, context.progress), *scene::scene_format_for_extension(path));
}

Result run_embed(const EmbedArguments& options, const Context& context) {
  for (const std::string& path : options.outputs) require_output(path);
  const embed::PieceBounds wanted = wanted_bounds(options); // complains before anything is computed
  const Embedding e = embedded(options.input, options.cusp_area, context);
  const Drawn drawn = draw(e, wanted, options, context);
  const embed::Residuals r = residuals(e.tri, e.skeleton, e.domain);
  Result result;
  result.warnings = e.warnings;
  if (constexpr double visible = 1e-6; !(std::max({r.seam, r.boundary_plane, r.edge_rotation}) < visible))
    result.warnings.push_back("the domain is too large for double precision: its far parts are off by " +
                              scientific(std::max(r.seam, r.boundary_plane), 1));
  result.text = block(report(e, r, drawn.piece));
  result.json = {{"signature", signature(e.tri)}, {"volume", e.structure.volume}};
  result.json["residuals"] = residuals_json(r);
  result.json["domain"] = domain_json(e);
  result.json["copies"] = piece_json(drawn.piece);
  for (const std::string& path : options.outputs)
    result.files.push_back({path, picture(path, drawn.body, options, context)});
  return result;
}

} // namespace

Run declare_embed(OptionTable& table) {
  const auto o = std::make_shared<EmbedArguments>();
  table.add("X", o->input, "a hyperbolic manifold; the structure is found first, as by hyperbolize")
      .required();
  table
      .add("-o,--output", o->outputs,
           "write a picture: .glb, .ply, .obj or .vtu; .svg for the circles at infinity or the tiling of a "
           "boundary; may be repeated")
      .value_name("FILE");
  table.add("--copies", o->copies, "greatest number of copies of the domain (1 if no option bounds them)");
  table.add("--word-length", o->word_length, "greatest number of face crossings to a copy");
  table.add("--radius", o->radius, "greatest distance to the center of a copy");
  table.add("--boundary", o->boundary,
            "unroll this boundary component or cusp in the plane, and show nothing else");
  table.add("--model", o->model, "model of hyperbolic space: half-space, ball or klein")
      .one_of({"half-space", "ball", "klein"})
      .with_default();
  table.add("--color", o->colors, "color the faces by tetrahedron, face or word-length")
      .one_of({"tetrahedron", "face", "word-length"})
      .with_default();
  table
      .add("--chord-error", o->chord_error,
           "greatest distance of a chord from its curve in the model (0: 1/400 of the size of the domain)")
      .with_default();
  table.add("--tube-radius", o->tube_radius, "hyperbolic radius of the tubes around edges (0: no tubes)")
      .with_default();
  table.add("--outside", o->outside, "omit the faces inside a copy");
  table.add("--cusp-area", o->cusp_area, "area of the cross-section that cuts a cusp off").with_default();
  return [o](const Context& context) { return run_embed(*o, context); };
}

} // namespace tetrarch::program
