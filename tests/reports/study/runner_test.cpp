#include "reports/study/runner.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <map>
#include <new>
#include <stdexcept>

namespace plumb::runner_test {
namespace {

using ::testing::HasSubstr;

Job job(const std::string& key, std::function<JobOutput()> run) { return {.key = key, .run = std::move(run)}; }

JobOutput number(int value) { return {{{"value", value}}, {}}; }

std::map<std::string, JobResult> found(const std::vector<Job>& jobs, Execution execution) {
  std::map<std::string, JobResult> all;
  EXPECT_TRUE(execute(units_of(jobs), execution, [&](std::span<const JobResult> results) {
    for (const JobResult& result : results) EXPECT_TRUE(all.emplace(result.key, result).second) << result.key;
  }));
  return all;
}

TEST(Runner, RunsEachJobOnceInAProcessOfItsOwn) {
  for (const int parallel : {1, 3}) {
    std::vector<Job> jobs;
    for (int i = 0; i < 20; ++i) {
      jobs.push_back(job(std::to_string(i), [i] { return JobOutput{{{"value", i}, {"process", getpid()}}, {}}; }));
    }
    const auto all = found(jobs, {.parallel = parallel});
    ASSERT_EQ(all.size(), 20u);
    for (const auto& [key, result] : all) {
      EXPECT_EQ(result.ending, Ending::done) << result.reason;
      EXPECT_EQ(result.output.values["value"], std::stoi(key));
      EXPECT_NE(result.output.values["process"], getpid());
    }
  }
}

TEST(Runner, ReportsACrashAndAHangAsResults) {
  const std::vector<Job> jobs{job("fine", [] { return number(1); }), job("crash", []() -> JobOutput { std::abort(); }),
                              job("exit", []() -> JobOutput { _exit(3); }),
                              job("throw", []() -> JobOutput { throw std::runtime_error("no such thing"); }),
                              job("refused", []() -> JobOutput { throw std::bad_alloc(); })};
  auto all = found(jobs, {.parallel = 2});
  EXPECT_EQ(all["fine"].ending, Ending::done);
  EXPECT_EQ(all["crash"].ending, Ending::crashed);
  EXPECT_THAT(all["crash"].reason, HasSubstr("signal 6"));
  EXPECT_EQ(all["exit"].ending, Ending::crashed);
  EXPECT_THAT(all["exit"].reason, HasSubstr("exit code 3"));
  EXPECT_EQ(all["throw"].ending, Ending::failed);
  EXPECT_EQ(all["throw"].reason, "no such thing");
  EXPECT_EQ(all["refused"].ending, Ending::out_of_memory);
  const Job hang = job("hang", []() -> JobOutput {
    for (;;) usleep(1000);
  });
  EXPECT_EQ(found({hang}, {.limits = {.seconds = 1}})["hang"].ending, Ending::timed_out);
}

// The machine's load decides how long a job takes, but not how much it computes.
TEST(Runner, CountsAProcessorsSecondsAndThoseOfProcessesThatHaveEnded) {
  const Job computes = job("computes", []() -> JobOutput {
    for (;;) {
    }
  });
  const JobResult ended = found({computes}, {.limits = {.processor_seconds = 0.1}})["computes"];
  EXPECT_EQ(ended.ending, Ending::timed_out);
  EXPECT_THAT(ended.reason, HasSubstr("0.1 s of a processor"));
  const Job waits = job("waits", [] {
    usleep(300'000);
    return number(1);
  });
  EXPECT_EQ(found({waits}, {.limits = {.processor_seconds = 0.1}})["waits"].ending, Ending::done);
  const Job delegates = job("delegates", []() -> JobOutput {
    for (;;) {
      const pid_t child = fork();
      if (child == 0) {
        while (std::clock() < CLOCKS_PER_SEC / 20) {
        }
        _exit(0);
      }
      waitpid(child, nullptr, 0);
    }
  });
  EXPECT_EQ(found({delegates}, {.limits = {.processor_seconds = 0.2}})["delegates"].ending, Ending::timed_out);
}

TEST(Runner, EndsAJobAtItsMemoryLimit) {
  const std::vector<Job> jobs{job("hog", []() -> JobOutput {
    std::vector<std::vector<char>> all;
    for (;;) all.emplace_back(1 << 20, '1');
  })};
  const JobResult hog = found(jobs, {.limits = {.mebibytes = 600}})["hog"];
  EXPECT_EQ(hog.ending, Ending::out_of_memory);
  EXPECT_THAT(hog.reason, HasSubstr("600 MiB"));
}

TEST(Runner, ReadsLongResultsWhole) {
  const std::string text(1 << 20, 'x');
  EXPECT_EQ(found({job("long",
                       [&] {
                         return JobOutput{{{"text", text}}, {}};
                       })},
                  {})["long"]
                .output.values["text"],
            text);
}

TEST(Runner, HandsTheChildWhatPrepareComputed) {
  int prepared = 0;
  Job user = job("user", [&] { return number(prepared); });
  user.prepare = [&] { prepared = 42; };
  EXPECT_EQ(found({user}, {})["user"].output.values["value"], 42);
}

TEST(Runner, RepeatsTimedJobsOfAGroupAndGivesMedianAndQuartiles) {
  std::vector<Job> jobs;
  for (const double seconds : {1e-3, 2e-3, 4e-3}) {
    const auto count = std::make_shared<int>(0);
    jobs.push_back({.key = std::to_string(seconds),
                    .run = [] { return number(1); },
                    .repetition = [=] { return ++*count == 1 ? 100 : seconds; },  // the first is a warm-up
                    .group = "all"});
  }
  for (const auto& [key, result] : found(jobs, {.parallel = 2})) {
    EXPECT_EQ(result.output.times["median"], std::stod(key));
    EXPECT_EQ(result.output.times["low"], std::stod(key));
    EXPECT_EQ(result.output.times["high"], std::stod(key));
    EXPECT_EQ(result.output.times["repetitions"], 5);
    EXPECT_EQ(result.output.times["wide"], false);
  }
}

TEST(Runner, RepeatsAnUnsteadyJobMoreOftenAndMarksItIfThatDoesNotHelp) {
  const auto unsteady = [](int steady_after) {
    const auto count = std::make_shared<int>(0);
    return [=] { return ++*count > steady_after || *count % 2 == 0 ? 1.0 : 3.0; };
  };
  const std::vector<Job> jobs{
      {.key = "always", .run = [] { return number(1); }, .repetition = unsteady(1000), .group = "g"},
      {.key = "at first", .run = [] { return number(1); }, .repetition = unsteady(6), .group = "g"}};
  auto all = found(jobs, {});
  EXPECT_EQ(all["always"].output.times["wide"], true);
  EXPECT_EQ(all["at first"].output.times["wide"], false);
  EXPECT_GT(all["at first"].output.times["repetitions"], 5);
  EXPECT_GT(all["always"].output.times["repetitions"], all["at first"].output.times["repetitions"]);
}

TEST(Runner, HasNoTimesForAJobWithNothingToTime) {
  const std::vector<Job> jobs{
      {.key = "none", .run = [] { return number(7); }, .repetition = [] { return std::nan(""); }, .group = "g"},
      {.key = "fine", .run = [] { return number(8); }, .repetition = [] { return 1.0; }, .group = "g"}};
  auto all = found(jobs, {});
  EXPECT_EQ(all["none"].ending, Ending::done);
  EXPECT_TRUE(all["none"].output.times.empty());
  EXPECT_EQ(all["fine"].output.times["median"], 1.0);
}

TEST(Runner, KeepsTheValuesOfAJobThatCrashesWhenTimed) {
  const std::vector<Job> jobs{
      {.key = "crash", .run = [] { return number(7); }, .repetition = []() -> double { std::abort(); }, .group = "g"},
      {.key = "fine", .run = [] { return number(8); }, .repetition = [] { return 1.0; }, .group = "g"}};
  auto all = found(jobs, {});
  EXPECT_EQ(all["crash"].ending, Ending::crashed);
  EXPECT_EQ(all["crash"].output.values["value"], 7);
  EXPECT_EQ(all["fine"].ending, Ending::done);
  EXPECT_EQ(all["fine"].output.times["median"], 1.0);
}

TEST(Runner, StopsWhenInterruptedAndKeepsFinishedResults) {
  std::vector<Job> jobs;
  for (int i = 0; i < 50; ++i) jobs.push_back(job(std::to_string(i), [i] { return number(i); }));
  std::size_t kept = 0;
  const Execution execution{.parallel = 2, .interrupted = [&] { return kept >= 10; }};
  EXPECT_FALSE(execute(units_of(jobs), execution, [&](std::span<const JobResult> results) { kept += results.size(); }));
  EXPECT_GE(kept, 10u);
  EXPECT_LT(kept, 50u);
}

TEST(Runner, RunsNothingBesideAJobThatMustBeAlone) {
  // A file that exists while one of the jobs is running.
  char name[] = "/tmp/plumb-alone-XXXXXX";
  close(mkstemp(name));
  const std::string busy = std::string(name) + ".busy";
  std::vector<Job> jobs;
  for (int i = 0; i < 4; ++i) {
    jobs.push_back({.key = std::to_string(i),
                    .run =
                        [=] {
                          const bool first = link(name, busy.c_str()) == 0;
                          usleep(20000);
                          if (first) unlink(busy.c_str());
                          return number(first ? 1 : 0);
                        },
                    .alone = true});
  }
  for (const auto& [key, result] : found(jobs, {.parallel = 4})) EXPECT_EQ(result.output.values["value"], 1) << key;
  unlink(name);
}

}  // namespace
}  // namespace plumb::runner_test
