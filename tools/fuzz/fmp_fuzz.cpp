// SPDX-License-Identifier: GPL-2.0-or-later
// The census records: what was read survives writing and reading, alone and as a document.
#include "fuzz.hpp"
#include "tetrarch/format/fmp.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetrarch;
  try {
    const std::vector<format::FmpRecord> records = format::read_fmp(fuzz::as_text(data, size), "fuzz");
    const std::string text = format::write_fmp(records);
    fuzz::require(format::read_fmp(text, "written") == records, "read(write(records)) == records", text);
    for (const format::FmpRecord& record : records)
      fuzz::require(format::fmp_record_of(format::document_of(record)) == record,
                    "a record survives as a document", text);
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
  return 0;
}
