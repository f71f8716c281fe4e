#include "reports/run/growth.h"

#include <gmock/gmock.h>

#include "reports/run/selection.h"

namespace plumb::growth_test {
namespace {

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

}  // namespace
}  // namespace plumb::growth_test
