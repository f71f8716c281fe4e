#include "scenarios/scene/quantity.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace plumb::quantity_test {
namespace {

TEST(Quantity, HasAUniqueNameAndAUnit) {
  std::set<std::string> names;
  for (int i = 0; i <= static_cast<int>(Quantity::apex); ++i) {
    EXPECT_TRUE(names.insert(name_of(static_cast<Quantity>(i))).second);
    EXPECT_STRNE(unit_of(static_cast<Quantity>(i)), "");
  }
}

TEST(Quantity, BelongsToTheSceneIfItIsEnergyOrMomentum) {
  EXPECT_TRUE(of_whole_scene(Quantity::energy));
  EXPECT_TRUE(of_whole_scene(Quantity::angular_momentum));
  EXPECT_FALSE(of_whole_scene(Quantity::angular_velocity));
}

}  // namespace
}  // namespace plumb::quantity_test
