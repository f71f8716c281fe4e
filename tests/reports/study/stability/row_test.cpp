#include "reports/study/stability/row.h"

#include <gtest/gtest.h>

#include "../../fakes.h"

namespace plumb::row_test {
namespace {

constexpr double limit = 3.3;

// Drifts beyond `limit` and topples beyond 7; the engine does not matter.
Trial trial_of(double x) {
  Trial trial{.scene = std::make_shared<const Scene>(fakes::thrown_box()), .dt = 0.5};
  trial.detectors.push_back({"", [x](const ObservedStep& now) {
                               const FailureMode mode = x > 7 ? FailureMode::topples : FailureMode::drifts;
                               const bool fails = x > limit && now.time > 0.9;
                               return fails ? std::optional(DetectorFinding{mode, 0}) : std::nullopt;
                             }});
  return trial;
}

StabilityMap map_of(Axis axis) {
  return {.name = "fake",
          .x = std::move(axis),
          .trials = [](double x, double, const EngineConfig&) { return std::vector<Trial>{trial_of(x)}; },
          .boundaries = {{.name = "stays", .resolution = 0.01},
                         {.name = "stands", .failing = {FailureMode::topples}, .resolution = 0.01}}};
}

MapRow found(const StabilityMap& map, const std::vector<double>& xs, Engine by = fakes::engine("ours")) {
  return measure_row(map, xs, 0, {&by, {}});
}

TEST(MapRow, HasTheOutcomeTimeAndBodyOfEachCell) {
  const MapRow row = found(map_of({.from = 1, .to = 9}), {1, 5, 9});
  EXPECT_EQ(row.cells[0].mode, FailureMode::holds);
  EXPECT_EQ(row.cells[1].mode, FailureMode::drifts);
  EXPECT_EQ(row.cells[1].body, "box");
  EXPECT_EQ(row.cells[1].time, 1);
  EXPECT_EQ(row.cells[2].mode, FailureMode::topples);
}

TEST(MapRow, BisectsEachBoundaryToItsResolution) {
  const MapRow row = found(map_of({.from = 1, .to = 9}), {1, 5, 9});
  EXPECT_LE(*row.brackets[0].low, limit);
  EXPECT_GT(*row.brackets[0].high, limit);
  EXPECT_LE(*row.brackets[0].high - *row.brackets[0].low, 0.01);
  EXPECT_EQ(row.brackets[0].outcome.mode, FailureMode::drifts);
  EXPECT_NEAR(*row.brackets[1].low, 7, 0.01);
  EXPECT_EQ(row.brackets[1].outcome.mode, FailureMode::topples);
}

TEST(MapRow, BisectsIntegersUntilNoneIsBetween) {
  const MapRow row = found(map_of({.from = 1, .to = 9, .whole = true}), {1, 9});
  EXPECT_EQ(row.brackets[0].low, 3);
  EXPECT_EQ(row.brackets[0].high, 4);
}

TEST(MapRow, LeavesABracketOpenIfNothingBoundsIt) {
  const MapRow all_hold = found(map_of({.from = 1, .to = 3}), {1, 2, 3});
  EXPECT_EQ(all_hold.brackets[0].low, 3);
  EXPECT_FALSE(all_hold.brackets[0].high);
  const MapRow none = found(map_of({.from = 4, .to = 9}), {4, 9});
  EXPECT_FALSE(none.brackets[0].low);
  EXPECT_EQ(none.brackets[0].high, 4);
}

TEST(MapRow, DistinguishesNotSupportedFromFailing) {
  Engine picky = fakes::engine("picky");
  picky.unsupported = [](const Scene&, const Settings&) { return "has no boxes"; };
  const MapRow row = found(map_of({.from = 1, .to = 9}), {1, 9}, picky);
  EXPECT_EQ(row.cells[0].mode, FailureMode::not_supported);
  EXPECT_EQ(row.cells[0].why, "has no boxes");
  EXPECT_FALSE(row.brackets[0].low || row.brackets[0].high);
}

TEST(MapRow, DistinguishesDivergenceFromErrors) {
  const StabilityMap map = map_of({.from = 1, .to = 2});
  const MapRow lost = found(map, {1, 2}, fakes::engine("lost", fakes::Stepper::Fault::explosion));
  EXPECT_EQ(lost.cells[0].mode, FailureMode::diverges);
  EXPECT_EQ(lost.cells[0].body, "box");
  EXPECT_EQ(lost.cells[0].time, 1);
  const MapRow thrown = found(map, {1, 2}, fakes::engine("thrown", fakes::Stepper::Fault::exception));
  EXPECT_EQ(thrown.cells[0].mode, FailureMode::fails);
  EXPECT_EQ(thrown.cells[0].why, "the engine gave up");
}

TEST(MapRow, TakesTheWorstTrialOfACell) {
  StabilityMap map = map_of({.from = 1, .to = 9});
  const auto one = map.trials;
  map.trials = [one](double x, double y, const EngineConfig& by) {
    std::vector<Trial> both = one(x, y, by);
    both.push_back(one(x + 5, y, by).front());
    both.push_back(one(1, y, by).front());
    return both;
  };
  EXPECT_EQ(found(map, {1, 3}).cells[1].mode, FailureMode::topples);
}

TEST(Agreement, IsMeasuredFromTheMiddleOfTheBracket) {
  const Boundary boundary{.agreement = 0.1};
  const Agreement near = agreement_of({.from = 0, .to = 9}, boundary, 4.0, 4.2, 4.15);
  EXPECT_TRUE(near.agrees);
  EXPECT_NEAR(*near.difference, 0.05, 1e-12);
  EXPECT_FALSE(agreement_of({.from = 0, .to = 9}, boundary, 4.0, 4.2, 4.3).agrees);
  const Agreement relative = agreement_of({.from = 1, .to = 9, .logarithmic = true}, boundary, 4.0, 4.2, 4.5);
  EXPECT_TRUE(relative.agrees);
  EXPECT_NEAR(*relative.difference, 0.4 / 4.5, 1e-12);
}

TEST(Agreement, OfAnOpenBracketNeedsTheoryOnItsOpenSide) {
  const Boundary boundary{.agreement = 0.1};
  const Axis up{.from = 1, .to = 9};
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(agreement_of(up, boundary, 9.0, std::nullopt, 12).agrees);
  EXPECT_FALSE(agreement_of(up, boundary, 9.0, std::nullopt, 5).agrees);
  EXPECT_TRUE(agreement_of(up, boundary, 9.0, std::nullopt, never).agrees);
  EXPECT_FALSE(agreement_of(up, boundary, 4.0, 4.1, never).agrees);
  EXPECT_TRUE(agreement_of(up, boundary, std::nullopt, 1.0, 0).agrees) << "fails at any x";
  EXPECT_FALSE(agreement_of(up, boundary, std::nullopt, 1.0, 5).agrees);
  const Axis down{.from = 9, .to = 1};
  EXPECT_TRUE(agreement_of(down, boundary, 1.0, std::nullopt, 0.5).agrees);
  EXPECT_FALSE(agreement_of(down, boundary, 1.0, std::nullopt, 5).agrees);
}

}  // namespace
}  // namespace plumb::row_test
