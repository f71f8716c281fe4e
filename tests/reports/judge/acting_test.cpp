#include "reports/judge/acting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/adapter.h"
#include "reports/vec.h"

namespace plumb {
namespace {

constexpr double step = 1e-6;

Scene pulled_every_way() {
  const Surface surface{.density = 1};
  return {
      .gravity = {0, -10},
      .bodies = {{.name = "a", .position = {1, 2}, .velocity = {1, 0}, .shapes = {{Box{}, surface}}},
                 {.name = "b", .position = {4, 1}, .angle = 0.3, .gravity_scale = 0.5, .shapes = {{Box{}, surface}}},
                 {.name = "c", .type = BodyType::kinematic, .position = {0, -3}, .velocity = {0, 2}}},
      .forces = {Attraction{.from = 0, .strength = 3, .exponent = 2, .mutual = true},
                 Attraction{.from = 2, .strength = 5, .exponent = 1},
                 Spring{.a = 0, .b = 1, .anchor_a = {0.5, 0}, .anchor_b = {0, 0.5}, .stiffness = 7, .length = 1},
                 Spring{.b = 1, .anchor_a = {9, 9}, .anchor_b = {-0.5, 0}, .stiffness = 2, .length = 3},
                 Constant{.body = 0, .force = {1, 2}, .torque = 3}}};
}

double potential(const Acting& acting, std::span<const BodyState> states) {
  return acting.conserved().energy(states).potential + acting.potential(states);
}

TEST(Acting, IsWhatThePotentialFallsBy) {
  const Scene scene = pulled_every_way();
  const Acting acting(scene);
  const std::vector<BodyState> states = initial_states(scene);
  const std::vector<Push> pushes = acting.on(states);
  for (const std::size_t body : {std::size_t{0}, std::size_t{1}}) {
    const auto falls_by = [&](auto&& move) {
      std::vector<BodyState> ahead = states;
      std::vector<BodyState> behind = states;
      move(ahead[body], step);
      move(behind[body], -step);
      return (potential(acting, behind) - potential(acting, ahead)) / (2 * step);
    };
    EXPECT_NEAR(pushes[body].force.x, falls_by([](BodyState& at, double by) { at.position.x += by; }), 1e-7);
    EXPECT_NEAR(pushes[body].force.y, falls_by([](BodyState& at, double by) { at.position.y += by; }), 1e-7);
    EXPECT_NEAR(pushes[body].torque, falls_by([](BodyState& at, double by) { at.angle += by; }), 1e-7);
  }
  EXPECT_EQ(pushes[2].force, Vec{});
}

TEST(Acting, CountsTheWorkOfWhatMovesTheCentreOfAnAttraction) {
  const Scene scene = pulled_every_way();
  const Acting acting(scene);
  const std::vector<BodyState> states = initial_states(scene);
  std::vector<BodyState> later = states;
  for (BodyState& state : later) state.position = state.position + step * state.velocity;
  double done = 0;  // on the bodies, by all forces
  const std::vector<Push> pushes = acting.on(states);
  for (std::size_t i = 0; i < 2; ++i) done += dot(pushes[i].force, states[i].velocity);
  const double lost = (potential(acting, states) - potential(acting, later)) / step;
  EXPECT_NEAR(done - lost, acting.power(states), 1e-4);
  EXPECT_GT(std::abs(acting.power(states)), 1);
}

// The engines' feed and the harness's own reading of the same scene.
TEST(Acting, AgreesWithTheLoadsThatAdaptersFeedTheirEngines) {
  const Scene scene = pulled_every_way();
  const std::vector<BodyState> states = initial_states(scene);
  Loads loads(scene);
  const auto fed = loads.at(states);
  const std::vector<Push> pushes = Acting(scene).on(states);
  for (const std::size_t body : {std::size_t{0}, std::size_t{1}}) {
    const Vec gravity = mass_of(scene.bodies[body]).mass * scene.bodies[body].gravity_scale * scene.gravity;
    EXPECT_NEAR(length(pushes[body].force - gravity - fed[body].force), 0, 1e-12);
    EXPECT_NEAR(pushes[body].torque, fed[body].torque, 1e-12);
  }
}

}  // namespace
}  // namespace plumb
