#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::rocking_block_test {
namespace {

using statement_of::Of;

constexpr double half_height = 4;  // m

std::vector<Expectation> angles(const Parameters& changes) {
  return Of{"rocking-block", changes, "block", Quantity::angle}.expectations();
}

struct Rocked {
  double angle = 0, spin = 0;
  int impacts = 0;
};

// The scene's own block in steps of 10 microseconds: it turns about the corner it stands on, and about the other from
// when that is on the ground, with the angular momentum that it had about it.
Rocked integrated(const Scene& scene, double until) {
  const Body& block = scene.bodies[1];
  const Mass mass = mass_of(block);
  const Vec size = std::get<Box>(block.shapes[0].geometry).size;
  const Vec corner{size.x / 2, size.y / 2};
  const double about_corner = mass.inertia + mass.mass * (corner.x * corner.x + corner.y * corner.y);
  Rocked now{block.angle, 0, 0};
  constexpr double h = 1e-5;
  const auto steps = static_cast<int>(std::lround(until / h));
  for (int i = 0; i < steps; ++i) {
    const double side = now.impacts % 2 == 0 ? 1 : -1;  // of the centre from the corner, where the block is level
    const auto pull = [&](double angle) {
      return -mass.mass * 10 * (side * corner.x * std::cos(angle) - corner.y * std::sin(angle)) / about_corner;
    };
    now.spin += h / 2 * pull(now.angle);
    now.angle += h * now.spin;
    now.spin += h / 2 * pull(now.angle);
    if (side * now.angle > 0) continue;
    // v of the centre is w x arm from the old corner; the angular momentum about the new one is I w + m arm' x v.
    const Vec velocity{-now.spin * corner.y, now.spin * side * corner.x};
    const Vec arm{-side * corner.x, corner.y};
    now.spin = (mass.inertia * now.spin + mass.mass * (arm.x * velocity.y - arm.y * velocity.x)) / about_corner;
    ++now.impacts;
  }
  return now;
}

TEST(RockingBlock, MovesAsAnIntegrationWithItsAngularMomentum) {
  for (const Parameters& changes :
       std::vector<Parameters>{{}, {{"slenderness", 0.4}, {"impacts", 4}}, {{"tilt", 0.9}, {"impacts", 3}}}) {
    const Scenario& family = *Catalog<Scenario>::find("rocking-block");
    const Parameters p = complete(family, changes);
    const Scene scene = family.scene(p);
    for (const Expectation& one : angles(changes)) {
      const Rocked then = integrated(scene, *one.time);
      EXPECT_NEAR(*one.expected, then.angle, 5e-5);
      EXPECT_LE(then.impacts, static_cast<int>(p.at("impacts")));
    }
  }
}

// Housner's own form, for small angles: the centre leans by a at rest and by a - q on a corner, and a quarter of a
// cycle takes acosh(1/(1 - q/a))/w.
TEST(RockingBlock, TakesHousnersTimeIfItIsSlender) {
  const double slenderness = 0.1;
  const double arm = half_height * std::hypot(slenderness, 1);
  const double w = std::sqrt(30 / (4 * arm));
  const double kept = 1 - 1.5 * slenderness * slenderness / (1 + slenderness * slenderness);
  for (const double tilt : {0.3, 0.6, 0.9}) {
    const auto quarter = [&](double share) { return std::acosh(1 / (1 - share)) / w; };
    const double next = 1 - std::sqrt(1 - kept * kept * (1 - (1 - tilt) * (1 - tilt)));
    const Expectation first = angles({{"slenderness", slenderness}, {"tilt", tilt}, {"impacts", 1}}).front();
    EXPECT_NEAR(*first.time, quarter(tilt) + quarter(next), 1.0 / 60 + 0.002 * *first.time) << tilt;
  }
}

TEST(RockingBlock, KeepsHousnersShareOfItsEnergyInElevenImpacts) {
  const Of of{"rocking-block", {}, "", Quantity::energy};
  const Scenario& family = *Catalog<Scenario>::find("rocking-block");
  const Scene scene = family.scene(complete(family, {}));
  const double weight = 10 * mass_of(scene.bodies[1]).mass;
  const double rests = weight * half_height;
  const double start = weight * scene.bodies[1].position.y - rests;
  const double kept = 1 - 1.5 * 0.04 / 1.04;
  EXPECT_NEAR((*of.expectations().front().expected - rests) / start, std::pow(kept, 2), 1e-12);
  EXPECT_NEAR((*of.expectations().back().expected - rests) / start, std::pow(kept, 22), 1e-12);
}

// Of a block that keeps all of its spin the first turning point would be as far as the start, of one that keeps none 0.
TEST(RockingBlock, StopsABlockThatLosesNothingOrAll) {
  const double start = 0.6 * std::atan(0.2);
  const Expectation first = angles({}).front();
  EXPECT_LT(first.allowed(statement_of::accurate()), (start - std::abs(*first.expected)) * 0.6);
  EXPECT_LT(first.allowed(statement_of::accurate()), std::abs(*first.expected) / 5);
}

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
}  // namespace plumb::rocking_block_test
