#include "reports/run/ensemble.h"

#include <gmock/gmock.h>

#include "reports/run/selection.h"

namespace plumb {
namespace {

using ::testing::Each;
using ::testing::SizeIs;

constexpr double dt = 1.0 / 60;
constexpr int members = 16;

// The fastest scene and engine that cannot be told to the end.
const Case& wild() {
  static const Case asked = parse_case("double-pendulum:angle=175,duration=16");
  return asked;
}

std::vector<Sample> ensemble(const EngineConfig& config, std::uint64_t seed) {
  return ensemble_of(*wild().scene, config, dt, 1e-6, members, seed);
}

bool any_different(std::span<const Contrast> contrasts) {
  return std::any_of(contrasts.begin(), contrasts.end(), [](const Contrast& one) { return one.different; });
}

TEST(Ensemble, IsTheSameForTheSameSeed) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  const auto one = ensemble(config, 1);
  ASSERT_THAT(one, SizeIs(3));
  EXPECT_THAT(one[0].values, SizeIs(members));
  EXPECT_EQ(one[1].values, ensemble(config, 1)[1].values);
  EXPECT_NE(one[1].values, ensemble(config, 2)[1].values);
}

// 100 pairs at a level of 1 %: more than 5 alarms come up once in 1900 times (binomial), and these seeds are fixed.
TEST(Ensemble, OfOneEngineFromOtherSeedsAreAlikeAsOftenAsStated) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  int alarms = 0;
  double smallest = 1;
  double sum = 0;
  for (std::uint64_t pair = 0; pair < 100; ++pair) {
    const auto contrasts =
        contrast(ensemble(config, 1 + 2 * members * pair), ensemble(config, 1 + members + 2 * members * pair));
    alarms += any_different(contrasts);
    smallest = std::min(smallest, contrasts[1].p);
    sum += contrasts[1].p;
  }
  EXPECT_LE(alarms, 5);
  EXPECT_LT(smallest, 0.1) << "p spreads over 0 ... 1";
  EXPECT_NEAR(sum / 100, 0.5, 0.1) << "evenly: its mean is off by 0.03, one sigma";
}

TEST(Ensemble, ABiasIsSeenAndItsSize) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  const auto right = ensemble(config, 1);
  auto forged = ensemble(config, 1001);
  for (double& value : forged[1].values) value += 1;
  const auto contrasts = contrast(right, forged);
  EXPECT_FALSE(contrasts[0].different);
  EXPECT_TRUE(contrasts[1].different);
  EXPECT_LT(contrasts[1].effect, -0.9);
  EXPECT_NEAR(contrasts[1].b.median - contrasts[1].a.median, 1, 0.3);
}

// A scene whose gravity is a tenth too strong.
TEST(Ensemble, AnEngineWithWrongPhysicsIsSeen) {
  const EngineConfig config = parse_engine("impulse:solver=article");
  Scene heavier = *wild().scene;
  heavier.gravity.y *= 1.1;
  const auto contrasts = contrast(ensemble(config, 1), ensemble_of(heavier, config, dt, 1e-6, members, 1));
  EXPECT_TRUE(any_different(contrasts));
}

}  // namespace
}  // namespace plumb
