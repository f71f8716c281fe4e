#include "reports/find/kind.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reports/find/shrink.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/scene_json.h"

namespace plumb::kind_test {
namespace {

std::string text_of(const Scene& scene) { return write_scene({.scene = scene, .truth = {}}); }

constexpr int draws = 40;

TEST(Kind, DrawsTheSameSceneFromTheSameSeedAndAnotherFromAnother) {
  for (const Kind* kind : Catalog<Kind>::all()) {
    EXPECT_EQ(text_of(drawn(*kind, 7, 3)), text_of(drawn(*kind, 7, 3))) << kind->name;
    EXPECT_NE(text_of(drawn(*kind, 7, 3)), text_of(drawn(*kind, 8, 3))) << kind->name;
    EXPECT_NE(text_of(drawn(*kind, 7, 3)), text_of(drawn(*kind, 7, 4))) << kind->name;
  }
}

TEST(Kind, DrawsScenesThatAFileCanHoldOfAtMostTwoHundredBodies) {
  EXPECT_GE(Catalog<Kind>::all().size(), 12U);
  for (const Kind* kind : Catalog<Kind>::all()) {
    for (int n = 0; n < draws; ++n) {
      const Scene scene = drawn(*kind, 1, n);
      EXPECT_NO_THROW(text_of(scene)) << scene.name;
      EXPECT_GE(scene.bodies.size(), 1U) << scene.name;
      EXPECT_LE(scene.bodies.size(), most_bodies + 2U) << scene.name << ": with what they stand on";
    }
  }
}

// Two sliders of 400 began in the ground.
TEST(Kind, StartsNothingInsideSomethingElseNorAgainstItsJointsUnlessItSaysSo) {
  for (const Kind* kind : Catalog<Kind>::all()) {
    if (kind->posed == Posed::overlapping) continue;
    for (int n = 0; n < 10 * draws; ++n) {
      const Scene scene = drawn(*kind, 31, n);
      const Contradictions found = contradictions(scene);
      EXPECT_LE(found.overlap, 1e-9) << scene.name;
      EXPECT_LE(found.joint_speed, 1e-9) << scene.name;
      EXPECT_LE(found.joint_gap, 1e-9) << scene.name;
    }
  }
}

TEST(Kind, DrawsMotorsPathsAndLimitsNowAndThen) {
  int motors = 0;
  int limited = 0;
  int paths = 0;
  for (const char* name : {"door", "slider", "belt"}) {
    for (int n = 0; n < draws; ++n) {
      const Scene scene = drawn(*Catalog<Kind>::find(name), 1, n);
      for (const Joint& joint : scene.joints) {
        motors += motor_of(joint) != nullptr ? 1 : 0;
        limited += motor_of(joint) != nullptr && limits_of(joint) != nullptr ? 1 : 0;
      }
      paths += std::ranges::any_of(scene.bodies, [](const Body& one) { return one.path.has_value(); }) ? 1 : 0;
    }
  }
  EXPECT_GE(motors, 10);
  EXPECT_GE(limited, 5);
  EXPECT_GE(paths, 10);
}

// Box2D and Chipmunk have one coefficient of friction and would be left out of all others.
TEST(Kind, DrawsTwoFrictionsInFewScenes) {
  int scenes = 0;
  int with_two = 0;
  for (const Kind* kind : Catalog<Kind>::all()) {
    for (int n = 0; n < draws; ++n) {
      const Scene scene = drawn(*kind, 1, n);
      ++scenes;
      with_two += std::ranges::any_of(scene.bodies, [](const Body& body) {
        return std::ranges::any_of(
            body.shapes, [](const Shape& one) { return one.surface.static_friction != one.surface.dynamic_friction; });
      });
    }
  }
  EXPECT_GE(with_two, scenes / 50);
  EXPECT_LE(with_two, scenes / 12);
}

TEST(Draw, UnitAtGoesAroundOnceInRisingOrder) {
  for (int i = 0; i < 64; ++i) {
    const Vec a = unit_at(i / 64.0);
    const Vec b = unit_at((i + 1) / 64.0);
    EXPECT_NEAR(a.x * a.x + a.y * a.y, 1, 1e-15);
    EXPECT_GT(a.x * b.y - a.y * b.x, 0) << i;
  }
}

TEST(Draw, StaysInItsRangesAndPrefersNoMagnitude) {
  Draw draw(3);
  int small = 0;
  for (int i = 0; i < 2000; ++i) {
    const double value = draw.over_magnitudes(0.01, 100);
    EXPECT_GE(value, 0.01);
    EXPECT_LE(value, 100);
    small += value < 1 ? 1 : 0;
    const int count = draw.count(1, 200);
    EXPECT_GE(count, 1);
    EXPECT_LE(count, 200);
  }
  EXPECT_NEAR(small, 1000, 150) << "half of the magnitudes are below 1";
}

}  // namespace
}  // namespace plumb::kind_test
