// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "info.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/moves/boundary_moves.hpp"
#include "tetrarch/moves/log.hpp"
#include "tetrarch/moves/pachner.hpp"
#include "tetrarch/workshop/nearest.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

namespace tetrarch::program {
namespace {

using moves::Complex;
using moves::Move;

struct MoveArguments {
  std::string input;
  std::vector<std::string> words;
  std::string log;
  std::string output;
  bool list = false;
};

bool is_number(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos;
}

void require_known(const std::vector<std::string>& words) {
  const std::vector<std::string> names = moves::move_names();
  for (const std::string& word : words)
    if (!is_number(word) && std::find(names.begin(), names.end(), word) == names.end())
      throw InputError("unknown move " + in_quotes(word) + workshop::did_you_mean(word, names));
}

/// The moves in a row of words, each as `parse_move` has it.
moves::MoveLog moves_in(const std::vector<std::string>& words) {
  moves::MoveLog log;
  for (std::size_t first = 0; first < words.size();) {
    std::size_t end = first + 1;
    while (end < words.size() && is_number(words[end])) ++end;
    log.push_back(moves::parse_move(joined({words.begin() + static_cast<std::ptrdiff_t>(first),
                                            words.begin() + static_cast<std::ptrdiff_t>(end)},
                                           " ")));
    first = end;
  }
  return log;
}

moves::MoveLog moves_in_file(const std::string& path) {
  std::istringstream lines(format::read_file(path));
  moves::MoveLog log;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty()) continue;
    try {
      log.push_back(moves::parse_move(line));
    } catch (const InputError& e) {
      throw InputError({path, number}, e.what());
    }
  }
  return log;
}

/// Whether a tetrahedron is there, which is for the caller of `apply` to know.
void require_there(const Complex& complex, const Move& move) {
  if (move.kind == moves::MoveKind::pack) return;
  if (move.tet >= complex.slot_count() || !complex.is_alive(move.tet))
    throw InputError("the move " + in_quotes(move.str()) + " names tetrahedron " + std::to_string(move.tet) +
                     ", which does not exist; the number of tetrahedra is " + std::to_string(complex.size()));
}

/// The triangle and the edge in it that a pinch is made at, seen from the side of lesser number.
std::array<int, 4> pinch_place(const Triangulation& tri, DirectedTetEdge e) {
  const TetFace face = Walk{e.tet, edge_frame(e.from, e.to)}.left_face();
  const std::array<int, 4> here{e.tet, face.face, e.from, e.to};
  if (tri.is_boundary(face)) return here;
  const Gluing g = tri.gluing(face);
  return std::min(here, {g.tet, g.perm[face.face], g.perm[e.from], g.perm[e.to]});
}

/// So many 0-2 moves at edges are listed at most: there is one for every two faces around an edge.
constexpr std::size_t most_pairs = 100'000;

/// Finds what would be legal, of the kinds that are wanted: each move once for the face, the edge class, the
/// pair of faces around it or the boundary component that it is made at. O(n log n), and the length of the
/// list.
class Lister {
public:
  using Kind = moves::MoveKind;

  Lister(const Triangulation& tri, const std::vector<std::string>& words, const Progress& progress)
      : tri_(tri), complex_(tri), skeleton_(tri), progress_(progress) {
    for (std::size_t k = 0; k < wanted_.size(); ++k) {
      Move move;
      move.kind = static_cast<Kind>(k);
      const auto meant = [&move](const std::string& word) { return is_called(move, word); };
      wanted_[k] = words.empty() || std::any_of(words.begin(), words.end(), meant);
    }
  }

  moves::MoveLog legal() {
    list_at_tetrahedra();
    list_at_vertices_and_faces();
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      progress_.step("trying moves", static_cast<double>(e.value) / skeleton_.edge_count());
      if (!skeleton_.is_reversed(e)) list_at_edge(e);
    }
    if (wants(Kind::cone))
      for (const auto& component : boundary_faces(complex_))
        if (!why_not_cone(complex_, component))
          legal_.push_back({Kind::cone, component.front().tet, component.front().face});
    return std::move(legal_);
  }
  /// Whether there are more 0-2 moves at edges than were listed.
  bool is_cut() const { return is_cut_; }

private:
  bool wants(Kind kind) const { return wanted_[static_cast<std::size_t>(kind)]; }
  void try_move(const Move& move) {
    if (wants(move.kind) && !why_not_apply(complex_, move)) legal_.push_back(move);
  }

  void list_at_tetrahedra() {
    std::set<std::array<int, 4>> pinched;
    for (int t = 0; t < tri_.size(); ++t) {
      for (const Kind kind : {Kind::one_four, Kind::shell}) try_move({kind, t});
      if (!wants(Kind::pinch)) continue;
      for (const auto& [a, b] : edge_vertex)
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
          if (pinched.insert(pinch_place(tri_, {t, from, to})).second) try_move({Kind::pinch, t, from, to});
    }
  }

  void list_at_vertices_and_faces() {
    for (const VertexId v : all<VertexId>(skeleton_.vertex_count())) {
      const TetVertex at = skeleton_.preimages(v).front();
      for (const Kind kind : {Kind::four_one, Kind::two_zero_vertex}) try_move({kind, at.tet, at.vertex});
    }
    for (const FaceId f : all<FaceId>(skeleton_.face_count())) {
      const TetFace at = skeleton_.preimages(f).front();
      for (const Kind kind : {Kind::two_three, Kind::zero_two_face, Kind::open_book})
        try_move({kind, at.tet, at.face});
    }
  }

  void list_at_edge(EdgeId e) {
    const Walk walk = skeleton_.around(e).front();
    const DirectedTetEdge at{walk.tet, walk.from(), walk.to()};
    for (const Kind kind : {Kind::three_two, Kind::two_zero_edge, Kind::close_book})
      try_move({kind, at.tet, at.from, at.to});
    for (const Kind kind : {Kind::merge, Kind::two_one}) {
      try_move({kind, at.tet, at.from, at.to});
      try_move({kind, at.tet, at.to, at.from});
    }
    for (const int axis : {0, 1}) try_move({Kind::four_four, at.tet, at.from, at.to, axis});
    if (wants(Kind::zero_two_edge)) list_pairs(e);
  }

  /// Between any two of the faces around the edge. Its direction tells which way round it goes, and in
  /// tetrahedra of the other handedness that is the other one.
  void list_pairs(EdgeId e) {
    const auto around = skeleton_.around(e);
    for (std::size_t k = 0; k < around.size() && !is_cut_; ++k) {
      progress_.step("trying moves", static_cast<double>(e.value) / skeleton_.edge_count());
      const Walk& start = around[k];
      const bool same = edge_frame(start.from(), start.to()) == start.hold;
      const DirectedTetEdge held{start.tet, same ? start.from() : start.to(),
                                 same ? start.to() : start.from()};
      for (const int turn : zero_two_turns(complex_, held)) {
        if (k + static_cast<std::size_t>(turn) >= around.size()) break;
        is_cut_ = pairs_ == most_pairs;
        if (is_cut_) return;
        ++pairs_;
        legal_.push_back({Kind::zero_two_edge, held.tet, held.from, held.to, turn});
      }
    }
  }

  const Triangulation& tri_;
  Complex complex_;
  Skeleton skeleton_;
  const Progress& progress_;
  std::array<bool, moves::move_kind_count> wanted_{};
  moves::MoveLog legal_;
  std::size_t pairs_ = 0;
  bool is_cut_ = false;
};

Result list_moves(const format::Document& document, const MoveArguments& options, const Context& context) {
  Lister lister(document.triangulation, options.words, context.progress);
  const moves::MoveLog legal = lister.legal();
  Result result;
  result.warnings = document.warnings;
  result.json["moves"] = Json::array();
  for (const Move& move : legal) {
    const std::string line = move.str();
    result.json["moves"].push_back(line);
    result.text += line + "\n";
  }
  result.json["complete"] = !lister.is_cut();
  if (lister.is_cut())
    result.warnings.push_back("there are more 0-2 moves at edges: the first " + std::to_string(most_pairs) +
                              " are listed");
  if (result.text.empty()) result.text = "no legal move of this kind\n";
  return result;
}

/// Makes the moves. Of those that were typed each numbers the tetrahedra anew, as `info` shows them; those of
/// a log keep their slots.
Result make_moves(const MoveArguments& options, const Context& context) {
  require_known(options.words);
  format::Document document = read_triangulation(options.input, context);
  if (options.list) return list_moves(document, options, context);
  const moves::MoveLog log = options.log.empty() ? moves_in(options.words) : moves_in_file(options.log);
  Complex complex(document.triangulation);
  Result result;
  result.warnings = document.warnings;
  for (std::size_t k = 0; k < log.size(); ++k) {
    context.progress.step("moves", static_cast<double>(k) / static_cast<double>(log.size()));
    require_there(complex, log[k]);
    if (const auto obstacle = apply(complex, log[k])) {
      const std::string where = log.size() > 1 ? " (move " + std::to_string(k + 1) + " of " +
                                                     std::to_string(log.size()) + "; none was made)"
                                               : "";
      result.status = Status::proved_no;
      result.json = {{"move", log[k].str()}, {"obstacle", to_string(*obstacle)}};
      result.text = log[k].str() + " is illegal: " + to_string(*obstacle) + where + "\n";
      return result;
    }
    if (options.log.empty()) complex.pack();
  }
  format::Document made = format::document_of(complex.triangulation(), document.name);
  Info info = info_of(made.triangulation, made.name, context);
  result.json = std::move(info.json);
  result.json["moves"] = log.size();
  result.text = block(info.rows);
  if (!options.output.empty()) add_file(result, options.output, made);
  result.value = std::make_shared<Value>(std::move(made));
  return result;
}

} // namespace

fields::List fields::of_move() {
  namespace type = workshop::type;
  return workshop::both_of(workshop::sometimes(workshop::notes_of<workshop::Info>()),
                           {{"moves", "", "how many were made; with --list, those that are legal",
                             type::either(type::integer, type::list(type::text)), false},
                            {"complete", "", "with --list: whether all are listed", type::truth, false},
                            {"move", "", "the illegal one, for which none was made", type::text, false},
                            {"obstacle", "", "why it is illegal", type::text, false}});
}

Run declare_move(OptionTable& table) {
  const auto options = std::make_shared<MoveArguments>();
  table.add("X", options->input, "a triangulation or a mesh").required();
  table.add("MOVE", options->words,
            "a move and its place, as --list shows them: 2-3 0 1 is the move across face 1 of tetrahedron 0; "
            "one illegal move cancels all");
  table.add("--list", options->list, "list the legal moves, of the named kinds or of all, and make none");
  table.add("--log", options->log, "make the moves in this file, as simplify --moves writes them")
      .value_name("FILE");
  table.add("-o,--output", options->output, "the file to write (its extension names the format)")
      .output_file(require_triangulation);
  return [options](const Context& context) {
    if (options->words.empty() == options->log.empty() && !options->list)
      throw InputError("expected moves, or a file of moves (--log FILE)");
    return make_moves(*options, context);
  };
}

} // namespace tetrarch::program
