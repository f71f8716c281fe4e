#include "reports/history/schema.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <utility>

#include "reports/history/store.h"
#include "sample.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

class Schema : public InFolder {
 protected:
  std::string refusal(const std::string& name) const {
    for (const auto missing : {Database::Missing::refuse, Database::Missing::make}) {
      try {
        open_history(place(name), missing);
        return "";
      } catch (const std::invalid_argument& error) {
        said_ = error.what();
      }
    }
    return said_;
  }

  // Refused, whoever asks, and left byte for byte, with nothing beside it.
  void expect_refused(const std::string& name, const std::string& why) const {
    const std::string before = bytes(name);
    EXPECT_THAT(refusal(name), HasSubstr(why));
    EXPECT_EQ(bytes(name), before);
    for (const char* beside : {"-journal", "-wal", "-shm"}) {
      EXPECT_FALSE(std::filesystem::exists(place(name) + beside)) << beside;
    }
  }

  void put_history(const std::string& name) const {
    History history = History::to_add(place(name));
    for (int i = 0; i < 20; ++i) history.add(sample_snapshot(i));
  }

 private:
  mutable std::string said_;
};

TEST_F(Schema, RefusesWhatIsNoHistory) {
  put("text", std::string(500, 'x'));
  expect_refused("text", "is no history of Plumb");
  put("short", "x");
  expect_refused("short", "is no history of Plumb");
  Database(place("other.sqlite"), Database::Missing::make)
      .carry_out("CREATE TABLE mine (a); INSERT INTO mine VALUES (1)");
  expect_refused("other.sqlite", "is a database of another program");
  EXPECT_THAT(refusal(""), HasSubstr("is a folder"));
}

TEST_F(Schema, BeginsAHistoryOnlyToAddToIt) {
  EXPECT_THROW(open_history(place("new"), Database::Missing::refuse), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(place("new")));
  EXPECT_EQ(refusal("new"), "");
  EXPECT_TRUE(History::of(place("new")).heads().empty());
}

TEST_F(Schema, SaysWhereItCannotWrite) {
  EXPECT_THAT(refusal("no/such/folder"), HasSubstr("no/such/folder: cannot be opened"));
}

std::string lines_of(const std::string& path) {
  const History history = History::of(path);
  std::string lines;
  for (const SnapshotHead& head : history.heads()) lines += to_line(history.snapshot(head.id)) + "\n";
  return lines;
}

// Any byte of any page, and beginnings of pages: what is not refused lies where nothing is kept.
TEST_F(Schema, NeverTellsAnythingElseOfADamagedHistory) {
  put_history("good");
  const std::string good = bytes("good"), lines = lines_of(place("good"));
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
        EXPECT_EQ(lines_of(place("broken")), lines) << "page " << page / 4096 << ", byte " << from;
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
  header[18] = 2;  // says that another journal is kept
  put("header", header);
  expect_refused("header", "is damaged");
}

TEST_F(Schema, RefusesAHistoryOfANewerPlumb) {
  put_history("newer");
  Database(place("newer"), Database::Missing::refuse).carry_out("PRAGMA user_version = 77");
  expect_refused("newer", "is of version 77, this Plumb knows 2 and older: a newer one wrote it");
}

// As version 1 wrote it.
TEST_F(Schema, BringsVersion1UpToDateWithAllItHolds) {
  Snapshot first = sample_snapshot(3);
  first.answers.begin()->second.metrics["energy_rise"] = {0.1, "J"};
  {
    Database old(place("old"), Database::Missing::make);
    old.carry_out(R"(
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
    for (const Snapshot& one : {first, sample_snapshot(12)}) {
      old.ask("INSERT INTO snapshots VALUES (?, ?, ?, ?, ?, ?)")
          .with(++snapshot, id_of(one), one.commit, one.at, R"(["plumb","report"])",
                R"({"compiler":"GNU 12.2.0","processor":"one"})")
          .next();
      for (const auto& [subject, answered] : one.answers) {
        old.ask(
               "INSERT INTO answers (number, snapshot, scenario, variant, contender, dt, verdict) VALUES (?, ?, ?, ?, "
               "?, ?, ?)")
            .with(++answer, snapshot, subject.scenario, subject.variant, subject.engine, subject.dt, answered.verdict)
            .next();
        if (answered.time) {
          old.ask("UPDATE answers SET step_us = ?, step_us_low = ?, step_us_high = ?, repetitions = ? WHERE number = ?")
              .with(answered.time->median, answered.time->low, answered.time->high, answered.time->repetitions, answer)
              .next();
        }
        for (const auto& [metric, measured] : answered.metrics) {
          old.ask("INSERT INTO results VALUES (?, ?, ?, ?)").with(answer, metric, measured.unit, measured.value).next();
        }
      }
    }
  }
  const History history = History::of(place("old"));
  ASSERT_EQ(history.heads().size(), 2u);
  EXPECT_EQ(to_line(history.snapshot(id_of(first))), to_line(first));
  EXPECT_EQ(to_line(history.snapshot(id_of(sample_snapshot(12)))), to_line(sample_snapshot(12)));
  EXPECT_FALSE(History::to_add(place("old")).add(first));
  EXPECT_TRUE(History::to_add(place("old")).add(sample_snapshot(13)));
  EXPECT_EQ(Database(place("old"), Database::Missing::refuse).whole("PRAGMA user_version"), 2);
}

}  // namespace
}  // namespace plumb
