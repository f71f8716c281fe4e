#include "reports/study/model/least_model.h"

#include <gtest/gtest.h>

#include <numeric>

namespace plumb {
namespace {

// Features of which each drop saves a share of what is left of the cost, and some must not go.
struct World {
  std::vector<std::vector<double>> saves;  // by feature and rung
  std::function<bool(const Levels&)> sufficient = [](const Levels&) { return true; };
  double worth = 0.03;
  int costs_asked = 0;

  double cost(const Levels& levels) const {
    double cost = 1;
    for (std::size_t f = 0; f < levels.size(); ++f) {
      if (levels[f] > 0) cost *= 1 - saves[f][levels[f] - 1];
    }
    return cost;
  }
  Levels least() {
    std::vector<Drop> drops;
    for (std::size_t f = 0; f < saves.size(); ++f) {
      for (std::size_t rung = 1; rung <= saves[f].size(); ++rung) drops.push_back({f, rung, ""});
    }
    const auto ratio = [this](const Levels& a, const Levels& b) {
      ++costs_asked;
      return cost(a) / cost(b);
    };
    const auto cheaper = [&](const Levels& a, const Levels& b) { return ratio(a, b) < 1 - worth; };
    return least_model(drops, saves.size(), {sufficient, ratio, cheaper});
  }
};

TEST(LeastModel, DropsAllThatIsNotNeededAndKeepsWhatIs) {
  World world{{{0.5}, {0.3}, {0.2}}, [](const Levels& levels) { return levels[1] == 0; }};
  EXPECT_EQ(world.least(), (Levels{1, 0, 1}));
}

TEST(LeastModel, TakesTheCheapestRungThatWillDo) {
  World world{{{0.1, 0.6, 0.4}}};
  EXPECT_EQ(world.least(), (Levels{2}));
  world.sufficient = [](const Levels& levels) { return levels[0] != 2; };
  EXPECT_EQ(world.least(), (Levels{3}));
}

TEST(LeastModel, DropsFirstWhatSavesMostWhereTwoMayNotBothGo) {
  World world{{{0.2}, {0.5}}, [](const Levels& levels) { return levels[0] + levels[1] < 2; }};
  EXPECT_EQ(world.least(), (Levels{0, 1}));
}

TEST(LeastModel, KeepsWhatSavesNothing) {
  World world{{{0.0}, {-0.5}, {0.02}}};
  EXPECT_EQ(world.least(), (Levels{0, 0, 0}));
}

// What seems to save the most alone may save nothing beside another.
TEST(LeastModel, PutsBackWhatAnotherDropHasMadeUseless) {
  const auto cost = [](const Levels& levels) { return levels[1] > 0 ? 0.5 : levels[0] > 0 ? 0.7 : 1.0; };
  const auto ratio = [&](const Levels& a, const Levels& b) {
    return a == Levels{1, 0} && b == Levels{0, 0} ? 0.3 : cost(a) / cost(b);
  };
  const auto cheaper = [&](const Levels& a, const Levels& b) { return cost(a) < cost(b); };
  EXPECT_EQ(least_model({{0, 1, ""}, {1, 1, ""}}, 2, {[](const Levels&) { return true; }, ratio, cheaper}),
            (Levels{0, 1}));
}

TEST(LeastModel, AsksNoCostOfWhatWillNotDo) {
  World world{{{0.5}, {0.3}}, [](const Levels& levels) { return levels == Levels{0, 0}; }};
  EXPECT_EQ(world.least(), (Levels{0, 0}));
  EXPECT_EQ(world.costs_asked, 0);
}

}  // namespace
}  // namespace plumb
