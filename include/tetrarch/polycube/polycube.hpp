// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The polycube of a solid, made without help.
///
///      .-''-.    labels    .-''-.    planes    .---.    integers    +-+-+
///     (      )  ------->  ( +z+x )  ------->   |   |    -------->   +-+-+
///      '-..-'              '-..-'              '---'                +-+-+
///
/// Labelings of several smoothnesses are tried and mended, those of fewest faults first. For each the solid
/// is mapped with free planes, the planes are rounded, and the solid is mapped again and unfolded. Source:
/// Yin, section 3.5, first step; Protais et al., "Robust quantization for polycube maps" (2022), for the
/// order of steps.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/polycube/labeling.hpp"
#include "tetrarch/polycube/planes.hpp"
#include "tetrarch/polycube/rounding.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tetrarch::polycube {

/// A labeled solid, ready to be mapped at any scale.
struct Frame {
  LabeledSolid labeled; ///< with room
  Charts charts;
  Planes planes;
  std::vector<double> places; ///< of planes, as least squares put them
  std::vector<Gap> gaps;      ///< in the lengths of the solid
};

/// Nothing if the equations of least squares cannot be solved. Throws Stopped.
[[nodiscard]] std::optional<Frame> frame(const product::Solid& solid, const std::vector<Label>& label,
                                         const Progress& progress = {});

/// Corners whose lines, as planes are placed, go away in ways that no cubes have: around them, tetrahedra
/// must be flipped. Vertices of the boundary, increasing. O(n log n).
template <class Number>
std::vector<int> twisted_corners(const Frame& frame, const std::vector<Number>& places);

/// A solid with its map to a polycube of unit cubes.
struct Polycube {
  LabeledSolid
      labeled; ///< that of the frame, refined where it would not unfold, with the image of each vertex
  std::vector<int> places;  ///< of each plane of the frame
  std::vector<int> twisted; ///< corners of the frame
  std::vector<int> flipped; ///< tetrahedra whose image has no positive volume, decided exactly
};

/// An edge of this length becomes about 1. Nothing where gaps contradict each other or the equations cannot
/// be solved. Throws Stopped.
[[nodiscard]] std::optional<Polycube> polycube(const Frame& frame, double edge,
                                               const Progress& progress = {});

/// The polycube of a solid at one scale or several. It keeps what does not depend on the scale.
class Polycubes {
public:
  /// Labels the solid, which must outlive the object.
  explicit Polycubes(const product::Solid& solid, const Progress& progress = {});

  /// The polycube of the first labeling that flips nothing, or flips least, out of three; nothing where there
  /// is none.
  struct Found {
    const Labeling* labeling = nullptr;
    const Frame* frame = nullptr;
    Polycube polycube;
  };
  [[nodiscard]] std::optional<Found> at(double edge, const Progress& progress = {});
  const std::vector<Labeling>& labelings() const { return labelings_; }

private:
  const product::Solid& solid_;
  std::vector<Labeling> labelings_;
  std::vector<std::optional<Frame>> frames_;
  std::vector<char> is_framed_;
  std::vector<std::size_t> order_; ///< in which labelings are tried
};

} // namespace tetrarch::polycube
