// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/group.hpp"

#include "dual_tree.hpp"
#include "tietze.hpp"

#include "tetrarch/algebra/smith.hpp"
#include "tetrarch/core/error.hpp"

#include <cstdlib>

namespace tetrarch::algebra {
namespace {

constexpr int alphabet = 26;

std::string letter_str(int letter, int generators) {
  const int g = std::abs(letter) - 1;
  if (generators <= alphabet) return std::string(1, static_cast<char>((letter > 0 ? 'a' : 'A') + g));
  return (letter > 0 ? "g" : "G") + std::to_string(g + 1);
}

/// A non-empty list after its bar or bracket, with a blank in front.
void append_item(std::string& text, const std::string& item, bool first) {
  text += (first ? " " : ", ") + item;
}

} // namespace

std::string word_str(const Word& word, int generators) {
  std::string text;
  for (const int letter : word) text += letter_str(letter, generators);
  return text;
}

std::string Presentation::str() const {
  std::string text = "<";
  for (int g = 0; g < generators; ++g) append_item(text, letter_str(g + 1, generators), g == 0);
  text += " |";
  for (std::size_t r = 0; r < relators.size(); ++r)
    append_item(text, relators[r].empty() ? "1" : word_str(relators[r], generators), r == 0);
  return text + " >";
}

Word freely_reduced(const Word& word) {
  Word out;
  out.reserve(word.size());
  for (const int letter : word) {
    if (!out.empty() && out.back() == -letter)
      out.pop_back();
    else
      out.push_back(letter);
  }
  return out;
}

Word cyclically_reduced(const Word& word) {
  Word out = freely_reduced(word);
  std::size_t cut = 0;
  while (2 * cut + 1 < out.size() && out[cut] == -out[out.size() - 1 - cut]) ++cut;
  if (cut == 0) return out;
  return {out.begin() + static_cast<std::ptrdiff_t>(cut), out.end() - static_cast<std::ptrdiff_t>(cut)};
}

DualPresentation dual_presentation(const Triangulation& tri, const Skeleton& skeleton) {
  require_manifold(tri, skeleton, "a presentation of the fundamental group");
  if (skeleton.component_count() != 1)
    throw PreconditionError(
        "a presentation of the fundamental group needs a connected triangulation, but this one has " +
        std::to_string(skeleton.component_count()) + " components");
  const Table<FaceId, char> tree = dual_spanning_forest(tri, skeleton);
  DualPresentation dual;
  Table<FaceId, int> letter(skeleton.face_count(), 0);
  for (const FaceId f : all<FaceId>(skeleton.face_count())) {
    if (skeleton.is_boundary(f) || tree[f]) continue;
    dual.generator_face.push_back(skeleton.preimages(f)[0]);
    letter[f] = static_cast<int>(dual.generator_face.size());
  }
  dual.presentation.generators = static_cast<int>(dual.generator_face.size());
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (skeleton.is_boundary(e)) continue;
    Word word;
    for (const Walk& w : skeleton.around(e)) {
      const FaceId f = skeleton.face(w.left_face());
      if (letter[f] == 0) continue;
      word.push_back(skeleton.preimages(f)[0] == w.left_face() ? letter[f] : -letter[f]);
    }
    dual.presentation.relators.push_back(std::move(word));
    dual.relator_edge.push_back(e);
  }
  return dual;
}

void require_letters(const Presentation& presentation) {
  for (std::size_t r = 0; r < presentation.relators.size(); ++r)
    for (const int letter : presentation.relators[r])
      if (letter == 0 || letter > presentation.generators || letter < -presentation.generators)
        throw PreconditionError("letter " + std::to_string(letter) + " of relator " + std::to_string(r) +
                                " names a generator that does not exist; the number of generators is " +
                                std::to_string(presentation.generators));
}

AbelianGroup abelianized(const Presentation& presentation) {
  require_letters(presentation);
  // Generators are the short side: a generator of a triangulation occurs at most three times.
  SparseMatrix matrix(presentation.generators, static_cast<int>(presentation.relators.size()));
  for (std::size_t r = 0; r < presentation.relators.size(); ++r)
    for (const int letter : presentation.relators[r])
      matrix.add(std::abs(letter) - 1, static_cast<int>(r), letter > 0 ? 1 : -1);
  const SmithForm form = smith_normal_form(matrix);
  return AbelianGroup(presentation.generators - form.rank(), form.factors);
}

} // namespace tetrarch::algebra
