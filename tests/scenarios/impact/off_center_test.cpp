#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::off_center_test {
namespace {

const Scenario& off_center() { return *Catalog<Scenario>::find("off-center"); }

double expected(const Parameters& p, Quantity quantity) {
  for (const Expectation& one : off_center().expectations(p)) {
    if (one.quantity == quantity) return *one.expected;
  }
  ADD_FAILURE() << name_of(quantity);
  return 0;
}

// first-impact looks for the landing itself, and solves for the impulse at the corner that it finds.
TEST(OffCenter, AgreesWithTheClosedFormOfFirstImpactsForAPolygonInAnyFrame) {
  const Engine& exact = *Catalog<Engine>::find("first-impact");
  for (const double form : {0.0, 1.0}) {
    const Parameters p = complete(off_center(), {{"form", form}});
    const Scene scene = off_center().scene(p);
    const std::unique_ptr<Simulation> motion = exact.build(scene, complete(exact, {}));
    ASSERT_GT(motion->valid_until(), scene.duration) << "it lands again";
    motion->step(scene.duration);
    std::vector<BodyState> end(scene.bodies.size());
    motion->read(end);
    EXPECT_NEAR(expected(p, Quantity::x), end[1].position.x, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::y), end[1].position.y, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::vy), end[1].velocity.y, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::angle), end[1].angle, 1e-12) << form;
    EXPECT_NEAR(expected(p, Quantity::angular_velocity), end[1].angular_velocity, 1e-12) << form;
  }
}

TEST(OffCenter, KeepsTheEnergyOfAnElasticImpact) {
  for (const double form : {0.0, 1.0, 2.0}) {
    const Parameters p = complete(off_center(), {{"form", form}, {"restitution", 1}});
    const Mass mass = mass_of(off_center().scene(p).bodies[1]);
    const double v = expected(p, Quantity::vy);
    const double w = expected(p, Quantity::angular_velocity);
    EXPECT_GT(std::abs(w), 0.1) << form;
    EXPECT_NEAR(mass.mass * v * v + mass.inertia * w * w, mass.mass * p.at("speed") * p.at("speed"), 1e-12) << form;
  }
}

}  // namespace
}  // namespace plumb::off_center_test
