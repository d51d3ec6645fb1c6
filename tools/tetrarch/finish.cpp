// SPDX-License-Identifier: GPL-2.0-or-later
#include "finish.hpp"

#include "tetrarch/core/error.hpp"

#include <system_error>

namespace tetrarch::program {
namespace {

Json ledger_json(const format::Ledger& ledger) {
  Json list = Json::array();
  for (const format::Ledger::Entry& e : ledger.entries())
    list.push_back({{"what", e.what}, {"count", e.count}});
  return list;
}

/// No command is done whose result holds a number that is none.
void require_numbers(Result& result) {
  const std::string where = result.json.where_not_a_number();
  if (where.empty() || result.status != Status::done) return;
  result.status = Status::undecided;
  result.warnings.push_back("rounding errors were too great: " + where + " is no number");
}

void tell_reads(Result& result, const Reads& reads) {
  if (!reads.any) return;
  if (!reads.passed_over.empty())
    result.warnings.insert(result.warnings.begin(), reads.passed_over.sentence());
  if (result.json.is_object()) result.json["passed_over"] = ledger_json(reads.passed_over);
}

} // namespace

void finish(Result& result, const Reads& reads) {
  require_numbers(result);
  tell_reads(result, reads);
}

void require_different(const std::vector<Result::File>& files, std::set<std::filesystem::path>& paths) {
  for (const Result::File& file : files) {
    std::error_code ignored; // of a path that leads nowhere nothing is known but its name
    std::filesystem::path path = std::filesystem::absolute(file.path, ignored);
    if (!ignored) path = std::filesystem::weakly_canonical(path, ignored);
    if (!paths.insert(ignored ? std::filesystem::path(file.path) : path).second)
      throw InputError({file.path, 0}, "two results have this file name; nothing was written");
  }
}

} // namespace tetrarch::program
