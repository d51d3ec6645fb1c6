// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The number arrays of VTK's XML files, however they are stored.
///
/// Stored as text, or as bytes: a header of integers, then the data. Not compressed, the header is the length
/// of the data; compressed, it is the number of blocks, their length, the length of the last one (0: as the
/// others), and the packed length of each. Bytes stand in the element as base64, or in the appended section,
/// as they are or as base64.

#include "unpack.hpp"

#include "tetrarch/core/error.hpp"

#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// What the file says about all its arrays.
struct VtuStorage {
  std::string source;
  std::string_view appended; ///< the appended section after its "_"
  bool appended_base64 = false;
  bool swapped = false; ///< the bytes of numbers are not in this machine's order
  bool wide_header = false;
  Packing packing = Packing::none;
};

/// The numbers of a DataArray. Throw InputError if it is not there, is damaged, or holds what no double or
/// int can hold.
std::vector<double> read_reals(const VtuStorage& storage, const pugi::xml_node& array);
std::vector<int> read_integers(const VtuStorage& storage, const pugi::xml_node& array);

} // namespace tetrarch::format
