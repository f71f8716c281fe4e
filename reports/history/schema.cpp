#include "reports/history/schema.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/run/report_json.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t application_id = 0x504c4d42;  // "PLMB"

// The statements that lead from each version to the next; a new file runs all of them. Released steps are never edited.
constexpr std::array<const char*, 3> migrations{
    // 1: one row for each number.
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
    // 2: names are stored once, and the values of a series together, in the order in which trends are read.
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
       DROP TABLE answers;)",
    // 3: other names. They are part of what a snapshot's id is a hash of, see renew_ids.
    R"(ALTER TABLE subjects RENAME COLUMN contender TO engine;
       UPDATE series SET metric = 'worst_error_ratio' WHERE metric = 'share_of_allowed';)"};

constexpr auto newest = static_cast<std::int64_t>(migrations.size());
constexpr std::int64_t renames_snapshots = 3;  // the version that changed ids

// Size and offsets of the file header (sqlite.org/fileformat.html, 1.3), whose numbers are big-endian.
constexpr std::size_t header_size = 100, journal_at = 18, version_at = 60, application_at = 68;
constexpr std::string_view magic("SQLite format 3\0", 16);

std::uint32_t word_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return word;
}

// Why a file is not a history of ours, judged by its first bytes, so that SQLite never opens a foreign file; "" if it
// may be one. An empty file may: a killed process may have left it.
std::string reason_to_refuse(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return "cannot be read";
  std::string bytes(header_size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(header_size));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.empty()) return "";
  if (bytes.size() < header_size || bytes.substr(0, magic.size()) != magic)
    return "is not a Plumb history; it was left unchanged";
  if (word_at(bytes, application_at) != application_id)
    return "is a database of another program; it was left unchanged";
  const std::uint32_t version = word_at(bytes, version_at);
  if (version > newest) {
    return fmt::format("is of version {}, but this Plumb reads up to version {}: a newer one wrote it", version,
                       newest);
  }
  if (bytes[journal_at] != 1 || bytes[journal_at + 1] != 1 || version == 0) return "is damaged; it was left unchanged";
  return "";
}

std::int64_t version_of(const Database& database) { return database.integer("PRAGMA user_version"); }

// Reads every page. Writes none, except to roll back what a killed process had not finished.
void check_pages(const Database& database) {
  Statement check = database.prepare("PRAGMA quick_check(1)");
  check.next();
  if (const std::string found = check.text(0); found != "ok") {
    database.refuse(fmt::format("is damaged ({}); it was left unchanged", found));
  }
}

// Gives every snapshot the id it would get if it were added now.
void renew_ids(Database& database) {
  std::vector<std::pair<std::int64_t, std::string>> ids;
  Statement snapshots = database.prepare("SELECT number, id FROM snapshots");
  while (snapshots.next()) ids.emplace_back(snapshots.integer(0), snapshots.text(1));
  Statement update = database.prepare("UPDATE snapshots SET id = ? WHERE number = ?");
  for (const auto& [number, id] : ids) {
    const Snapshot snapshot = read_snapshot(database, number);
    if (old_id_of(snapshot) != id) {
      database.refuse(
          fmt::format("is damaged (snapshot {} is not what was added); it was left unchanged", id.substr(0, 12)));
    }
    update.with(id_of(snapshot), number).next();
  }
}

void migrate(Database& database) {
  Transaction transaction(database);
  // Another process may have migrated it meanwhile.
  for (auto version = version_of(database) + 1; version <= newest; ++version) {
    database.execute(migrations[static_cast<std::size_t>(version - 1)]);
    if (version == renames_snapshots) renew_ids(database);
    database.execute(fmt::format("PRAGMA user_version = {}; PRAGMA application_id = {}", version, application_id));
  }
  transaction.commit();
}

std::string damaged(const Database& database) { return database.path().string() + ": is damaged"; }

}  // namespace

Database open_history(const fs::path& path, Database::Missing missing) {
  const bool exists = fs::exists(path);
  if (!exists && missing == Database::Missing::refuse) {
    throw std::invalid_argument(path.string() + ": there is no such file; plumb history add creates one");
  }
  if (fs::is_directory(path)) throw std::invalid_argument(path.string() + ": is a folder");
  if (const std::string why = exists ? reason_to_refuse(path) : ""; !why.empty()) {
    throw std::invalid_argument(path.string() + ": " + why);
  }
  Database database(path, missing);
  check_pages(database);
  const auto version = version_of(database);
  if (version == 0 && missing == Database::Missing::refuse) database.refuse("nothing has been added to it yet");
  if (version < newest) migrate(database);
  return database;
}

Snapshot read_snapshot(const Database& database, std::int64_t number) {
  Statement found = database.prepare("SELECT commit_hash, at, command, environment FROM snapshots WHERE number = ?");
  if (!found.with(number).next()) database.refuse(fmt::format("snapshot number {} is missing", number));
  Snapshot snapshot{
      .commit = found.text(0), .at = found.text(1), .environment = parse_environment(database, found.text(3))};
  const std::string name = damaged(database);
  const nlohmann::json command = parse_json(found.text(2), name);
  snapshot.command = text_list_from(JsonReader(command, name));
  Statement verdicts = database.prepare(
      "SELECT scenario, variant, engine, dt, verdict, step_us, step_us_low, step_us_high, repetitions "
      "FROM verdicts JOIN subjects ON subject = number WHERE snapshot = ?");
  verdicts.with(number);
  while (verdicts.next()) {
    SnapshotRun& run = snapshot.runs[subject_at(verdicts, 0)];
    run.verdict = verdicts.text(4);
    if (verdicts.null(5)) continue;
    run.time = {verdicts.number(5), verdicts.number(6), verdicts.number(7), static_cast<int>(verdicts.integer(8))};
  }
  Statement points = database.prepare(
      "SELECT scenario, variant, engine, dt, metric, unit, value FROM points "
      "JOIN series ON series = series.number JOIN subjects ON subject = subjects.number WHERE snapshot = ?");
  points.with(number);
  while (points.next()) {
    snapshot.runs[subject_at(points, 0)].metrics[points.text(4)] = {points.number(6), points.text(5)};
  }
  return snapshot;
}

Subject subject_at(const Statement& row, int column) {
  return {row.text(column), row.text(column + 1), row.text(column + 2), row.number(column + 3)};
}

std::map<std::string, std::string> parse_environment(const Database& database, const std::string& text) {
  const std::string name = damaged(database);
  const nlohmann::json json = parse_json(text, name);
  return text_map_from(JsonReader(json, name));
}

}  // namespace plumb
