// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/cover.hpp"

#include "isometry_table.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::embed {
namespace {

/// Whether a walk within the radius may leave copy g through a letter; `from` is g^-1 of the base point.
using MayCross = std::function<bool(const Vector4<double>& from, int letter)>;

void require_bounds(const PieceBounds& bounds) {
  if (bounds.copies < 0 || bounds.word_length < 0 || !(bounds.radius >= 0))
    throw PreconditionError("universal_cover: a bound is negative");
  if (bounds.copies == 0 && bounds.word_length == 0 && bounds.radius == 0)
    throw PreconditionError(
        "universal_cover: the number of copies, the word length or the radius must be bounded");
}

void append(Piece& piece, const Matrix4<double>& copy, int parent, int letter,
            const Vector4<double>& center) {
  piece.copies.push_back(copy);
  piece.parent.push_back(parent);
  piece.letter.push_back(letter);
  piece.length.push_back(parent < 0 ? 0 : piece.length[parent] + 1);
  piece.distance.push_back(distance(center, copy * center));
}

/// Drops what lies outside the radius and leads to nothing inside.
void trim(Piece& piece, double radius) {
  const std::size_t n = piece.copies.size();
  std::vector<int> image(n, -1);
  for (std::size_t c = n; c-- > 0;) {
    if (piece.distance[c] <= radius) image[c] = 0;
    if (image[c] == 0 && piece.parent[c] >= 0) image[piece.parent[c]] = 0;
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < n; ++c) {
    if (image[c] < 0) continue;
    image[c] = static_cast<int>(kept);
    piece.copies[kept] = piece.copies[c];
    piece.parent[kept] = piece.parent[c] < 0 ? -1 : image[piece.parent[c]];
    piece.letter[kept] = piece.letter[c];
    piece.length[kept] = piece.length[c];
    piece.distance[kept] = piece.distance[c];
    ++kept;
  }
  piece.copies.resize(kept);
  piece.parent.resize(kept);
  piece.letter.resize(kept);
  piece.length.resize(kept);
  piece.distance.resize(kept);
}

/// The isometries within the bounds; with a radius also those that lead to them.
Piece walk_cover(std::span<const Matrix4<double>> letters, const PieceBounds& bounds,
                 const MayCross& may_cross, const Progress& progress) {
  const Vector4<double>& center = base_point<double>;
  Piece piece;
  if (bounds.copies > 0)
    piece.copies.reserve(static_cast<std::size_t>(std::min<std::int64_t>(bounds.copies, 1 << 22)));
  IsometryTable table(piece.copies);
  append(piece, identity<double>(), -1, -1, center);
  table.add_last();
  bool full = false;
  for (std::size_t next = 0; next < piece.copies.size() && !full; ++next) {
    if (bounds.word_length > 0 && piece.length[next] == bounds.word_length) break;
    if (next % 1024 == 0)
      progress.step("copies",
                    bounds.copies > 0 ? static_cast<double>(piece.copies.size()) / bounds.copies : -1);
    const Matrix4<double> here = piece.copies[next];
    const Vector4<double> from = inverse(here) * center;
    for (std::size_t letter = 0; letter < letters.size(); ++letter) {
      if (bounds.radius > 0 && !may_cross(from, static_cast<int>(letter))) continue;
      const Matrix4<double> there = here * letters[letter];
      if (table.find(there) >= 0) continue;
      if (bounds.copies > 0 && static_cast<std::int64_t>(piece.copies.size()) >= bounds.copies) {
        piece.complete = bounds.word_length == 0 && bounds.radius == 0;
        full = true;
        break;
      }
      append(piece, there, static_cast<int>(next), static_cast<int>(letter), center);
      table.add_last();
    }
  }
  piece.largest_duplicate = table.largest_duplicate();
  piece.closest = table.closest();
  if (bounds.radius > 0) trim(piece, bounds.radius);
  return piece;
}

/// The planes that bound one hexagon: its own, and those that cut it out of its own.
struct Hexagon {
  Vector4<double> plane;
  std::vector<Vector4<double>> sides;
};

std::vector<std::vector<Hexagon>> hexagons_of(const Domain<double>& domain) {
  std::vector<std::vector<Hexagon>> all_hexagons;
  for (const GluableFace<double>& face : domain.faces) {
    auto& hexagons = all_hexagons.emplace_back();
    for (const TetFace f : face.hexagons) {
      const auto& v = domain.vertices[f.tet];
      Hexagon& hexagon = hexagons.emplace_back();
      hexagon.plane = face_normal(v, f.face);
      for (int i = 0; i < 4; ++i) {
        if (i == f.face) continue;
        hexagon.sides.push_back(face_normal(v, i));
        if (domain.types[f.tet][i] == VertexType::hyperideal) hexagon.sides.push_back(v[i]);
      }
    }
  }
  return all_hexagons;
}

/// A lower bound of the distance of x from the hexagon, as its hyperbolic sine: that from its plane, and
/// those from the half-spaces that it lies in.
double sinh_distance(const Vector4<double>& x, const Hexagon& hexagon) {
  double most = std::abs(inner(x, hexagon.plane));
  for (const Vector4<double>& side : hexagon.sides) most = std::max(most, inner(x, side));
  return most;
}

} // namespace

std::int64_t piece_bytes(std::int64_t copies) {
  return copies * static_cast<std::int64_t>(sizeof(Matrix4<double>) + 3 * sizeof(int) + sizeof(double) +
                                            4 * sizeof(int));
}

Piece universal_cover(const Domain<double>& domain, const PieceBounds& bounds, const Progress& progress) {
  require_bounds(bounds);
  std::vector<Matrix4<double>> letters;
  for (const GluableFace<double>& face : domain.faces) letters.push_back(face.pairing);
  // A geodesic of length at most `radius` between two centres passes only through faces that come so close.
  const auto hexagons = hexagons_of(domain);
  const double reach = std::sinh(bounds.radius) * (1 + 1e-9);
  const MayCross may_cross = [&](const Vector4<double>& from, int letter) {
    return std::any_of(hexagons[letter].begin(), hexagons[letter].end(),
                       [&](const Hexagon& hexagon) { return sinh_distance(from, hexagon) <= reach; });
  };
  return walk_cover(letters, bounds, may_cross, progress);
}

Piece group_piece(std::span<const Matrix4<double>> letters, double size, const PieceBounds& bounds,
                  const Progress& progress) {
  require_bounds(bounds);
  // The straight way to a centre within the radius leads through polygons whose centres are within this:
  const double reach = bounds.radius + size;
  const MayCross may_cross = [&](const Vector4<double>& from, int letter) {
    return distance(from, letters[static_cast<std::size_t>(letter)] * base_point<double>) <= reach;
  };
  return walk_cover(letters, bounds, may_cross, progress);
}

std::vector<int> word_to(const Piece& piece, int c) {
  std::vector<int> word;
  for (; piece.parent[c] >= 0; c = piece.parent[c]) word.push_back(piece.letter[c]);
  std::reverse(word.begin(), word.end());
  return word;
}

} // namespace tetrarch::embed
