#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::box_on_box_test {
namespace {

using statement_of::Of;

double expected(const Parameters& changes, const char* body, Quantity quantity) {
  return *Of{"box-on-box", changes, body, quantity}.expectations().front().expected;
}

// Momentum, angular momentum about the struck box's start, and Newton's law at both ends of the overlap. At e = 1 the
// energy is kept, which follows from none of the formulas used.
TEST(BoxOnBox, KeepsMomentaAndSeparatesBothEndsOfTheOverlapAlike) {
  const Scenario& family = *Catalog<Scenario>::find("box-on-box");
  for (const double offset : {0.0, 0.2, 0.5}) {
    for (const double ratio : {0.2, 1.0, 5.0}) {
      for (const double e : {0.2, 1.0}) {
        const Parameters changes{{"offset", offset}, {"ratio", ratio}, {"restitution", e}};
        const Scene scene = family.scene(complete(family, changes));
        const Mass a = mass_of(scene.bodies[0]);
        const Mass b = mass_of(scene.bodies[1]);
        const double v = scene.bodies[0].velocity.x;
        const double va = expected(changes, "flies", Quantity::vx);
        const double vb = expected(changes, "struck", Quantity::vx);
        const double wa = expected(changes, "flies", Quantity::angular_velocity);
        const double wb = expected(changes, "struck", Quantity::angular_velocity);
        EXPECT_NEAR(a.mass * va + b.mass * vb, a.mass * v, 1e-12);
        EXPECT_NEAR(a.inertia * wa + b.inertia * wb - b.mass * vb * offset, 0, 1e-12);
        for (const double y : {offset - 0.5, 0.5}) {
          EXPECT_NEAR((vb - wb * (y - offset)) - (va - wa * y), e * v, 1e-12) << "at the end " << y;
        }
        const double energy = a.mass * va * va + b.mass * vb * vb + a.inertia * wa * wa + b.inertia * wb * wb;
        if (e == 1) {
          EXPECT_NEAR(energy, a.mass * v * v, 1e-12);
        }
      }
    }
  }
}

TEST(BoxOnBox, StopsABlowThroughTheCentresOfBoxesThatMeetHalf) {
  const Of speed{"box-on-box", {{"offset", 0.5}}, "struck", Quantity::vx};
  const double central = 1.5 * 3 / 2;  // (1 + e) v/2
  EXPECT_LT(speed.allows_at_most(), std::abs(central - *speed.expectations().front().expected) / 10);
}

}  // namespace
}  // namespace plumb::box_on_box_test
