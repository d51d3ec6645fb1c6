// SPDX-License-Identifier: GPL-2.0-or-later
#include "census.hpp"
#include "command.hpp"
#include "output.hpp"
#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/catalogue/database.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/format/compressed.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/workshop/structure.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace tetrarch::program {

using catalogue::Manifold;

namespace {

/// "3,2": genera, decreasing. Nothing for no text.
std::optional<std::vector<int>> genera_in(const std::string& text) {
  if (text.empty()) return std::nullopt;
  constexpr int largest = 1000;
  std::vector<int> genera;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    std::string_view item = std::string_view(text).substr(at, comma - at);
    const bool crosscaps = item.ends_with('k'); // as in `census gluings --links`
    if (crosscaps) item.remove_suffix(1);
    const auto number = format::parse_integer(item);
    if (!number || *number < (crosscaps ? 3 : 2) || *number > largest)
      throw InputError("--boundary " + in_quotes(text) +
                       ": expected genera from 2 on, such as 2 or 3,2, or crosscaps from 3 on, such as 3k");
    genera.push_back(static_cast<int>(crosscaps ? -*number : *number));
    at = comma + 1;
  }
  std::sort(genera.begin(), genera.end(), std::greater<>());
  return genera;
}

/// "9..10": both ends included.
std::pair<double, double> range_in(const std::string& text) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (text.empty()) return {-infinite, infinite};
  const std::size_t dots = text.find("..");
  const auto refuse = [&text] {
    return InputError("--volume " + in_quotes(text) + ": expected a range such as 9..10");
  };
  if (dots == std::string::npos || text.size() == 2) throw refuse();
  const auto end = [&](std::size_t from, std::size_t length, double otherwise) {
    const std::string_view number = std::string_view(text).substr(from, length);
    if (number.empty()) return otherwise;
    const auto value = format::parse_double(number);
    if (!value) throw refuse();
    return *value;
  };
  return {end(0, dots, -infinite), end(dots + 2, std::string::npos, infinite)};
}

using Visitor = std::function<void(const Manifold&)>;

/// Where manifolds are looked for: one's own file, the compiled-in tables, the installed file.
class Source {
public:
  explicit Source(const std::string& path) {
    if (path.empty()) return;
    const std::string file = located(path);
    if (catalogue::is_database(file))
      own_file_.emplace(file);
    else
      own_table_ = read_table_file(file);
  }

  void visit(const catalogue::Wanted& wanted, const Visitor& visitor) const {
    if (const catalogue::Database* file = file_for(wanted)) return file->visit(wanted, visitor);
    for (const Manifold& m : own_table_ ? *own_table_ : catalogue::require_table(key_of(wanted)))
      if (wanted.fits(m)) visitor(m);
  }

  long long count(const catalogue::Wanted& wanted) const {
    if (const catalogue::Database* file = file_for(wanted)) return file->count(wanted);
    long long count = 0;
    visit(wanted, [&count](const Manifold&) { ++count; });
    return count;
  }

  std::optional<Manifold> find(const std::string& name) const {
    if (own_file_) return own_file_->by_name(name);
    if (!own_table_) return catalogue::find_by_name(name);
    for (const Manifold& m : *own_table_)
      if (m.name == name) return m;
    return std::nullopt;
  }

private:
  /// The file that holds what is wanted; null: a table does, or nothing.
  const catalogue::Database* file_for(const catalogue::Wanted& wanted) const {
    if (own_file_) return &*own_file_;
    const catalogue::Database* installed = catalogue::installed_database();
    if (own_table_ || installed == nullptr) return nullptr;
    const catalogue::TableKey key = key_of(wanted);
    if (catalogue::stored_count(key) > 0) return nullptr;
    const std::vector<catalogue::TableKey> tables = installed->tables();
    return std::find(tables.begin(), tables.end(), key) != tables.end() ? installed : nullptr;
  }
  /// Of the installed tables: one's own file is searched whole.
  static catalogue::TableKey key_of(const catalogue::Wanted& wanted) {
    return {wanted.tetrahedra.value(), wanted.orientable.value_or(true)};
  }

  std::optional<catalogue::Database> own_file_;
  std::optional<std::vector<Manifold>> own_table_;
};

/// "order 2: Z/2, chiral".
std::string words_of(const catalogue::Symmetry& symmetry) {
  std::string text = "order " + std::to_string(symmetry.order);
  if (!symmetry.group.empty()) text += ": " + symmetry.group;
  if (symmetry.amphichiral) text += *symmetry.amphichiral ? ", amphichiral" : ", chiral";
  return text;
}

/// Of a structure, beside what a table holds.
bool is_wanted(const workshop::FieldNote& field) {
  const std::string_view name = field.name;
  return name == "certified" || name == "volume_interval" || name == "certificate" || name == "cusps";
}

/// What a table leaves out because it takes a few milliseconds: an interval for the volume, the shapes of the
/// cusps, the digest of the certificate.
void add_certified(Result& result, std::vector<std::pair<std::string, std::string>>& rows, const Manifold& m,
                   const Progress& progress) {
  workshop::StructureOptions how;
  how.as_given = true;
  how.certify = true;
  const workshop::Structure found = workshop::structure(from_signature(m.signature), how, progress);
  Json& told = result.json["structure"] = Json::object();
  for (const auto& field : workshop::fields_of<workshop::Structure>())
    if (is_wanted(field) && (field.present == nullptr || field.present(found)))
      told[field.name] = field.value(found);
  for (const auto& row : rows_of(found))
    if (row.first == "volume in" || row.first == "certificate" || row.first.starts_with("cusp "))
      rows.push_back(row);
}

void add_table(OptionTable& table, std::string& path) {
  table
      .add("--table", path,
           "look in this table instead of the installed ones, a file that census enumerate -o, census merge "
           "-o "
           "or census table wrote")
      .value_name("FILE");
}

} // namespace

Json manifold_json(const Manifold& m) {
  Json j{{"name", nullptr}, {"tetrahedra", m.tetrahedra}};
  if (!m.orientable) j["orientable"] = false;
  j.update(Json::parse(json_text(m)));
  return j;
}

std::vector<workshop::FieldNote> fields_of_manifold() {
  namespace type = workshop::type;
  return {
      {"name", "", "in its table; null: none", type::or_null(type::text)},
      {"tetrahedra", "", "number of tetrahedra", type::integer},
      {"orientable", "", "false; absent where it is orientable", type::truth, false},
      {"signature", "", "isomorphism signature of a geometric gluing", type::text},
      {"volume", "curvature -1", "to 30 digits, as a text", type::text},
      {"boundary", "", "genera of the geodesic boundary components, decreasing; -k for k crosscaps",
       type::list(type::integer)},
      {"cusps", "", "number of cusps", type::integer},
      {"klein_cusps", "", "those of them that are Klein bottles; absent: none", type::integer, false},
      {"edges", "", "number of edge classes of the gluing", type::integer},
      {"homology", "", "first homology", type::text},
      {"cells", "", "those of the canonical decomposition, by their names", type::list(type::text)},
      {"canonical_signature", "", "a text that two manifolds share if and only if they are isometric",
       type::text},
      {"symmetries", "", "number of isometries of the manifold to itself", type::integer},
      {"dihedral_angles", "radians",
       "of each tetrahedron, at its edges 01, 02, 03, 12, 13, 23, to 30 digits, as texts; absent from brief "
       "tables",
       type::list(type::list(type::text, 6)), false}};
}

/// A stored volume rounded to twelve decimals.
std::string shortened(const std::string& volume) {
  constexpr int decimals = 12;
  return fixed(format::parse_double(volume).value_or(0), decimals);
}

Option& add_tetrahedra(OptionTable& table, Target number) {
  return table.add("--tetrahedra", number, "number of tetrahedra")
      .in_range(1, enumeration::max_gluing_tetrahedra);
}

void add_nonorientable(OptionTable& table, bool& wanted) {
  table.add("--nonorientable", wanted,
            "the manifolds that are not orientable, which have a table of their own");
}

void add_table_choice(OptionTable& table, TableChoice& choice, bool required) {
  Option& tetrahedra = add_tetrahedra(table, &choice.tetrahedra);
  if (required)
    tetrahedra.required();
  else
    tetrahedra.with_default();
  add_nonorientable(table, choice.nonorientable);
}

std::vector<Manifold> read_table_file(const std::string& path) {
  return catalogue::read_table(format::unpacked(format::read_file(path), path), path);
}

fields::List fields::of_census_list() {
  namespace type = workshop::type;
  return {
      {"tetrahedra", "", "of the table asked; null: of all sizes in a file", type::or_null(type::integer)},
      {"count", "", "number of manifolds", type::integer},
      {"manifolds", "", "the entries, as census show has them; without --count",
       type::list(workshop::Type(workshop::schema_of(fields_of_manifold()))), false}};
}

Run declare_census_list(OptionTable& table) {
  struct Options {
    std::optional<int> tetrahedra;
    bool nonorientable = false;
    std::string table;
    std::string boundary;
    std::string volume;
    std::string homology;
    std::optional<int> cusps;
    bool count = false;
  };
  const auto o = std::make_shared<Options>();
  add_tetrahedra(table, &o->tetrahedra);
  add_nonorientable(table, o->nonorientable);
  add_table(table, o->table);
  table
      .add("--boundary", o->boundary,
           "only with geodesic boundary of just these genera, such as 2 or 3,2; 3k is a sphere with three "
           "crosscaps")
      .value_name("LIST");
  table.add("--volume", o->volume, "only with a volume in this range; either end may be left out")
      .value_name("A..B");
  table.add("--homology", o->homology, "only with this first homology, such as 'Z^2 + Z/3'")
      .value_name("GROUP");
  table.add("--cusps", o->cusps, "only with this number of cusps").in_range(0, 1000);
  table.add("--count", o->count, "print no more than their number");
  return [o](const Context& context) {
    const auto [least, greatest] = range_in(o->volume);
    catalogue::Wanted wanted{
        o->tetrahedra, genera_in(o->boundary), least, greatest, o->homology, o->cusps, {}};
    if (o->table.empty() && !wanted.tetrahedra) wanted.tetrahedra = TableChoice().tetrahedra;
    // A file may hold either kind, or both.
    if (o->table.empty() || o->nonorientable) wanted.orientable = !o->nonorientable;
    const Source source(o->table);
    Result result;
    result.json = {{"tetrahedra", wanted.tetrahedra ? Json(*wanted.tetrahedra) : Json()}, {"count", 0}};
    if (o->count) {
      const long long count = source.count(wanted);
      result.json["count"] = count;
      result.text = std::to_string(count) + "\n";
      return result;
    }
    Json manifolds = Json::array();
    std::vector<std::pair<std::string, std::string>> rows;
    source.visit(wanted, [&](const Manifold& m) {
      context.progress.step("listing");
      manifolds.push_back(manifold_json(m));
      rows.emplace_back(m.name, shortened(m.volume) + "  " + m.boundary_text() + "  " + m.homology + "  " +
                                    m.signature);
    });
    result.json["count"] = rows.size();
    result.json["manifolds"] = std::move(manifolds);
    result.text = block(rows);
    return result;
  };
}

fields::List fields::of_census_show() {
  namespace type = workshop::type;
  List proved = workshop::sometimes(workshop::notes_of<workshop::Structure>());
  std::erase_if(proved, [](const workshop::FieldNote& note) { return !is_wanted(note); });
  return workshop::both_of(
      fields_of_manifold(),
      {{"isometry_group", "", "its name; null: none of those known", type::or_null(type::text)},
       {"amphichiral", "", "whether an isometry reverses orientation; null: there is no orientation",
        type::or_null(type::truth)},
       {"structure", "", "as hyperbolize --certify has it: certified, volume_interval, certificate and cusps",
        workshop::Type(workshop::schema_of(proved))}});
}

Run declare_census_show(OptionTable& table) {
  struct Options {
    std::string name;
    std::string table;
  };
  const auto o = std::make_shared<Options>();
  table.add("NAME", o->name, "a census name, such as fmp3_17").required();
  add_table(table, o->table);
  return [o](const Context& context) {
    const auto found = Source(o->table).find(o->name);
    if (!found) throw InputError("no census manifold is called " + in_quotes(o->name));
    const Manifold& m = *found;
    const catalogue::Symmetry symmetry = symmetry_of(m);
    Result result;
    result.json = manifold_json(m);
    result.json["isometry_group"] = symmetry.group.empty() ? Json() : Json(symmetry.group);
    result.json["amphichiral"] = symmetry.amphichiral ? Json(*symmetry.amphichiral) : Json();
    std::vector<std::pair<std::string, std::string>> rows{{"name", m.name},
                                                          {"tetrahedra", std::to_string(m.tetrahedra)},
                                                          {"signature", m.signature},
                                                          {"volume", m.volume},
                                                          {"boundary", m.boundary_text()},
                                                          {"edge classes", std::to_string(m.edges)},
                                                          {"homology", m.homology},
                                                          {"canonical cells", joined(m.cells, ", ")},
                                                          {"isometry signature", m.canonical_signature},
                                                          {"isometry group", words_of(symmetry)}};
    add_certified(result, rows, m, context.progress);
    for (std::size_t t = 0; t < m.dihedral_angles.size(); ++t)
      for (int e = 0; e < 6; ++e)
        rows.emplace_back(e == 0 ? "angles " + std::to_string(t) : "", m.dihedral_angles[t][e]);
    result.text = block(rows);
    result.value = std::make_shared<Value>(format::document_of(from_signature(m.signature), m.name));
    return result;
  };
}

fields::List fields::of_census_table() {
  namespace type = workshop::type;
  return {{"manifolds", "", "number of manifolds", type::integer},
          {"output", "", "the file written", type::text}};
}

Run declare_census_table(OptionTable& table) {
  struct Options {
    std::vector<std::string> tables;
    std::string output;
  };
  const auto o = std::make_shared<Options>();
  table.add("FILE", o->tables, "tables as census enumerate -o writes them, packed by xz or not").required();
  table.add("-o,--output", o->output, "the SQLite file to write").output_file().required();
  return [o](const Context& context) {
    std::vector<Manifold> all;
    for (std::size_t k = 0; k < o->tables.size(); ++k) {
      context.progress.step("reading tables", static_cast<double>(k) / static_cast<double>(o->tables.size()));
      for (Manifold& m : read_table_file(located(o->tables[k]))) all.push_back(std::move(m));
    }
    Result result;
    result.files.push_back({o->output, catalogue::database_of(all)});
    result.json = {{"manifolds", all.size()}, {"output", o->output}};
    result.text = counted(static_cast<long long>(all.size()), "manifold") + " written to " + o->output + "\n";
    return result;
  };
}

} // namespace tetrarch::program
