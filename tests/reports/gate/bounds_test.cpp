#include "reports/gate/bounds.h"

#include <gmock/gmock.h>

#include <limits>

#include "../fakes.h"
#include "reports/gate/compare.h"

namespace plumb {
namespace {

constexpr auto silent = [](const std::string&, std::size_t, std::size_t) {};

// The throw, its gravity and its start changed a little.
struct Thrown {
  Scenario scenario = fakes::throwing();
  Engine free_flight = fakes::free_flight();
  Engine engine = fakes::engine("ours");

  Plan plan(double gravity = 1, double moved = 0) const {
    Case asked = fakes::case_of(scenario, &free_flight);
    Scene scene = *asked.scene;
    scene.gravity.y *= gravity;
    scene.bodies[0].position.y += moved;
    asked.scene = std::make_shared<const Scene>(scene);
    return {.cases = {asked}, .configs = {{&engine, {}}}, .timed = false};
  }
  static Baseline on(const char* platform, const Plan& plan) {
    Report report = run_experiment(plan, silent);
    report.environment["libm"] = platform;
    return baseline_of(report);
  }
  Baseline accepted() const {
    Baseline baseline = on("one", plan());
    find_bounds(plan(), baseline, silent);
    return baseline;
  }
};

TEST(Bounds, AreKnownForEveryNumberAndNarrowWhereNothingGrows) {
  const Thrown thrown;
  const Baseline baseline = thrown.accepted();
  ASSERT_EQ(baseline.runs.size(), 2u) << "the engine and the closed form";
  for (const auto& [key, run] : baseline.runs) {
    EXPECT_FALSE(run.numbers.empty()) << key.text();
    for (const auto& [name, number] : run.numbers) {
      ASSERT_TRUE(number.moves) << name;
      EXPECT_LT(*number.moves, 1e-6) << key.text() << ": " << name;
      EXPECT_FALSE(number.wavers) << name;
    }
  }
  EXPECT_EQ(baseline.runs.at({"throw", "as it is", "ours", ""}).neighbours, std::set<Verdict>{Verdict::right});
}

TEST(Bounds, LetPassWhatRoundingMayDoAndNothingMore) {
  const Thrown thrown;
  const Baseline before = thrown.accepted();
  EXPECT_TRUE(compare(before, Thrown::on("another", thrown.plan(1, 1e-13))).passed());
  const GateResult weaker = compare(before, Thrown::on("another", thrown.plan(0.999)));
  EXPECT_EQ(caught_by(weaker, {"throw", "as it is", "ours", ""}), Rule::bound);
}

TEST(Bounds, AreTheSameForAnyNumberOfJobs) {
  const Thrown thrown;
  Baseline one = thrown.accepted();
  Baseline three = one;
  for (auto& [key, run] : three.runs) {
    for (auto& [name, number] : run.numbers) number.moves.reset();
  }
  Plan plan = thrown.plan();
  plan.jobs = 3;
  find_bounds(plan, three, silent);
  for (const auto& [key, run] : one.runs) EXPECT_EQ(run.numbers, three.runs.at(key).numbers) << key.text();
}

// Falls to the left or to the right, by the last bits of where it starts.
class OnAnEdge : public Simulation {
 public:
  explicit OnAnEdge(const Scene& scene) : states_(initial_states(scene)), side_(states_[0].position.x > 1 ? 1 : -1) {}
  void step(double dt) override { states_[0].position.x += side_ * dt; }
  void read(std::span<BodyState> out) const override { out[0] = states_[0]; }

 private:
  std::vector<BodyState> states_;
  double side_;
};

TEST(Bounds, AreWideWhereStartsNextToEachOtherPart) {
  Thrown thrown;
  thrown.engine.build = [](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
    return std::make_unique<OnAnEdge>(scene);
  };
  const Baseline baseline = thrown.accepted();
  const KeptRun& run = baseline.runs.at({"throw", "as it is", "ours", ""});
  EXPECT_GT(*run.numbers.at("truth_error_end").moves, 0.1);
}

}  // namespace
}  // namespace plumb
