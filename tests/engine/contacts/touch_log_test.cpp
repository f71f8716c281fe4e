#include <gmock/gmock.h>

#include <stdexcept>

#include "../support.h"

namespace touch_log_test {
namespace {

using namespace impulse;
using testing::IsEmpty;
using testing::SizeIs;

class Touching : public testing::TestWithParam<const char*> {
 protected:
  static Settings settings() {
    Settings chosen;
    chosen.solver = GetParam();
    chosen.contact_events = true;
    return chosen;
  }
};

TEST_P(Touching, BeginsOnceAndIsReportedWhileItLasts) {
  World world(settings());
  const BodyId floor = add_floor(world);
  const BodyId box = world.create_body(at(0, 1), Shape::box({Real{0.5}, Real{0.5}}));
  std::size_t begun = 0;
  std::size_t ended = 0;
  for (int i = 0; i < 120; ++i) {
    world.step();
    const ContactEvents events = world.contact_events();
    for (const TouchingParts& pair : events.begun) {
      EXPECT_EQ(pair.a, floor);
      EXPECT_EQ(pair.b, box);
      EXPECT_GT(pair.normal_impulse, 0);
    }
    begun += events.begun.size();
    ended += events.ended.size();
  }
  EXPECT_EQ(begun, 1U);
  EXPECT_EQ(ended, 0U);
  ASSERT_THAT(world.contact_events().touching, SizeIs(1));
  const TouchingParts rest = world.contact_events().touching[0];
  EXPECT_EQ(rest.normal, (Vec2{0, 1}));
  EXPECT_NEAR(rest.point.x, 0, .01);
  EXPECT_NEAR(rest.point.y, 0, .01);
  // A unit square of 1 kg/m^2 presses with m g dt in a step, up to its remaining settling motion.
  EXPECT_NEAR(rest.normal_impulse, 10 * world.dt(), .001);
}

// e = 1 and no gravity: one impact.
TEST_P(Touching, OfABounceBeginsAndEnds) {
  Settings chosen = settings();
  chosen.gravity = {};
  World world(chosen);
  add_floor(world, frictionless(1));
  world.create_body(at(0, 1, 0, -3), Shape::circle(Real{0.5}), frictionless(1));
  std::size_t begun = 0;
  std::size_t ended = 0;
  Real impulse = 0;
  for (int i = 0; i < 30; ++i) {
    world.step();
    begun += world.contact_events().begun.size();
    ended += world.contact_events().ended.size();
    for (const TouchingParts& pair : world.contact_events().touching) impulse += pair.normal_impulse;
  }
  EXPECT_EQ(begun, 1U);
  EXPECT_EQ(ended, 1U);
  EXPECT_NEAR(impulse, 2 * 3 * pi / 4, 64 * round_off);  // 2 m v
  EXPECT_THAT(world.contact_events().touching, IsEmpty());
}

TEST_P(Touching, EndsWithABody) {
  World world(settings());
  add_floor(world);
  const BodyId box = world.create_body(at(0, .5), Shape::box({Real{0.5}, Real{0.5}}));
  run(world, 10);
  world.destroy_body(box);
  EXPECT_THAT(world.contact_events().ended, IsEmpty());
  // Another takes its place, and its row.
  const BodyId heir = world.create_body(at(0, .5), Shape::box({Real{0.5}, Real{0.5}}));
  ASSERT_EQ(heir.index, box.index);
  world.step();
  ASSERT_THAT(world.contact_events().ended, SizeIs(1));
  EXPECT_EQ(world.contact_events().ended[0].b, box);
  EXPECT_FALSE(world.contains(world.contact_events().ended[0].b));
  ASSERT_THAT(world.contact_events().begun, SizeIs(1));
  EXPECT_EQ(world.contact_events().begun[0].b, heir);
}

TEST_P(Touching, LetsBodiesBeDestroyedWhileItIsRead) {
  World world(settings());
  add_floor(world);
  for (int i = 0; i < 5; ++i) world.create_body(at(2 * i, .5), Shape::circle(Real{0.5}));
  world.step();
  for (const TouchingParts& pair : world.contact_events().begun) world.destroy_body(pair.b);
  EXPECT_EQ(world.body_count(), 1U);
  world.step();
  EXPECT_THAT(world.contact_events().ended, SizeIs(5));
}

TEST(TouchingWithoutEvents, IsNotReported) {
  World world((Settings()));
  EXPECT_THROW(world.contact_events(), std::logic_error);
}

INSTANTIATE_TEST_SUITE_P(Solvers, Touching, testing::Values("accurate", "article", "soft-step"),
                         [](const auto& named) { return named.param[0] == 's' ? "soft_step" : named.param; });

}  // namespace
}  // namespace touch_log_test
