#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "scenarios/integrate.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::springs_test {
namespace {

using statement_of::Of;

double mass_of_first(const Scene& scene) { return mass_of(scene.bodies.front()).mass; }

TEST(Beats, AgreeWithAnIntegration) {
  const Scenario& family = *Catalog<Scenario>::find("beats");
  for (const Parameters& changes : std::vector<Parameters>{{}, {{"alike", 3}, {"ratio", 3}}}) {
    const Scene scene = family.scene(complete(family, changes));
    const double k = std::get<Spring>(scene.forces[0]).stiffness / mass_of_first(scene);
    const double c = std::get<Spring>(scene.forces[2]).stiffness / mass_of_first(scene);
    const auto rate = [&](const std::array<double, 4>& y) {
      return std::array<double, 4>{y[2], y[3], -k * y[0] + c * (y[1] - y[0]), -k * y[1] + c * (y[0] - y[1])};
    };
    for (const std::size_t moment : {0u, 1u}) {
      const auto end = integrated(std::array<double, 4>{0.6, 0, 0, 0}, moment == 0 ? 3.15 : 5, 20000, rate);
      EXPECT_NEAR(*(Of{"beats", changes, "struck", Quantity::x}.expectations()[moment].expected), end[0], 1e-9);
      EXPECT_NEAR(*(Of{"beats", changes, "coupled", Quantity::x}.expectations()[moment].expected), 2 + end[1], 1e-9);
    }
  }
}

// About when the other disc has all the energy, the one that was struck is at rest where it belongs.
TEST(Beats, StopDiscsThatAreNotCoupled) {
  const double alone = 0.6;  // m, by which the struck disc would still swing
  EXPECT_LT((Of{"beats", {}, "struck", Quantity::x, 4}.allows(statement_of::skinned())), alone / 4);
  EXPECT_LT((Of{"beats", {}, "struck", Quantity::x, 4}.allows(statement_of::accurate())), alone / 50);
}

TEST(SpringEllipse, AgreesWithAnIntegration) {
  const Scenario& family = *Catalog<Scenario>::find("spring-ellipse");
  const Scene scene = family.scene(complete(family, {}));
  const double k = std::get<Spring>(scene.forces[0]).stiffness / mass_of_first(scene);
  const Vec about = std::get<Spring>(scene.forces[0]).anchor_a;
  const Body& disc = scene.bodies[0];
  const auto end = integrated(std::array<double, 4>{disc.position.x, disc.position.y, disc.velocity.x, disc.velocity.y},
                              5, 20000, [&](const std::array<double, 4>& y) {
                                return std::array<double, 4>{y[2], y[3], -k * (y[0] - about.x), -k * (y[1] - about.y)};
                              });
  EXPECT_NEAR(*(Of{"spring-ellipse", {}, "disc", Quantity::x}.expectations().front().expected), end[0], 1e-9);
  EXPECT_NEAR(*(Of{"spring-ellipse", {}, "disc", Quantity::y}.expectations().front().expected), end[1], 1e-9);
}

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
}  // namespace plumb::springs_test
