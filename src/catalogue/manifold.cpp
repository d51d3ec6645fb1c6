// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/manifold.hpp"

#include "tables.hpp"
#include "tetrarch/canonical/isometries.hpp"
#include "tetrarch/catalogue/database.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <nlohmann/json.hpp>
#include <unordered_map>

namespace tetrarch::catalogue {
namespace {

/// Tables of more are not looked for.
constexpr int most_tetrahedra = 9;

using numeric::Real50;
using Json = nlohmann::ordered_json;

constexpr std::string_view format_tag = "tetrarch-census";
constexpr std::string_view lines_tag = "tetrarch-census-lines";
constexpr int format_version = 1;
/// What the heading of a table has besides.
constexpr std::string_view not_orientable = ",\n  \"orientable\": false";

/// Volumes are known to 30 digits; different ones of few tetrahedra differ by 1e-6 and more.
const Real50& equal_volumes() {
  static const Real50 margin("1e-25");
  return margin;
}

bool same_volume(const std::string& a, const std::string& b) {
  return abs(Real50(a) - Real50(b)) < equal_volumes();
}

Manifold from_json(const Json& j, TableKey table) {
  Manifold m;
  m.name = j.value("name", "");
  m.tetrahedra = table.tetrahedra;
  m.orientable = table.orientable;
  m.signature = j.at("signature");
  m.volume = j.at("volume");
  m.boundary = j.at("boundary").get<std::vector<int>>();
  m.cusps = j.at("cusps");
  m.klein_cusps = j.value("klein_cusps", 0);
  m.edges = j.at("edges");
  m.homology = j.at("homology");
  m.cells = j.at("cells").get<std::vector<std::string>>();
  m.canonical_signature = j.at("canonical_signature");
  m.symmetries = j.at("symmetries");
  if (j.contains("dihedral_angles"))
    m.dihedral_angles = j.at("dihedral_angles").get<std::vector<std::array<std::string, 6>>>();
  if (from_signature(m.signature).size() != m.tetrahedra ||
      (!m.dihedral_angles.empty() && static_cast<int>(m.dihedral_angles.size()) != m.tetrahedra))
    throw InputError("'" + m.signature + "' does not have " + std::to_string(m.tetrahedra) + " tetrahedra");
  return m;
}

Json parse(std::string_view text, const std::string& source) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    const auto line = 1 + std::count(text.begin(), text.begin() + std::min(e.byte, text.size()), '\n');
    throw InputError({source, static_cast<int>(line)}, "the text is not JSON, or it ends too early");
  }
}

Json to_json(const Manifold& m) {
  Json j;
  if (!m.name.empty()) j["name"] = m.name;
  j["signature"] = m.signature;
  j["volume"] = m.volume;
  j["boundary"] = m.boundary;
  j["cusps"] = m.cusps;
  if (m.klein_cusps > 0) j["klein_cusps"] = m.klein_cusps;
  j["edges"] = m.edges;
  j["homology"] = m.homology;
  j["cells"] = m.cells;
  j["canonical_signature"] = m.canonical_signature;
  j["symmetries"] = m.symmetries;
  if (!m.dihedral_angles.empty()) j["dihedral_angles"] = m.dihedral_angles;
  return j;
}

/// From the members of a table, or of the heading of one.
TableKey key_in(const Json& j) {
  return {j.at("tetrahedra").get<int>(), j.value("orientable", true)};
}

/// A table of lines, whose first one says what it is.
std::vector<Manifold> read_lines(std::string_view text, const std::string& source) {
  std::vector<Manifold> manifolds;
  int number = 0;
  TableKey table;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    ++number;
    try {
      if (number == 1) {
        const Json heading = Json::parse(line);
        if (heading.at("version") != format_version)
          throw InputError("this is no census table of version " + std::to_string(format_version));
        table = key_in(heading);
      } else {
        manifolds.push_back(from_json(Json::parse(line), table));
        manifolds.back().name = name_prefix(table) + std::to_string(number - 1);
      }
    } catch (const Json::exception& e) {
      throw InputError({source, number}, e.what());
    } catch (const InputError& e) {
      throw InputError({source, number}, e.what());
    }
  }
  return manifolds;
}

/// The line of a table round this place, without what parts it from others. It is not parsed.
std::string_view line_at(std::string_view table, std::size_t place) {
  const std::size_t begin = table.rfind('\n', place) + 1;
  std::string_view line = table.substr(begin, table.find('\n', place) - begin);
  while (line.starts_with(' ')) line.remove_prefix(1);
  if (line.ends_with(',')) line.remove_suffix(1);
  return line;
}

/// The line of a stored table that holds this member; empty if there is none.
std::string_view line_with(std::string_view table, const std::string& member) {
  const std::size_t found = table.find(member);
  return found == std::string_view::npos ? std::string_view() : line_at(table, found);
}

/// A line of a compiled-in table.
struct StoredLine {
  TableKey table;
  std::string_view text;
};
using LinesBySignature = std::unordered_map<std::string_view, StoredLine>;

/// By the signature of the canonical triangulation.
LinesBySignature index_stored_lines() {
  constexpr std::string_view member = "\"canonical_signature\":\"";
  LinesBySignature lines;
  for (const TableKey key : stored_tables()) {
    const std::string_view table = stored_table_text(key);
    for (std::size_t at = table.find(member); at != std::string_view::npos; at = table.find(member, at)) {
      at += member.size();
      lines.emplace(table.substr(at, table.find('"', at) - at), StoredLine{key, line_at(table, at)});
    }
  }
  return lines;
}

} // namespace

std::string json_text(const Manifold& m) {
  return to_json(m).dump();
}

Manifold read_manifold(std::string_view text, TableKey table) {
  try {
    return from_json(parse(text, "a manifold"), table);
  } catch (const Json::exception& e) {
    throw InputError(std::string("this is no manifold of the census: ") + e.what());
  }
}

std::string Manifold::boundary_text() const {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : " + ") + part; };
  for (const int genus : boundary)
    add(genus > 0 ? "genus " + std::to_string(genus) : std::to_string(-genus) + " crosscaps");
  const auto add_cusps = [&add](int count, const char* what) {
    if (count > 0) add(std::to_string(count) + what + (count == 1 ? "" : "s"));
  };
  add_cusps(cusps - klein_cusps, " cusp");
  add_cusps(klein_cusps, " Klein bottle cusp");
  return text;
}

Symmetry symmetry_of(const Manifold& m) {
  const Triangulation tri = from_signature(m.canonical_signature);
  const std::vector<Isomorphism> isometries = automorphisms(tri);
  return {static_cast<int>(isometries.size()),
          canonical::name_of_group(canonical::multiplication_table(isometries)),
          canonical::is_amphichiral(tri, isometries)};
}

void sort_by_volume(std::vector<Manifold>& manifolds) {
  std::vector<std::pair<Real50, std::size_t>> order;
  for (std::size_t k = 0; k < manifolds.size(); ++k) order.emplace_back(Real50(manifolds[k].volume), k);
  std::sort(order.begin(), order.end());
  std::vector<int> rank(manifolds.size(), 0); // of the volume among the different ones
  for (std::size_t k = 1; k < order.size(); ++k)
    rank[order[k].second] =
        rank[order[k - 1].second] + (order[k].first - order[k - 1].first < equal_volumes() ? 0 : 1);
  std::sort(order.begin(), order.end(), [&](const auto& x, const auto& y) {
    const Manifold& a = manifolds[x.second];
    const Manifold& b = manifolds[y.second];
    return std::tie(rank[x.second], a.boundary, a.cusps, a.canonical_signature) <
           std::tie(rank[y.second], b.boundary, b.cusps, b.canonical_signature);
  });
  std::vector<Manifold> sorted;
  sorted.reserve(manifolds.size());
  for (const auto& entry : order) sorted.push_back(std::move(manifolds[entry.second]));
  manifolds = std::move(sorted);
}

std::vector<VolumeCount> count_volumes(const std::vector<Manifold>& sorted) {
  std::vector<VolumeCount> counts;
  for (const Manifold& m : sorted) {
    if (counts.empty() || !same_volume(counts.back().volume, m.volume)) counts.push_back({m.volume, 0});
    ++counts.back().manifolds;
  }
  return counts;
}

std::vector<Manifold> without_angles(std::vector<Manifold> manifolds) {
  for (Manifold& m : manifolds) m.dihedral_angles.clear();
  return manifolds;
}

std::string write_table(TableKey table, const std::vector<Manifold>& manifolds) {
  std::string text = "{\n  \"format\": \"" + std::string(format_tag) +
                     "\",\n  \"version\": " + std::to_string(format_version) +
                     ",\n  \"tetrahedra\": " + std::to_string(table.tetrahedra) +
                     (table.orientable ? "" : std::string(not_orientable)) + ",\n  \"manifolds\": [";
  for (std::size_t k = 0; k < manifolds.size(); ++k)
    text += (k > 0 ? ",\n    " : "\n    ") + json_text(manifolds[k]);
  return text + "\n  ]\n}\n";
}

std::string name_prefix(TableKey table) {
  constexpr int largest_published = 4;
  const char* const family = table.tetrahedra <= largest_published ? "fmp" : "tet";
  return (table.orientable ? family : "tetn") + std::to_string(table.tetrahedra) + "_";
}

std::string write_table_lines(TableKey table, const std::vector<Manifold>& manifolds) {
  Json heading{{"format", lines_tag}, {"version", format_version}, {"tetrahedra", table.tetrahedra}};
  if (!table.orientable) heading["orientable"] = false;
  std::string text = heading.dump();
  for (const Manifold& m : manifolds) {
    Json line = to_json(m);
    line.erase("name");
    line.erase("dihedral_angles");
    text += "\n" + line.dump();
  }
  return text + "\n";
}

std::vector<Manifold> read_table(std::string_view text, const std::string& source) {
  if (text.starts_with(Json{{"format", lines_tag}}.dump().substr(0, lines_tag.size() + 12)))
    return read_lines(text, source);
  const Json j = parse(text, source);
  std::vector<Manifold> manifolds;
  try {
    if (j.at("format") != format_tag || j.at("version") != format_version)
      throw InputError("this is no census table of version " + std::to_string(format_version));
    const TableKey table = key_in(j);
    for (const Json& entry : j.at("manifolds")) manifolds.push_back(from_json(entry, table));
  } catch (const Json::exception& e) {
    throw InputError({source, 0}, "manifold " + std::to_string(manifolds.size()) + ": " + e.what());
  } catch (const InputError& e) {
    throw InputError({source, 0}, "manifold " + std::to_string(manifolds.size()) + ": " + e.what());
  }
  return manifolds;
}

std::string_view stored_table_text(TableKey table) {
  const std::string wanted = "\"tetrahedra\": " + std::to_string(table.tetrahedra) + ",";
  for (const std::string_view text : detail::embedded_tables()) {
    const std::string_view heading = text.substr(0, text.find("\"manifolds\""));
    const bool is_orientable = heading.find(not_orientable) == std::string_view::npos;
    if (is_orientable == table.orientable && heading.find(wanted) != std::string_view::npos) return text;
  }
  return {};
}

const std::vector<Manifold>& stored_table(TableKey table) {
  constexpr std::size_t places = 2 * (std::size_t{most_tetrahedra} + 1);
  static std::array<std::once_flag, places> is_read;
  static std::array<std::vector<Manifold>, places> tables; // those of no tetrahedra stay empty
  const int n = table.tetrahedra > most_tetrahedra ? 0 : std::max(table.tetrahedra, 0);
  const std::size_t place = 2 * static_cast<std::size_t>(n) + (table.orientable ? 0 : 1);
  std::call_once(is_read[place], [n, place, orientable = table.orientable] {
    const std::string_view text = stored_table_text({n, orientable});
    if (!text.empty())
      tables[place] = read_table(text, "census table of " + std::to_string(n) + " tetrahedra");
  });
  return tables[place];
}

std::vector<TableKey> stored_tables() {
  std::vector<TableKey> found;
  for (const bool orientable : {true, false})
    for (int n = 1; n <= most_tetrahedra; ++n)
      if (!stored_table_text({n, orientable}).empty()) found.emplace_back(n, orientable);
  return found;
}

const std::vector<Manifold>& require_table(TableKey table) {
  const std::vector<Manifold>& found = stored_table(table);
  if (!found.empty()) return found;
  std::string stored;
  for (const TableKey key : stored_tables())
    if (key.orientable == table.orientable)
      stored += (stored.empty() ? "" : ", ") + std::to_string(key.tetrahedra);
  throw InputError("no census table of " + std::to_string(table.tetrahedra) + " tetrahedra" +
                   (table.orientable ? "" : ", not orientable,") +
                   " is stored (stored: " + (stored.empty() ? "none" : stored) + ")");
}

int stored_count(TableKey table) {
  const std::string_view text = stored_table_text(table);
  int count = 0;
  for (std::size_t at = text.find("\n    {"); at != std::string_view::npos; at = text.find("\n    {", at + 1))
    ++count;
  return count;
}

std::optional<Manifold> find_by_name(std::string_view name) {
  for (const TableKey table : stored_tables()) {
    if (!name.starts_with(name_prefix(table))) continue;
    const std::string_view line =
        line_with(stored_table_text(table), "{\"name\":\"" + std::string(name) + "\"");
    if (!line.empty()) return read_manifold(line, table);
  }
  return installed_database() != nullptr ? installed_database()->by_name(name) : std::nullopt;
}

std::optional<Manifold> find_by_isometry_signature(std::string_view signature) {
  static const LinesBySignature lines = index_stored_lines();
  const auto found = lines.find(signature);
  if (found != lines.end()) return read_manifold(found->second.text, found->second.table);
  return installed_database() != nullptr ? installed_database()->by_isometry_signature(signature)
                                         : std::nullopt;
}

std::vector<std::string> stored_names() {
  std::vector<std::string> names;
  for (const TableKey table : stored_tables())
    for (int k = 1, count = stored_count(table); k <= count; ++k)
      names.push_back(name_prefix(table) + std::to_string(k));
  return names;
}

} // namespace tetrarch::catalogue
