// The only file that knows SQLite.
#include "reports/history/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace plumb {
namespace {

constexpr int patience = 60'000;  // ms

std::string explained(sqlite3* connection, int code) {
  switch (code & 0xff) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:  // a table or a column is not there
      return fmt::format("is damaged ({}); it is left as it is", sqlite3_errmsg(connection));
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
  const std::string place = name == nullptr ? "" : name;
  const std::string why = explained(connection, code);
  if (!why.empty()) throw std::invalid_argument(place + ": " + why);
  throw std::runtime_error(place + ": " + sqlite3_errmsg(connection));
}

}  // namespace

struct Statement::Handle {
  sqlite3* connection = nullptr;
  sqlite3_stmt* statement = nullptr;

  Handle(sqlite3* asked, std::string_view question) : connection(asked) {
    const int code = sqlite3_prepare_v2(asked, question.data(), static_cast<int>(question.size()), &statement, nullptr);
    if (code != SQLITE_OK) fail(asked, code);
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

std::int64_t Statement::whole(int column) const { return sqlite3_column_int64(handle_->statement, column); }

bool Statement::null(int column) const { return sqlite3_column_type(handle_->statement, column) == SQLITE_NULL; }

// What went wrong before was told when it did.
void Statement::start_again() { sqlite3_reset(handle_->statement); }

void Statement::put(int place, std::string_view text) {
  handle_->expect_ok(
      sqlite3_bind_text(handle_->statement, place + 1, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
}

// SQLite takes NaN for null by itself.
void Statement::put(int place, double number) {
  handle_->expect_ok(sqlite3_bind_double(handle_->statement, place + 1, number));
}

void Statement::put(int place, std::int64_t number) {
  handle_->expect_ok(sqlite3_bind_int64(handle_->statement, place + 1, number));
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
  const int flags = SQLITE_OPEN_READWRITE | (missing == Missing::make ? SQLITE_OPEN_CREATE : 0);
  // "./": a name that begins with "file:" or ":" is a file as well.
  const std::string name = path_.is_absolute() ? path_.string() : "./" + path_.string();
  if (sqlite3_open_v2(name.c_str(), &handle_->connection, flags, nullptr) != SQLITE_OK) {
    refuse(fmt::format("cannot be opened: {}", sqlite3_errmsg(handle_->connection)));
  }
  sqlite3_extended_result_codes(handle_->connection, 1);
  sqlite3_busy_timeout(handle_->connection, patience);
}

Database::Database(Database&&) noexcept = default;
Database::~Database() = default;

Statement Database::ask(std::string_view question) const {
  return Statement(std::make_unique<Statement::Handle>(handle_->connection, question));
}

std::int64_t Database::whole(std::string_view question) const {
  Statement asked = ask(question);
  asked.next();
  return asked.whole(0);
}

void Database::carry_out(const std::string& statements) {
  const int code = sqlite3_exec(handle_->connection, statements.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(handle_->connection, code);
}

std::int64_t Database::last_row() const { return sqlite3_last_insert_rowid(handle_->connection); }

void Database::refuse(const std::string& why) const { throw std::invalid_argument(path_.string() + ": " + why); }

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.carry_out("ROLLBACK");
  } catch (const std::exception&) {
    // SQLite has rolled back by itself where an error ended the transaction.
    open_ = false;
  }
}

void Transaction::commit() {
  database_.carry_out("COMMIT");
  open_ = false;
}

}  // namespace plumb
