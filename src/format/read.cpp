// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/read.hpp"

#include "inflate.hpp"

#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/fmp.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/format/orb.hpp"
#include "tetrarch/format/regina.hpp"
#include "tetrarch/format/signature_text.hpp"
#include "tetrarch/format/snappea.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>

namespace tetrarch::format {
namespace {

constexpr std::string_view any_triangulation = "a triangulation: Tetrarch JSON, a SnapPea, Regina or Orb "
                                               "file, a census record or an isomorphism signature";

/// Some editors begin UTF-8 files with this mark.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// A count of tetrahedra stands in so many digits; longer ones are something else.
constexpr std::size_t longest_count = 10;

bool is_digits(std::string_view token) {
  return std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < ' ' && !is_space(c);
}

std::string extension_of(std::string_view path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string_view::npos || path[dot] == '/') return {};
  std::string extension(path.substr(dot));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

Collection collection_of(Document document) {
  Collection one;
  std::string name = document.name;
  one.elements.push_back({std::move(name), std::move(document), {}});
  return one;
}

Collection read_records(std::string_view text, const std::string& source) {
  Collection records;
  for (const FmpRecord& record : read_fmp(text, source))
    records.elements.push_back({{}, document_of(record), {}});
  return records;
}

/// Text, no longer compressed and without a byte order mark.
Collection read_plain(std::string_view text, const std::string& source) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  TextCursor in(text, source);
  if (in.at_end())
    throw InputError(Place{source, 0}, "the text is empty, expected " + std::string(any_triangulation));
  const std::optional<FileFormat> format = recognise(text, source);
  if (!format && is_control(in.next_char()))
    throw InputError(in.here(), "found a binary file (a byte of value " +
                                    std::to_string(static_cast<int>(in.next_char())) + "), expected " +
                                    std::string(any_triangulation));
  if (!format) in.fail_at(in.peek(), any_triangulation);
  switch (*format) {
  case FileFormat::json:
    return collection_of(read_json(text, source));
  case FileFormat::snappea:
    return collection_of(read_snappea(text, source));
  case FileFormat::signature:
    return read_signatures(text, source);
  case FileFormat::fmp:
    return read_records(text, source);
  case FileFormat::regina:
    return read_regina_packets(text, source);
  case FileFormat::orb:
    return collection_of(read_orb(text, source));
  }
  throw PreconditionError("no such file format");
}

/// The first word of a text that is no comment; empty if there is none.
std::string_view first_word(TextCursor& in) {
  while (!in.at_end() && in.next_char() == '#') in.rest_of_line();
  return in.at_end() ? in.peek() : in.token("");
}

} // namespace

std::string name_of(FileFormat format) {
  switch (format) {
  case FileFormat::json:
    return "json";
  case FileFormat::snappea:
    return "snappea";
  case FileFormat::signature:
    return "signature";
  case FileFormat::fmp:
    return "fmp";
  case FileFormat::regina:
    return "regina";
  case FileFormat::orb:
    return "orb";
  }
  throw PreconditionError("no such file format");
}

std::optional<FileFormat> format_for_extension(std::string_view path) {
  const std::string extension = extension_of(path);
  if (extension == ".json") return FileFormat::json;
  if (extension == ".tri") return FileFormat::snappea;
  if (extension == ".sig" || extension == ".txt") return FileFormat::signature;
  if (extension == ".fmp") return FileFormat::fmp;
  if (extension == ".rga") return FileFormat::regina;
  if (extension == ".orb") return FileFormat::orb;
  return std::nullopt;
}

std::optional<FileFormat> recognise(std::string_view text, const std::string& source) {
  if (text.starts_with(gzip_mark)) return FileFormat::regina;
  TextCursor in(text, source);
  if (in.at_end() || is_control(in.next_char())) return std::nullopt;
  const std::string_view first = first_word(in);
  if (first.empty()) return format_for_extension(source);
  if (first.front() == '{') return FileFormat::json;
  if (first.front() == '<') return FileFormat::regina;
  if (first.front() == '%') return in.peek() == "orb" ? FileFormat::orb : FileFormat::snappea;
  const std::optional<FileFormat> hint = format_for_extension(source);
  if (first.size() <= longest_count && is_digits(first)) return hint.value_or(FileFormat::fmp);
  if (in.at_end() || hint) return hint.value_or(FileFormat::signature);
  return is_signature_text(first) ? std::optional(FileFormat::signature) : std::nullopt;
}

Collection read_all(std::string_view text, const std::string& source) {
  if (!text.starts_with(gzip_mark)) return read_plain(text, source);
  const Inflated plain = inflate(text, most_inflated(text.size()), {source, 0});
  Collection all = read_plain(plain.data, source);
  all.passed_over.note("byte after the compressed data", static_cast<std::int64_t>(plain.left));
  return all;
}

Document read_any(std::string_view text, const std::string& source) {
  return the_only(read_all(text, source), source);
}

Document read_document(const std::string& path) {
  return read_any(read_file(path), source_name(path));
}

namespace {

Written write_without_warning(const Document& document, FileFormat format) {
  switch (format) {
  case FileFormat::json:
    return {write_json(document), {}};
  case FileFormat::snappea:
    return write_snappea(document);
  case FileFormat::signature:
    return {signature(document.triangulation) + "\n", {}};
  case FileFormat::fmp:
    return {write_fmp({fmp_record_of(document)}), {}};
  case FileFormat::regina:
  case FileFormat::orb:
    throw InputError("the format " + name_of(format) +
                     " is read only, expected json, snappea, signature or fmp");
  }
  throw PreconditionError("no such file format");
}

} // namespace

Written write_any(const Document& document, FileFormat format) {
  Written written = write_without_warning(document, format);
  if (format != FileFormat::json && !document.marks.empty())
    written.warnings.push_back("the orders of " + std::to_string(document.marks.size()) +
                               " edges are left out: only JSON holds them");
  return written;
}

} // namespace tetrarch::format
