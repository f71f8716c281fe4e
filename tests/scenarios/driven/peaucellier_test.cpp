#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::peaucellier_test {
namespace {

using statement_of::Of;

Scene scene_of(double swing) {
  const Scenario& family = *Catalog<Scenario>::find("peaucellier");
  return family.scene(complete(family, {{"swing", swing}}));
}

// Every bar has its length at the start, and its ends move across it only.
TEST(Peaucellier, StartsWithRigidBars) {
  for (const double swing : {20.0, 60.0, 70.0}) {
    const Scene scene = scene_of(swing);
    const auto velocity_at = [&](std::size_t body, Vec at) {
      const Body& of = scene.bodies[body];
      const double w = of.angular_velocity;
      return Vec{of.velocity.x - w * (at.y - of.position.y), of.velocity.y + w * (at.x - of.position.x)};
    };
    ASSERT_EQ(scene.joints.size(), 6u);
    for (const Joint& joint : scene.joints) {
      const auto& bar = std::get<Distance>(joint);
      const Vec along{bar.anchor_b.x - bar.anchor_a.x, bar.anchor_b.y - bar.anchor_a.y};
      const Vec a = velocity_at(bar.a, bar.anchor_a);
      const Vec b = velocity_at(bar.b, bar.anchor_b);
      EXPECT_NEAR(std::hypot(along.x, along.y), bar.length, 1e-12);
      EXPECT_NEAR((b.x - a.x) * along.x + (b.y - a.y) * along.y, 0, 1e-12);
    }
  }
}

// The inversion: the end is on the ray through the crank's pin, at (long^2 - bar^2) over the pin's distance.
TEST(Peaucellier, InvertsTheCircleOfTheCrank) {
  const auto x = Of{"peaucellier", {}, "end", Quantity::x}.expectations();
  const auto y = Of{"peaucellier", {}, "end", Quantity::y}.expectations();
  const double widest = 60 * std::acos(-1) / 180;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double angle = widest * (2 * x[i].time.value_or(3) / 3 - 1);
    const Vec pin{0.6 + 0.6 * std::cos(angle), 0.6 * std::sin(angle)};
    const double far = (1.5 * 1.5 - 0.6 * 0.6) / (pin.x * pin.x + pin.y * pin.y);
    EXPECT_NEAR(*x[i].expected, far * pin.x, 1e-12);
    EXPECT_NEAR(*y[i].expected, far * pin.y, 1e-12);
    EXPECT_EQ(*x[i].expected, *x[0].expected) << "a straight line";
  }
}

// With the crank's pivot a tenth off, the line is an arc that is 4 cm off it at its ends.
TEST(Peaucellier, StopsALinkageThatDrawsAnArc) {
  EXPECT_LT((Of{"peaucellier", {}, "end", Quantity::x}.allows(statement_of::accurate())), 0.01);
}

}  // namespace
}  // namespace plumb::peaucellier_test
