// SPDX-License-Identifier: GPL-2.0-or-later
#include "info.hpp"

#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

/// The beginning of a signature that would fill the screen.
std::string on_screen(const std::string& signature) {
  constexpr std::size_t most = 400;
  constexpr std::size_t shown = 60;
  if (signature.size() <= most) return signature;
  return signature.substr(0, shown) + "... (" + std::to_string(signature.size()) +
         " characters; 'convert NAME --to sig' prints all)";
}

} // namespace

Info info_of(const Triangulation& tri, const std::string& name, const Context& context, bool brief) {
  const workshop::Info found = workshop::info(tri, name, brief, context.progress);
  return {tree_of(found), rows_of(found, shown_signature(found, context))};
}

std::string shown_signature(const workshop::Info& info, const Context& context) {
  return context.values == nullptr ? info.signature : on_screen(info.signature);
}

Run declare_info(OptionTable& table) {
  const auto input = std::make_shared<std::string>();
  table.add("X", *input, "a triangulation or a mesh").required();
  return [input](const Context& context) {
    const format::Document document = read_triangulation(*input, context);
    Info info = info_of(document.triangulation, document.name, context);
    Result result;
    result.warnings = document.warnings;
    result.json = std::move(info.json);
    result.text = block(info.rows);
    return result;
  };
}

} // namespace tetrarch::program
