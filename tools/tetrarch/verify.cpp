// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/checker/check.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/workshop/verify.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

Result verify(const std::string& path, const Progress& progress) {
  const checker::Report report = checker::check(format::read_file(located(path)), format::source_name(path),
                                                [&progress] { progress.step("checking"); });
  Result result;
  result.status = report.accepted ? Status::done : Status::proved_no;
  result.json = workshop::tree_of(report);
  result.text = block(workshop::rows_of(report));
  return result;
}

} // namespace

Run declare_verify(OptionTable& table) {
  const auto path = std::make_shared<std::string>();
  table.add("FILE", *path, "a certificate, as hyperbolize writes it to a name that ends in .cert.json")
      .required();
  return [path](const Context& context) { return verify(*path, context.progress); };
}

} // namespace tetrarch::program
