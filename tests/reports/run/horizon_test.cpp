#include "reports/run/horizon.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "reports/run/experiment.h"
#include "reports/run/selection.h"
#include "scenarios/images.h"

namespace plumb::horizon_test {
namespace {

using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr double frame = 1.0 / 60;
constexpr Stepping first_order{.dt = frame, .h = frame, .drift = 0.5, .order = 1, .impact_lag = 1};

TEST(Growth, IsAboutOneInFreeFall) {
  const Scene scene = *parse_cases("bounce:e=0.8").front().scene;
  const Growth growth(scene, frame, 0.5);
  const std::size_t moment = 30;
  const double drift = growth.own_error(first_order, moment).place;
  EXPECT_NEAR(drift, 10 * 0.5 * frame / 2, 1e-9);
  const std::size_t disc = scene.bodies[0].type == BodyType::dynamic ? 0 : 1;
  const auto shift = growth.allowance(first_order, moment, disc);
  ASSERT_TRUE(shift);
  EXPECT_GE(shift->place, drift);
  EXPECT_LE(shift->place, 5 * drift);
}

TEST(Growth, IsLargeInAChaoticScene) {
  const Scene scene = *parse_cases("double-pendulum:wild").front().scene;
  const Growth growth(scene, frame, 2.5);
  const auto amplified = [&](std::size_t moment) {
    Stepping fine = first_order;
    fine.h = 1e-6;
    return growth.allowance(fine, moment, 2)->place / growth.own_error(fine, moment).place;
  };
  EXPECT_GT(amplified(149), 3 * amplified(6));
}

TEST(Growth, AllowsNothingLargerThanWhatItTried) {
  const Growth growth(*parse_cases("double-pendulum:wild").front().scene, frame, 1);
  Stepping rough = first_order;
  rough.joint_slop = 1;
  EXPECT_FALSE(growth.allowance(rough, 60, 1));
}

constexpr double dt = 1.0 / 60;

std::optional<double> scene_horizon(const char* word) { return horizon_of(*parse_cases(word).front().scene, dt); }

TEST(Horizon, IsShorterThanTheRunForChaoticMotion) {
  for (const char* word : {"gas", "rain:seed 1", "tumbler:boxes", "double-pendulum:duration=20"}) {
    const auto horizon = scene_horizon(word);
    ASSERT_TRUE(horizon) << word;
    EXPECT_GT(*horizon, 0.1) << word;
  }
}

TEST(Horizon, IsNotReachedForRegularMotion) {
  for (const char* word : {"spring", "bounce", "pendulum", "orbit", "stacking:ten", "double-pendulum:small", "slope"}) {
    EXPECT_FALSE(scene_horizon(word)) << word;
  }
}

// Differences grow exponentially: runs that start a thousand times farther apart diverge sooner, but not by much.
TEST(Horizon, ComesSoonerForCoarserArithmetic) {
  const Case pendulum = parse_case("double-pendulum:duration=20");
  const auto own = [&](const char* word) {
    const EngineConfig config = parse_engine(word);
    const Outcome outcome = run(*pendulum.scene, config, dt);
    return horizon_of(*pendulum.scene, config, dt, *outcome.trace).value_or(20);
  };
  EXPECT_LT(own("impulse:precision=float"), own("impulse"));
  EXPECT_GT(own("impulse:precision=float"), 1);
}

TEST(Horizon, PerturbsStartsByABillionthOrByWhatTheArithmeticResolves) {
  Scene scene = *parse_case("spring").scene;
  scene.bodies.front().position = {1, 0};
  EXPECT_EQ(smallest_difference(scene, {.epsilon = 0x1p-53}), 1e-9);
  scene.bodies.front().position = {1000, 0};
  EXPECT_EQ(smallest_difference(scene, {.epsilon = 0x1p-24}), 8000 * 0x1p-24);
}

TEST(Perturbed, MovesOnlyDynamicBodiesAndEquallyForTheSameSeed) {
  const Scene scene = *parse_case("pyramid").scene;
  const Scene moved = perturbed(scene, 0.01, 3);
  const Scene again = perturbed(scene, 0.01, 3);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vec from = scene.bodies[i].position;
    const Vec to = moved.bodies[i].position;
    EXPECT_EQ(to, again.bodies[i].position);
    EXPECT_EQ(to == from, scene.bodies[i].type != BodyType::dynamic);
    EXPECT_NEAR(to.x, from.x, 0.01);
    EXPECT_NEAR(to.y, from.y, 0.01);
  }
}

constexpr int members = 16;

// The cheapest scene and engine that cannot be predicted to the end.
const Case& chaotic() {
  static const Case one = parse_case("double-pendulum:angle=175,duration=16");
  return one;
}

std::vector<EnsembleSample> ensemble(const EngineConfig& config, std::uint64_t seed) {
  return run_ensemble(*chaotic().scene, config, dt, 1e-6, members, seed);
}

bool any_different(std::span<const EnsembleDifference> differences) {
  return std::any_of(differences.begin(), differences.end(),
                     [](const EnsembleDifference& one) { return one.different; });
}

TEST(Ensemble, IsTheSameForTheSameSeed) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  const auto one = ensemble(config, 1);
  ASSERT_THAT(one, SizeIs(3));
  EXPECT_THAT(one[0].values, SizeIs(members));
  EXPECT_EQ(one[1].values, ensemble(config, 1)[1].values);
  EXPECT_NE(one[1].values, ensemble(config, 2)[1].values);
}

// 100 pairs at a level of 1 %: more than 5 false positives occur once in 1900 times (binomial), and the seeds are
// fixed.
TEST(Ensemble, OfOneEngineDifferByChanceAsRarelyAsStated) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  int false_positives = 0;
  double smallest = 1;
  double sum = 0;
  for (std::uint64_t pair = 0; pair < 100; ++pair) {
    const auto differences =
        compare_ensembles(ensemble(config, 1 + 2 * members * pair), ensemble(config, 1 + members + 2 * members * pair));
    false_positives += any_different(differences);
    smallest = std::min(smallest, differences[1].p);
    sum += differences[1].p;
  }
  EXPECT_LE(false_positives, 5);
  EXPECT_LT(smallest, 0.1) << "p spreads over 0 ... 1";
  EXPECT_NEAR(sum / 100, 0.5, 0.1) << "evenly: its mean is off by 0.03, one sigma";
}

TEST(Ensemble, FindsABiasAndItsSize) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  const auto right = ensemble(config, 1);
  auto forged = ensemble(config, 1001);
  for (double& value : forged[1].values) value += 1;
  const auto differences = compare_ensembles(right, forged);
  EXPECT_FALSE(differences[0].different);
  EXPECT_TRUE(differences[1].different);
  EXPECT_LT(differences[1].effect, -0.9);
  EXPECT_NEAR(differences[1].b.median - differences[1].a.median, 1, 0.3);
}

// Gravity is a tenth too strong.
TEST(Ensemble, FindsAnEngineWithWrongPhysics) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  Scene heavier = *chaotic().scene;
  heavier.gravity.y *= 1.1;
  const auto differences = compare_ensembles(ensemble(config, 1), run_ensemble(heavier, config, dt, 1e-6, members, 1));
  EXPECT_TRUE(any_different(differences));
}

Report report_of(const char* word, const std::vector<const char*>& engines) {
  Plan plan{.cases = {parse_cases(word).front()}, .ensemble = 8};
  for (const char* engine : engines) plan.configs.push_back(parse_engine(engine));
  return run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {});
}

// Six of each suffice for a difference to be significant: (6! 6!)/12! = 1e-3 by chance.
TEST(Ensemble, HasFewerRunsOfALargeSceneButEnoughToTell) {
  const auto runs = [](const char* word, int most) {
    return ensemble_members(*parse_cases(word).front().scene, dt, most);
  };
  EXPECT_EQ(runs("tumbler:boxes", 16), 16);
  EXPECT_EQ(runs("gas:side=16", 16), 6);
  EXPECT_EQ(runs("gas:side=16", 4), 4);
  EXPECT_EQ(runs("gas:side=16", 48), 20);
}

TEST(CompareBeyondHorizon, FindsEnginesDifferentButPlausibleInAChaoticScene) {
  if (Catalog<Engine>::find("chipmunk") == nullptr) GTEST_SKIP() << "built without Chipmunk";
  const Report report = report_of("rain:seed 1", {"impulse", "chipmunk:slop=0.1"});
  EXPECT_EQ(report.runs[0].metrics.count("horizon"), 1u);
  ASSERT_EQ(report.comparisons.size(), 1u);
  const Comparison& one = report.comparisons.front();
  EXPECT_EQ(one.verdict, Verdict::plausible);
  EXPECT_THAT(one.reason, StartsWith("different: energy"));
  EXPECT_EQ(one.metrics.count("horizon"), 1u);
  EXPECT_LT(one.metrics.at("ensemble_energy_p").value, 0.01);
}

TEST(CompareBeyondHorizon, FindsNoDifferenceOfAnEngineFromItself) {
  const Report report = report_of("rain:seed 1", {"impulse", "impulse:workers=2"});
  EXPECT_EQ(report.comparisons.front().verdict, Verdict::beyond_horizon);
  EXPECT_THAT(report.comparisons.front().reason, StartsWith("plausible beyond the horizon at "));
}

TEST(CompareBeyondHorizon, SpendsNothingOnAnEngineThatIsWrongAnyway) {
  const Report report = report_of("rain:seed 1", {"impulse", "impulse:solver=article"});
  ASSERT_EQ(report.runs[0].metrics.count("horizon"), 1u);
  ASSERT_EQ(report.runs[1].verdict, Verdict::wrong);
  EXPECT_EQ(report.comparisons.front().verdict, Verdict::wrong);
  EXPECT_EQ(report.comparisons.front().metrics.count("ensemble_energy_p"), 0u);
}

TEST(CompareBeyondHorizon, LeavesPredictableScenesAlone) {
  const Report report = report_of("bounce:e=0.8", {"impulse", "impulse:solver=soft-step"});
  EXPECT_EQ(report.runs[1].metrics.count("horizon"), 0u);
  for (const Comparison& one : report.comparisons) {
    EXPECT_NE(one.verdict, Verdict::beyond_horizon);
    EXPECT_EQ(one.metrics.count("ensemble_energy_p"), 0u);
  }
}

}  // namespace
}  // namespace plumb::horizon_test
