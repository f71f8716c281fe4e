#include "solver/collision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::collision_test {
namespace {

constexpr double fall = 2;     // m/s
constexpr double inverse = 6;  // 1/(kg m^2), of a box of 1 m and 1 kg

/// A corner of such a box that leans, on the ground.
ImpactRow corner() {
  ImpactRow row;
  row.normal = {0, 1};
  row.mass_b = {1, real(inverse)};
  row.static_friction = row.dynamic_friction = 1;
  row.restitution = 1;
  row.count = 1;
  row.points[0].cross_b = real(.3);
  row.points[0].dot_b = real(-.6);
  return row;
}

Velocity after(double slide) {
  ImpactRow row = corner();
  Velocity ground;
  Velocity box{vec(slide, -fall), 0};
  Collision collision(row, ground, box);
  collision.couple();
  collision.solve();
  collision.apply(ground, box);
  return box;
}

// What slides the way in which the corner is thrown turns round: Newton's law with all of the restitution creates
// energy. Pushed as if there were no friction, which creates none either, its velocity jumped by .87 m/s.
TEST(Collision, ReboundsByAsMuchAsCreatesNoEnergy) {
  const Velocity between = after(0);
  for (const double slide : {-.1, -.01, -1e-3, -1e-4, 1e-4, 1e-3, .01, .1}) {
    const Velocity box = after(slide);
    const double energy =
        (static_cast<double>(length_squared(box.v)) + static_cast<double>(box.w * box.w) / inverse) / 2;
    const double before = (slide * slide + fall * fall) / 2;
    EXPECT_LE(energy, before * (1 + bound(1e-13, 1e-5))) << slide;
    EXPECT_LT(static_cast<double>(length(box.v - between.v)), 4 * std::abs(slide) + bound(1e-12, 1e-5)) << slide;
    EXPECT_LT(static_cast<double>(std::abs(box.w - between.w)), 4 * std::abs(slide) + bound(1e-12, 1e-5)) << slide;
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::collision_test
