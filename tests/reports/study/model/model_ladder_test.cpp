#include "reports/study/model/model_ladder.h"

#include <gtest/gtest.h>

#include <set>

#include "reports/run/selection.h"

namespace plumb {
namespace {

Levels none() { return Levels(model_features().size(), 0); }

TEST(ModelLadder, LeavesTheFullModelAsItIsAtTheTop) {
  const EngineConfig full = parse_engine("impulse:substeps=8");
  EXPECT_EQ(model_at(full, none()).settings, full.settings);
}

TEST(ModelLadder, HasSingleDropsThatAllDifferFromTheFullModelAndFromEachOther) {
  const EngineConfig full = parse_engine("impulse");
  std::set<Settings> seen{full.settings};
  for (const Drop& drop : single_drops(full)) {
    Levels levels = none();
    levels[drop.feature] = drop.rung;
    EXPECT_TRUE(seen.insert(model_at(full, levels).settings).second) << drop.setting;
  }
  EXPECT_GT(seen.size(), 15U);
}

TEST(ModelLadder, DropsNothingThatAFullModelDoesNotHave) {
  for (const Drop& drop : single_drops(parse_engine("impulse:float,substeps=2"))) {
    EXPECT_NE(drop.setting, "precision=float");
    EXPECT_NE(drop.setting, "substeps=2");
  }
}

TEST(ModelLadder, DropsTogetherWhatIsDroppedApart) {
  const EngineConfig full = parse_engine("impulse");
  Levels levels = none();
  for (const Drop& drop : single_drops(full)) {
    if (drop.setting == "contacts=off" || drop.setting == "precision=float") levels[drop.feature] = drop.rung;
  }
  EXPECT_EQ(model_at(full, levels).settings, parse_engine("impulse:contacts=off,precision=float").settings);
}

}  // namespace
}  // namespace plumb
