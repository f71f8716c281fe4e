#include "reports/study/runner.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <new>
#include <stdexcept>

namespace plumb {
namespace {

using ::testing::HasSubstr;

Point point(const std::string& key, std::function<Row()> run) { return {.key = key, .run = std::move(run)}; }

Row number(int value) { return {{{"value", value}}, {}}; }

std::map<std::string, PointResult> found(const std::vector<Point>& points, Execution how) {
  std::map<std::string, PointResult> all;
  EXPECT_TRUE(execute(units_of(points), how, [&](std::span<const PointResult> results) {
    for (const PointResult& result : results) EXPECT_TRUE(all.emplace(result.key, result).second) << result.key;
  }));
  return all;
}

TEST(Runner, FindsOutEachPointOnceInAProcessOfItsOwn) {
  for (const int jobs : {1, 3}) {
    std::vector<Point> points;
    for (int i = 0; i < 20; ++i) {
      points.push_back(point(std::to_string(i), [i] { return Row{{{"value", i}, {"process", getpid()}}, {}}; }));
    }
    const auto all = found(points, {.jobs = jobs});
    ASSERT_EQ(all.size(), 20u);
    for (const auto& [key, result] : all) {
      EXPECT_EQ(result.ending, Ending::done) << result.reason;
      EXPECT_EQ(result.row.values["value"], std::stoi(key));
      EXPECT_NE(result.row.values["process"], getpid());
    }
  }
}

TEST(Runner, TakesACrashAndAHangAsOutcomes) {
  const std::vector<Point> points{point("fine", [] { return number(1); }),
                                  point("crash", []() -> Row { std::abort(); }),
                                  point("exit", []() -> Row { _exit(3); }),
                                  point("throw", []() -> Row { throw std::runtime_error("no such thing"); }),
                                  point("hang",
                                        []() -> Row {
                                          for (;;) usleep(1000);
                                        }),
                                  point("refused", []() -> Row { throw std::bad_alloc(); })};
  auto all = found(points, {.jobs = 2, .limits = {.seconds = 1}});
  EXPECT_EQ(all["fine"].ending, Ending::done);
  EXPECT_EQ(all["crash"].ending, Ending::crashed);
  EXPECT_THAT(all["crash"].reason, HasSubstr("signal 6"));
  EXPECT_EQ(all["exit"].ending, Ending::crashed);
  EXPECT_THAT(all["exit"].reason, HasSubstr("exit code 3"));
  EXPECT_EQ(all["throw"].ending, Ending::failed);
  EXPECT_EQ(all["throw"].reason, "no such thing");
  EXPECT_EQ(all["hang"].ending, Ending::timed_out);
  EXPECT_EQ(all["refused"].ending, Ending::out_of_memory);
}

TEST(Runner, EndsAHogAtItsLimitOfMemory) {
  const std::vector<Point> points{point("hog", []() -> Row {
    std::vector<std::vector<char>> all;
    for (;;) all.emplace_back(1 << 20, '1');
  })};
  const PointResult hog = found(points, {.limits = {.mebibytes = 600}})["hog"];
  EXPECT_EQ(hog.ending, Ending::out_of_memory);
  EXPECT_THAT(hog.reason, HasSubstr("600 MiB"));
}

TEST(Runner, HearsLongRowsWhole) {
  const std::string text(1 << 20, 'x');
  EXPECT_EQ(found({point("long", [&] { return Row{{{"text", text}}, {}}; })}, {})["long"].row.values["text"], text);
}

TEST(Runner, LetsAPreparedThoughtReachTheChild) {
  int thought = 0;
  Point asked = point("asked", [&] { return number(thought); });
  asked.prepare = [&] { thought = 42; };
  EXPECT_EQ(found({asked}, {})["asked"].row.values["value"], 42);
}

// Each says how many turns of its group had been taken before its own, from a clock that all share.
TEST(Runner, LetsTimedPointsOfAGroupTakeTurnsAndTellsMedianAndQuartiles) {
  std::vector<Point> points;
  for (const double seconds : {1e-3, 2e-3, 4e-3}) {
    const auto turns = std::make_shared<int>(0);
    points.push_back({.key = std::to_string(seconds),
                      .run = [] { return number(1); },
                      .turn = [=] { return ++*turns == 1 ? 100 : seconds; },  // the first is a warm-up
                      .group = "all"});
  }
  for (const auto& [key, result] : found(points, {.jobs = 2})) {
    EXPECT_EQ(result.row.times["median"], std::stod(key));
    EXPECT_EQ(result.row.times["low"], std::stod(key));
    EXPECT_EQ(result.row.times["high"], std::stod(key));
    EXPECT_EQ(result.row.times["repetitions"], 5);
    EXPECT_EQ(result.row.times["wide"], false);
  }
}

TEST(Runner, MeasuresAnUnsteadyPointAgainAndMarksItIfThatDoesNotHelp) {
  const auto unsteady = [](int steady_after) {
    const auto turns = std::make_shared<int>(0);
    return [=] { return ++*turns > steady_after || *turns % 2 == 0 ? 1.0 : 3.0; };
  };
  const std::vector<Point> points{
      {.key = "always", .run = [] { return number(1); }, .turn = unsteady(1000), .group = "g"},
      {.key = "at first", .run = [] { return number(1); }, .turn = unsteady(6), .group = "g"}};
  auto all = found(points, {});
  EXPECT_EQ(all["always"].row.times["wide"], true);
  EXPECT_EQ(all["at first"].row.times["wide"], false);
  EXPECT_GT(all["at first"].row.times["repetitions"], 5);
  EXPECT_GT(all["always"].row.times["repetitions"], all["at first"].row.times["repetitions"]);
}

TEST(Runner, TimesNothingWhereThereIsNothingToTime) {
  const std::vector<Point> points{
      {.key = "none", .run = [] { return number(7); }, .turn = [] { return std::nan(""); }, .group = "g"},
      {.key = "fine", .run = [] { return number(8); }, .turn = [] { return 1.0; }, .group = "g"}};
  auto all = found(points, {});
  EXPECT_EQ(all["none"].ending, Ending::done);
  EXPECT_TRUE(all["none"].row.times.empty());
  EXPECT_EQ(all["fine"].row.times["median"], 1.0);
}

TEST(Runner, KeepsWhatAPointFoundThoughItCrashesWhenTimed) {
  const std::vector<Point> points{
      {.key = "crash", .run = [] { return number(7); }, .turn = []() -> double { std::abort(); }, .group = "g"},
      {.key = "fine", .run = [] { return number(8); }, .turn = [] { return 1.0; }, .group = "g"}};
  auto all = found(points, {});
  EXPECT_EQ(all["crash"].ending, Ending::crashed);
  EXPECT_EQ(all["crash"].row.values["value"], 7);
  EXPECT_EQ(all["fine"].ending, Ending::done);
  EXPECT_EQ(all["fine"].row.times["median"], 1.0);
}

TEST(Runner, StopsWhenInterruptedAndKeepsWhatWasFinished) {
  std::vector<Point> points;
  for (int i = 0; i < 50; ++i) points.push_back(point(std::to_string(i), [i] { return number(i); }));
  std::size_t kept = 0;
  const Execution how{.jobs = 2, .interrupted = [&] { return kept >= 10; }};
  EXPECT_FALSE(execute(units_of(points), how, [&](std::span<const PointResult> results) { kept += results.size(); }));
  EXPECT_GE(kept, 10u);
  EXPECT_LT(kept, 50u);
}

TEST(Runner, LeavesAPointThatWantsToBeAloneAlone) {
  // A file that is there while one is at work.
  char name[] = "/tmp/plumb-alone-XXXXXX";
  close(mkstemp(name));
  const std::string busy = std::string(name) + ".busy";
  std::vector<Point> points;
  for (int i = 0; i < 4; ++i) {
    points.push_back({.key = std::to_string(i),
                      .run =
                          [=] {
                            const bool first = link(name, busy.c_str()) == 0;
                            usleep(20000);
                            if (first) unlink(busy.c_str());
                            return number(first ? 1 : 0);
                          },
                      .alone = true});
  }
  for (const auto& [key, result] : found(points, {.jobs = 4})) EXPECT_EQ(result.row.values["value"], 1) << key;
  unlink(name);
}

}  // namespace
}  // namespace plumb
