// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The content of a triangulation file: the gluings, which are the truth, and statements about them.
///
/// Every reader of this room returns a `Document` and every writer takes one, so that converting is reading
/// and writing. Only the JSON format holds all of it; the others drop what they have no place for.

#include "tetrarch/core/marks.hpp"
#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/format/json_value.hpp"
#include "tetrarch/format/ledger.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// A finite real number as a file spells it: a double, or a decimal text with as many digits as one likes.
/// In JSON the former is a number and the latter a string, so that no reader can lose its digits unawares.
class Number {
public:
  Number() : Number(0.0) {}
  /// Throws PreconditionError if `value` is infinite or no number.
  explicit Number(double value);
  /// Throws PreconditionError unless `digits` is a decimal number: "-1.25", "3", "6.02e23".
  explicit Number(std::string digits);

  double value() const { return value_; }
  /// The digits; of a double, the fewest that read back as the same double.
  const std::string& text() const { return text_; }
  /// Made from a text rather than from a double.
  bool is_text() const { return is_text_; }

  friend bool operator==(const Number& a, const Number& b) {
    return a.is_text_ == b.is_text_ && a.text_ == b.text_;
  }

private:
  double value_ = 0;
  std::string text_;
  bool is_text_ = false;
};

/// Whether `text` is a decimal number as JSON spells them (leading zeros and signs: "-0.5", never "+.5")
/// whose value is in the range of a double. O(length).
bool is_decimal(std::string_view text);

/// One number per edge of a tetrahedron, in the order 01,02,03,12,13,23.
template <class T>
using PerEdge = std::array<T, 6>;

/// What is known of a hyperbolic structure. Either list is empty or has one entry per tetrahedron.
struct Metric {
  /// Lengths; none where the edge runs into a cusp and is infinite.
  std::vector<PerEdge<std::optional<Number>>> edge_lengths;
  /// In radians.
  std::vector<PerEdge<Number>> dihedral_angles;
  std::optional<Number> volume;
  /// The object as it was read, for its unknown members and their order; null if it was not read.
  JsonValue members;
};

/// How tetrahedra make up the cells of a canonical decomposition.
struct CanonicalCells {
  std::vector<std::string> cells; ///< the cells' names, by their numbers
  std::vector<int> cell_of;       ///< of each tetrahedron
  /// Of each tetrahedron and face, whether it is only drawn, inside of a cell; both sides agree.
  std::vector<std::array<bool, 4>> flat_faces;
  std::string isometry_signature; ///< equal exactly for isometric manifolds; empty: not said
  JsonValue members;              ///< as of a Metric
};

/// The projection of a circle bundle's total space to its base surface. Vertices of the triangulation lie
/// over vertices of the base, at a level 0 ... fiber, of which the last is the first again.
struct FiberCoordinates {
  int fiber = 1; ///< edges of a fibre
  std::optional<int> euler_number;
  std::vector<std::array<double, 3>> base_vertices;
  std::vector<std::array<int, 3>> base_triangles;
  std::vector<int> triangle_of;             ///< of each tetrahedron, the base triangle below it
  std::vector<std::array<int, 4>> vertices; ///< of each tetrahedron, the base vertices below its own
  std::vector<std::array<int, 4>> levels;   ///< and the levels of those over the triangle
  JsonValue members;                        ///< as of a Metric
};

struct Document {
  Triangulation triangulation = Triangulation();
  std::string name; ///< UTF-8; empty: none
  Marks marks;      ///< of edges with a cone angle or a parabolic meridian, without fault
  std::optional<Metric> metric;
  std::optional<CanonicalCells> canonical;
  std::optional<FiberCoordinates> bundle;
  JsonValue provenance; ///< an object that says where all this came from; null: none
  /// The object as it was read, for its unknown members and their order; null if it was not read. The members
  /// known above are written from above, whatever stands here.
  JsonValue members;
  /// What the read left out, and what else its reader had to say, as sentences; writers ignore both.
  Ledger passed_over;
  std::vector<std::string> warnings;
};

/// What a writer gives: the text, and what the reader of it will miss or stumble over, as sentences.
struct Written {
  std::string text;
  std::vector<std::string> warnings;
};

/// `text` with every byte sequence that is no UTF-8 replaced by U+FFFD, control characters by spaces, and
/// without white space at either end: a name as a one-line field may hold it. O(length).
std::string clean_line(std::string_view text);

/// A document of these gluings alone.
Document document_of(Triangulation triangulation, std::string name = {});

} // namespace tetrarch::format
