#include "reports/history/schema.h"

#include <gmock/gmock.h>

#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reports/history/store.h"
#include "sample.h"

namespace plumb::schema_test {
namespace {

using ::testing::HasSubstr;

class Schema : public InFolder {
 protected:
  std::string refusal(const std::string& name) const {
    for (const auto missing : {Database::Missing::refuse, Database::Missing::create}) {
      try {
        open_history(path(name), missing);
        return "";
      } catch (const std::invalid_argument& error) {
        said_ = error.what();
      }
    }
    return said_;
  }

  // Refused for reading and for adding, and left unchanged, without another file beside it.
  void expect_refused(const std::string& name, const std::string& why) const {
    const std::string before = bytes(name);
    EXPECT_THAT(refusal(name), HasSubstr(why));
    EXPECT_EQ(bytes(name), before);
    for (const char* beside : {"-journal", "-wal", "-shm"}) {
      EXPECT_FALSE(std::filesystem::exists(path(name) + beside)) << beside;
    }
  }

  void put_history(const std::string& name) const {
    History history = History::to_add(path(name));
    for (int i = 0; i < 20; ++i) history.add(sample_snapshot(i));
  }

 private:
  mutable std::string said_;
};

TEST_F(Schema, RefusesForeignFiles) {
  put("text", std::string(500, 'x'));
  expect_refused("text", "is not a Plumb history");
  put("short", "x");
  expect_refused("short", "is not a Plumb history");
  Database(path("other.sqlite"), Database::Missing::create)
      .execute("CREATE TABLE mine (a); INSERT INTO mine VALUES (1)");
  expect_refused("other.sqlite", "is a database of another program");
  EXPECT_THAT(refusal(""), HasSubstr("is a folder"));
}

TEST_F(Schema, CreatesAHistoryOnlyToAddToIt) {
  EXPECT_THROW(open_history(path("new"), Database::Missing::refuse), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(path("new")));
  EXPECT_EQ(refusal("new"), "");
  EXPECT_TRUE(History::of(path("new")).heads().empty());
}

TEST_F(Schema, NamesTheFileItCannotOpen) {
  EXPECT_THAT(refusal("no/such/folder"), HasSubstr("no/such/folder: cannot be opened"));
}

std::string lines_of(const std::string& path) {
  const History history = History::of(path);
  std::string lines;
  for (const SnapshotHead& head : history.heads()) lines += to_line(history.snapshot(head.id)) + "\n";
  return lines;
}

// Inverts bytes in every page. What is not refused is in unused space.
TEST_F(Schema, NeverReadsOtherContentsFromADamagedHistory) {
  put_history("good");
  const std::string good = bytes("good"), lines = lines_of(path("good"));
  int refused = 0, tried = 0;
  for (std::size_t page = 0; page < good.size(); page += 4096) {
    for (const auto& [from, many] : {std::pair{0, 64}, {2100, 1}, {3500, 1}, {4095, 1}}) {
      std::string broken = good;
      for (int i = from; i < from + many; ++i) {
        char& byte = broken[page + static_cast<std::size_t>(i)];
        byte = static_cast<char>(~byte);
      }
      put("broken", broken);
      ++tried;
      try {
        EXPECT_EQ(lines_of(path("broken")), lines) << "page " << page / 4096 << ", byte " << from;
      } catch (const std::invalid_argument&) {
        ++refused;
      }
      EXPECT_EQ(bytes("broken"), broken);
    }
  }
  EXPECT_GT(refused, tried / 4);
}

TEST_F(Schema, RefusesADamagedHistory) {
  put_history("good");
  const std::string good = bytes("good");
  std::string broken = good;
  for (std::size_t i = 4096; i < 4096 + 64; ++i) broken[i] = static_cast<char>(~broken[i]);
  put("broken", broken);
  expect_refused("broken", "is damaged");
  put("cut", good.substr(0, good.size() / 2));
  expect_refused("cut", "is damaged");
  std::string header = good;
  header[18] = 2;  // claims another kind of journal
  put("header", header);
  expect_refused("header", "is damaged");
}

TEST_F(Schema, RefusesANewerHistory) {
  put_history("newer");
  Database(path("newer"), Database::Missing::refuse).execute("PRAGMA user_version = 77");
  expect_refused("newer", "is of version 77, but this Plumb reads up to version 3: a newer one wrote it");
}

// As version 1 wrote it.
void put_version_1(const std::string& path, const std::vector<Snapshot>& snapshots) {
  Database old(path, Database::Missing::create);
  old.execute(R"(
    BEGIN;
    CREATE TABLE snapshots (
      number INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, commit_hash TEXT NOT NULL, at TEXT NOT NULL,
      command TEXT NOT NULL, environment TEXT NOT NULL);
    CREATE TABLE answers (
      number INTEGER PRIMARY KEY, snapshot INTEGER NOT NULL REFERENCES snapshots,
      scenario TEXT NOT NULL, variant TEXT NOT NULL, contender TEXT NOT NULL, dt REAL NOT NULL,
      verdict TEXT NOT NULL, step_us REAL, step_us_low REAL, step_us_high REAL, repetitions INTEGER);
    CREATE TABLE results (
      answer INTEGER NOT NULL REFERENCES answers, metric TEXT NOT NULL, unit TEXT NOT NULL, value REAL,
      PRIMARY KEY (answer, metric)) WITHOUT ROWID;
    PRAGMA user_version = 1;
    PRAGMA application_id = 1347177794;
    COMMIT)");
  std::int64_t snapshot = 0, answer = 0;
  for (const Snapshot& one : snapshots) {
    old.prepare("INSERT INTO snapshots VALUES (?, ?, ?, ?, ?, ?)")
        .with(++snapshot, old_id_of(one), one.commit, one.at, R"(["plumb","report"])",
              R"({"compiler":"GNU 12.2.0","processor":"one"})")
        .next();
    for (const auto& [subject, run] : one.runs) {
      old.prepare(
             "INSERT INTO answers (number, snapshot, scenario, variant, contender, dt, verdict) "
             "VALUES (?, ?, ?, ?, ?, ?, ?)")
          .with(++answer, snapshot, subject.scenario, subject.variant, subject.engine, subject.dt, run.verdict)
          .next();
      if (const auto& time = run.time) {
        old.prepare(
               "UPDATE answers SET step_us = ?, step_us_low = ?, step_us_high = ?, repetitions = ? WHERE number = ?")
            .with(time->median, time->low, time->high, time->repetitions, answer)
            .next();
      }
      for (const auto& [metric, measured] : run.metrics) {
        const std::string old_metric = metric == worst_ratio_metric ? "share_of_allowed" : metric;
        old.prepare("INSERT INTO results VALUES (?, ?, ?, ?)")
            .with(answer, old_metric, measured.unit, measured.value)
            .next();
      }
    }
  }
}

// As version 2 wrote it, for one run with one metric.
void put_version_2(const std::string& path, const Snapshot& one) {
  const auto& [subject, run] = *one.runs.begin();
  Database old(path, Database::Missing::create);
  old.execute(R"(
    BEGIN;
    CREATE TABLE snapshots (
      number INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, commit_hash TEXT NOT NULL, at TEXT NOT NULL,
      command TEXT NOT NULL, environment TEXT NOT NULL);
    CREATE TABLE subjects (
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
    PRAGMA user_version = 2;
    PRAGMA application_id = 1347177794;
    COMMIT)");
  old.prepare("INSERT INTO snapshots VALUES (1, ?, ?, ?, ?, ?)")
      .with(old_id_of(one), one.commit, one.at, R"(["plumb","report"])",
            R"({"compiler":"GNU 12.2.0","processor":"one"})")
      .next();
  old.prepare("INSERT INTO subjects VALUES (1, ?, ?, ?, ?)")
      .with(subject.scenario, subject.variant, subject.engine, subject.dt)
      .next();
  old.prepare("INSERT INTO verdicts (subject, snapshot, verdict) VALUES (1, 1, ?)").with(run.verdict).next();
  old.execute("INSERT INTO series VALUES (1, 1, 'share_of_allowed', '1')");
  old.prepare("INSERT INTO points VALUES (1, 1, ?)").with(run.metrics.at(worst_ratio_metric).value).next();
}

TEST_F(Schema, MigratesVersion1WithAllItHolds) {
  Snapshot first = sample_snapshot(3);
  first.runs.begin()->second.metrics["energy_rise"] = {0.1, "J"};
  put_version_1(path("old"), {first, sample_snapshot(12)});
  const History history = History::of(path("old"));
  ASSERT_EQ(history.heads().size(), 2u);
  EXPECT_EQ(to_line(history.snapshot(id_of(first))), to_line(first));
  EXPECT_EQ(to_line(history.snapshot(id_of(sample_snapshot(12)))), to_line(sample_snapshot(12)));
  EXPECT_FALSE(History::to_add(path("old")).add(first));
  EXPECT_TRUE(History::to_add(path("old")).add(sample_snapshot(13)));
  EXPECT_EQ(Database(path("old"), Database::Missing::refuse).integer("PRAGMA user_version"), 3);
}

TEST_F(Schema, MigratesVersion2ToTheIdsOfVersion3) {
  Snapshot one = sample_snapshot(3);
  one.runs.erase(std::next(one.runs.begin()), one.runs.end());
  one.runs.begin()->second = {.verdict = "right", .metrics = {{worst_ratio_metric, {0.1, "1"}}}};
  put_version_2(path("old"), one);
  EXPECT_EQ(History::of(path("old")).heads().at(0).id, id_of(one));
  EXPECT_EQ(to_line(History::of(path("old")).snapshot(id_of(one))), to_line(one));
  EXPECT_EQ(History::of(path("old")).series(worst_ratio_metric).size(), 1u);
  EXPECT_FALSE(History::to_add(path("old")).add(one));
}

TEST_F(Schema, RefusesAnOldHistoryWithAnAlteredNumber) {
  Snapshot one = sample_snapshot(3);
  one.runs.erase(std::next(one.runs.begin()), one.runs.end());
  one.runs.begin()->second = {.verdict = "right", .metrics = {{worst_ratio_metric, {0.1, "1"}}}};
  put_version_2(path("old"), one);
  Database(path("old"), Database::Missing::refuse).execute("UPDATE points SET value = 7");
  expect_refused("old", "is not what was added");
}

}  // namespace
}  // namespace plumb::schema_test
