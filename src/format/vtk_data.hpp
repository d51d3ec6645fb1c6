// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The numbers and arrays of VTK's legacy files, as text or as big-endian bytes.

#include "mesh_cursor.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

struct VtkScalar {
  std::size_t size = 0; ///< bytes; 0: a bit
  bool real = false;
};

class VtkNumbers {
public:
  explicit VtkNumbers(MeshCursor& in) : in_(in) {}

  bool binary = false;

  /// Throws InputError for a name that is none of a type of numbers.
  VtkScalar type(std::string_view name) const;
  /// Whether the type is one whose numbers `integers` reads.
  bool are_integers(std::string_view name) const;
  /// Goes to the line after the one that names the type, where bytes begin.
  void begin_data();
  double real(VtkScalar type);
  std::int64_t integer(std::string_view type, std::string_view expected, std::int64_t least);
  /// `begin_data`, then so many integers.
  std::vector<int> integers(std::string_view type, std::int64_t count);
  /// The same for labels, which may be negative and of any type of integers.
  std::vector<int> labels(std::string_view type, std::int64_t count);
  /// `begin_data`, then as many values of any type, also strings and bits.
  void pass_over_array(std::string_view type, std::int64_t count);

private:
  std::int64_t integer(VtkScalar type, std::string_view expected, std::int64_t least);
  void pass_over_string();

  MeshCursor& in_;
};

/// The first line of an attribute of points or cells (and, of scalars, the name of a lookup table).
struct VtkAttribute {
  std::string name;
  std::string type = "float";
  std::int64_t components = 1;
  std::int64_t own_size = -1; ///< of a lookup table; -1: as many as points or cells
  bool is_field = false;
};
/// None for a keyword that is not known.
std::optional<VtkAttribute> read_attribute_head(MeshCursor& in, std::string_view keyword, bool binary);

} // namespace tetrarch::format
