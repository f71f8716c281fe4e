#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace plumb {

/// A question to a database, asked as often as one likes. Columns and places of values are counted from 0.
class Statement {
 public:
  Statement(Statement&&) noexcept;
  ~Statement();

  /// Values in the order of their places; of NaN: null.
  template <class... Values>
  Statement& with(const Values&... values) {
    start_again();
    int place = 0;
    (put(place++, values), ...);
    return *this;
  }

  /// Whether there is a further row.
  bool next();

  std::string text(int column) const;
  double number(int column) const;  // of null: NaN
  std::int64_t whole(int column) const;
  bool null(int column) const;

 private:
  friend class Database;
  struct Handle;
  explicit Statement(std::unique_ptr<Handle>);

  void start_again();
  void put(int place, std::string_view);
  void put(int place, double);
  void put(int place, std::int64_t);
  void put(int place, int value) { put(place, static_cast<std::int64_t>(value)); }

  std::unique_ptr<Handle> handle_;
};

/// An SQLite file. Who finds it being written by another waits a minute. Everything throws std::invalid_argument,
/// naming the file, where it is damaged, cannot be opened, read or written, or does not become free in that time.
class Database {
 public:
  enum class Missing { refuse, make };
  Database(std::filesystem::path, Missing);
  Database(Database&&) noexcept;
  ~Database();

  Statement ask(std::string_view question) const;
  /// The first column of the first row.
  std::int64_t whole(std::string_view question) const;
  /// One or several statements without an answer.
  void carry_out(const std::string& statements);
  /// Number of the row that was added last.
  std::int64_t last_row() const;

  const std::filesystem::path& path() const { return path_; }
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  struct Handle;

  std::filesystem::path path_;
  std::unique_ptr<Handle> handle_;
};

/// Everything in its life is written at once or, where it is not committed, not at all. Nobody else writes meanwhile.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) { database_.carry_out("BEGIN IMMEDIATE"); }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace plumb
