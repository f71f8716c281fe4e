#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::joined_pair_test {
namespace {

// The two as point masses on a stiff spring, which turns none of them, by the velocity Verlet method: the pull that
// keeps them apart is all it takes for the circles that the scene expects.
TEST(JoinedPair, CirclesAsTwoMassesOnAStiffSpringDo) {
  const Scenario& scenario = *Catalog<Scenario>::find("joined-pair");
  const Parameters p = complete(scenario, {{"joint", 1}});
  const Scene scene = scenario.scene(p);
  const double masses[] = {mass_of(scene.bodies[0]).mass, mass_of(scene.bodies[1]).mass};
  Vec at[] = {scene.bodies[0].position, scene.bodies[1].position};
  Vec velocity[] = {scene.bodies[0].velocity, scene.bodies[1].velocity};
  const double reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
  const double stiffness = 1e7 * reduced;
  const double length = 2 - reduced * 2 * p.at("turn") * p.at("turn") / stiffness;  // stretched to 2 m
  constexpr double h = 1e-5;
  const auto push = [&](double time) {
    const Vec apart{at[1].x - at[0].x, at[1].y - at[0].y};
    const double distance = std::hypot(apart.x, apart.y);
    const double impulse = time * stiffness * (distance - length) / distance;
    for (const int i : {0, 1}) {
      const double way = (i == 0 ? impulse : -impulse) / masses[i];
      velocity[i] = {velocity[i].x + way * apart.x, velocity[i].y + way * apart.y};
    }
  };
  for (int step = 0; step < static_cast<int>(std::lround(scene.duration / h)); ++step) {
    push(h / 2);
    for (const int i : {0, 1}) at[i] = {at[i].x + h * velocity[i].x, at[i].y + h * velocity[i].y};
    push(h / 2);
  }
  const auto all = scenario.expectations(p);
  EXPECT_NEAR(*all[0].expected, at[0].x, 1e-5);
  EXPECT_NEAR(*all[1].expected, at[0].y, 1e-5);
  EXPECT_NEAR(*all[3].expected, at[1].x, 1e-5);
  EXPECT_NEAR(*all[4].expected, at[1].y, 1e-5);
}

}  // namespace
}  // namespace plumb::joined_pair_test
