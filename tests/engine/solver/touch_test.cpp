#include "solver/touch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../support.h"
#include "bodies/body_set.h"
#include "narrow_phase/collide.h"

namespace impulse::inline IMPULSE_PRECISION::touch_test {
namespace {

constexpr Real tolerance = 64 * round_off;

struct Pair {
  BodySet bodies;
  Contact contact;

  Pair(const Shape& a, Vec2 at_a, const Shape& b, Vec2 at_b, double angle_a = 0, double angle_b = 0) {
    contact.body_a = add(a, at_a, angle_a);
    contact.body_b = add(b, at_b, angle_b);
    const Pose& pose_a = bodies.pose[contact.body_a];
    const Pose& pose_b = bodies.pose[contact.body_b];
    const Manifold m = collide(a, pose_a, b, pose_b, 1);
    contact.radius_a = a.radius();
    contact.radius_b = b.radius();
    contact.normal = m.normal;
    contact.count = m.count;
    contact.found_a = pose_a;
    contact.found_b = pose_b;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
      contact.points[i].arm_a = m.points[i].point - pose_a.p;
      contact.points[i].arm_b = m.points[i].point - pose_b.p;
      contact.found_separation[i] = m.points[i].separation;
    }
  }
  std::uint32_t add(const Shape& shape, Vec2 where, double angle) {
    BodyDef def;
    def.position = where;
    def.angle = real(angle);
    bodies.add(def, std::array{Part{shape, {}}});
    return static_cast<std::uint32_t>(bodies.size() - 1);
  }
  Touch touch() const { return {contact, bodies, contact.found_a, contact.found_b}; }
};

Motion moved(Vec2 by, double turn = 0) {
  Motion motion;
  motion.advance({by, real(turn)}, 1);
  return motion;
}

// The corner is at (1, 1). The disc was found beside it or above the face that ends there, and goes straight from one
// place to another, both from the corner; either body is listed first.
TEST(Touch, TellsWhenADiscPassesTheEndOfAFace) {
  struct Way {
    Vec2 found, from, to;
    double share;  // of the way to the end of the face
  };
  const auto way = [](Vec2 found, Vec2 from, Vec2 to, double share) { return Way{found, from, to, share}; };
  const auto v = [](double x, double y) { return Vec2{real(x), real(y)}; };
  const Vec2 beside = v(.3, .5);
  const Vec2 above = v(-.1, .6);
  for (const Way& one : {way(above, above, v(.2, .6), 1. / 3), way(above, v(-.4, .6), above, 1),
                         way(above, v(.2, .5), v(.4, .5), 1), way(beside, beside, v(-.3, .5), .5),
                         way(beside, beside, v(.6, -.3), .625), way(beside, v(-.2, .8), v(.8, -.4), .2),
                         way(beside, beside, v(.5, .2), 1), way(beside, v(-.2, .5), v(-2.2, .5), .9)}) {
    const Shape box = Shape::box({1, 1});
    const Shape disc = Shape::circle(real(.5));
    const Vec2 at = Vec2{1, 1} + one.found;
    const Motion still = moved({});
    const Motion from = moved(one.from - one.found);
    const Motion to = moved(one.to - one.found);
    const Touch first = Pair(box, {0, 0}, disc, at).touch();
    const Touch second = Pair(disc, at, box, {0, 0}).touch();
    EXPECT_NEAR(first.until_corner(still, from, still, to), one.share, tolerance) << one.share;
    EXPECT_NEAR(second.until_corner(from, still, to, still), one.share, tolerance) << one.share;
  }
}

// The corner is at (1, 1); the disc starts above and beside it, or above the face that ends there, and goes from the
// one to the other, either body listed first.
TEST(Touch, OfADiscAndABoxIsTheirDistanceWhereverTheDiscGoes) {
  for (const Vec2 start : {Vec2{real(.3), real(.5)}, Vec2{real(-.1), real(.6)}}) {
    for (const Vec2 apart : {start, Vec2{real(.7), real(.3)}, Vec2{real(.2), real(.5)}, Vec2{real(-.2), real(.3)}}) {
      const Vec2 to_disc{std::max(apart.x, Real{0}), apart.y};
      const Shape box = Shape::box({1, 1});
      const Shape disc = Shape::circle(real(.5));
      const Vec2 at = Vec2{1, 1} + start;
      const Pair first(box, {0, 0}, disc, at);
      const Pair second(disc, at, box, {0, 0});
      const TouchFrame frame = first.touch().at(moved({}), moved(apart - start));
      const TouchFrame other = second.touch().at(moved(apart - start), moved({}));
      EXPECT_NEAR(frame.points[0].separation, length(to_disc) - real(.5), tolerance);
      EXPECT_NEAR(first.touch().gap(0, moved({}), moved(apart - start)), length(to_disc) - real(.5), tolerance);
      EXPECT_NEAR(length(frame.normal - normalized(to_disc)), 0, tolerance);
      EXPECT_NEAR(other.points[0].separation, frame.points[0].separation, tolerance);
      EXPECT_NEAR(length(other.normal + frame.normal), 0, tolerance);
    }
  }
}

// Two boxes that lie on each other but for a small angle, each with one corner on the other: by which of the two faces
// they were found depends on the direction of the scene, and their points do not.
void expect_alike(const TouchFrame& frame, const TouchFrame& expected, int i, Real near = tolerance) {
  const bool same = std::abs(frame.points[0].cross_a - expected.points[0].cross_a) < real(.1);
  for (std::size_t k = 0; k < 2; ++k) {
    const PointArms& p = frame.points[same ? k : 1 - k];
    EXPECT_NEAR(p.separation, expected.points[k].separation, near) << i;
    EXPECT_NEAR(p.cross_a, expected.points[k].cross_a, near) << i;
    EXPECT_NEAR(p.cross_b, expected.points[k].cross_b, near) << i;
  }
}

TEST(Touch, OfFacesThatAreNearlyFlushDependsOnNoDirection) {
  const Shape box = Shape::box({real(.1), real(.11)});
  const auto frame_at = [&](double angle) {
    const Rotation turned(real(angle));
    const Pair pair(box, {}, box, turned * Vec2{real(.2025), real(.08)}, angle, angle + 4e-4);
    return pair.touch().at({}, {});
  };
  for (int i = 1; i < 16; ++i) expect_alike(frame_at(.4 * i), frame_at(0), i);
}

// The lower corners are level but for a hundredth of a millimetre. Which of them ends the overlap must be seen along
// the mean of both normals: along either one, 2 cm away, it is another. In float both are taken to be there.
TEST(Touch, OfFacesWithCornersBesideEachOtherDependsOnNoDirection) {
  const Shape tall = Shape::box({real(.1), real(.12)});
  const Shape low = Shape::box({real(.1), real(.1)});
  const auto frame_at = [&](double angle) {
    const Rotation turned(real(angle));
    const Pair pair(tall, {}, low, turned * Vec2{real(.22), real(-.02005)}, angle - 1e-3, angle + 5e-4);
    return pair.touch().at({}, {});
  };
  for (int i = 1; i < 16; ++i) expect_alike(frame_at(.4 * i), frame_at(0), i, std::max(tolerance, 512 * round_off));
}

// The side of the box below its corner, which the disc passes.
TEST(Touch, OfADiscFollowsACornerToEitherFaceBesideIt) {
  const Pair pair(Shape::box({1, 1}), {0, 0}, Shape::circle(real(.5)), {real(1.3), real(1.5)});
  const TouchFrame beside = pair.touch().at(moved({}), moved({real(.2), real(-.9)}));
  EXPECT_NEAR(beside.points[0].separation, 0, tolerance);
  EXPECT_NEAR(length(beside.normal - Vec2{1, 0}), 0, tolerance);
  EXPECT_NEAR(beside.points[0].cross_a, real(-.6), tolerance);
  const TouchFrame turned = pair.touch().at(moved({}, .2), moved({}));
  const Vec2 seen{real(1.3 * std::cos(.2) + 1.5 * std::sin(.2)), real(1.5 * std::cos(.2) - 1.3 * std::sin(.2))};
  EXPECT_NEAR(turned.points[0].separation, length(seen - Vec2{1, 1}) - real(.5), tolerance);
}

// One that is thrown through a face overlaps it; it does not come out on the other side.
TEST(Touch, OfADiscBehindAFaceIsAnOverlap) {
  const Pair pair(Shape::box({1, real(.01)}), {0, 0}, Shape::circle(real(.1)), {0, real(.3)});
  EXPECT_NEAR(pair.touch().gap(0, moved({}), moved({0, real(-.4)})), real(-.21), tolerance);
}

// Of ground that goes on the search has left out what the plane of the face stands for.
TEST(Touch, OfAFaceThatOthersJoinIsWithItsPlane) {
  Pair pair(Shape::box({1, 1}), {0, 0}, Shape::circle(real(.5)), {real(.9), real(1.6)});
  pair.contact.joins = true;
  EXPECT_NEAR(pair.touch().gap(0, moved({}), moved({real(.4), 0})), real(.1), tolerance);
  EXPECT_NEAR(pair.touch().at(moved({}), moved({real(.4), 0})).normal.x, 0, tolerance);
}

TEST(Touch, OfAFaceTurnsWithItsBody) {
  const Pair pair(Shape::box({2, 1}), {0, 0}, Shape::circle(real(.5)), {0, real(1.6)});
  const TouchFrame frame = pair.touch().at(moved({}, .1), moved({}));
  EXPECT_NEAR(frame.normal.x, -std::sin(.1), tolerance);
  EXPECT_NEAR(frame.normal.y, std::cos(.1), tolerance);
  EXPECT_NEAR(frame.points[0].separation, real(1.6 * std::cos(.1) - 1.5), tolerance);
}

// An impulse that acts on two bodies in two places would change their angular momentum.
TEST(Touch, LetsBothArmsEndInOnePlace) {
  const Pair pair(Shape::box({2, 1}), {0, 0}, Shape::box({real(.5), real(.5)}), {real(.2), real(1.5)});
  const TouchFrame frame = pair.touch().at(moved({}, .05), moved({real(.1), real(.02)}, -.1));
  const Vec2 tangent = perpendicular(frame.normal);
  for (const PointArms& p : frame.points) {
    const Vec2 on_a = p.dot_a * frame.normal - p.cross_a * tangent;
    const Vec2 on_b = Vec2{real(.3), real(1.52)} + p.dot_b * frame.normal - p.cross_b * tangent;
    EXPECT_NEAR(length(on_a - on_b), 0, tolerance);
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::touch_test
