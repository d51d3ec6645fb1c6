// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/fmp.hpp"

#include "gluing_lines.hpp"

#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace tetrarch::format {
namespace {

constexpr std::int64_t many = std::numeric_limits<int>::max();
constexpr std::size_t fewest_dashes = 3;
constexpr std::string_view dashes = "-------------------";

bool is_dashes(std::string_view line) {
  return line.size() >= fewest_dashes && line.find_first_not_of('-') == std::string_view::npos;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

/// All tokens as finite numbers, or nothing if one is none. More than `limit` of them are nothing as well.
std::optional<std::vector<double>> numbers_in(std::string_view text, std::size_t limit) {
  std::vector<double> out;
  TextCursor in(text, "");
  while (!in.at_end()) {
    const std::optional<double> value = parse_double(in.token(""));
    if (!value || !std::isfinite(*value) || out.size() == limit) return std::nullopt;
    out.push_back(*value);
  }
  return out;
}

/// The genera of "T^(2) T^(1)", or nothing if anything else stands there.
std::optional<std::vector<int>> genera_in(std::string_view text) {
  std::vector<int> out;
  TextCursor in(text, "");
  while (!in.at_end()) {
    std::string_view token = in.token("");
    if (token.size() < 5 || token.substr(0, 3) != "T^(" || token.back() != ')') return std::nullopt;
    token = token.substr(3, token.size() - 4);
    const std::optional<std::int64_t> genus = parse_integer(token);
    if (!genus || *genus < 0 || *genus > many) return std::nullopt;
    out.push_back(static_cast<int>(*genus));
  }
  return out;
}

/// Reads one record.
class RecordReader {
public:
  explicit RecordReader(TextCursor& in) : in_(in) {}

  FmpRecord read() {
    n_ = in_.integer("the number of tetrahedra, at least 1", 1, many);
    GluingLines gluings(in_);
    for (std::int64_t t = 0; t < n_; ++t) gluings.read_one(n_);
    record_.triangulation = gluings.checked();
    if (in_.at_end()) return std::move(record_);
    bool closed = false;
    while (!closed) closed = read_line();
    if (!record_.dihedral_angles.empty() && static_cast<std::int64_t>(record_.dihedral_angles.size()) != n_)
      throw InputError(last_line_, "found the angles of " + std::to_string(record_.dihedral_angles.size()) +
                                       " tetrahedra, expected those of " + std::to_string(n_));
    return std::move(record_);
  }

private:
  /// True at the line of dashes.
  bool read_line() {
    if (in_.at_end()) in_.fail_at(in_.peek(), "a line of dashes, the end of the record");
    last_line_ = in_.here();
    if (in_.peek().substr(0, 2) == "N.") {
      read_angles();
      heading_.clear();
      return false;
    }
    const std::string line = clean_line(in_.rest_of_line());
    if (is_dashes(line)) return true;
    if (line.empty()) return false; // nothing but control characters
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) {
      if (!understood(heading_, line)) record_.other.push_back(line);
      return false;
    }
    const std::string label = lower(std::string_view(line).substr(0, colon));
    const std::string_view value = trimmed(std::string_view(line).substr(colon + 1));
    heading_ = value.empty() ? label : "";
    if (!value.empty() && !understood(label, value)) record_.other.push_back(line);
    return false;
  }

  void read_angles() {
    const auto t = static_cast<std::int64_t>(record_.dihedral_angles.size());
    const std::string whose = "the angles of tetrahedron " + std::to_string(t);
    const std::string_view label = in_.token("");
    std::string_view index = label.substr(2);
    if (index.empty()) index = in_.token(whose);
    const std::string_view digits = index.back() == ':' ? index.substr(0, index.size() - 1) : index;
    if (t >= n_ || parse_integer(digits) != t)
      in_.fail_at(index,
                  t < n_ ? whose + " next" : "the angles of " + std::to_string(n_) + " tetrahedra only");
    PerEdge<double> six{};
    for (double& angle : six) angle = in_.number(whose + ", six numbers");
    record_.dihedral_angles.push_back(six);
    const std::string_view rest = in_.rest_of_line();
    if (!rest.empty()) in_.fail_at(rest, "the end of the line after six angles");
  }

  bool understood(const std::string& label, std::string_view value) {
    // Nothing else looks like T^(g), so this needs no label.
    const std::optional<std::vector<int>> genera = genera_in(value);
    if (genera && !genera->empty()) {
      if (!record_.boundary_genera.empty()) return false;
      record_.boundary_genera = *genera;
      return true;
    }
    const auto begins = [&label](std::string_view with) { return label.substr(0, with.size()) == with; };
    if (begins("vol")) return take_volumes(value);
    if (label.find("fundamental") != std::string::npos || begins("pi1") || begins("pi_1"))
      return take_text(record_.fundamental_group, value);
    if (label.find("homology") != std::string::npos || begins("h1") || begins("h_1"))
      return take_text(record_.homology, value);
    return false;
  }

  /// The first line with a single number is the total, the first other one with n of them the list.
  bool take_volumes(std::string_view value) {
    const std::optional<std::vector<double>> numbers = numbers_in(value, static_cast<std::size_t>(n_));
    if (!numbers || numbers->empty()) return false;
    if (numbers->size() == 1 && !record_.volume) {
      record_.volume = numbers->front();
    } else if (static_cast<std::int64_t>(numbers->size()) == n_ && record_.tetrahedron_volumes.empty()) {
      record_.tetrahedron_volumes = *numbers;
    } else {
      return false;
    }
    return true;
  }

  static bool take_text(std::string& field, std::string_view value) {
    if (!field.empty() || value.empty()) return false;
    field = value;
    return true;
  }

  TextCursor& in_;
  std::int64_t n_ = 0;
  FmpRecord record_;
  Place last_line_;
  std::string heading_; ///< of lines that have no label of their own
};

void append_numbers(std::string& text, const auto& numbers) {
  for (const double x : numbers) text += " " + to_text(x);
}

void append_field(std::string& text, const std::string& label, const std::string& value) {
  const std::string line = clean_line(value);
  if (!line.empty()) text += label + ": " + line + "\n";
}

void append_gluings(std::string& text, const Triangulation& tri) {
  if (tri.size() == 0)
    throw InputError("a census record has at least one tetrahedron, this triangulation none");
  text += std::to_string(tri.size()) + "\n";
  for (int t = 0; t < tri.size(); ++t) {
    for (int f = 0; f < 4; ++f)
      if (tri.is_boundary({t, f}))
        throw InputError("a census record cannot hold boundary faces, such as face " + std::to_string(f) +
                         " of tetrahedron " + std::to_string(t));
    text += gluing_lines_of(tri, t);
  }
}

std::string record_text(const FmpRecord& record) {
  std::string text;
  append_gluings(text, record.triangulation);
  if (!record.dihedral_angles.empty() &&
      record.dihedral_angles.size() != static_cast<std::size_t>(record.triangulation.size()))
    throw PreconditionError("a census record has the angles of all its tetrahedra or of none");
  if (!record.dihedral_angles.empty()) text += "Dihedral angles:\n";
  for (std::size_t t = 0; t < record.dihedral_angles.size(); ++t) {
    text += "N. " + std::to_string(t) + " ";
    append_numbers(text, record.dihedral_angles[t]);
    text += "\n";
  }
  if (record.volume) text += "Volume: " + to_text(*record.volume) + "\n";
  if (!record.tetrahedron_volumes.empty()) {
    text += "Volumes of tetrahedra:";
    append_numbers(text, record.tetrahedron_volumes);
    text += "\n";
  }
  if (!record.boundary_genera.empty()) {
    text += "Boundary:";
    for (const int g : record.boundary_genera) text += " T^(" + std::to_string(g) + ")";
    text += "\n";
  }
  append_field(text, "Fundamental group", record.fundamental_group);
  append_field(text, "Homology", record.homology);
  for (const std::string& line : record.other) text += clean_line(line) + "\n";
  return text + std::string(dashes) + "\n";
}

} // namespace

std::vector<FmpRecord> read_fmp(std::string_view text, const std::string& source) {
  TextCursor in(text, source);
  std::vector<FmpRecord> records;
  do records.push_back(RecordReader(in).read());
  while (!in.at_end());
  return records;
}

std::string write_fmp(const std::vector<FmpRecord>& records) {
  std::string text;
  for (const FmpRecord& record : records) text += record_text(record);
  return text;
}

Document document_of(const FmpRecord& record) {
  Document document = document_of(record.triangulation);
  Metric metric;
  for (const PerEdge<double>& six : record.dihedral_angles) {
    PerEdge<Number>& out = metric.dihedral_angles.emplace_back();
    for (std::size_t e = 0; e < 6; ++e) out[e] = Number(six[e]);
  }
  if (record.volume) metric.volume = Number(*record.volume);
  if (!metric.dihedral_angles.empty() || metric.volume) document.metric = std::move(metric);
  Json rest = Json::object();
  if (!record.tetrahedron_volumes.empty()) rest["tetrahedron_volumes"] = record.tetrahedron_volumes;
  if (!record.boundary_genera.empty()) rest["boundary_genera"] = record.boundary_genera;
  if (!record.fundamental_group.empty()) rest["fundamental_group"] = record.fundamental_group;
  if (!record.homology.empty()) rest["homology"] = record.homology;
  if (!record.other.empty()) rest["other"] = record.other;
  if (!rest.empty()) document.members = Json{{"fmp", std::move(rest)}};
  return document;
}

FmpRecord fmp_record_of(const Document& document) {
  FmpRecord record;
  record.triangulation = document.triangulation;
  if (document.metric) {
    for (const PerEdge<Number>& six : document.metric->dihedral_angles) {
      PerEdge<double>& out = record.dihedral_angles.emplace_back();
      for (std::size_t e = 0; e < 6; ++e) out[e] = six[e].value();
    }
    if (document.metric->volume) record.volume = document.metric->volume->value();
  }
  // The member is one of ours only if it looks like one: anybody may have written it.
  const Json& members = document.members;
  const Json rest = members.is_object() ? members.value("fmp", Json()) : Json();
  const auto take = [&rest](const char* key, auto& field) {
    if (!rest.is_object() || !rest.contains(key)) return;
    try {
      rest.at(key).get_to(field);
    } catch (const Json::exception&) {
      field = {};
    }
  };
  take("tetrahedron_volumes", record.tetrahedron_volumes);
  take("boundary_genera", record.boundary_genera);
  take("fundamental_group", record.fundamental_group);
  take("homology", record.homology);
  take("other", record.other);
  return record;
}

} // namespace tetrarch::format
