#include "reports/gate/baseline.h"

#include <gmock/gmock.h>

#include <cmath>

#include "../writers/sample.h"

namespace plumb::baseline_test {
namespace {

Trace trace_of(const BodyState& state, const ContactState& contact) {
  Trace trace(1);
  trace.record(0, std::span(&state, 1), {});
  trace.record(0.5, std::span(&state, 1), std::span(&contact, 1));
  return trace;
}

TEST(HashOfATrace, DependsOnEveryBit) {
  const BodyState state{.position = {1, 2}, .angle = 3, .velocity = {4, 5}, .angular_velocity = 6};
  const ContactState contact{.a = 1, .b = 2, .point = {1, 1}, .normal = {0, 1}, .normal_impulse = 7};
  const std::string hash = hash_of(trace_of(state, contact));
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(hash, hash_of(trace_of(state, contact)));
  const auto up = [](double& number) { number = std::nextafter(number, 100); };
  for (double BodyState::*number : {&BodyState::angle, &BodyState::angular_velocity}) {
    BodyState other = state;
    up(other.*number);
    EXPECT_NE(hash_of(trace_of(other, contact)), hash);
  }
  for (Vec BodyState::*vector : {&BodyState::position, &BodyState::velocity}) {
    BodyState other = state;
    up((other.*vector).y);
    EXPECT_NE(hash_of(trace_of(other, contact)), hash);
  }
  for (double ContactState::*number :
       {&ContactState::normal_impulse, &ContactState::tangent_impulse, &ContactState::separation}) {
    ContactState other = contact;
    up(other.*number);
    EXPECT_NE(hash_of(trace_of(state, other)), hash);
  }
  ContactState other = contact;
  other.b = 3;
  EXPECT_NE(hash_of(trace_of(state, other)), hash);
}

TEST(BaselineRunOf, HasEveryMetricAndCheck) {
  const Report report = sample_report();
  const BaselineRun run = baseline_run_of(report.runs[1]);
  EXPECT_EQ(run.verdict, Verdict::wrong);
  EXPECT_EQ(run.numbers.at("energy_rise").unit, "1");
  EXPECT_EQ(run.numbers.at("truth: x of box, \"the\" first at 2 s").status, CheckStatus::broken);
  EXPECT_EQ(run.numbers.at("invariant: cone").status, CheckStatus::not_reported);
  EXPECT_EQ(run.numbers.at("invariant: push").value, 0.5);
  EXPECT_EQ(run.numbers.size(), 5u);
}

TEST(BaselineRunOf, LeavesOutTheHorizonBecauseItNeedsAnEnsemble) {
  RunRecord run;
  run.metrics = {{"horizon", {0.9, "s"}}, {"energy_rise", {0.1, "1"}}};
  EXPECT_EQ(baseline_run_of(run).numbers.size(), 1u);
}

TEST(BaselineRunOf, NamesEventsWithoutTheirTime) {
  RunRecord run;
  for (const double time : {0.5, 0.75}) {
    run.truth.push_back({.body = "ball", .quantity = name_of(Quantity::apex), .time = time});
  }
  const BaselineRun all = baseline_run_of(run);
  EXPECT_EQ(all.numbers.count(std::string("truth: ") + name_of(Quantity::apex) + " of ball"), 1u);
  EXPECT_EQ(all.numbers.count(std::string("truth: ") + name_of(Quantity::apex) + " of ball (2)"), 1u);
}

TEST(BaselineOfAReport, HasEveryRunAndItsPlatform) {
  Report report = sample_report();
  report.environment = {{"compiler", "some"}, {"processor", "any"}};
  report.engines = {{.name = "lost", .source = "1.0"}, {.name = "sliding", .source = "a book", .exact = true}};
  const Baseline baseline = baseline_of(report);
  EXPECT_EQ(baseline.runs.size(), 3u);
  EXPECT_EQ(baseline.dt, 1.0 / 60);
  EXPECT_EQ(baseline.platform, (std::map<std::string, std::string>{{"compiler", "some"}}));
  EXPECT_EQ(baseline.engines, (std::map<std::string, std::string>{{"lost", "1.0"}}));
  const BaselineRun& failed = baseline.runs.at({"slide", "on ice", "lost", ""});
  EXPECT_EQ(failed.bits, "");
  EXPECT_THAT(failed.reason, ::testing::HasSubstr("diverged"));
}

}  // namespace
}  // namespace plumb::baseline_test
