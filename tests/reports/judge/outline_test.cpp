#include "reports/judge/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "reports/vec.h"

namespace plumb {
namespace {

double gap(const Geometry& a, Vec at_a, double angle_a, const Geometry& b, Vec at_b, double angle_b) {
  const Outline one = placed(outline_of(a, {}), at_a, angle_a);
  const Outline other = placed(outline_of(b, {}), at_b, angle_b);
  const double there = gap_between(one, other);
  const double back = gap_between(other, one);
  EXPECT_TRUE(back == there || std::abs(back - there) < 1e-14) << "the gap is the same from both sides";
  return there;
}

const Geometry disc = Circle{.radius = 0.5};
const Geometry box = Box{.size = {2, 1}};
const Geometry capsule = Capsule{.from = {-1, 0}, .to = {1, 0}, .radius = 0.25};
const Geometry segment = Segment{.from = {-1, 0}, .to = {1, 0}};
const Geometry context = HalfSpace{.normal = {0, 1}, .offset = 0};
const Geometry triangle = Polygon{.vertices = {{0, 0}, {2, 0}, {0, 2}}};
constexpr double quarter = std::numbers::pi / 2;

TEST(GapBetween, DiscsByTheirCentres) {
  EXPECT_NEAR(gap(disc, {0, 0}, 0, disc, {3, 4}, 1), 4, 1e-14);
  EXPECT_NEAR(gap(disc, {0, 0}, 0, disc, {0.6, 0}, 0), -0.4, 1e-14);
}

TEST(GapBetween, BoxesFaceToFaceAndCornerToCorner) {
  EXPECT_NEAR(gap(box, {0, 0}, 0, box, {0, 1.25}, 0), 0.25, 1e-14);
  EXPECT_NEAR(gap(box, {0, 0}, 0, box, {0.3, 0.9}, 0), -0.1, 1e-14);
  EXPECT_NEAR(gap(box, {0, 0}, 0, box, {5, 5}, 0), 5, 1e-14);  // corners (3, 4) apart
  EXPECT_NEAR(gap(box, {0, 0}, 0, box, {1.4, 0}, quarter), -0.1, 1e-14);
}

TEST(GapBetween, ADiscAndABoxOutsideBesideACornerAndDeepInside) {
  EXPECT_NEAR(gap(box, {0, 0}, 0, disc, {0, 1.5}, 0), 0.5, 1e-14);
  EXPECT_NEAR(gap(box, {0, 0}, 0, disc, {1.3, 0.9}, 0), 0, 1e-14);
  EXPECT_NEAR(gap(box, {0, 0}, 0, disc, {0, 0.2}, 0), -0.8, 1e-14);
}

TEST(GapBetween, CapsulesAreSegmentsGrown) {
  EXPECT_NEAR(gap(capsule, {0, 0}, 0, capsule, {0, 1}, 0), 0.5, 1e-14);
  EXPECT_NEAR(gap(capsule, {0, 0}, 0, capsule, {3, 0}, 0), 0.5, 1e-14);
  EXPECT_NEAR(gap(capsule, {0, 0}, 0, box, {0, 0.7}, 0), -0.05, 1e-14);
  EXPECT_NEAR(gap(capsule, {0, 0}, 0, disc, {1.3, 0.4}, 0), -0.25, 1e-14);
}

TEST(GapBetween, SegmentsThatCrossOrLieInLine) {
  EXPECT_NEAR(gap(segment, {0, 0}, 0, segment, {0, 0.25}, quarter), -0.75, 1e-14);
  EXPECT_NEAR(gap(segment, {0, 0}, 0, segment, {3, 0}, 0), 1, 1e-14);
  EXPECT_NEAR(gap(segment, {0, 0}, 0.3, disc, rotated({2, 0}, 0.3), 0), 0.5, 1e-14);
}

TEST(GapBetween, HalfSpacesHoldAllBelowTheirLine) {
  EXPECT_NEAR(gap(context, {0, 1}, 0, disc, {7, 2}, 0), 0.5, 1e-14);
  EXPECT_NEAR(gap(context, {0, 0}, 0, box, {0, 0.4}, 0), -0.1, 1e-14);
  EXPECT_NEAR(gap(context, {0, 0}, quarter, disc, {-0.75, 9}, 0), 0.25, 1e-14);
  EXPECT_EQ(gap(context, {0, 0}, 0, context, {0, 0}, 1), std::numeric_limits<double>::infinity());
}

TEST(GapBetween, PolygonsOfEitherWinding) {
  const Geometry turned = Polygon{.vertices = {{0, 2}, {2, 0}, {0, 0}}};
  const Vec beyond_the_slope{2, 2};
  const double expected = std::sqrt(2.0) - 0.5;
  EXPECT_NEAR(gap(triangle, {0, 0}, 0, disc, beyond_the_slope, 0), expected, 1e-14);
  EXPECT_NEAR(gap(turned, {0, 0}, 0, disc, beyond_the_slope, 0), expected, 1e-14);
}

TEST(RangeAlong, CoversTheOutlineAndNoHalfSpace) {
  const auto range = range_along({0, 1}, placed(outline_of(capsule, {0, 0}), {0, 2}, quarter));
  EXPECT_NEAR(range->low, 0.75, 1e-14);
  EXPECT_NEAR(range->high, 3.25, 1e-14);
  EXPECT_FALSE(range_along({0, 1}, outline_of(context, {})));
}

}  // namespace
}  // namespace plumb
