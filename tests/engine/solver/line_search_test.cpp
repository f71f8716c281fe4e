#include "solver/line_search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "column.h"
#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::line_search_test {
namespace {

struct Fall {
  double highest = 0;  // m, of the heavy body after it has hit
  double apart = 0;    // m, how far the two end from where they rest
};

/// A body falls `height` on one `ratio` times lighter, which rests on the ground.
Fall fall_of_heavy_on_light(double ratio, double height) {
  World world(accurate());
  ground(world, {1, real(.5), real(.5), 0});
  const Shape cube = Shape::box(vec(.5, .5));
  const BodyId light = world.create_body(at(0, .5), cube, {1, real(.5), real(.5), 0});
  const BodyId heavy = world.create_body(at(0, 1.5 + height), cube, {real(ratio), real(.5), real(.5), 0});
  run_for(world, std::sqrt(2 * height / g) + 2.0 / 60);
  Fall fall;
  for (int i = 0; i < 240; ++i) {
    world.step();
    fall.highest = std::max(fall.highest, static_cast<double>(world.body(heavy).position().y));
  }
  fall.apart = std::max(std::abs(static_cast<double>(world.body(light).position().y) - .5),
                        std::abs(static_cast<double>(world.body(heavy).position().y) - 1.5));
  return fall;
}

// The impulse of the blow, given again as a guess, threw it up: 6 kJ became 637.
TEST(LineSearch, KeepsAHeavyBodyFromBeingThrownUpByTheBlowThatStoppedIt) {
  for (const double ratio : {10.0, 100.0, 1000.0}) {
    for (const double height : {.1, .5, 2.0}) {
      const Fall fall = fall_of_heavy_on_light(ratio, height);
      EXPECT_LT(fall.highest, 1.502) << ratio << ' ' << height;
      EXPECT_LT(fall.apart, ratio < 1000 ? .001 : .01) << ratio << ' ' << height;
    }
  }
}

/// A body of 1000 kg on one of 1 kg, which lies on the ground.
struct HeavyOnLight : Column {
  std::vector<Velocity> acceleration = std::vector<Velocity>(3), kicks = acceleration, changes = acceleration;
  LineSearch search;

  HeavyOnLight() : Column({1, 1000}) {}
  /// The impulse, N s, that is kept of both contacts after a sub-step that began with `guess` and ended with `impulse`.
  double kept(double impulse, double guess) {
    for (ImpactRow& row : rows) {
      row.points[0].normal_impulse = real(impulse);
      row.half[0].x = real(guess / 2);
    }
    search.temper(island, bodies, acceleration, kicks, changes);
    EXPECT_NEAR(rows[0].points[0].normal_impulse, rows[1].points[0].normal_impulse, bound(1e-9, 1e-2));
    return static_cast<double>(rows[1].points[0].normal_impulse);
  }
};

TEST(LineSearch, KeepsAnImpulseThatBearsTheWeight) {
  HeavyOnLight column;
  column.acceleration[2].v.y = -10;
  EXPECT_EQ(column.kept(100, 6), 100) << "1000 kg 10 m/s^2 .01 s";
  EXPECT_EQ(column.kept(150, 100), 150) << "which only brakes";
}

TEST(LineSearch, GoesBackFromABlowToTheLoadBefore) {
  HeavyOnLight column;
  column.acceleration[2].v.y = -10;
  EXPECT_NEAR(column.kept(4000, 100), 100, bound(1e-9, 1e-2));
  EXPECT_NEAR(column.kept(4000, 0), 100, bound(1e-9, 1e-2));
}

TEST(LineSearch, KeepsNothingOfABodyThatLeaves) {
  HeavyOnLight column;
  column.bodies.velocity[2].v.y = 3;
  EXPECT_EQ(column.kept(100, 100), 0);
}

/// A sweep of relax: no contact approaches after its turn.
void sweep(Column& column) {
  for (ImpactRow& row : column.rows) {
    RowPoint& p = row.points[0];
    Velocity& a = column.bodies.velocity[row.a];
    Velocity& b = column.bodies.velocity[row.b];
    ContactFrame frame(row, a, b);
    apply_accumulated(row, p, frame, std::max(p.normal_impulse - p.normal_mass * frame.normal_velocity(p), real(0)));
    frame.write_back(row, a, b);
  }
}

TEST(LineSearch, StopsAHeavyBodyOnALightOneInFewerSweeps) {
  for (const bool helped : {false, true}) {
    HeavyOnLight column;
    column.bodies.velocity[2].v.y = -1;
    column.search.begin(column.island);
    for (int i = 0; i < 60; ++i) {
      if (helped && i > 0) column.search.go_on(column.island, column.bodies, column.changes, false);
      sweep(column);
    }
    const double speed = std::abs(static_cast<double>(column.bodies.velocity[2].v.y));
    if (helped) {
      EXPECT_LT(speed, .5);
    } else {
      EXPECT_GT(speed, .9) << "sweeps alone need as many as the ratio of the masses";
    }
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::line_search_test
