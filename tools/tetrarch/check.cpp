// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "input.hpp"
#include "output.hpp"

#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/workshop/check.hpp"

#include <memory>
#include <optional>

namespace tetrarch::program {
namespace {

struct CheckArguments {
  std::string input;
  std::string output;
  workshop::CheckOptions how;
};

Result check(const CheckArguments& options, const Context& context) {
  std::optional<format::MeshFormat> format;
  if (!options.output.empty()) format = mesh_output_format(options.output);
  workshop::Diagnosis found = workshop::check(read_soup(options.input, context), options.how);
  Result result;
  result.status = status_of(found.verdict());
  result.json = tree_of(found);
  result.text = text_of(found);
  if (format) result.files.push_back({options.output, format::write_soup(found.soup, *format)});
  result.value = std::make_shared<Value>(format::mesh_document_of(std::move(found.soup)));
  return result;
}

} // namespace

Run declare_check(OptionTable& table) {
  const auto options = std::make_shared<CheckArguments>();
  table.add("MESH", options->input, "a mesh of tetrahedra or a surface").required();
  table.add("--listed", options->how.listed, "number of findings of each kind to print in full")
      .in_range(0, 1'000'000)
      .with_default();
  declare_doctor(table, options->how.doctor);
  table.add("-o,--output", options->output, "write the mesh, repaired or not, in the format of the extension")
      .output_file();
  return [options](const Context& context) { return check(*options, context); };
}

} // namespace tetrarch::program
