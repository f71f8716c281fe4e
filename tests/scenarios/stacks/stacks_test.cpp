#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::stacks_test {
namespace {

using statement_of::Of;

// The top of ten boxes that has slid off to the side by half a box.
TEST(Stacking, StopsATowerThatLeansByHalfABox) {
  EXPECT_LT((Of{"stacking", {}, "box 10", Quantity::x}.allows_at_most()), 0.5);
}

TEST(Stacking, GrantsNoCreepOnLevelGround) {
  Stepping stated = statement_of::skinned();
  const Of x{"stacking", {}, "box 10", Quantity::x};
  const double before = x.allows(stated);
  stated.creep = 0.17;
  EXPECT_EQ(x.allows(stated), before);
}

// A skin moves boxes apart; it does not tilt them.
TEST(Stacking, TakesTheTiltFromTheSlopAlone) {
  Stepping stated = statement_of::skinned();
  const Of angle{"stacking", {}, "box 10", Quantity::angle};
  const double before = angle.allows(stated);
  stated.skin = 1;
  EXPECT_EQ(angle.allows(stated), before);
}

// What springs add to what a rigid contact is allowed.
double sinks(const Of& check) {
  Stepping rigid = statement_of::soft();
  rigid.contact_frequency = rigid.fixed_contact_frequency = 0;
  return check.allows(statement_of::soft()) - check.allows(rigid);
}

// Ten boxes on springs of 30 Hz, 60 Hz on the ground, sink by 1.25 g/w^2 = 0.352 mm/4 for each of ten weights on the
// ground and by 2.5 g/w^2 = 0.704 mm for each of 45 above.
TEST(Stacking, KnowsHowFarATowerSinksByTheSpringsOfItsContacts) {
  const Of top{"stacking", {}, "box 10", Quantity::y};
  constexpr double depth = 0.03254;
  EXPECT_NEAR(sinks(top), depth, 1e-5);
  EXPECT_LT(top.allows(statement_of::soft()), depth * (30.0 / 20) * (30.0 / 20))
      << "a tower on springs of 20 Hz, stated as of 30, is wrong";
}

// A box a hundred times as heavy presses the spring of one of 1 kg by 500 N 2.525/w^2 = 35.5 mm, and that one the
// ground's by 505 N 2.5/(2 w)^2 = 8.9 mm.
TEST(Stacking, WeighsWhatPressesASpring) {
  EXPECT_NEAR(sinks({"stacking", {{"boxes", 2}, {"ratio", 100}}, "box 2", Quantity::y}), 0.04442, 1e-5);
}

// The tallest of the row, of 18 boxes of half a metre: as above, whatever their size.
TEST(TowerRow, KnowsHowFarATowerSinksByTheSpringsOfItsContacts) {
  EXPECT_NEAR(sinks({"tower-row", {}, "box 18 of 18", Quantity::y}), (18. / 8 + 153) * 2.5 * 10 / 35530.58, 1e-6);
}

TEST(SettlingTower, KnowsHowFarATowerSinksByTheSpringsOfItsContacts) {
  EXPECT_NEAR(sinks({"settling-tower", {}, "box 10", Quantity::y}), 0.03254, 1e-5);
}

// Box2D 3 lets the second row sink by 2.24 mm, the apex by 8.65 mm.
TEST(Pyramid, KnowsHowFarEachRowSinksByTheSpringsOfItsContacts) {
  const double second = sinks({"pyramid", {{"base", 10}}, "box 2.5", Quantity::y});
  EXPECT_GT(second, 0.00224);
  EXPECT_LT(second, 1.3 * 0.00224);
  const double apex = sinks({"pyramid", {{"base", 10}}, "box 10.1", Quantity::y});
  EXPECT_GT(apex, 0.00865);
  EXPECT_LT(apex, 1.3 * 0.00865);
}

// Box2D 3 and Rapier tilt the top block by 5.9 mrad and lower it by 12.6 mm at 90 %.
TEST(Overhang, KnowsHowFarBlocksTiltByTheSpringsOfTheirContacts) {
  const Parameters most{{"fraction", 0.9}};
  EXPECT_NEAR(sinks({"overhang", most, "block 1", Quantity::angle}), 0.00589, 1e-5);
  EXPECT_NEAR(sinks({"overhang", most, "block 3", Quantity::angle}), 0.00308, 1e-5);
  EXPECT_NEAR(sinks({"overhang", most, "block 1", Quantity::y}), 0.0126, 1e-4);
}

// Box2D 3 and Rapier lower the second storey's roof by 10.2 mm, and the first one's by 4 mm.
TEST(CardHouse, KnowsHowFarStoreysSettleByTheSpringsOfTheirContacts) {
  const double second = sinks({"card-house", {{"levels", 3}}, "2: roof 1", Quantity::y});
  EXPECT_GT(second, 0.010 - 0.0042);
  EXPECT_LT(second, 1.5 * 0.0102);
  EXPECT_LT(sinks({"card-house", {{"levels", 3}}, "1: roof 1", Quantity::y}), second);
}

TEST(Arch, StopsACrownThatHasComeDownByItsThickness) {
  EXPECT_LT((Of{"arch", {}, "stone 10", Quantity::y}.allows_at_most()), 1.2 / 2);
}

// Items that hang where they started, with no force on them: 1.17 m/s after .117 s.
TEST(Tumbler, StopsItemsThatDoNotFallAndItemsOutsideTheDrum) {
  const Of falls{"tumbler", {}, "item 1", Quantity::vy};
  EXPECT_LT(*falls.expectations().front().expected, -1);
  EXPECT_LT(falls.allows_at_most(), 0.01);
  EXPECT_LT((Of{"tumbler", {}, "item 1", Quantity::x}.allows_at_most()), 0.03);
}

Scene scene_of(const char* name) {
  const Scenario& family = *Catalog<Scenario>::find(name);
  return family.scene(complete(family, {}));
}

TEST(TowerRow, HasATowerOfEachHeight) {
  EXPECT_EQ(scene_of("tower-row").bodies.size(), 1u + 18 * 19 / 2);
  EXPECT_EQ(*Of({"tower-row", {}, "box 18 of 18", Quantity::y}).expectations().front().expected, 17.5 * 0.5);
}

// A tower that falls lies on the ground.
TEST(TowerRow, StopsATowerThatFalls) {
  EXPECT_LT((Of{"tower-row", {}, "box 18 of 18", Quantity::y}.allows_at_most()), 17.5 * 0.5 / 10);
  EXPECT_LT((Of{"tower-row", {}, "box 1 of 1", Quantity::y}.allows_at_most()), 0.25);
}

// Each box starts above the one below it, and all gaps close.
TEST(SettlingTower, ClosesEveryGap) {
  const Scene scene = scene_of("settling-tower");
  for (int k = 1; k <= 10; ++k) {
    const std::string name = "box " + std::to_string(k);
    const double rests = *Of({"settling-tower", {}, name, Quantity::y}).expectations().front().expected;
    EXPECT_NEAR(scene.bodies[static_cast<std::size_t>(k)].position.y - rests, k * 0.02, 1e-12);
  }
}

// Boxes that keep bouncing do so with up to sqrt(2 g k gap).
TEST(SettlingTower, StopsBoxesThatBounceOrHang) {
  EXPECT_LT((Of{"settling-tower", {}, "box 10", Quantity::speed}.allows_at_most()), 0.2);
  EXPECT_LT((Of{"settling-tower", {}, "box 1", Quantity::y}.allows(statement_of::accurate())), 0.02 / 10);
}

// Without friction the pyramid falls along the slope with g sin a; at the angle of friction, tan a = mu, it coasts,
// that is stands still.
TEST(SlidingPyramid, SlidesFreelyWithoutFrictionAndHardlyAtTheAngleOfFriction) {
  const Scenario& scenario = *Catalog<Scenario>::find("sliding-pyramid");
  const auto slid = [&](double angle, double friction, double excess = 0) {
    const Parameters p = complete(scenario, {{"angle", angle}, {"friction", friction}, {"excess", excess}});
    const Scene scene = scenario.scene(p);
    const Vec start = scene.bodies[1].position;
    const auto all = scenario.expectations(p);
    return std::hypot(*all[0].expected - start.x, *all[1].expected - start.y);
  };
  const double degree = std::acos(-1) / 180;
  constexpr double duration = 1.5;
  EXPECT_NEAR(slid(30, 0), 10 * 0.5 / 2 * duration * duration, 1e-12);
  EXPECT_NEAR(slid(12, 0.2), 5 * duration * duration * std::abs(std::sin(12 * degree) - 0.2 * std::cos(12 * degree)),
              1e-12);
  EXPECT_LT(slid(12, 0.2), 0.2);
  EXPECT_EQ(slid(20, 0.1, 0.5), slid(20, 0.1)) << "the friction of sticking is too little to hold it";
}

// Carries the weights of a pyramid along gravity from the top to the slope: through a box, what comes in at x of its
// upper face leaves the lower one at x - tan a, its own weight at -tan a / 2. Each box shares its load between the two
// below it, on which it lies from -.5 to -.05 m and from .05 to .5 m beside its middle.
TEST(HeldPyramid, CarriesItsWeightStraightAgainstGravity) {
  struct Load {
    double size = 0, moment = 0;
  };
  for (int base = 2; base <= 8; ++base) {
    for (double degrees = 5; degrees <= 20; degrees += 2.5) {
      const double lean = std::tan(degrees * std::acos(-1) / 180);
      std::vector<Load> on_top(1);
      for (int boxes = 1; boxes <= base; ++boxes) {
        std::vector<Load> below(on_top.size() + 1);
        for (std::size_t i = 0; i < on_top.size(); ++i) {
          const double load = on_top[i].size + 1;
          const double at = (on_top[i].moment - on_top[i].size * lean - lean / 2) / load;
          EXPECT_LT(std::abs(at), .5) << base << " rows, " << degrees << " degrees, row " << base - boxes + 1;
          const double left = std::clamp(at - .1, -.5, -.05);
          const double right = std::clamp(at + .1, .05, .5);
          const double share = (at - left) / (right - left);
          EXPECT_GT(share, 0);
          EXPECT_LT(share, 1);
          const auto give = [&below](std::size_t box, double size, double place) {
            below[box].size += size;
            below[box].moment += size * place;
          };
          give(i, (1 - share) * load, left + .55);
          give(i + 1, share * load, right - .55);
        }
        on_top = below;
      }
    }
  }
}

// A pile that slides has left by half a box and more.
TEST(HeldPyramid, StopsAPileThatSlides) {
  const Of x{"held-pyramid", {{"base", 4}}, "box 4.1", Quantity::x};
  EXPECT_LT(x.allows(statement_of::accurate()), .02);
  const Of lowest{"held-pyramid", {}, "box 1.1", Quantity::x};
  EXPECT_LT(lowest.allows_at_most(), .5);
}

}  // namespace
}  // namespace plumb::stacks_test
