#include "scenarios/scene/surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb::surface_test {
namespace {

TEST(Materials, AreFoundByTheirExactName) {
  ASSERT_NE(find_material("wood"), nullptr);
  EXPECT_EQ(find_material("wood")->density, 0.3);
  EXPECT_EQ(find_material("wood")->restitution, 0.2);
  EXPECT_EQ(find_material("static")->density, 0);
  EXPECT_EQ(find_material("Wood"), nullptr);
  EXPECT_EQ(find_material(""), nullptr);
}

const Surface wood{.density = 1, .static_friction = 0.3, .dynamic_friction = 0.2, .restitution = 0.5};
const Surface rubber{.density = 1, .static_friction = 1.2, .dynamic_friction = 0.8, .restitution = 0.75};

TEST(MixedFriction, FollowsTheScenesRule) {
  const auto mixed = [](FrictionMixing rule) { return mixed_static_friction({.friction = rule}, wood, rubber); };
  EXPECT_DOUBLE_EQ(mixed(FrictionMixing::geometric), 0.6);
  EXPECT_DOUBLE_EQ(mixed(FrictionMixing::pythagorean), std::sqrt(1.53));
  EXPECT_DOUBLE_EQ(mixed(FrictionMixing::average), 0.75);
  EXPECT_DOUBLE_EQ(mixed(FrictionMixing::min), 0.3);
  EXPECT_DOUBLE_EQ(mixed(FrictionMixing::max), 1.2);
  EXPECT_DOUBLE_EQ(mixed(FrictionMixing::multiply), 0.36);
}

TEST(MixedFriction, MixesStaticAndDynamicFrictionSeparately) {
  EXPECT_DOUBLE_EQ(mixed_dynamic_friction({}, wood, rubber), 0.4);
  EXPECT_DOUBLE_EQ(mixed_static_friction({}, wood, rubber), 0.6);
}

TEST(MixedRestitution, FollowsTheScenesRule) {
  const auto mixed = [](RestitutionMixing rule) { return mixed_restitution({.restitution = rule}, wood, rubber); };
  EXPECT_DOUBLE_EQ(mixed(RestitutionMixing::max), 0.75);
  EXPECT_DOUBLE_EQ(mixed(RestitutionMixing::min), 0.5);
  EXPECT_DOUBLE_EQ(mixed(RestitutionMixing::average), 0.625);
  EXPECT_DOUBLE_EQ(mixed(RestitutionMixing::multiply), 0.375);
}

}  // namespace
}  // namespace plumb::surface_test
