#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace plumb {

/// A prepared SQL statement that can be run many times. Columns and parameters are counted from 0.
class Statement {
 public:
  Statement(Statement&&) noexcept;
  ~Statement();

  /// Starts the statement again with these parameters; NaN becomes null.
  template <class... Values>
  Statement& with(const Values&... values) {
    reset();
    int index = 0;
    (bind(index++, values), ...);
    return *this;
  }

  /// Runs the statement up to its next row; false if there is none.
  bool next();

  std::string text(int column) const;
  double number(int column) const;  // NaN for null
  std::int64_t integer(int column) const;
  bool null(int column) const;

 private:
  friend class Database;
  struct Handle;
  explicit Statement(std::unique_ptr<Handle>);

  void reset();
  void bind(int index, std::string_view);
  void bind(int index, double);
  void bind(int index, std::int64_t);
  void bind(int index, int value) { bind(index, static_cast<std::int64_t>(value)); }

  std::unique_ptr<Handle> handle_;
};

/// An SQLite file. Waits up to a minute while another process writes it. Every function throws std::invalid_argument,
/// naming the file, if it is damaged, cannot be opened, read or written, or stays locked.
class Database {
 public:
  enum class Missing { refuse, create };
  Database(std::filesystem::path, Missing);
  Database(Database&&) noexcept;
  ~Database();

  Statement prepare(std::string_view sql) const;
  /// The first column of the first row of a query.
  std::int64_t integer(std::string_view sql) const;
  /// Runs one or more statements that return no rows.
  void execute(const std::string& sql);
  /// The number of the row that was inserted last.
  std::int64_t last_row() const;

  const std::filesystem::path& path() const { return path_; }
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  struct Handle;

  std::filesystem::path path_;
  std::unique_ptr<Handle> handle_;
};

/// What is written while it exists is written as a whole by commit, or not at all. Other processes cannot write
/// meanwhile.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) { database_.execute("BEGIN IMMEDIATE"); }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace plumb
