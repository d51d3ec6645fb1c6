// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/database.hpp"

#include "sqlite.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>

namespace tetrarch::catalogue {
namespace {

namespace fs = std::filesystem;
using detail::Connection;
using detail::Statement;

/// What SQLite keeps of whose file it is, "TETR", and the version of the tables in it.
constexpr int application = 1413829714;
constexpr int version = 2;

constexpr const char* columns =
    "name, tetrahedra, signature, volume, boundary, cusps, edges, homology, cells, "
    "canonical_signature, symmetries, orientable, klein_cusps";

constexpr const char* schema =
    "CREATE TABLE manifold (id INTEGER PRIMARY KEY, name TEXT, tetrahedra INTEGER NOT NULL, signature TEXT "
    "NOT "
    "NULL, volume TEXT NOT NULL, volume_value REAL NOT NULL, boundary TEXT NOT NULL, cusps INTEGER NOT NULL, "
    "edges INTEGER NOT NULL, homology TEXT NOT NULL, cells TEXT NOT NULL, canonical_signature TEXT NOT NULL, "
    "symmetries INTEGER NOT NULL, orientable INTEGER NOT NULL, klein_cusps INTEGER NOT NULL, symmetry_group "
    "TEXT, amphichiral INTEGER);";
/// After the rows: an index that is built at once is smaller, and built sooner.
constexpr const char* indexes =
    "CREATE UNIQUE INDEX by_name ON manifold (name);"
    "CREATE UNIQUE INDEX by_canonical_signature ON manifold (canonical_signature);"
    "CREATE INDEX by_volume ON manifold (tetrahedra, volume_value);"
    "CREATE INDEX by_boundary ON manifold (tetrahedra, boundary, cusps);"
    "CREATE INDEX by_homology ON manifold (tetrahedra, homology);";

double number_in(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

template <class Item>
std::string list_text(const std::vector<Item>& list) {
  return nlohmann::json(list).dump();
}

/// "Z^2+Z/3" as tables have it: "Z^2 + Z/3".
std::string as_in_tables(const std::string& homology) {
  std::string text;
  for (const char c : homology)
    if (c == '+')
      text += " + ";
    else if (c != ' ')
      text += c;
  return text;
}

Manifold manifold_in(const Statement& row) {
  Manifold m;
  m.name = row.text(0);
  m.tetrahedra = static_cast<int>(row.number(1));
  m.signature = row.text(2);
  m.volume = row.text(3);
  m.boundary = nlohmann::json::parse(row.text(4)).get<std::vector<int>>();
  m.cusps = static_cast<int>(row.number(5));
  m.edges = static_cast<int>(row.number(6));
  m.homology = row.text(7);
  m.cells = nlohmann::json::parse(row.text(8)).get<std::vector<std::string>>();
  m.canonical_signature = row.text(9);
  m.symmetries = static_cast<int>(row.number(10));
  m.orientable = row.number(11) != 0;
  m.klein_cusps = static_cast<int>(row.number(12));
  return m;
}

/// The condition of a query, and its parameters in their order.
class Condition {
public:
  explicit Condition(const Wanted& wanted)
      : boundary_(wanted.boundary ? list_text(*wanted.boundary) : ""),
        homology_(as_in_tables(wanted.homology)), wanted_(wanted) {
    if (wanted.tetrahedra) add("tetrahedra = ?");
    if (std::isfinite(wanted.least_volume)) add("volume_value >= ?");
    if (std::isfinite(wanted.greatest_volume)) add("volume_value <= ?");
    if (wanted.boundary) add("boundary = ?");
    if (!homology_.empty()) add("homology = ?");
    if (wanted.cusps) add("cusps = ?");
    if (wanted.orientable) add("orientable = ?");
  }
  const std::string& text() const { return text_; }
  void bind(Statement& statement) const {
    int at = 0;
    if (wanted_.tetrahedra) statement.bind(++at, *wanted_.tetrahedra);
    if (std::isfinite(wanted_.least_volume)) statement.bind(++at, wanted_.least_volume);
    if (std::isfinite(wanted_.greatest_volume)) statement.bind(++at, wanted_.greatest_volume);
    if (wanted_.boundary) statement.bind(++at, boundary_);
    if (!homology_.empty()) statement.bind(++at, homology_);
    if (wanted_.cusps) statement.bind(++at, *wanted_.cusps);
    if (wanted_.orientable) statement.bind(++at, static_cast<int>(*wanted_.orientable));
  }

private:
  void add(const char* part) { text_ += (text_.empty() ? " WHERE " : " AND ") + std::string(part); }

  std::string text_;
  std::string boundary_;
  std::string homology_;
  const Wanted& wanted_;
};

void insert(Statement& row, const Manifold& m) {
  const std::string boundary = list_text(m.boundary);
  const std::string cells = list_text(m.cells);
  const Symmetry symmetry = symmetry_of(m);
  int at = 0;
  if (!m.name.empty()) row.bind(1, m.name);
  ++at;
  row.bind(++at, m.tetrahedra);
  row.bind(++at, m.signature);
  row.bind(++at, m.volume);
  row.bind(++at, boundary);
  row.bind(++at, m.cusps);
  row.bind(++at, m.edges);
  row.bind(++at, m.homology);
  row.bind(++at, cells);
  row.bind(++at, m.canonical_signature);
  row.bind(++at, m.symmetries);
  row.bind(++at, static_cast<int>(m.orientable));
  row.bind(++at, m.klein_cusps);
  row.bind(++at, number_in(m.volume));
  ++at;
  if (!symmetry.group.empty()) row.bind(at, symmetry.group);
  ++at;
  if (symmetry.amphichiral) row.bind(at, static_cast<int>(*symmetry.amphichiral));
  row.step();
  row.reset();
}

/// Opened to be read by several threads, and seen to be ours.
Connection open_ours(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) throw InputError({path, 0}, "there is no such file");
  Connection connection(path, SQLITE_OPEN_READONLY | SQLITE_OPEN_FULLMUTEX);
  const auto number = [&](const char* pragma) {
    Statement statement(connection, pragma);
    return statement.step() ? statement.number(0) : 0;
  };
  if (number("PRAGMA application_id") != application)
    throw InputError({path, 0}, "this is no file of census tables");
  if (number("PRAGMA user_version") != version)
    throw InputError({path, 0}, "this file of census tables is of another version");
  return connection;
}

/// Where the program lies, or nothing where the system does not say.
fs::path beside_program() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : (program.parent_path() / "../share/tetrarch/census.sqlite").lexically_normal();
}

std::unique_ptr<Database> open_installed() {
  const char* named = std::getenv("TETRARCH_CENSUS"); // NOLINT(concurrency-mt-unsafe): nobody sets any
  if (named != nullptr) return std::make_unique<Database>(named);
  std::error_code ignored;
  const fs::path path = beside_program();
  return fs::is_regular_file(path, ignored) ? std::make_unique<Database>(path.string()) : nullptr;
}

} // namespace

bool Wanted::fits(const Manifold& m) const {
  const double volume = number_in(m.volume);
  return (!tetrahedra || m.tetrahedra == *tetrahedra) && (!boundary || m.boundary == *boundary) &&
         volume >= least_volume && volume <= greatest_volume &&
         (homology.empty() || m.homology == as_in_tables(homology)) && (!cusps || m.cusps == *cusps) &&
         (!orientable || m.orientable == *orientable);
}

struct Database::State {
  explicit State(const std::string& path)
      : connection(open_ours(path)), name(select("name")), signature(select("canonical_signature")) {}

  Statement select(const char* key) const {
    return {connection, std::string("SELECT ") + columns + " FROM manifold WHERE " + key + " = ?"};
  }

  std::optional<Manifold> find(Statement& statement, std::string_view key) const {
    const std::lock_guard lock(mutex);
    statement.reset();
    statement.bind(1, key);
    std::optional<Manifold> found;
    if (statement.step()) found = manifold_in(statement);
    statement.reset();
    return found;
  }

  Connection connection;
  mutable std::mutex mutex; ///< of the two statements
  Statement name;
  Statement signature;
};

Database::Database(const std::string& path) : state_(std::make_unique<State>(path)) {}

Database::~Database() = default;

std::optional<Manifold> Database::by_name(std::string_view name) const {
  return state_->find(state_->name, name);
}

std::optional<Manifold> Database::by_isometry_signature(std::string_view signature) const {
  return state_->find(state_->signature, signature);
}

long long Database::count(const Wanted& wanted) const {
  const Condition condition(wanted);
  Statement query(state_->connection, "SELECT count(*) FROM manifold" + condition.text());
  condition.bind(query);
  return query.step() ? query.number(0) : 0;
}

void Database::visit(const Wanted& wanted, const std::function<void(const Manifold&)>& visitor) const {
  const Condition condition(wanted);
  Statement query(state_->connection,
                  std::string("SELECT ") + columns + " FROM manifold" + condition.text() + " ORDER BY id");
  condition.bind(query);
  while (query.step()) visitor(manifold_in(query));
}

std::vector<TableKey> Database::tables() const {
  std::vector<TableKey> found;
  Statement query(state_->connection, "SELECT DISTINCT tetrahedra, orientable FROM manifold ORDER BY "
                                      "orientable DESC, tetrahedra");
  while (query.step()) found.emplace_back(static_cast<int>(query.number(0)), query.number(1) != 0);
  return found;
}

std::string database_of(const std::vector<Manifold>& manifolds) {
  const Connection connection;
  connection.run("PRAGMA page_size = 4096;");
  const std::string heading = "PRAGMA application_id = " + std::to_string(application) +
                              "; PRAGMA user_version = " + std::to_string(version) + ";";
  connection.run(heading.c_str());
  connection.run("BEGIN");
  connection.run(schema);
  Statement row(connection, std::string("INSERT INTO manifold (") + columns +
                                ", volume_value, symmetry_group, amphichiral) VALUES "
                                "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const Manifold& m : manifolds) insert(row, m);
  connection.run(indexes);
  connection.run("COMMIT; ANALYZE;");
  return connection.bytes();
}

bool is_database(const std::string& path) {
  constexpr std::string_view beginning = "SQLite format 3";
  std::string bytes(beginning.size(), ' ');
  std::ifstream file(path, std::ios::binary);
  return file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) && bytes == beginning;
}

const Database* installed_database() {
  static const std::unique_ptr<Database> database = open_installed();
  return database.get();
}

} // namespace tetrarch::catalogue
