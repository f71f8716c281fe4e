#include "reports/judge/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "reports/judge/mechanics.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/vec.h"

namespace plumb::overlap_test {
namespace {

double gap(const Geometry& a, Vec at_a, double angle_a, const Geometry& b, Vec at_b, double angle_b) {
  const Outline one = placed(outline_of(a, {}), at_a, angle_a);
  const Outline other = placed(outline_of(b, {}), at_b, angle_b);
  const double forward = gap_between(one, other);
  const double back = gap_between(other, one);
  EXPECT_TRUE(back == forward || std::abs(back - forward) < 1e-14) << "the gap is the same from both sides";
  return forward;
}

const Geometry disc = Circle{.radius = 0.5};
const Geometry box = Box{.size = {2, 1}};
const Geometry capsule = Capsule{.from = {-1, 0}, .to = {1, 0}, .radius = 0.25};
const Geometry segment = Segment{.from = {-1, 0}, .to = {1, 0}};
const Geometry ground = HalfSpace{.normal = {0, 1}, .offset = 0};
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

TEST(GapBetween, ADiscOutsideABoxAtItsCornerAndDeepInside) {
  EXPECT_NEAR(gap(box, {0, 0}, 0, disc, {0, 1.5}, 0), 0.5, 1e-14);
  EXPECT_NEAR(gap(box, {0, 0}, 0, disc, {1.3, 0.9}, 0), 0, 1e-14);
  EXPECT_NEAR(gap(box, {0, 0}, 0, disc, {0, 0.2}, 0), -0.8, 1e-14);
}

TEST(GapBetween, CapsulesAreGrownSegments) {
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

TEST(GapBetween, HalfSpacesContainAllBelowTheirLine) {
  EXPECT_NEAR(gap(ground, {0, 1}, 0, disc, {7, 2}, 0), 0.5, 1e-14);
  EXPECT_NEAR(gap(ground, {0, 0}, 0, box, {0, 0.4}, 0), -0.1, 1e-14);
  EXPECT_NEAR(gap(ground, {0, 0}, quarter, disc, {-0.75, 9}, 0), 0.25, 1e-14);
  EXPECT_EQ(gap(ground, {0, 0}, 0, ground, {0, 0}, 1), std::numeric_limits<double>::infinity());
}

TEST(GapBetween, PolygonsOfEitherWinding) {
  const Geometry clockwise = Polygon{.vertices = {{0, 2}, {2, 0}, {0, 0}}};
  const Vec beyond_the_slope{2, 2};
  const double expected = std::sqrt(2.0) - 0.5;
  EXPECT_NEAR(gap(triangle, {0, 0}, 0, disc, beyond_the_slope, 0), expected, 1e-14);
  EXPECT_NEAR(gap(clockwise, {0, 0}, 0, disc, beyond_the_slope, 0), expected, 1e-14);
}

TEST(RangeAlong, CoversTheOutlineButNoHalfSpace) {
  const auto range = range_along({0, 1}, placed(outline_of(capsule, {0, 0}), {0, 2}, quarter));
  EXPECT_NEAR(range->low, 0.75, 1e-14);
  EXPECT_NEAR(range->high, 3.25, 1e-14);
  EXPECT_FALSE(range_along({0, 1}, outline_of(ground, {})));
}

Body box_at(double x, double y) {
  return {.name = "box", .position = {x, y}, .shapes = {{.geometry = Box{.size = {1, 1}}}}};
}

Body ground_body() { return {.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}}; }

double deepest(const Scene& scene) { return Overlap(scene).deepest(initial_states(scene)).depth; }

TEST(Overlap, FindsTheDeepestPair) {
  EXPECT_NEAR(deepest({.bodies = {ground_body(), box_at(0, 0.49), box_at(0, 1.46), box_at(8, 4)}}), 0.03, 1e-12);
  EXPECT_EQ(deepest({.bodies = {ground_body(), box_at(0, 0.5), box_at(0, 1.5)}}), 0);
}

TEST(Overlap, FindsThePairsWithinReach) {
  const Scene scene{.bodies = {ground_body(), box_at(0, 0.6), box_at(1.2, 0.8)}};
  const std::vector<BodyState> states = initial_states(scene);
  const auto pairs = [&](double reach) {
    return Overlap(scene).near(states, std::vector<double>{0, reach, reach}).size();
  };
  EXPECT_EQ(pairs(0), 0u);
  EXPECT_EQ(pairs(0.0999), 0u);
  EXPECT_EQ(pairs(0.1001), 2u);  // the ground and a box, and both boxes
  EXPECT_EQ(pairs(0.3001), 3u);
}

TEST(Overlap, LeavesOutBodiesThatMayNotTouch) {
  Scene layers{.bodies = {box_at(0, 0), box_at(0.5, 0)}};
  EXPECT_NEAR(deepest(layers), 0.5, 1e-12);
  layers.bodies[0].layers = 1;
  layers.bodies[1].layers = 2;
  EXPECT_EQ(deepest(layers), 0);

  Scene jointed{.bodies = {box_at(0, 0), box_at(0.5, 0)}};
  jointed.joints = {Revolute{.a = 1, .b = 0}};
  EXPECT_EQ(deepest(jointed), 0);

  Scene fixed{.bodies = {box_at(0, 0), box_at(0.5, 0)}};
  fixed.bodies[0].type = fixed.bodies[1].type = BodyType::fixed;
  EXPECT_EQ(deepest(fixed), 0);
}

TEST(Overlap, PlacesShapesAroundTheCentreOfMass) {
  Body shifted = box_at(0, 0.4);
  shifted.shapes[0].geometry = Box{.size = {1, 1}, .center = {3, 0}};
  EXPECT_NEAR(deepest({.bodies = {ground_body(), shifted}}), 0.1, 1e-12);
}

// Within round-off, for the extreme values of every parameter; the largest scenes only repeat their pattern.
TEST(Overlap, IsZeroInEverySceneOfTheCatalogAtItsStart) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    std::vector<Parameters> settings{complete(*scenario, {})};
    for (const Variant& variant : scenario->variants) settings.push_back(complete(*scenario, variant.changes));
    for (const Parameter& parameter : scenario->parameters) {
      settings.push_back(complete(*scenario, {{parameter.name, parameter.min}}));
      settings.push_back(complete(*scenario, {{parameter.name, parameter.max}}));
    }
    for (const Parameters& parameters : settings) {
      const Scene scene = scenario->scene(parameters);
      if (scene.bodies.size() > 2000) continue;
      EXPECT_LT(deepest(scene), 1e-9) << scenario->name << ' ' << scene.bodies.size();
    }
  }
}

}  // namespace
}  // namespace plumb::overlap_test
