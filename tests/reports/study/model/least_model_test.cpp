#include "reports/study/model/least_model.h"

#include <gtest/gtest.h>

#include <set>

#include "reports/run/selection.h"

namespace plumb::least_model_test {
namespace {

// Features whose drops each save a fraction of the remaining cost; some drops may be insufficient.
struct FakeModels {
  std::vector<std::vector<double>> saves;  // by feature and step
  std::function<bool(const FeatureLevels&)> sufficient = [](const FeatureLevels&) { return true; };
  double worth = 0.03;
  int costs_measured = 0;

  double cost(const FeatureLevels& levels) const {
    double cost = 1;
    for (std::size_t f = 0; f < levels.size(); ++f) {
      if (levels[f] > 0) cost *= 1 - saves[f][levels[f] - 1];
    }
    return cost;
  }
  FeatureLevels least() {
    std::vector<FeatureDrop> drops;
    for (std::size_t f = 0; f < saves.size(); ++f) {
      for (std::size_t step = 1; step <= saves[f].size(); ++step) drops.push_back({f, step, ""});
    }
    const auto ratio = [this](const FeatureLevels& a, const FeatureLevels& b) {
      ++costs_measured;
      return cost(a) / cost(b);
    };
    const auto cheaper = [&](const FeatureLevels& a, const FeatureLevels& b) { return ratio(a, b) < 1 - worth; };
    return least_model(drops, saves.size(), {sufficient, ratio, cheaper});
  }
};

TEST(LeastModel, DropsAllThatIsNotNeededAndKeepsTheRest) {
  FakeModels models{{{0.5}, {0.3}, {0.2}}, [](const FeatureLevels& levels) { return levels[1] == 0; }};
  EXPECT_EQ(models.least(), (FeatureLevels{1, 0, 1}));
}

TEST(LeastModel, TakesTheCheapestSufficientStep) {
  FakeModels models{{{0.1, 0.6, 0.4}}};
  EXPECT_EQ(models.least(), (FeatureLevels{2}));
  models.sufficient = [](const FeatureLevels& levels) { return levels[0] != 2; };
  EXPECT_EQ(models.least(), (FeatureLevels{3}));
}

TEST(LeastModel, DropsFirstWhatSavesMostIfTwoExcludeEachOther) {
  FakeModels models{{{0.2}, {0.5}}, [](const FeatureLevels& levels) { return levels[0] + levels[1] < 2; }};
  EXPECT_EQ(models.least(), (FeatureLevels{0, 1}));
}

TEST(LeastModel, KeepsWhatSavesNothing) {
  FakeModels models{{{0.0}, {-0.5}, {0.02}}};
  EXPECT_EQ(models.least(), (FeatureLevels{0, 0, 0}));
}

// The drop that saves most by itself may save nothing together with another.
TEST(LeastModel, RestoresAFeatureWhoseDropHasBecomeRedundant) {
  const auto cost = [](const FeatureLevels& levels) { return levels[1] > 0 ? 0.5 : levels[0] > 0 ? 0.7 : 1.0; };
  const auto ratio = [&](const FeatureLevels& a, const FeatureLevels& b) {
    return a == FeatureLevels{1, 0} && b == FeatureLevels{0, 0} ? 0.3 : cost(a) / cost(b);
  };
  const auto cheaper = [&](const FeatureLevels& a, const FeatureLevels& b) { return cost(a) < cost(b); };
  EXPECT_EQ(least_model({{0, 1, ""}, {1, 1, ""}}, 2, {[](const FeatureLevels&) { return true; }, ratio, cheaper}),
            (FeatureLevels{0, 1}));
}

TEST(LeastModel, MeasuresNoCostOfInsufficientModels) {
  FakeModels models{{{0.5}, {0.3}}, [](const FeatureLevels& levels) { return levels == FeatureLevels{0, 0}; }};
  EXPECT_EQ(models.least(), (FeatureLevels{0, 0}));
  EXPECT_EQ(models.costs_measured, 0);
}

TEST(LeastModel, KeepsWhatItHasFoundWhenTimeIsOut) {
  int trials = 0;
  const auto ratio = [](const FeatureLevels& a, const FeatureLevels&) { return a[0] > 0 ? 0.5 : 0.7; };
  const ModelTrials limited{.sufficient = [&](const FeatureLevels&) { return ++trials > 0; },
                            .cost_ratio = ratio,
                            .cheaper = [](const FeatureLevels&, const FeatureLevels&) { return true; },
                            .out_of_time = [&] { return trials >= 3; }};
  EXPECT_EQ(least_model({{0, 1, ""}, {1, 1, ""}}, 2, limited), (FeatureLevels{1, 0}));
}

TEST(LeastModel, TriesNoDropThatSavesNothingIfJudgingIsSlow) {
  std::vector<FeatureLevels> judged;
  const ModelTrials trials{
      .sufficient = [&](const FeatureLevels& levels) { return judged.push_back(levels), true; },
      .cost_ratio = [](const FeatureLevels& a, const FeatureLevels&) { return a[0] > 0 ? 0.5 : 1.2; },
      .cheaper = [](const FeatureLevels& a, const FeatureLevels& b) { return a[0] > b[0]; },
      .slow_to_judge = true};
  EXPECT_EQ(least_model({{0, 1, ""}, {1, 1, ""}}, 2, trials), (FeatureLevels{1, 0}));
  for (const FeatureLevels& levels : judged) EXPECT_EQ(levels[1], 0u);
}

FeatureLevels none() { return FeatureLevels(model_features().size(), 0); }

TEST(ModelFeatures, KeepTheFullModelAtLevelZero) {
  const EngineConfig full = parse_engine("impulse:substeps=8");
  EXPECT_EQ(model_at(full, none()).settings, full.settings);
}

TEST(ModelFeatures, HaveSingleDropsThatAllDifferFromTheFullModelAndFromEachOther) {
  const EngineConfig full = parse_engine("impulse");
  std::set<Settings> seen{full.settings};
  for (const FeatureDrop& drop : single_drops(full)) {
    FeatureLevels levels = none();
    levels[drop.feature] = drop.step;
    EXPECT_TRUE(seen.insert(model_at(full, levels).settings).second) << drop.setting;
  }
  EXPECT_GT(seen.size(), 15U);
}

TEST(ModelFeatures, DropNothingThatTheFullModelDoesNotHave) {
  for (const FeatureDrop& drop : single_drops(parse_engine("impulse:float,substeps=2"))) {
    EXPECT_NE(drop.setting, "precision=float");
    EXPECT_NE(drop.setting, "substeps=2");
  }
}

TEST(ModelFeatures, CombineSingleDrops) {
  const EngineConfig full = parse_engine("impulse");
  FeatureLevels levels = none();
  for (const FeatureDrop& drop : single_drops(full)) {
    if (drop.setting == "contacts=off" || drop.setting == "precision=float") levels[drop.feature] = drop.step;
  }
  EXPECT_EQ(model_at(full, levels).settings, parse_engine("impulse:contacts=off,precision=float").settings);
}

}  // namespace
}  // namespace plumb::least_model_test
