// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// All faces of a list of tetrahedra, gathered by their vertices.
///
/// The codes 4t+f are sorted into buckets by the smallest of the three vertices, in two linear passes; a
/// bucket holds some twenty faces, and only within it are the other two vertices compared. A hash table of
/// faces was the alternative: it takes four times the memory, and its order is nobody's.

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/tet.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetrarch::solid {

/// A t-face among those with the same smallest vertex. Its two other vertices are one number, as comparing
/// numbers is all that the sweep does.
struct SortedFace {
  std::uint64_t others = 0; ///< the larger two vertices, the middle one in the upper half
  int apex = 0;             ///< the fourth vertex of the tetrahedron
  std::uint32_t code = 0;   ///< 4t+f
  TetFace at() const { return {static_cast<int>(code / 4), static_cast<int>(code % 4)}; }
};

class FaceSweep {
public:
  /// Face f of tetrahedron t counts where `use(t)` holds; the vertices of such a t are in 0..points-1 and
  /// differ. O(n + points).
  template <class Use>
  FaceSweep(const std::vector<std::array<int, 4>>& tetrahedra, std::size_t points, Use use);

  /// Calls `visit(std::span<const SortedFace>)` for every set of faces on the same three vertices, in the
  /// order of these; within the set, by apex, then by tetrahedron. O(k log k) for each vertex, if it is the
  /// smallest of k faces.
  template <class Visit>
  void for_each_class(Visit visit);

private:
  SortedFace sorted_face(std::uint32_t code) const;
  int smallest(std::size_t t, int f) const {
    const auto& v = tetrahedra_[t];
    const auto& corner = face_vertex[static_cast<std::size_t>(f)];
    return std::min({v[corner[0]], v[corner[1]], v[corner[2]]});
  }

  const std::vector<std::array<int, 4>>& tetrahedra_;
  std::vector<std::uint32_t> start_; ///< of each bucket, and of the end
  std::vector<std::uint32_t> codes_;
  std::vector<SortedFace> bucket_;
};

/// Fewer tetrahedra than these have codes of 32 bits.
inline constexpr std::size_t most_tetrahedra = std::size_t{1} << 30;

template <class Use>
FaceSweep::FaceSweep(const std::vector<std::array<int, 4>>& tetrahedra, std::size_t points, Use use)
    : tetrahedra_(tetrahedra), start_(points + 2, 0) {
  if (tetrahedra.size() >= most_tetrahedra) throw PreconditionError("there are too many tetrahedra");
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    if (use(t))
      for (int f = 0; f < 4; ++f) ++start_[smallest(t, f) + 2];
  for (std::size_t v = 2; v < start_.size(); ++v) start_[v] += start_[v - 1];
  codes_.resize(start_.back());
  // start_[v + 1] runs through bucket v and ends where bucket v + 1 begins.
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    if (use(t))
      for (int f = 0; f < 4; ++f)
        codes_[start_[smallest(t, f) + 1]++] = static_cast<std::uint32_t>(4 * t + f);
}

inline SortedFace FaceSweep::sorted_face(std::uint32_t code) const {
  const auto& v = tetrahedra_[code / 4];
  const int f = static_cast<int>(code % 4);
  const auto& corner = face_vertex[static_cast<std::size_t>(f)];
  int a = v[corner[0]];
  int b = v[corner[1]];
  int c = v[corner[2]];
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {static_cast<std::uint64_t>(b) << 32 | static_cast<std::uint64_t>(c), v[f], code};
}

template <class Visit>
void FaceSweep::for_each_class(Visit visit) {
  for (std::size_t v = 0; v + 2 < start_.size(); ++v) {
    bucket_.clear();
    for (std::uint32_t k = start_[v]; k < start_[v + 1]; ++k) bucket_.push_back(sorted_face(codes_[k]));
    std::sort(bucket_.begin(), bucket_.end(), [](const SortedFace& p, const SortedFace& q) {
      if (p.others != q.others) return p.others < q.others;
      return p.apex != q.apex ? p.apex < q.apex : p.code < q.code;
    });
    for (std::size_t first = 0, last = 0; first < bucket_.size(); first = last) {
      while (last < bucket_.size() && bucket_[last].others == bucket_[first].others) ++last;
      visit(std::span<const SortedFace>(bucket_).subspan(first, last - first));
    }
  }
}

} // namespace tetrarch::solid
