// The only file that uses SQLite.
#include "reports/history/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "reports/system/files.h"

namespace plumb {
namespace {

constexpr int busy_timeout = 60'000;  // ms

std::string explanation_of(sqlite3* connection, int code) {
  switch (code & 0xff) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:  // a table or a column is missing
      return fmt::format("is damaged ({}); it was left unchanged", sqlite3_errmsg(connection));
    case SQLITE_BUSY:
      return "another process has been writing it for a minute";
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return "cannot be opened";
    case SQLITE_READONLY:
    case SQLITE_FULL:
    case SQLITE_IOERR:
      return fmt::format("cannot be written: {}", sqlite3_errmsg(connection));
    default:
      return "";
  }
}

[[noreturn]] void fail(sqlite3* connection, int code) {
  const char* name = sqlite3_db_filename(connection, "main");
  const std::string path = name == nullptr ? "" : name;
  const std::string why = explanation_of(connection, code);
  if (!why.empty()) throw std::invalid_argument(path + ": " + why);
  throw FileError(path + ": " + sqlite3_errmsg(connection));
}

}  // namespace

struct Statement::Handle {
  sqlite3* connection = nullptr;
  sqlite3_stmt* statement = nullptr;

  Handle(sqlite3* of, std::string_view sql) : connection(of) {
    const int code = sqlite3_prepare_v2(of, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    if (code != SQLITE_OK) fail(of, code);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { sqlite3_finalize(statement); }

  void expect_ok(int code) const {
    if (code != SQLITE_OK) fail(connection, code);
  }
};

Statement::Statement(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}
Statement::Statement(Statement&&) noexcept = default;
Statement::~Statement() = default;

bool Statement::next() {
  const int code = sqlite3_step(handle_->statement);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) fail(handle_->connection, code);
  return false;
}

std::string Statement::text(int column) const {
  const unsigned char* begin = sqlite3_column_text(handle_->statement, column);
  const int bytes = sqlite3_column_bytes(handle_->statement, column);
  return begin == nullptr ? "" : std::string(reinterpret_cast<const char*>(begin), static_cast<std::size_t>(bytes));
}

double Statement::number(int column) const {
  return null(column) ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(handle_->statement, column);
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_->statement, column); }

bool Statement::null(int column) const { return sqlite3_column_type(handle_->statement, column) == SQLITE_NULL; }

// Ignores the result, which is the error of the previous run.
void Statement::reset() { sqlite3_reset(handle_->statement); }

void Statement::bind(int index, std::string_view text) {
  handle_->expect_ok(
      sqlite3_bind_text(handle_->statement, index + 1, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
}

// SQLite itself stores NaN as null.
void Statement::bind(int index, double number) {
  handle_->expect_ok(sqlite3_bind_double(handle_->statement, index + 1, number));
}

void Statement::bind(int index, std::int64_t number) {
  handle_->expect_ok(sqlite3_bind_int64(handle_->statement, index + 1, number));
}

struct Database::Handle {
  sqlite3* connection = nullptr;

  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { sqlite3_close(connection); }
};

Database::Database(std::filesystem::path path, Missing missing)
    : path_(std::move(path)), handle_(std::make_unique<Handle>()) {
  const int flags = SQLITE_OPEN_READWRITE | (missing == Missing::create ? SQLITE_OPEN_CREATE : 0);
  // "./" makes names that begin with "file:" or ":" ordinary file names.
  const std::string name = path_.is_absolute() ? path_.string() : "./" + path_.string();
  if (sqlite3_open_v2(name.c_str(), &handle_->connection, flags, nullptr) != SQLITE_OK) {
    refuse(fmt::format("cannot be opened: {}", sqlite3_errmsg(handle_->connection)));
  }
  sqlite3_extended_result_codes(handle_->connection, 1);
  sqlite3_busy_timeout(handle_->connection, busy_timeout);
}

Database::Database(Database&&) noexcept = default;
Database::~Database() = default;

Statement Database::prepare(std::string_view sql) const {
  return Statement(std::make_unique<Statement::Handle>(handle_->connection, sql));
}

std::int64_t Database::integer(std::string_view sql) const {
  Statement query = prepare(sql);
  query.next();
  return query.integer(0);
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle_->connection, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(handle_->connection, code);
}

std::int64_t Database::last_row() const { return sqlite3_last_insert_rowid(handle_->connection); }

void Database::refuse(const std::string& why) const { throw std::invalid_argument(path_.string() + ": " + why); }

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const std::exception&) {
    // SQLite has already rolled back if an error ended the transaction.
    open_ = false;
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace plumb
