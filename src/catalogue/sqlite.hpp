// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// SQLite's C interface, as far as it is used here, with errors as InputError.

#include "tetrarch/core/error.hpp"

#include <cstdint>
#include <memory>
#include <new>
#include <sqlite3.h>
#include <string>
#include <string_view>

namespace tetrarch::catalogue::detail {

struct CloseConnection {
  void operator()(sqlite3* db) const { ::sqlite3_close(db); }
};
struct Finalize {
  void operator()(sqlite3_stmt* statement) const { ::sqlite3_finalize(statement); }
};

/// An open file.
class Connection {
public:
  Connection(std::string path, int flags) : path_(std::move(path)) { open(path_.c_str(), flags); }
  /// Tables in memory.
  Connection() { open(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE); }
  sqlite3* get() const { return db_.get(); }
  void run(const char* sql) const {
    if (::sqlite3_exec(db_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
  }
  /// What a file of these tables holds.
  std::string bytes() const {
    struct Free {
      void operator()(unsigned char* memory) const { ::sqlite3_free(memory); }
    };
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, Free> all(::sqlite3_serialize(db_.get(), "main", &size, 0));
    if (!all) throw std::bad_alloc();
    return {all.get(), all.get() + size};
  }
  [[noreturn]] void fail() const {
    throw InputError({path_, 0}, std::string("SQLite: ") + (db_ ? ::sqlite3_errmsg(db_.get()) : "no memory"));
  }

private:
  void open(const char* path, int flags) {
    sqlite3* db = nullptr;
    const int code = ::sqlite3_open_v2(path, &db, flags, nullptr);
    db_.reset(db);
    if (code != SQLITE_OK) fail();
  }

  std::string path_;
  std::unique_ptr<sqlite3, CloseConnection> db_;
};

/// One statement, its parameters from 1, its columns from 0. It must not outlive the connection.
class Statement {
public:
  Statement(const Connection& connection, const std::string& sql) : connection_(connection) {
    sqlite3_stmt* statement = nullptr;
    if (::sqlite3_prepare_v2(connection.get(), sql.c_str(), -1, &statement, nullptr) != SQLITE_OK)
      connection.fail();
    statement_.reset(statement);
  }
  /// The text must live until the statement is reset or gone.
  void bind(int at, std::string_view text) {
    check(::sqlite3_bind_text64(statement_.get(), at, text.data(), text.size(), nullptr, SQLITE_UTF8));
  }
  void bind(int at, int number) { check(::sqlite3_bind_int(statement_.get(), at, number)); }
  void bind(int at, double number) { check(::sqlite3_bind_double(statement_.get(), at, number)); }
  /// Whether there is a further row.
  bool step() {
    const int code = ::sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) connection_.fail();
    return code == SQLITE_ROW;
  }
  /// Ready for other parameters.
  void reset() {
    ::sqlite3_reset(statement_.get());
    ::sqlite3_clear_bindings(statement_.get());
  }
  std::string text(int column) const {
    const unsigned char* bytes = ::sqlite3_column_text(statement_.get(), column);
    const int size = ::sqlite3_column_bytes(statement_.get(), column);
    return bytes == nullptr ? std::string() : std::string(bytes, bytes + size);
  }
  std::int64_t number(int column) const { return ::sqlite3_column_int64(statement_.get(), column); }

private:
  void check(int code) const {
    if (code != SQLITE_OK) connection_.fail();
  }

  const Connection& connection_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

} // namespace tetrarch::catalogue::detail
