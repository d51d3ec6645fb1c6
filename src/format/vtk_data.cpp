// SPDX-License-Identifier: GPL-2.0-or-later
#include "vtk_data.hpp"

#include <limits>
#include <map>

namespace tetrarch::format {
namespace {

constexpr bool vtk_swapped = swapped_if(std::endian::big);

/// The names that the legacy format gives its number types. Whatever its size in memory, an id has 4 bytes in
/// a file.
const std::map<std::string_view, VtkScalar> scalar_types{
    {"bit", {0, false}},           {"char", {1, false}},          {"signed_char", {1, false}},
    {"unsigned_char", {1, false}}, {"short", {2, false}},         {"unsigned_short", {2, false}},
    {"int", {4, false}},           {"unsigned_int", {4, false}},  {"long", {8, false}},
    {"unsigned_long", {8, false}}, {"long_long", {8, false}},     {"unsigned_long_long", {8, false}},
    {"vtktypeint8", {1, false}},   {"vtktypeuint8", {1, false}},  {"vtktypeint16", {2, false}},
    {"vtktypeuint16", {2, false}}, {"vtktypeint32", {4, false}},  {"vtktypeuint32", {4, false}},
    {"vtktypeint64", {8, false}},  {"vtktypeuint64", {8, false}}, {"vtkIdType", {4, false}},
    {"vtkidtype", {4, false}},     {"float", {4, true}},          {"double", {8, true}},
    {"vtktypefloat32", {4, true}}, {"vtktypefloat64", {8, true}}};

} // namespace

VtkScalar VtkNumbers::type(std::string_view name) const {
  const auto found = scalar_types.find(name);
  if (found == scalar_types.end()) in_.fail(name, "a type of numbers, like double");
  return found->second;
}

bool VtkNumbers::are_integers(std::string_view name) const {
  const auto found = scalar_types.find(name);
  return found != scalar_types.end() && !found->second.real && found->second.size > 0;
}

void VtkNumbers::begin_data() {
  if (binary) in_.rest_of_line();
}

double VtkNumbers::real(VtkScalar type) {
  if (!binary) return in_.number("a coordinate");
  const char* const raw = in_.bytes(type.size, "a coordinate").data();
  if (!type.real) in_.fail("integer coordinates", "float or double");
  return type.size == 4 ? static_cast<double>(load<float>(raw, vtk_swapped)) : load<double>(raw, vtk_swapped);
}

std::int64_t VtkNumbers::integer(std::string_view type_name, std::string_view expected, std::int64_t least) {
  return integer(binary ? type(type_name) : VtkScalar{}, expected, least);
}

std::int64_t VtkNumbers::integer(VtkScalar type, std::string_view expected, std::int64_t least) {
  if (!binary) return in_.integer(expected, least, most_elements);
  const char* const raw = in_.bytes(type.size, expected).data();
  std::int64_t value = least - 1;
  if (!type.real && type.size == 4) value = load<std::int32_t>(raw, vtk_swapped);
  if (!type.real && type.size == 8) value = load<std::int64_t>(raw, vtk_swapped);
  if (value < least || value > most_elements) in_.fail(std::to_string(value), expected);
  return value;
}

std::vector<int> VtkNumbers::integers(std::string_view type_name, std::int64_t count) {
  begin_data();
  const VtkScalar type = binary && count > 0 ? this->type(type_name) : VtkScalar{};
  std::vector<int> out;
  out.reserve(in_.believable(count, 2));
  for (std::int64_t i = 0; i < count; ++i)
    out.push_back(static_cast<int>(integer(type, "an integer", 1 - most_elements)));
  return out;
}

std::vector<int> VtkNumbers::labels(std::string_view type_name, std::int64_t count) {
  begin_data();
  const VtkScalar type = this->type(type_name);
  std::vector<int> out;
  out.reserve(in_.believable(count, 1));
  for (std::int64_t i = 0; i < count; ++i) {
    if (!binary) {
      out.push_back(in_.reference("a label"));
      continue;
    }
    const char* const raw = in_.bytes(type.size, "a label").data();
    std::int64_t value = 0;
    if (type.size == 1)
      value =
          type_name.starts_with("unsigned") ? load<std::uint8_t>(raw, false) : load<std::int8_t>(raw, false);
    if (type.size == 2) value = load<std::int16_t>(raw, vtk_swapped);
    if (type.size == 4) value = load<std::int32_t>(raw, vtk_swapped);
    if (type.size == 8) value = load<std::int64_t>(raw, vtk_swapped);
    const bool fits = value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
    out.push_back(fits ? static_cast<int>(value) : 0);
  }
  return out;
}

/// The two first bits say how many bytes the length takes: 11: 1, 10: 2, 01: 4, 00: 8. The others are the
/// length. Source: VTK's vtkDataWriter.
void VtkNumbers::pass_over_string() {
  const auto first = static_cast<unsigned char>(in_.bytes(1, "a string").front());
  const int more = first >> 6 == 3 ? 0 : first >> 6 == 2 ? 1 : first >> 6 == 1 ? 3 : 7;
  std::uint64_t length = first & 0x3fU;
  for (int k = 0; k < more; ++k)
    length = length << 8 | static_cast<unsigned char>(in_.bytes(1, "a string").front());
  in_.bytes(length, "a string");
}

void VtkNumbers::pass_over_array(std::string_view name, std::int64_t count) {
  const bool words = name == "string" || name == "utf8_string" || name == "variant";
  if (words) {
    in_.rest_of_line();
    for (std::int64_t i = 0; i < count && in_.bytes_left() > 0; ++i) {
      if (binary && name != "variant")
        pass_over_string();
      else
        in_.rest_of_line();
    }
    return;
  }
  const VtkScalar scalar = type(name);
  if (!binary) {
    for (std::int64_t i = 0; i < count; ++i) in_.number("a number");
    return;
  }
  begin_data();
  const auto values = static_cast<std::uint64_t>(count);
  in_.bytes(scalar.size > 0 ? values * scalar.size : (values + 7) / 8, "an array");
}

std::optional<VtkAttribute> read_attribute_head(MeshCursor& in, std::string_view keyword, bool binary) {
  VtkAttribute attribute;
  if (keyword == "FIELD") {
    attribute.is_field = true;
    return attribute;
  }
  const auto is_one_of = [keyword](std::initializer_list<std::string_view> list) {
    for (const std::string_view word : list)
      if (word == keyword) return true;
    return false;
  };
  if (!is_one_of({"SCALARS", "COLOR_SCALARS", "LOOKUP_TABLE", "VECTORS", "NORMALS", "TEXTURE_COORDINATES",
                  "TENSORS", "TENSORS6", "GLOBAL_IDS", "PEDIGREE_IDS", "EDGE_FLAGS"}))
    return std::nullopt;
  attribute.name = in.token("a name");
  if (is_one_of({"COLOR_SCALARS", "LOOKUP_TABLE"})) {
    const std::int64_t size = in.integer("how many numbers there are", 0, most_elements / 4);
    attribute.components = keyword == "LOOKUP_TABLE" ? 4 : size;
    if (keyword == "LOOKUP_TABLE") attribute.own_size = size;
    attribute.type = binary ? "unsigned_char" : "float";
    return attribute;
  }
  constexpr std::int64_t most_components = 1000;
  if (keyword == "TEXTURE_COORDINATES")
    attribute.components = in.integer("the number of components", 1, most_components);
  attribute.type = in.token("a type");
  if (keyword == "VECTORS" || keyword == "NORMALS") attribute.components = 3;
  if (keyword == "TENSORS") attribute.components = 9;
  if (keyword == "TENSORS6") attribute.components = 6;
  if (keyword == "SCALARS") {
    if (in.line_goes_on()) attribute.components = in.integer("the number of components", 1, most_components);
    if (in.peek() == "LOOKUP_TABLE") {
      in.token("");
      in.token("the name of a lookup table");
    }
  }
  return attribute;
}

} // namespace tetrarch::format
