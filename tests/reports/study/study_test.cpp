#include "reports/study/study.h"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

#include "reports/report.h"
#include "reports/run/selection.h"
#include "reports/study/job.h"

namespace plumb::study_test {
namespace {

std::string label(const Method& method) { return label_of(method.config.engine->name, method.config.method()); }

TEST(Methods, AreThoseThatEnginesListEachOnceOursFirst) {
  const std::vector<Method> all = default_methods();
  std::set<std::string> labels;
  for (const Method& method : all) EXPECT_TRUE(labels.insert(label(method)).second) << label(method);
  EXPECT_EQ(label(all.front()), "impulse");
  EXPECT_THAT(labels, ::testing::IsSupersetOf({"impulse:solver=xpbd", "impulse:solver=exact,integrator=rk4"}));
}

TEST(Methods, SelectedByNameHaveTheLadderOfTheirMethod) {
  const std::vector<Method> named = select_methods({"impulse", "impulse:solver=split-impulse", "impulse:substeps=2"});
  ASSERT_EQ(named.size(), 3u);
  EXPECT_EQ(named[0].ladder.option, "substeps");
  EXPECT_EQ(named[1].ladder.option, "iterations");
  EXPECT_EQ(named[2].ladder.option, "") << "the word itself sets how hard it works";
  EXPECT_THROW(select_methods({"impluse"}), std::invalid_argument);
}

TEST(HashOfCases, DependsOnTheirScenes) {
  const auto cases = [](const char* word) { return select_cases({word}, false, {}); };
  EXPECT_EQ(hash_of(cases("spring:w=4")), hash_of(cases("spring:w=4")));
  EXPECT_NE(hash_of(cases("spring:w=4")), hash_of(cases("spring:w=15")));
}

TEST(RequireDistinctKeys, NamesAKeyThatOccursTwice) {
  const std::vector<Job> jobs{{.key = "a"}, {.key = "b"}, {.key = "a"}};
  try {
    require_distinct_keys(jobs);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\"a\""));
  }
}

}  // namespace
}  // namespace plumb::study_test
