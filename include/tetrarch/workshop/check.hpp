// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is wrong with a mesh, and if nothing is, what it is: type, boundary, size, quality.
///
///     const Diagnosis found = check(open_mesh("part.off"));
///     if (found.verdict() == Verdict::yes) use(found.soup);

#include "tetrarch/core/surface.hpp"
#include "tetrarch/doctor/quality.hpp"
#include "tetrarch/doctor/validate.hpp"
#include "tetrarch/format/soup.hpp"
#include "tetrarch/workshop/doctor.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

struct CheckOptions {
  int listed = 10; ///< findings of each kind that are kept in full
  Doctor doctor;   ///< mends the mesh first
};

/// The faults of a mesh of tetrahedra or of a surface, and its measures. It owns all that it speaks of.
struct Diagnosis {
  format::Soup soup;                ///< mended as far as that was asked for
  std::vector<std::string> repairs; ///< a sentence for each thing that was mended
  bool is_surface = false;
  doctor::Report report;

  /// Of a surface without fatal findings; what can be mended is taken as mended.
  struct Sheet {
    std::vector<SurfaceType> types; ///< of its components
    struct Loop {
      double length = 0; ///< in the mesh's own unit
      double area = 0;   ///< of its largest shadow, in the square of that unit
      /// In the order of a walk, counted from 0, so that v17 asks for the same loop elsewhere.
      std::vector<long long> vertices;
    };
    std::vector<Loop> loops; ///< of the boundary, by decreasing length
  };
  std::optional<Sheet> sheet;

  /// Of a solid without fatal findings whose boundary has none, either.
  struct Hull {
    std::vector<SurfaceType> types; ///< of the surfaces that bound it
    int components = 0;             ///< of the solid
  };
  std::optional<Hull> hull;

  /// Where there are elements, all indices are in range and all points finite.
  struct Measures {
    doctor::Extent extent;   ///< in the mesh's own unit
    doctor::Quality quality; ///< angles in degrees; the ten worst elements
  };
  std::optional<Measures> measures;

  std::size_t elements() const; ///< triangles of a surface, else tetrahedra
  /// Whether it is a surface of which every component is closed and orientable.
  bool encloses() const;
  /// A proved no if there are fatal findings: no manifold.
  Verdict verdict() const;
};

/// Throws InputError if the component asked for is not there; faults of the mesh are findings. O(n log n).
Diagnosis check(format::Soup soup, const CheckOptions& options = {});

/// Some lines for people: repairs, findings, what it is.
std::string text_of(const Diagnosis& found);

template <>
const FieldList<Diagnosis>& fields_of<Diagnosis>();

} // namespace tetrarch::workshop
