#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../fakes.h"
#include "reports/compare/comparator.h"

namespace plumb::comparator_test {
namespace {

RunRecord record(const std::string& engine, std::initializer_list<double> xs, Verdict verdict = Verdict::plausible) {
  const auto trace = std::make_shared<Trace>(1);
  for (const double x : xs) {
    const BodyState state{.position = {x, 0}, .velocity = {x, 0}};
    trace->record(static_cast<double>(trace->size()), std::span(&state, 1), {});
  }
  // 2 kg at 1 m/s: the scales are 1 J and 2 kg m/s.
  Scene scene{.gravity = {0, 0}, .bodies = {{.name = "box", .shapes = {{.geometry = Box{.size = {1, 2}}}}}}};
  scene.bodies[0].velocity = {1, 0};
  return {.scenario = "slide",
          .variant = "one",
          .engine = engine,
          .verdict = verdict,
          .scene = std::make_shared<const Scene>(scene),
          .trace = trace};
}

// The same, with something to rest on.
RunRecord on_ground(RunRecord run) {
  Scene scene = *run.scene;
  scene.bodies.push_back({.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}});
  const auto trace = std::make_shared<Trace>(2);
  for (std::size_t i = 0; i < run.trace->size(); ++i) {
    const BodyState states[] = {run.trace->states(i)[0], {}};
    trace->record(run.trace->time(i), states, {});
  }
  run.scene = std::make_shared<const Scene>(scene);
  run.trace = trace;
  return run;
}

TEST(Compare, ComparesEveryTwoEnginesAndAllWithTheTruth) {
  RunRecord truth = record("exact", {0, 0}, Verdict::right);
  truth.exact = true;
  RunRecord method = record("ours", {0, 0});
  method.method = "solver=b";
  const std::vector<RunRecord> runs{truth, record("ours", {0, 0}), record("rival", {0, 0}), method};
  std::vector<std::string> pairs;
  for (const Comparison& one : compare(runs, nullptr)) pairs.push_back(one.a + " - " + one.b);
  EXPECT_THAT(pairs, ::testing::ElementsAre("ours - exact", "rival - exact", "ours:solver=b - exact", "ours - rival",
                                            "ours - ours:solver=b", "rival - ours:solver=b"));
}

TEST(Compare, MeasuresDifferencesOverTimeAndAtTheEnd) {
  RunRecord a = record("ours", {0, 3, 4});
  RunRecord b = record("rival", {0, 0, 3});
  a.metrics["penetration_max"] = {0.3, "m"};
  b.metrics["penetration_max"] = {0.1, "m"};
  const Comparison one = compare(std::vector{a, b}, nullptr).at(0);
  EXPECT_DOUBLE_EQ(one.metrics.at("position_difference_max").value, 3);
  EXPECT_DOUBLE_EQ(one.metrics.at("position_difference_rms").value, std::sqrt(10 / 3.0));
  EXPECT_DOUBLE_EQ(one.metrics.at("position_difference_end").value, 1);
  EXPECT_DOUBLE_EQ(one.metrics.at("energy_difference_max").value, 9);  // 2 kg: E = v^2
  EXPECT_DOUBLE_EQ(one.metrics.at("energy_difference_end").value, 16 - 9);
  EXPECT_DOUBLE_EQ(one.metrics.at("momentum_difference_max").value, 6);
  EXPECT_DOUBLE_EQ(one.metrics.at("penetration_max_difference").value, 0.3 - 0.1);
}

TEST(Compare, DividesDifferencesByTheScalesOfTheScene) {
  RunRecord a = record("ours", {0, 3, 4});
  RunRecord b = record("rival", {0, 0, 3});
  a.metrics["penetration_max"] = {0.3, "m"};
  const KeyDifferences key = *compare(std::vector{a, b}, nullptr).at(0).key;
  EXPECT_DOUBLE_EQ(key.energy.largest, 9);
  EXPECT_DOUBLE_EQ(key.energy.end, 7);
  EXPECT_DOUBLE_EQ(key.energy_scale, 1);
  EXPECT_DOUBLE_EQ(key.momentum.largest, 3);
  EXPECT_DOUBLE_EQ(key.momentum.end, 1);
  EXPECT_DOUBLE_EQ(key.momentum_scale, 2);
  EXPECT_EQ(key.angular_momentum.largest, 0) << "all on one line through the origin";
  EXPECT_EQ(key.overlap_a, 0.3);
  EXPECT_EQ(key.overlap_b, std::nullopt);
  EXPECT_EQ(key.diverged_at, 1);
}

TEST(Compare, SaysWhichRunCameToRestAndWhen) {
  const auto key = [](std::initializer_list<double> a, std::initializer_list<double> b) {
    return *compare(std::vector{on_ground(record("ours", a)), on_ground(record("rival", b))}, nullptr).at(0).key;
  };
  const KeyDifferences one = key({5, 5, 0, 0}, {5, 0, 0, 5});
  EXPECT_EQ(one.rest_a, 2);
  EXPECT_EQ(one.rest_b, std::nullopt) << "at rest in between does not count";
  EXPECT_STREQ(resting(one), "one");
  const KeyDifferences both = key({5, 5, 0}, {0, 0, 0});
  EXPECT_EQ(both.rest_a, 2);
  EXPECT_EQ(both.rest_b, 0);
  EXPECT_STREQ(resting(both), "both");
  EXPECT_STREQ(resting(key({5, 5}, {5, 5})), "none");
}

TEST(Compare, HasNoDivergenceTimeForRunsThatStayTogether) {
  const auto one = compare(std::vector{record("ours", {0, 1}), record("rival", {0, 1.001})}, nullptr).at(0);
  EXPECT_EQ(one.key->diverged_at, std::nullopt);
}

TEST(Compare, ComparesUpToTheEndOfTheShorterRun) {
  const auto one = compare(std::vector{record("ours", {0, 0, 0, 9}), record("rival", {0, 0})}, nullptr).at(0);
  EXPECT_EQ(one.metrics.at("position_difference_max").value, 0);
}

TEST(Compare, HasTheWorseVerdictOfTheTwo) {
  const auto verdict = [](Verdict a, Verdict b) {
    return compare(std::vector{record("ours", {0, 0}, a), record("rival", {0, 0}, b)}, nullptr).at(0);
  };
  EXPECT_EQ(verdict(Verdict::right, Verdict::right).verdict, Verdict::right);
  EXPECT_EQ(verdict(Verdict::right, Verdict::plausible).verdict, Verdict::plausible);
  EXPECT_EQ(verdict(Verdict::right, Verdict::wrong).verdict, Verdict::wrong);
  EXPECT_EQ(verdict(Verdict::right, Verdict::wrong).reason, "rival: wrong");
}

TEST(Compare, MeasuresNothingIfARunFailed) {
  RunRecord failed = record("rival", {0, 0}, Verdict::failed);
  failed.status = Status::failed;
  failed.reason = "diverged";
  const Comparison one = compare(std::vector{record("ours", {0, 0}), failed}, nullptr).at(0);
  EXPECT_EQ(one.verdict, Verdict::failed);
  EXPECT_EQ(one.reason, "rival: diverged");
  EXPECT_TRUE(one.metrics.empty());
  EXPECT_FALSE(one.key);
}

}  // namespace
}  // namespace plumb::comparator_test
