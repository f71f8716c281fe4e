#include "reference/reduced.h"

#include <gtest/gtest.h>

#include "scenarios/parts.h"

namespace plumb {
namespace {

Scene scene() {
  Scene made;
  made.bodies = {level_ground(surface(0.5, 0.2)), disc("disc", {0, 1}, 0.5, surface(0.5, 0.2))};
  made.bodies[1].angular_velocity = 2;
  made.bodies[1].shapes[0].surface.static_friction = 0.8;
  return made;
}

const Surface& of_disc(const Scene& scene) { return scene.bodies[1].shapes[0].surface; }

Scene with(const std::string& option, const std::string& value) {
  Settings settings{{"rotation", "on"}, {"friction", "full"}, {"restitution", "on"}};
  settings[option] = value;
  return reduced(scene(), settings);
}

TEST(Reduced, LeavesAsceneAsItIsByDefault) {
  for (const Option& option : reductions()) {
    const Scene same = with(option.key, option.value);
    EXPECT_EQ(same.bodies[1].angular_velocity, 2);
    EXPECT_FALSE(same.bodies[1].fixed_rotation);
    EXPECT_EQ(of_disc(same).static_friction, 0.8);
    EXPECT_EQ(of_disc(same).restitution, 0.2);
  }
}

TEST(Reduced, TakesAwayWhatIsAskedForAndNothingElse) {
  EXPECT_TRUE(with("rotation", "off").bodies[1].fixed_rotation);
  EXPECT_EQ(with("rotation", "off").bodies[1].angular_velocity, 0);
  EXPECT_FALSE(with("rotation", "off").bodies[0].fixed_rotation);
  EXPECT_EQ(of_disc(with("rotation", "off")).static_friction, 0.8);
  EXPECT_EQ(of_disc(with("friction", "dynamic")).static_friction, 0.5);
  EXPECT_EQ(of_disc(with("friction", "dynamic")).dynamic_friction, 0.5);
  EXPECT_EQ(of_disc(with("friction", "off")).static_friction, 0);
  EXPECT_EQ(of_disc(with("friction", "off")).dynamic_friction, 0);
  EXPECT_EQ(of_disc(with("friction", "off")).restitution, 0.2);
  EXPECT_EQ(of_disc(with("restitution", "off")).restitution, 0);
  EXPECT_EQ(of_disc(with("restitution", "off")).dynamic_friction, 0.5);
}

}  // namespace
}  // namespace plumb
