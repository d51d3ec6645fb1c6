// SPDX-License-Identifier: GPL-2.0-or-later
// JSON meshes and groups: whatever their readers accept comes out canonical, and canonical text is a fixed
// point.
#include "fuzz.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/mesh_json.hpp"

namespace {

using namespace tetrarch;

template <class Read, class Write>
void require_fixed_point(std::string_view text, Read read, Write write) {
  try {
    const std::string written = write(read(text, "fuzz"));
    const std::string again = write(read(written, "written"));
    fuzz::require(again == written, "write(read(text)) == text", written, again);
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::as_text(data, size);
  require_fixed_point(text, format::read_mesh_json, format::write_mesh_json);
  require_fixed_point(text, format::read_group_json, format::write_group_json);
  return 0;
}
