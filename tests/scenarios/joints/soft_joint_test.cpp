#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "scenarios/integrate.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::soft_joint_test {
namespace {

using statement_of::Of;

// Both discs, pulled by what the scene's own joint says.
TEST(SoftJoint, MovesAsAnIntegrationOfBothDiscs) {
  for (const Parameters& changes :
       std::vector<Parameters>{{}, {{"damping", 0}}, {{"damping", 0.8}, {"frequency", 5}, {"ratio", 0.3}}}) {
    const Scenario& family = *Catalog<Scenario>::find("soft-joint");
    const Scene scene = family.scene(complete(family, changes));
    const auto& joint = std::get<Distance>(scene.joints[0]);
    const double left = mass_of(scene.bodies[0]).mass;
    const double right = mass_of(scene.bodies[1]).mass;
    const auto rate = [&](const std::array<double, 4>& s) {
      const double pull = joint.stiffness * (s[1] - s[0] - joint.length) + joint.damping * (s[3] - s[2]);
      return std::array<double, 4>{s[2], s[3], pull / left, -pull / right};
    };
    const std::array<double, 4> start{scene.bodies[0].position.x, scene.bodies[1].position.x, 0, 0};
    for (const auto& [body, at] : {std::pair{"left", std::size_t{0}}, std::pair{"right", std::size_t{1}}}) {
      for (const Expectation& one : Of{"soft-joint", changes, body, Quantity::x}.expectations())
        EXPECT_NEAR(*one.expected, integrated(start, *one.time, 20000, rate)[at], 1e-9);
    }
    const Expectation speed = Of{"soft-joint", changes, "right", Quantity::vx}.expectations().back();
    EXPECT_NEAR(*speed.expected, integrated(start, *speed.time, 20000, rate)[3], 1e-9);
  }
}

// After one and a half swings e^(-2 c w t) = .15 of the energy is left, and all of it without damping.
TEST(SoftJoint, StopsAJointWithoutDamping) {
  const double all = *Of{"soft-joint", {{"damping", 0}}, "", Quantity::energy}.expectations().back().expected;
  const double left = *Of{"soft-joint", {}, "", Quantity::energy}.expectations().back().expected;
  EXPECT_LT((Of{"soft-joint", {}, "", Quantity::energy}.allows_at_most()), (all - left) / 2);
}

// A quarter of a swing of twice the stiffness ends on the other side, by about a third of the amplitude.
TEST(SoftJoint, StopsAJointOfTwiceTheStiffness) {
  const Of of{.scenario = "soft-joint", .changes = {}, .body = "left", .quantity = Quantity::x, .before = 1};
  EXPECT_LT(of.allows_at_most(), 0.8 * 0.75 * 0.3);
}

}  // namespace
}  // namespace plumb::soft_joint_test
