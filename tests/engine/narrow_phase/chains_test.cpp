// Chains of segments: see src/narrow_phase/chains.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "../random_shapes.h"
#include "../real_literal.h"
#include "narrow_phase/collide.h"
#include "shapes/distance.h"

namespace impulse::chains_test {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Pose origin{};

Pose at(Real x, Real y, Real angle = 0) { return {{x, y}, Rotation(angle)}; }

TEST(Collide, OfAChainIgnoresShapesBehindIt) {
  const std::vector<Vec2> points{{1, 0}, {-1, 0}};
  const Shape link = Shape::chain(points, false)[0];
  const Shape disc = Shape::circle(0.5_r);
  const Shape box = Shape::box({0.5_r, 0.5_r});
  EXPECT_EQ(collide(link, origin, disc, at(0, 0.4_r), 0.1_r).count, 1);
  EXPECT_EQ(collide(link, origin, disc, at(0, -0.4_r), 0.1_r).count, 0);
  EXPECT_EQ(collide(link, origin, box, at(0, 0.4_r), 0.1_r).count, 2);
  EXPECT_EQ(collide(link, origin, box, at(0, -0.4_r), 0.1_r).count, 0);
}

// The largest tilt of a normal while the shape is dragged over a floor of short pieces, slightly overlapping.
Real worst_lean(const std::vector<Shape>& floor, const Shape& shape, Real height) {
  Real worst = 0;
  for (int step = 0; step < 4000; ++step) {
    const Pose pose = at(-2 + 0.001_r * static_cast<Real>(step), height, 0.002_r * std::sin(static_cast<Real>(step)));
    int count = 0;
    for (const Shape& piece : floor) {
      const Manifold m = collide(piece, origin, shape, pose, 0.005_r);
      count += m.count;
      if (m.count > 0) worst = std::max(worst, std::abs(m.normal.x));
    }
    EXPECT_GT(count, 0) << "fell through at step " << step;
  }
  return worst;
}

TEST(Collide, NeverCatchesOnTheJoinsOfAChainAsItDoesOnPlainSegments) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 20; ++i) points.push_back({5 - 0.5_r * static_cast<Real>(i), 0});
  const std::vector<Shape> chain = Shape::chain(points, false);
  std::vector<Shape> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) segments.push_back(Shape::segment(points[i], points[i + 1]));

  const Shape box = Shape::box({0.4_r, 0.4_r});
  const Shape disc = Shape::circle(0.4_r);
  const Shape capsule = Shape::capsule({-0.3_r, 0}, {0.3_r, 0}, 0.1_r);
  const std::vector<Vec2> triangle{{-0.4_r, -0.4_r}, {0.4_r, -0.4_r}, {0, 0.4_r}};
  // The box itself leans by 0.002 rad, and its face may be the reference.
  EXPECT_LT(worst_lean(chain, box, 0.395_r), 0.003_r);
  EXPECT_LT(worst_lean(chain, disc, 0.395_r), 1e-4_r);
  EXPECT_LT(worst_lean(chain, capsule, 0.095_r), 0.003_r);
  EXPECT_LT(worst_lean(chain, Shape::polygon(triangle), 0.395_r), 0.003_r);
  EXPECT_GT(worst_lean(segments, box, 0.395_r), 0.9_r);
  EXPECT_GT(worst_lean(segments, disc, 0.395_r), 0.05_r);
}

TEST(Collide, OfAChainHoldsABoxInACornerAndOnAnEdge) {
  // A floor, then a wall on the left.
  const std::vector<Vec2> valley{{5, 0}, {0, 0}, {0, 5}};
  const std::vector<Shape> inward = Shape::chain(valley, false);
  const Shape box = Shape::box({0.5_r, 0.5_r});
  const Pose in_corner = at(0.495_r, 0.49_r);
  EXPECT_EQ(collide(inward[0], origin, box, in_corner, 0.01_r).normal, (Vec2{0, 1}));
  EXPECT_EQ(collide(inward[1], origin, box, in_corner, 0.01_r).normal, (Vec2{1, 0}));

  // A plateau that ends in a cliff on the left; the box slides down the cliff.
  const std::vector<Vec2> plateau{{5, 0}, {0, 0}, {0, -5}};
  const std::vector<Shape> outward = Shape::chain(plateau, false);
  const Pose beside = at(-0.495_r, 0.1_r);
  EXPECT_EQ(collide(outward[0], origin, box, beside, 0.01_r).count, 0);
  const Manifold pushed = collide(outward[1], origin, box, beside, 0.01_r);
  ASSERT_GT(pushed.count, 0);
  EXPECT_EQ(pushed.normal, (Vec2{-1, 0}));

  // On its corner over the edge, by one link only.
  const Pose balanced = at(-0.2_r, 0.65_r, 0.7853981634_r);
  EXPECT_EQ(collide(outward[0], origin, Shape::circle(1), at(-0.6_r, 0.79_r), 0.01_r).count +
                collide(outward[1], origin, Shape::circle(1), at(-0.6_r, 0.79_r), 0.01_r).count,
            1);
  EXPECT_LE(collide(outward[0], origin, box, balanced, 0.01_r).count, 2);
}

// A rough ground that runs towards -x: hills, dents, steep walls.
std::vector<Vec2> rough_ground(RandomShapes& random) {
  std::vector<Vec2> points;
  Real x = 4;
  for (int i = 0; i < 12; ++i) {
    points.push_back({x, random.number(-0.6, 0.6)});
    x -= random.number(0.05, 1.2);
  }
  return points;
}

struct Support {
  int count = 0;
  Real least = std::numeric_limits<Real>::infinity();
};

Support support_of(const std::vector<Shape>& chain, const Shape& shape, const Pose& pose, Real margin) {
  Support all;
  for (const Shape& link : chain) {
    const Manifold m = collide(link, origin, shape, pose, margin);
    all.count += m.count;
    for (int i = 0; i < m.count; ++i) {
      all.least = std::min(all.least, m.points[static_cast<std::size_t>(i)].separation);
    }
  }
  return all;
}

// For all joints, the links together report the distance to their line: no shape falls between two links, and none is
// reported nearer or deeper than it is.
TEST(Collide, OfAChainIsTheDistanceToTheWholeLine) {
  RandomShapes random(14);
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::vector<Vec2> points = rough_ground(random);
    const std::vector<Shape> chain = Shape::chain(points, false);
    const Shape shape = random.shape(all_shape_types[static_cast<std::size_t>(i) % 4]);
    Pose pose{{random.number(-1, 1), 4}, Rotation(random.number(-4, 4))};
    const auto to_line = [&] {
      Gap nearest{std::numeric_limits<Real>::infinity(), {}, {}, {}};
      for (const Shape& link : chain) {
        const Gap gap = distance(link, origin, shape, pose);
        if (gap.distance < nearest.distance) nearest = gap;
      }
      return nearest;
    };
    // Down to 0.1 m above the ground, by steps that cannot pass it.
    constexpr Real above = 0.1_r;
    for (int step = 0; step < 60; ++step) pose.p.y -= to_line().distance - above;
    const Real gap = to_line().distance;
    const Vec2 foot = to_line().a;
    const bool at_an_end = length(foot - points.front()) < 0.05_r || length(foot - points.back()) < 0.05_r;
    if (at_an_end || gap < 0.5_r * above || gap > 1.5_r * above) continue;
    ++compared;
    const Support near = support_of(chain, shape, pose, 0.2_r);
    ASSERT_GT(near.count, 0) << i;
    ASSERT_NEAR(near.least, gap, 3.1e-5_r * (gap + shape.radius()) + 100 * epsilon) << i;

    // Pushed in by `sink`, no height over any link can have changed by more.
    const Real sink = 0.02_r;
    pose.p.y -= gap + sink;
    const Support deep = support_of(chain, shape, pose, 0.2_r);
    ASSERT_GT(deep.count, 0) << i;
    ASSERT_GT(deep.least, -1.1_r * (gap + sink)) << i;
    ASSERT_LT(deep.least, gap) << i;
  }
  EXPECT_GT(compared, 3000);
}

}  // namespace
}  // namespace impulse::chains_test
