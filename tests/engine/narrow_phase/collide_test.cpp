#include "narrow_phase/collide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../random_shapes.h"
#include "../real_literal.h"

namespace impulse::collide_test {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Pose origin{};

Pose at(Real x, Real y, Real angle = 0) { return {{x, y}, Rotation(angle)}; }

Real least_separation(const Manifold& m) {
  Real least = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < m.count; ++i) least = std::min(least, m.points[static_cast<std::size_t>(i)].separation);
  return least;
}

bool half_space_free(ShapeType type) { return type != ShapeType::half_space; }
bool has_inside(ShapeType type) { return type != ShapeType::half_space && type != ShapeType::segment; }

TEST(Collide, SupportsEveryPairOfTypes) {
  RandomShapes random(1);
  for (const ShapeType a : all_shape_types) {
    for (const ShapeType b : all_shape_types) {
      const bool can_meet = has_inside(a) || has_inside(b) || (half_space_free(a) != half_space_free(b));
      int met = 0;
      for (int i = 0; i < 50; ++i) {
        const Shape shape_a = random.shape(a);
        const Shape shape_b = random.shape(b);
        const Pose pose_a = random.pose(0.2);
        const Manifold m = collide(shape_a, pose_a, shape_b, random.pose(0.2), 0.1_r);
        met += m.count > 0 ? 1 : 0;
        EXPECT_LE(m.count, 2);
        EXPECT_NEAR(length(m.normal), m.count > 0 || length(m.normal) > 0 ? 1 : 0, 4 * epsilon);
      }
      EXPECT_EQ(met > 0, can_meet) << static_cast<int>(a) << " with " << static_cast<int>(b);
    }
  }
}

// A table with only one of (a, b) and (b, a) filled, or without flipping the normal, fails here.
TEST(Collide, OfSwappedShapesFlipsTheNormalExactlyAndKeepsThePoints) {
  RandomShapes random(2);
  for (const ShapeType type_a : all_shape_types) {
    for (const ShapeType type_b : all_shape_types) {
      for (int i = 0; i < 300; ++i) {
        const Shape a = random.shape(type_a);
        const Shape b = random.shape(type_b);
        const Pose pose_a = random.pose(1);
        const Pose pose_b = random.pose(1);
        const Manifold m = collide(a, pose_a, b, pose_b, 0.2_r);
        const Manifold n = collide(b, pose_b, a, pose_a, 0.2_r);
        ASSERT_EQ(m.count, n.count);
        ASSERT_EQ(m.normal, -n.normal);
        for (std::size_t k = 0; k < static_cast<std::size_t>(m.count); ++k) {
          ASSERT_EQ(m.points[k].point, n.points[k].point);
          ASSERT_EQ(m.points[k].separation, n.points[k].separation);
          const std::uint32_t feature = n.points[k].feature;
          ASSERT_EQ(m.points[k].feature, (feature & 0xff) << 8 | feature >> 8);
        }
      }
    }
  }
}

// Change of basis: the result does not depend on the world's frame.
TEST(Collide, GivesTheSameInEveryFrame) {
  RandomShapes random(3);
  const Pose moved{{3, -2}, Rotation(0.6_r)};
  const auto seen = [&](const Pose& pose) { return Pose{to_world(moved, pose.p), moved.q * pose.q}; };
  constexpr Real allowed = 100 * epsilon;  // a few roundings of coordinates up to 10
  int different = 0;
  for (int i = 0; i < 5000; ++i) {
    const Shape a = random.shape(all_shape_types[static_cast<std::size_t>(i) % 6]);
    const Shape b = random.shape(all_shape_types[static_cast<std::size_t>(i) / 6 % 6]);
    const Pose pose_a = random.pose(1);
    const Pose pose_b = random.pose(1);
    const Manifold m = collide(a, pose_a, b, pose_b, 0.2_r);
    const Manifold n = collide(a, seen(pose_a), b, seen(pose_b), 0.2_r);
    // Rounding may decide between two equal faces, or about a point exactly at the margin; all else must agree.
    const bool tipped = m.count != n.count || (m.count > 0 && dot(moved.q * m.normal, n.normal) < 0.999_r);
    different += tipped ? 1 : 0;
    if (tipped) continue;
    for (std::size_t k = 0; k < static_cast<std::size_t>(m.count); ++k) {
      const Vec2 p = to_world(moved, m.points[k].point);
      ASSERT_NEAR(m.points[k].separation, n.points[k].separation, allowed);
      ASSERT_NEAR(p.x, n.points[k].point.x, 20 * allowed);
      ASSERT_NEAR(p.y, n.points[k].point.y, 20 * allowed);
    }
  }
  EXPECT_LT(different, 5);
}

TEST(Collide, LeavesOutPointsBeyondTheMargin) {
  const Shape box = Shape::box({1, 1});
  const Shape disc = Shape::circle(1);
  EXPECT_EQ(collide(box, origin, box, at(0, 2.25_r), 0.2_r).count, 0);
  EXPECT_EQ(collide(box, origin, box, at(0, 2.25_r), 0.25_r).count, 2);
  EXPECT_EQ(collide(disc, origin, disc, at(0, 2.25_r), 0.2_r).count, 0);
  EXPECT_EQ(collide(disc, origin, disc, at(0, 2.25_r), 0.25_r).count, 1);
  EXPECT_EQ(collide(disc, origin, box, at(0, 2.25_r), 0.25_r).count, 1);
}

// The core of two shapes' separation, found without separating axes: vertices against edges in double.
struct Oracle {
  double distance = 0;  // 0 where they overlap
  double depth = 0;     // least penetration over all face normals
};

struct Point {
  double x, y;
};

std::vector<Point> corners(const Shape& shape, const Pose& pose) {
  std::vector<Point> out;
  for (int i = 0; i < shape.count(); ++i) {
    const Vec2 v = shape.vertex(i);
    out.push_back({static_cast<double>(pose.p.x) + static_cast<double>(pose.q.c) * static_cast<double>(v.x) -
                       static_cast<double>(pose.q.s) * static_cast<double>(v.y),
                   static_cast<double>(pose.p.y) + static_cast<double>(pose.q.s) * static_cast<double>(v.x) +
                       static_cast<double>(pose.q.c) * static_cast<double>(v.y)});
  }
  return out;
}

double to_edge(Point p, Point a, Point b) {
  const double ex = b.x - a.x;
  const double ey = b.y - a.y;
  const double u = std::clamp(((p.x - a.x) * ex + (p.y - a.y) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
  return std::hypot(p.x - a.x - u * ex, p.y - a.y - u * ey);
}

Oracle ask_oracle(const std::vector<Point>& a, const std::vector<Point>& b) {
  double nearest = 1e300;
  double best = -1e300;
  for (const auto* pair : {&a, &b}) {
    const std::vector<Point>& one = *pair;
    const std::vector<Point>& other = pair == &a ? b : a;
    for (std::size_t i = 0; i < one.size(); ++i) {
      const Point p = one[i];
      const Point q = one[(i + 1) % one.size()];
      const double l = std::hypot(q.x - p.x, q.y - p.y);
      double lowest = 1e300;
      for (const Point v : other) {
        nearest = std::min(nearest, to_edge(v, p, q));
        lowest = std::min(lowest, ((v.x - p.x) * (q.y - p.y) - (v.y - p.y) * (q.x - p.x)) / l);
      }
      best = std::max(best, lowest);
    }
  }
  return best > 0 ? Oracle{nearest, 0} : Oracle{0, -best};
}

void expect_oracle(ShapeType type_a, ShapeType type_b, unsigned seed) {
  RandomShapes random(seed);
  constexpr double margin = 0.3;
  constexpr double rounding = 64 * static_cast<double>(epsilon);
  int apart = 0;
  int overlapping = 0;
  for (int i = 0; i < 20000; ++i) {
    const Shape a = random.shape(type_a);
    const Shape b = random.shape(type_b);
    const Pose pose_a = random.pose(1);
    const Pose pose_b = random.pose(1);
    const Oracle truth = ask_oracle(corners(a, pose_a), corners(b, pose_b));
    const double radii = static_cast<double>(a.radius() + b.radius());
    const Manifold m = collide(a, pose_a, b, pose_b, static_cast<Real>(margin));
    if (truth.distance - radii > margin + rounding) {
      ASSERT_EQ(m.count, 0) << i;
      continue;
    }
    if (truth.distance - radii > margin - rounding) continue;
    ASSERT_GT(m.count, 0) << i;
    const auto found = static_cast<double>(least_separation(m));
    if (truth.distance > 0) {
      // Nearly parallel faces count as parallel: 1 - cos(1/128) of the distance.
      ASSERT_NEAR(found, truth.distance - radii, rounding + truth.distance * 3.1e-5) << i;
      ++apart;
    } else {
      // The first shape's face is preferred by so much, see beats().
      ASSERT_GE(-found - radii, truth.depth - rounding) << i;
      ASSERT_LE(-found - radii, truth.depth * (1 + 1.0 / 63) + 1.02e-4 + rounding) << i;
      ++overlapping;
    }
  }
  EXPECT_GT(apart, 500);
  EXPECT_GT(overlapping, 500);
}

TEST(Collide, OfBoxesMatchesBruteForce) { expect_oracle(ShapeType::box, ShapeType::box, 4); }
TEST(Collide, OfBoxAndPolygonMatchesBruteForce) { expect_oracle(ShapeType::box, ShapeType::polygon, 5); }
TEST(Collide, OfPolygonsMatchesBruteForce) { expect_oracle(ShapeType::polygon, ShapeType::polygon, 6); }
TEST(Collide, OfCapsulesMatchesBruteForce) { expect_oracle(ShapeType::capsule, ShapeType::capsule, 7); }
TEST(Collide, OfCapsuleAndPolygonMatchesBruteForce) { expect_oracle(ShapeType::polygon, ShapeType::capsule, 8); }
TEST(Collide, OfBoxAndSegmentMatchesBruteForce) { expect_oracle(ShapeType::box, ShapeType::segment, 9); }
TEST(Collide, OfCapsuleAndSegmentMatchesBruteForce) { expect_oracle(ShapeType::capsule, ShapeType::segment, 10); }

// A circle is a point with a radius, so the same oracle applies.
TEST(Collide, OfCirclesMatchesBruteForceOutsideOfCores) {
  RandomShapes random(11);
  for (const ShapeType type :
       {ShapeType::circle, ShapeType::box, ShapeType::polygon, ShapeType::capsule, ShapeType::segment}) {
    for (int i = 0; i < 5000; ++i) {
      const Shape a = random.shape(ShapeType::circle);
      const Shape b = random.shape(type);
      const Pose pose_a = random.pose(1.5);
      const Pose pose_b = random.pose(1.5);
      const Point center = corners(a, pose_a)[0];
      const std::vector<Point> outline = corners(b, pose_b);
      double nearest = std::hypot(center.x - outline[0].x, center.y - outline[0].y);
      if (outline.size() > 1) {
        for (std::size_t k = 0; k < outline.size(); ++k) {
          nearest = std::min(nearest, to_edge(center, outline[k], outline[(k + 1) % outline.size()]));
        }
      }
      const bool inside =
          b.count() > 2 && b.contains(to_local(pose_b, {static_cast<Real>(center.x), static_cast<Real>(center.y)}));
      const double expected = (inside ? -nearest : nearest) - static_cast<double>(a.radius() + b.radius());
      const Manifold m = collide(a, pose_a, b, pose_b, 10);
      ASSERT_EQ(m.count, 1);
      ASSERT_NEAR(static_cast<double>(m.points[0].separation), expected, 64 * static_cast<double>(epsilon));
    }
  }
}

// Moved apart by the reported separation along the reported normal, the pair just touches.
TEST(Collide, ReportsThePenetrationToRemove) {
  RandomShapes random(12);
  for (int i = 0; i < 20000; ++i) {
    const Shape a = random.shape(all_shape_types[static_cast<std::size_t>(i) % 6]);
    const Shape b = random.shape(all_shape_types[static_cast<std::size_t>(i) / 6 % 6]);
    const Pose pose_a = random.pose(1);
    Pose pose_b = random.pose(1);
    const Manifold m = collide(a, pose_a, b, pose_b, 0);
    if (m.count == 0) continue;
    const Real depth = -least_separation(m);
    pose_b.p += depth * m.normal;
    const Manifold touching = collide(a, pose_a, b, pose_b, 0.01_r);
    ASSERT_GT(touching.count, 0) << i;
    // Not exactly 0: the first shape's face is preferred by so much, see beats().
    ASSERT_NEAR(least_separation(touching), 0, 1.1e-4_r + depth / 60) << i;
  }
}

// A box stands on the corner of another with its own, in every direction and mirrored: which shape comes first says
// nothing.
TEST(Collide, OfTwoCornersIsByTheFaceThatSeparatesThemMost) {
  constexpr double depth = 1e-5;
  constexpr double beside = 8e-5;  // by the other shape's face: less than the first shape's is preferred by
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const double mirror : {1., -1.}) {
      const Rotation turned(static_cast<Real>(quarter * 1.5707963267948966));
      const Rotation tilted(static_cast<Real>(mirror * .5));
      const Vec2 corner = tilted * Vec2{static_cast<Real>(mirror * -.3), -0.3_r};
      const Vec2 there = Vec2{static_cast<Real>(mirror * (.5 - beside)), static_cast<Real>(.5 - depth)} - corner;
      for (const bool boxes : {true, false}) {
        const auto square = [&](Real half) {
          const std::array<Vec2, 4> corners{Vec2{-half, -half}, {half, -half}, {half, half}, {-half, half}};
          return boxes ? Shape::box({half, half}) : Shape::polygon(corners);
        };
        const Manifold m = collide(square(0.5_r), {{}, turned}, square(0.3_r), {turned * there, turned * tilted}, 0);
        ASSERT_GT(m.count, 0);
        EXPECT_NEAR(static_cast<double>(least_separation(m)), -depth, 64 * static_cast<double>(epsilon))
            << quarter << ' ' << mirror << ' ' << boxes;
      }
    }
  }
}

TEST(Collide, OfStackedBoxesHasTwoPointsWithTheirOwnSeparations) {
  const Shape box = Shape::box({0.5_r, 0.5_r});
  const Real tilt = 0.02_r;
  const Manifold m = collide(Shape::box({5, 0.5_r}), origin, box, at(0.25_r, 1, tilt), 0.1_r);
  ASSERT_EQ(m.count, 2);
  EXPECT_EQ(m.normal, (Vec2{0, 1}));
  const SinCos of = sin_cos(tilt);
  for (const ManifoldPoint& p : m.points) {
    const Real side = p.point.x < 0.25_r ? -0.5_r : 0.5_r;
    const Vec2 corner{0.25_r + of.cos * side + of.sin * 0.5_r, 1 + of.sin * side - of.cos * 0.5_r};
    EXPECT_NEAR(p.separation, corner.y - 0.5_r, 4 * epsilon);
    EXPECT_NEAR(p.point.x, corner.x, 4 * epsilon);
    EXPECT_NEAR(p.point.y, (corner.y + 0.5_r) / 2, 4 * epsilon);  // midway
  }
}

TEST(Collide, KeepsItsFeaturesWhileABoxJittersOnAnother) {
  const Shape box = Shape::box({0.5_r, 0.5_r});
  const Manifold still = collide(box, origin, box, at(0, 0.995_r), 0.02_r);
  ASSERT_EQ(still.count, 2);
  RandomShapes random(13);
  for (int i = 0; i < 1000; ++i) {
    const Pose trembling{{random.number(-1e-3, 1e-3), random.number(0.99, 1.005)},
                         Rotation(random.number(-3e-3, 3e-3))};
    const Manifold m = collide(box, origin, box, trembling, 0.02_r);
    ASSERT_EQ(m.count, 2) << i;
    ASSERT_EQ(m.points[0].feature, still.points[0].feature) << i;
    ASSERT_EQ(m.points[1].feature, still.points[1].feature) << i;
  }
}

TEST(Collide, UsesTheLineBetweenCornersThatPassEachOther) {
  const Shape box = Shape::box({1, 1});
  const Manifold m = collide(box, origin, box, at(2.03_r, 2.04_r), 0.1_r);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.points[0].separation, 0.05_r, 8 * epsilon);
  EXPECT_NEAR(m.normal.x, 0.6_r, 200 * epsilon);  // two roundings of a coordinate 2 in a distance 0.05
  EXPECT_NEAR(m.normal.y, 0.8_r, 200 * epsilon);
}

TEST(Collide, SeparatesCapsulesThatLieEndToEnd) {
  const Shape capsule = Shape::capsule({-1, 0}, {1, 0}, 0.25_r);
  const Manifold m = collide(capsule, origin, capsule, at(2.4_r, 0), 0.1_r);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.points[0].separation, -0.1_r, 8 * epsilon);
  EXPECT_EQ(m.normal, (Vec2{1, 0}));
}

// Bent so little that the face of one separates the cores by less than the preference of the other allows for.
TEST(Collide, SeparatesCapsulesThatLieEndToEndSlightlyBent) {
  const Shape capsule = Shape::capsule({-1, 0}, {1, 0}, 0.25_r);
  for (const Real turn : {1e-6_r, 2e-5_r, -2e-5_r, 1e-4_r, -1e-3_r}) {
    for (const Real rise : {0.0_r, 1e-5_r, -1e-5_r, -3e-5_r}) {
      const Manifold m = collide(capsule, origin, capsule, at(2.4_r, rise, turn), 0.1_r);
      ASSERT_EQ(m.count, 1);
      EXPECT_NEAR(m.points[0].separation, -0.1_r, 1e-5_r) << turn << ' ' << rise;
      EXPECT_GT(m.normal.x, 0.99_r) << turn << ' ' << rise;
    }
  }
}

TEST(Collide, KeepsItsPrecisionFarFromTheOrigin) {
  const Shape box = Shape::box({0.5_r, 0.5_r});
  const Real far = 4096;  // a power of two: sums with halves and quarters are exact
  const Manifold near = collide(box, at(0, 0, 0.3_r), box, at(0.25_r, 1, 0.4_r), 0.1_r);
  const Manifold m = collide(box, at(far, far, 0.3_r), box, at(far + 0.25_r, far + 1, 0.4_r), 0.1_r);
  ASSERT_EQ(m.count, near.count);
  ASSERT_GT(m.count, 0);
  EXPECT_EQ(m.normal, near.normal);
  EXPECT_EQ(m.points[0].separation, near.points[0].separation);
}

TEST(Collide, OfAHalfSpaceTakesTheTwoDeepestCorners) {
  const Shape ground = Shape::half_space({0, 2}, 1);  // y <= 0.5
  const Manifold m = collide(ground, origin, Shape::box({1, 0.5_r}), at(0, 0.9_r, 0.1_r), 0.01_r);
  ASSERT_EQ(m.count, 2);
  EXPECT_EQ(m.normal, (Vec2{0, 1}));
  EXPECT_LT(least_separation(m), -0.19_r);
}

TEST(Collide, OfAHalfSpaceSeesTheFarEndOfARodThatFallsOver) {
  const Shape floor = Shape::half_space({0, 1}, 0);
  const Shape rod = Shape::box({1, 0.01_r});
  // The foot's other corner is lower than the far end, which is on its way down.
  const Pose leaning = at(0, 0.1_r, 0.1_r);
  const Manifold m = collide(floor, origin, rod, leaning, 1);
  ASSERT_EQ(m.count, 2);
  EXPECT_GT(std::abs(m.points[0].point.x - m.points[1].point.x), 1.9_r);
}

}  // namespace
}  // namespace impulse::collide_test
