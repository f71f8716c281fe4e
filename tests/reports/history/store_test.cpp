#include "reports/history/store.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

#include "sample.h"

namespace plumb::store_test {
namespace {

class Store : public InFolder {};

// Does work in a new process, which exits with 0, or with 1 if anything was thrown.
pid_t start_process(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child != 0) return child;
  try {
    work();
  } catch (const std::exception&) {
    _exit(1);
  }
  _exit(0);
}

int status_of(pid_t child) {
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

TEST_F(Store, KeepsEverySnapshotOnceWithEveryBit) {
  History history = History::to_add(path("h"));
  for (const int i : {5, 0, 11}) EXPECT_TRUE(history.add(sample_snapshot(i)));
  for (const int i : {5, 0}) EXPECT_FALSE(history.add(sample_snapshot(i)));
  const auto heads = history.heads();
  ASSERT_EQ(heads.size(), 3u);
  EXPECT_EQ(heads[0].commit, "c0ffee0");
  EXPECT_EQ(heads[2].commit, "c0ffee11");
  EXPECT_EQ(heads[2].verdicts, (std::map<std::string, int>{{"failed", 1}, {"wrong", 1}}));
  for (const int i : {0, 5, 11}) {
    EXPECT_EQ(to_line(history.snapshot(id_of(sample_snapshot(i)))), to_line(sample_snapshot(i)));
  }
}

TEST_F(Store, SortsSeriesByTime) {
  History history = History::to_add(path("h"));
  for (const int i : {12, 3, 7}) history.add(sample_snapshot(i));
  const auto all = history.series("energy_rise");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].subject.engine, "impulse");
  EXPECT_EQ(all[0].unit, "J");
  ASSERT_EQ(all[0].values.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(all[0].values[i].snapshot, i);
  EXPECT_EQ(all[0].values[1].value, 1);
  EXPECT_EQ(all[0].values[2].value, 2);
  const auto times = history.series(step_time);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times[0].values[0].high, 0.75);
  EXPECT_EQ(history.series().size(), 4u);
  const auto verdicts = history.verdicts();
  ASSERT_EQ(verdicts.size(), 2u);
  EXPECT_EQ(verdicts[1].values[2].verdict, "wrong");
}

TEST_F(Store, DetectsAnAlteredNumber) {
  History::to_add(path("h")).add(sample_snapshot(0));
  Database(path("h"), Database::Missing::refuse).execute("UPDATE points SET value = 7 WHERE value = 1");
  EXPECT_THROW(History::of(path("h")).snapshot(id_of(sample_snapshot(0))), std::invalid_argument);
}

// Every snapshot is added by two processes. The first one creates the file.
TEST_F(Store, CanBeWrittenByEightProcessesAtOnce) {
  constexpr int writers = 8, each = 8;
  std::vector<pid_t> children;
  for (int writer = 0; writer < writers; ++writer) {
    children.push_back(start_process([&] {
      for (int i = 0; i < each; ++i)
        History::to_add(path("h")).add(sample_snapshot((writer * each / 2 + i) % (writers * each / 2)));
    }));
  }
  for (const pid_t child : children) EXPECT_EQ(status_of(child), 0);
  const History history = History::of(path("h"));
  ASSERT_EQ(history.heads().size(), writers * each / 2u);
  for (int i = 0; i < writers * each / 2; ++i) EXPECT_NO_THROW(history.snapshot(id_of(sample_snapshot(i)))) << i;
}

// The writer is killed after longer and longer times, at first before the file exists, at last when it has written.
TEST_F(Store, IsCompleteWheneverItsWriterIsKilled) {
  std::size_t kept = 0;
  for (int round = 0; round < 24 || kept == 0; ++round) {
    const pid_t child = start_process([&] {
      for (int i = 0;; ++i) History::to_add(path("h")).add(sample_snapshot(round * 1000 + i));
    });
    std::this_thread::sleep_for(std::chrono::microseconds(1700 * round));
    kill(child, SIGKILL);
    EXPECT_TRUE(WIFSIGNALED(status_of(child)));
    History history = History::to_add(path("h"));
    const auto heads = history.heads();
    EXPECT_GE(heads.size(), kept);
    for (const SnapshotHead& head : heads) EXPECT_NO_THROW(history.snapshot(head.id)) << "round " << round;
    kept = heads.size();
  }
}

}  // namespace
}  // namespace plumb::store_test
