#include "reports/study/methods.h"

#include <gmock/gmock.h>

#include <set>

#include "reports/report.h"

namespace plumb {
namespace {

std::string label(const Method& method) { return label_of(method.config.engine->name, method.config.method()); }

TEST(Methods, AreThoseThatEnginesStateEachOnceOursFirst) {
  const std::vector<Method> all = default_methods();
  std::set<std::string> labels;
  for (const Method& method : all) EXPECT_TRUE(labels.insert(label(method)).second) << label(method);
  EXPECT_EQ(label(all.front()), "impulse");
  EXPECT_THAT(labels, ::testing::IsSupersetOf({"impulse:solver=xpbd", "impulse:solver=exact,integrator=rk4"}));
}

TEST(Methods, AskedForByNameHaveTheLadderOfTheirOwnMethod) {
  const std::vector<Method> asked = methods_asked({"impulse", "impulse:solver=split-impulse", "impulse:substeps=2"});
  ASSERT_EQ(asked.size(), 3u);
  EXPECT_EQ(asked[0].ladder.option, "substeps");
  EXPECT_EQ(asked[1].ladder.option, "iterations");
  EXPECT_EQ(asked[2].ladder.option, "") << "it says itself how hard it works";
  EXPECT_THROW(methods_asked({"impluse"}), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
