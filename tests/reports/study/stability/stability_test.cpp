#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <sstream>

#include "../../../reference/programs/faults.h"
#include "../study_files.h"
#include "reports/study/results_file.h"
#include "reports/study/study.h"
#include "scenarios/catalog.h"

namespace plumb::stability_test {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

class StabilityStudy : public StudyFiles {
 protected:
  // Two maps, 5 and 9 rows.
  std::vector<std::string> stability(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"study", "stability", "--maps", "slope", "mass-ratio", "--engine",
                                 "box2d", "--cells",   "8",      "--out", at(out)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  static StudyPlan plan(const Json& configuration) { return Catalog<Study>::find("stability")->plan(configuration); }

  static Json configuration(const std::vector<std::string>& maps, const std::vector<std::string>& engines) {
    return {{"maps", maps}, {"engines", engines}, {"cells", 4}};
  }
};

TEST_F(StabilityStudy, PlansAJobForEveryRow) {
  std::map<std::string, int> keys;
  for (const Job& job : plan(configuration({}, {})).jobs) EXPECT_EQ(++keys[job.key], 1) << job.key;
  for (const char* key :
       {"stability|slope|impulse|friction=0.5", "stability|stack|box2d|velocity=8",
        "stability|stack|impulse|substeps=4", "stability|stack|impulse:solver=exact|alone=0",
        "stability|tunnelling|impulse:continuous=off|wall=0.05", "stability|tunnelling|chipmunk|wall=0.05"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

TEST_F(StabilityStudy, MeasuresCellsBoundaryAndTheory) {
  const StudyPlan slope = plan(configuration({"slope"}, {"impulse"}));
  for (const Job& job : slope.jobs) {
    const Json values = job.run().values;
    EXPECT_EQ(values.at("outcomes").get<std::string>().size(), 4u);
    EXPECT_EQ(values.at("since").size(), 4u);
    EXPECT_LT(values.at("sticks_low"), values.at("sticks_high"));
    EXPECT_EQ(values.at("sticks_agrees"), true) << values.dump();
    EXPECT_EQ(values.at("sticks_body"), "box");
  }
}

TEST_F(StabilityStudy, ConcludesTheLimitOfEachMethod) {
  const StudyPlan slope = plan(configuration({"slope"}, {"impulse", "chipmunk"}));
  std::vector<JobResult> results;
  for (const Job& job : slope.jobs) results.push_back({.key = job.key, .output = job.run()});
  results.back().ending = Ending::crashed;
  results.back().output = {};
  const Findings found = slope.conclude(results);
  const Json& map = found.findings.at("maps").front();
  ASSERT_EQ(map.at("limits").size(), 2u);
  EXPECT_EQ(map.at("limits")[0].at("engine"), "impulse");
  EXPECT_NEAR(map.at("limits")[0].at("low").get<double>(), 26.565, 0.1);
  EXPECT_EQ(map.at("agreements")[0].at("agree"), 5);
  EXPECT_EQ(map.at("agreements")[1].at("rows"), 4) << "a crashed row does not count";
  EXPECT_THAT(found.text, HasSubstr("1 crashed"));
}

TEST_F(StabilityStudy, SaysWhyAnEngineFails) {
  for (const char* fault : {"crashes-in-build", "crashes-when-asked-how"}) {
    const StudyPlan slope = plan(configuration({"slope"}, {faulty_program(PLUMB_SOURCE_DIR, fault)}));
    std::vector<JobResult> results;
    for (const Job& job : slope.jobs) results.push_back({.key = job.key, .output = job.run()});
    const Findings found = slope.conclude(results);
    EXPECT_THAT(found.text, HasSubstr("none: fails")) << fault;
    EXPECT_THAT(found.text, HasSubstr(" failed in 5 of 5 jobs, first in slope: ")) << fault;
    EXPECT_THAT(found.text, HasSubstr("ended by signal 11")) << fault;
  }
}

TEST_F(StabilityStudy, SaysFirstWhichMethodIsTheBestAndWhichFailed) {
  const StudyPlan slope = plan(configuration({"slope"}, {"impulse", "chipmunk"}));
  std::vector<JobResult> results;
  for (const Job& job : slope.jobs) {
    const bool ours = job.key.find("impulse") != job.key.npos;
    results.push_back(
        {.key = job.key, .ending = ours ? Ending::done : Ending::failed, .reason = ours ? "" : "no disk"});
    if (ours) results.back().output = job.run();
  }
  const Findings found = slope.conclude(results);
  EXPECT_THAT(found.text, ::testing::StartsWith("impulse is the best or among the best in 1 of 1 map. Of all methods' "
                                                "boundaries with a theory, 5 of 5 agree with it."));
  EXPECT_EQ(found.findings.at("sentence").get<std::string>().find("impulse is the best"), 0u);
  EXPECT_THAT(found.text, HasSubstr("chipmunk failed: failed, no disk"));
  EXPECT_EQ(found.findings.at("maps")[0].at("best"), Json::array({"impulse"}));
  EXPECT_EQ(found.findings.at("maps")[0].at("limits")[1].at("failed"), "failed, no disk");
}

TEST_F(StabilityStudy, FitsTheTerminal) {
  const StudyPlan stack = plan(configuration({"stack"}, {}));
  std::vector<JobResult> results;
  for (const Job& job : stack.jobs)
    results.push_back({.key = job.key, .ending = Ending::crashed, .reason = "signal 11"});
  std::istringstream lines(stack.conclude(results).text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
}

TEST_F(StabilityStudy, RefusesUnknownNamesAndSuggestsTheNearest) {
  const auto refused = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"study", "stability", "--out", at("out")};
    words.insert(words.end(), more.begin(), more.end());
    const Said said = say(words);
    EXPECT_EQ(said.code, 2) << said.out;
    return said.err;
  };
  EXPECT_THAT(refused({"--maps", "stakc"}), HasSubstr("did you mean \"stack\"?"));
  EXPECT_THAT(refused({"--engine", "box3d"}), HasSubstr("did you mean \"box2d\"?"));
  EXPECT_THAT(refused({"--maps", "stack", "stack"}), HasSubstr("selected twice"));
  EXPECT_THAT(refused({"--cells", "1"}), HasSubstr("--cells"));
  EXPECT_THAT(refused({"--mpas", "stack"}), HasSubstr("--maps"));
}

TEST_F(StabilityStudy, MergedFromShardsEqualsTheWhole) {
  std::vector<std::string> merge{"merge", "--out", at("merged")};
  for (const char* k : {"2", "1", "3"}) {
    ASSERT_EQ(say(stability("shards", {"--shard", std::string(k) + "/3"})).code, 0);
    merge.push_back(at("shards") + "/study-stability-" + k + "-of-3.jsonl");
  }
  EXPECT_EQ(say(merge).code, 0);
  EXPECT_EQ(say(stability("whole", {"--jobs", "1"})).code, 0);
  EXPECT_EQ(document("merged", "stability").dump(1), document("whole", "stability").dump(1));
  EXPECT_EQ(text(at("merged") + "/study-stability.csv"), text(at("whole") + "/study-stability.csv"));
}

TEST_F(StabilityStudy, ResumesAfterKill9) {
  const std::string file = at("killed") + "/study-stability.jsonl";
  const auto lines = [&] {
    const std::string all = text(file);
    return std::count(all.begin(), all.end(), '\n');
  };
  const pid_t process = fork();
  if (process == 0) _exit(program(stability("killed")));
  while (lines() < 3) usleep(200);
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
  const auto kept = lines();
  EXPECT_EQ(say(stability("killed", {"--resume"})).code, 0);
  EXPECT_EQ(say(stability("calm")).code, 0);
  EXPECT_LT(kept, lines()) << "it was killed in the middle";
  EXPECT_EQ(document("killed", "stability").dump(1), document("calm", "stability").dump(1));
}

}  // namespace
}  // namespace plumb::stability_test
