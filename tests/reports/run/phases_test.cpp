#include "reports/run/phases.h"

#include <gmock/gmock.h>

#include "reports/run/experiment.h"
#include "reports/run/selection.h"
#include "reports/vec.h"
#include "reports/writers/json.h"

namespace plumb {
namespace {

constexpr double dt = 1.0 / 60;

TEST(Phases, BeginWithTheCaseAsItIsAndFillAStepEvenly) {
  const auto all = phases(parse_case("bounce"), 8);
  ASSERT_EQ(all.size(), 8u);
  EXPECT_EQ(all.front().first_step, 1);
  std::vector<double> shares;
  for (const Case& one : all) shares.push_back(one.first_step);
  std::sort(shares.begin(), shares.end());
  double before = 0;
  for (const double share : shares) {
    EXPECT_GT(share, before);
    EXPECT_LT(share - before, 2.0 / 8) << "an even filling has gaps of 1/8";
    before = share;
  }
  EXPECT_EQ(phases(parse_case("bounce"), 1).size(), 1u);
}

TEST(Phases, EndWithTheScene) {
  const Case asked = parse_case("bounce");
  for (const Case& one : phases(asked, 5)) {
    const Outcome outcome = run(*one.scene, parse_engine("impulse"), dt, one.first_step);
    ASSERT_EQ(outcome.status, Status::ok);
    EXPECT_DOUBLE_EQ(outcome.trace->time(1), one.first_step * dt);
    EXPECT_NEAR(outcome.trace->times().back(), asked.scene->duration, 1e-9);
  }
}

Judgement judged(const Case& asked, const EngineConfig& config) {
  const Truth truth(*asked.closed_form, *asked.scene);
  const Outcome outcome = run(*asked.scene, config, dt);
  return judge_case(asked, config, dt, *outcome.trace, &truth);
}

// An impact that is noticed at the end of its step is late by anything from nothing to a step; one that is solved for
// is not late at all.
TEST(Phases, SpreadTheErrorOfImpactsNoticedLate) {
  const Case asked = parse_cases("head-on:e=0.5").front();
  const Judgement late = judged(asked, parse_engine("impulse:solver=article"));
  const Judgement exact = judged(asked, parse_engine("impulse"));
  EXPECT_EQ(late.verdict, Verdict::right);
  ASSERT_EQ(late.checks.size(), 4u);
  const TruthCheck& place = late.checks[1];
  ASSERT_EQ(place.quantity, "x");
  ASSERT_TRUE(place.spread);
  EXPECT_EQ(place.spread->phases, judged_phases);
  EXPECT_EQ(place.error, place.spread->max) << "the worst phase is judged";
  EXPECT_LT(place.spread->min, 0.3 * place.spread->max);
  EXPECT_LE(place.spread->min, place.spread->median);
  EXPECT_LE(place.spread->median, place.spread->max);
  EXPECT_LT(exact.checks[1].spread->max, 1e-12);
}

TEST(Phases, AreWrongIfOneIs) {
  const Case asked = parse_cases("corner-impact:e=1").front();
  Engine lucky = *Catalog<Engine>::find("impulse");
  // Right as long as nothing but whole steps is asked of it.
  class Lucky : public Simulation {
   public:
    explicit Lucky(std::unique_ptr<Simulation> with) : with_(std::move(with)) {}
    void step(double h) override {
      with_->step(h);
      broken_ = broken_ || std::abs(h - dt) > 1e-9;
    }
    void read(std::span<BodyState> out) const override {
      with_->read(out);
      if (broken_) out.back().velocity.y += 1;
    }

   private:
    std::unique_ptr<Simulation> with_;
    bool broken_ = false;
  };
  lucky.build = [](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
    return std::make_unique<Lucky>(Catalog<Engine>::find("impulse")->build(scene, settings));
  };
  const Judgement judgement = judged(asked, {&lucky, complete(lucky, {})});
  EXPECT_EQ(judgement.verdict, Verdict::wrong);
  EXPECT_FALSE(judgement.checks[0].passed);
  EXPECT_LT(judgement.checks[0].spread->min, 1e-9);
  EXPECT_NEAR(judgement.checks[0].spread->max, 1, 1e-9);
}

TEST(Phases, AreInTheReportOfAFamilyThatHasThem) {
  Plan plan{.cases = {parse_cases("head-on:e=0.5").front(), parse_cases("spring").front()},
            .configs = {parse_engine("impulse")}};
  const auto json = to_json(carry_out(plan, [](const std::string&, std::size_t, std::size_t) {}));
  EXPECT_EQ(json["runs"][1]["truth"][0]["phases"]["count"], judged_phases);
  EXPECT_TRUE(json["runs"][3]["truth"][0]["phases"].is_null());
}

}  // namespace
}  // namespace plumb
