#include "reports/history/schema.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t application = 0x504c4d42;  // "PLMB"

// From each version to the next; a new file takes all of them. What was released is never edited, but added to.
constexpr std::array<const char*, 2> steps{
    // 1: a row for each number.
    R"(CREATE TABLE snapshots (
         number INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, commit_hash TEXT NOT NULL, at TEXT NOT NULL,
         command TEXT NOT NULL, environment TEXT NOT NULL);
       CREATE TABLE answers (
         number INTEGER PRIMARY KEY, snapshot INTEGER NOT NULL REFERENCES snapshots,
         scenario TEXT NOT NULL, variant TEXT NOT NULL, contender TEXT NOT NULL, dt REAL NOT NULL,
         verdict TEXT NOT NULL, step_us REAL, step_us_low REAL, step_us_high REAL, repetitions INTEGER);
       CREATE TABLE results (
         answer INTEGER NOT NULL REFERENCES answers, metric TEXT NOT NULL, unit TEXT NOT NULL, value REAL,
         PRIMARY KEY (answer, metric)) WITHOUT ROWID;)",
    // 2: names are written once, and the values of a series stand together, which is how trends are read.
    R"(CREATE TABLE subjects (
         number INTEGER PRIMARY KEY,
         scenario TEXT NOT NULL, variant TEXT NOT NULL, contender TEXT NOT NULL, dt REAL NOT NULL,
         UNIQUE (scenario, variant, contender, dt));
       CREATE TABLE series (
         number INTEGER PRIMARY KEY, subject INTEGER NOT NULL REFERENCES subjects,
         metric TEXT NOT NULL, unit TEXT NOT NULL,
         UNIQUE (subject, metric, unit));
       CREATE TABLE points (
         series INTEGER NOT NULL REFERENCES series, snapshot INTEGER NOT NULL REFERENCES snapshots, value REAL,
         PRIMARY KEY (series, snapshot)) WITHOUT ROWID;
       CREATE INDEX points_of_snapshot ON points (snapshot);
       CREATE TABLE verdicts (
         subject INTEGER NOT NULL REFERENCES subjects, snapshot INTEGER NOT NULL REFERENCES snapshots,
         verdict TEXT NOT NULL, step_us REAL, step_us_low REAL, step_us_high REAL, repetitions INTEGER,
         PRIMARY KEY (subject, snapshot)) WITHOUT ROWID;
       CREATE INDEX verdicts_of_snapshot ON verdicts (snapshot);
       INSERT INTO subjects (scenario, variant, contender, dt)
         SELECT DISTINCT scenario, variant, contender, dt FROM answers ORDER BY 1, 2, 3, 4;
       INSERT INTO series (subject, metric, unit)
         SELECT DISTINCT subjects.number, metric, unit
         FROM results JOIN answers ON answer = answers.number JOIN subjects USING (scenario, variant, contender, dt)
         ORDER BY 1, 2, 3;
       INSERT INTO points
         SELECT series.number, snapshot, value
         FROM results JOIN answers ON answer = answers.number JOIN subjects USING (scenario, variant, contender, dt)
         JOIN series ON series.subject = subjects.number AND series.metric = results.metric AND series.unit = results.unit;
       INSERT INTO verdicts
         SELECT subjects.number, snapshot, verdict, step_us, step_us_low, step_us_high, repetitions
         FROM answers JOIN subjects USING (scenario, variant, contender, dt);
       DROP TABLE results;
       DROP TABLE answers;)"};

constexpr auto newest = static_cast<std::int64_t>(steps.size());

// Of the file format's header (sqlite.org/fileformat.html, 1.3), big-endian.
constexpr std::size_t header = 100, journal_at = 18, version_at = 60, application_at = 68;
constexpr std::string_view magic("SQLite format 3\0", 16);

std::uint32_t word_at(const std::string& bytes, std::size_t place) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes[place + i]);
  return word;
}

// Why a file is no history of ours, seen from its first bytes, so that SQLite never opens what is not; "" where it may
// be one. An empty file may become one, and is one that a killed process had only begun.
std::string foreign(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return "cannot be read";
  std::string bytes(header, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(header));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.empty()) return "";
  if (bytes.size() < header || bytes.substr(0, magic.size()) != magic)
    return "is no history of Plumb; it is left as it is";
  if (word_at(bytes, application_at) != application) return "is a database of another program; it is left as it is";
  const std::uint32_t version = word_at(bytes, version_at);
  if (version > newest) {
    return fmt::format("is of version {}, this Plumb knows {} and older: a newer one wrote it", version, newest);
  }
  if (bytes[journal_at] != 1 || bytes[journal_at + 1] != 1 || version == 0) return "is damaged; it is left as it is";
  return "";
}

std::int64_t version_of(const Database& database) { return database.whole("PRAGMA user_version"); }

// Reads every page; writes none, but takes back what a process that was killed had not finished.
void check_pages(const Database& database) {
  Statement check = database.ask("PRAGMA quick_check(1)");
  check.next();
  if (const std::string found = check.text(0); found != "ok") {
    database.refuse(fmt::format("is damaged ({}); it is left as it is", found));
  }
}

void bring_up_to_date(Database& database) {
  Transaction all(database);
  // Another process may have been quicker.
  for (auto version = version_of(database); version < newest; ++version) {
    database.carry_out(steps[static_cast<std::size_t>(version)]);
    database.carry_out(fmt::format("PRAGMA user_version = {}; PRAGMA application_id = {}", version + 1, application));
  }
  all.commit();
}

}  // namespace

Database open_history(const fs::path& path, Database::Missing missing) {
  const bool there = fs::exists(path);
  if (!there && missing == Database::Missing::refuse) {
    throw std::invalid_argument(path.string() + ": there is no such file; plumb history add begins one");
  }
  if (fs::is_directory(path)) throw std::invalid_argument(path.string() + ": is a folder");
  if (const std::string why = there ? foreign(path) : ""; !why.empty()) {
    throw std::invalid_argument(path.string() + ": " + why);
  }
  Database database(path, missing);
  check_pages(database);
  const auto version = version_of(database);
  if (version == 0 && missing == Database::Missing::refuse) database.refuse("nothing has been recorded in it yet");
  if (version < newest) bring_up_to_date(database);
  return database;
}

}  // namespace plumb
