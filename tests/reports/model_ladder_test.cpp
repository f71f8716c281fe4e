#include "reports/model_ladder.h"

#include <gtest/gtest.h>

#include <set>

#include "reports/cli.h"

namespace plumb {
namespace {

Levels none() { return Levels(model_features().size(), 0); }

TEST(ModelLadder, LeavesTheFullModelAsItIsAtTheTop) {
  const Entrant full = parse_entrant("impulse:substeps=8");
  EXPECT_EQ(model_at(full, none()).settings, full.settings);
}

TEST(ModelLadder, HasSingleDropsThatAllDifferFromTheFullModelAndFromEachOther) {
  const Entrant full = parse_entrant("impulse");
  std::set<Settings> seen{full.settings};
  for (const Drop& drop : single_drops(full)) {
    Levels levels = none();
    levels[drop.feature] = drop.rung;
    EXPECT_TRUE(seen.insert(model_at(full, levels).settings).second) << drop.setting;
  }
  EXPECT_GT(seen.size(), 15U);
}

TEST(ModelLadder, DropsNothingThatAFullModelDoesNotHave) {
  for (const Drop& drop : single_drops(parse_entrant("impulse:float,substeps=2"))) {
    EXPECT_NE(drop.setting, "precision=float");
    EXPECT_NE(drop.setting, "substeps=2");
  }
}

TEST(ModelLadder, DropsTogetherWhatIsDroppedApart) {
  const Entrant full = parse_entrant("impulse");
  Levels levels = none();
  for (const Drop& drop : single_drops(full)) {
    if (drop.setting == "contacts=off" || drop.setting == "precision=float") levels[drop.feature] = drop.rung;
  }
  EXPECT_EQ(model_at(full, levels).settings, parse_entrant("impulse:contacts=off,precision=float").settings);
}

}  // namespace
}  // namespace plumb
