// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A file that holds several triangulations: a Regina file of many packets, a list of signatures, of census
/// records.

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::format {

/// One triangulation in a file. What is wrong with it is no fault of the others.
struct Element {
  std::string name; ///< the label of a packet, what stands after a signature; empty: none
  Document document;
  std::optional<InputError> error; ///< why there is no document
};

/// All triangulations in a file, in its order, and what else it holds.
struct Collection {
  std::vector<Element> elements;
  Ledger passed_over;
};

/// The document of an element with all that the read passed over. Throws InputError if the element is bad.
Document document_of(Element element, const Ledger& passed_over);

/// The only element. Throws InputError at `source` if there are none or several: it lists the first names,
/// and how to say which.
Document the_only(Collection collection, const std::string& source);

} // namespace tetrarch::format
