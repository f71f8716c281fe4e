#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::chains_test {
namespace {

// The forces on every hinge follow from the planks' moments alone: if a plank of weight w has slope tan b under a
// horizontal pull H, the pull on its upper end is H tan b + w/2 upwards. The sum over both banks carries all the
// weight.
TEST(RopeBridge, HangsInEquilibrium) {
  const Scenario& scenario = *Catalog<Scenario>::find("rope-bridge");
  for (const double ratio : {1.0, 50.0}) {
    const Scene scene = scenario.scene(complete(scenario, {{"ratio", ratio}}));
    const auto slope = [&](int link) { return std::tan(scene.bodies[static_cast<std::size_t>(link)].angle); };
    const double plank = mass_of(scene.bodies[1]).mass;
    const double load = mass_of(scene.bodies.back()).mass;
    EXPECT_NEAR(load / plank, ratio, 1e-12 * ratio);
    // Links 1 ... 12 run from the left bank to the right; the load hangs between 6 and 7.
    const double pull = plank / (slope(8) - slope(7));
    for (int link = 1; link < 12; ++link) {
      const double hung = link == 6 ? load + plank : plank;
      EXPECT_NEAR(pull * (slope(link + 1) - slope(link)), hung, 1e-9 * load) << ratio << ' ' << link;
    }
    const double length = 12 * 0.5;
    EXPECT_NEAR(scene.bodies[13].position.x - scene.bodies[0].position.x, 0.9 * length, 1e-12);
  }
}

}  // namespace
}  // namespace plumb::chains_test
