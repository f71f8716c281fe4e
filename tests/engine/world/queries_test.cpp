#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "../support.h"

namespace queries_test {
namespace {

using namespace impulse;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<BodyId> found_at(World& world, Vec2 point) {
  std::vector<BodyId> found;
  world.query_point(point, [&found](BodyId id, const Part&) {
    found.push_back(id);
    return true;
  });
  return found;
}

std::vector<BodyId> found_in(World& world, const Aabb& box) {
  std::vector<BodyId> found;
  world.query_aabb(box, [&found](BodyId id, const Part&) {
    found.push_back(id);
    return true;
  });
  return found;
}

TEST(QueryPoint, FindsTheBodiesThatContainIt) {
  World world;
  const BodyId disc = world.create_body(at(0, 0), Shape::circle(1));
  BodyDef turned = at(1, 0);
  turned.angle = pi / 4;
  const BodyId box = world.create_body(turned, Shape::box({1, 1}));
  EXPECT_THAT(found_at(world, {Real{0.5}, 0}), ElementsAre(disc, box));
  EXPECT_THAT(found_at(world, {Real{2.25}, 0}), ElementsAre(box));  // inside only because the box is rotated
  EXPECT_THAT(found_at(world, {Real{1.75}, real(.8)}), IsEmpty());
  world.remove_body(box);
  EXPECT_THAT(found_at(world, {Real{2.25}, 0}), IsEmpty());
}

TEST(QueryPoint, FindsABodyAtItsNewPose) {
  World world;
  const BodyId disc = world.create_body(at(0, 0), Shape::circle(1));
  world.body(disc).set_pose({50, 0}, 0);
  EXPECT_THAT(found_at(world, {50, 0}), ElementsAre(disc));
}

TEST(QueryAabb, FindsEveryPartWhoseBoundsItOverlaps) {
  World world;
  const std::array parts{Part{Shape::circle(1, {-5, 0}), {}}, Part{Shape::circle(1, {5, 0}), {}}};
  const BodyId dumbbell = world.create_body({}, parts);
  EXPECT_THAT(found_in(world, {{-10, -1}, {10, 1}}), ElementsAre(dumbbell, dumbbell));
  EXPECT_THAT(found_in(world, {{3, -1}, {10, 1}}), ElementsAre(dumbbell));
  EXPECT_THAT(found_in(world, {{-1, -1}, {1, 1}}), IsEmpty());
}

TEST(QueryAabb, StopsWhenTheCallbackReturnsFalse) {
  World world;
  for (int i = 0; i < 5; ++i) world.create_body(at(i, 0), Shape::circle(1));
  int calls = 0;
  world.query_aabb({{-10, -10}, {10, 10}}, [&calls](BodyId, const Part&) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
}

TEST(RayCast, FindsTheNearestPartAndThePointOfEntry) {
  World world;
  world.create_body(at(8, 0), Shape::circle(1));
  BodyDef turned = at(4, 0);
  turned.angle = pi / 2;
  const std::array parts{Part{Shape::circle(Real{0.5}, {0, 5}), {}}, Part{Shape::box({1, 2}), {}}};
  const BodyId near = world.create_body(turned, parts);
  // The rotated box extends from x = 2 to 6 and y = -1 to 1; the circle is behind the ray's start.
  const std::optional<BodyHit> hit = world.ray_cast({0, 0}, {10, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, near);
  EXPECT_EQ(hit->part, 1U);
  EXPECT_NEAR(hit->point.x, 2, 32 * round_off);
  const std::optional<BodyHit> lower = world.ray_cast({4, -10}, {4, 10});
  ASSERT_TRUE(lower);
  EXPECT_NEAR(lower->point.y, -1, 32 * round_off);
  EXPECT_NEAR(lower->fraction, .45, 8 * round_off);
  EXPECT_NEAR(lower->normal.y, -1, 8 * round_off);
  EXPECT_FALSE(world.ray_cast({0, 9}, {10, 9}));
}

TEST(RayCast, VisitsPartsInOrderAndStopsWhenTheCallbackReturnsFalse) {
  World world;
  const BodyId far = world.create_body(at(6, 0), Shape::circle(1));
  const BodyId near = world.create_body(at(3, 0), Shape::circle(1));
  world.create_body(at(0, 0), Shape::circle(1));  // contains the ray's start
  std::vector<BodyId> met;
  world.ray_cast({0, 0}, {10, 0}, [&met](const BodyHit& hit) {
    met.push_back(hit.body);
    return true;
  });
  EXPECT_THAT(met, ElementsAre(near, far));
  met.clear();
  world.ray_cast({0, 0}, {10, 0}, [&](const BodyHit& hit) {
    met.push_back(hit.body);
    world.destroy_body(hit.body);
    return false;
  });
  EXPECT_THAT(met, ElementsAre(near));
  EXPECT_EQ(world.ray_cast({0, 0}, {10, 0})->body, far);
}

TEST(RayCast, HitsOnlyTheGivenLayers) {
  World world;
  BodyDef glass = at(2, 0);
  glass.layers = 0b01;
  world.create_body(glass, Shape::circle(1));
  BodyDef wall = at(6, 0);
  wall.layers = 0b10;
  const BodyId seen = world.create_body(wall, Shape::circle(1));
  EXPECT_EQ(world.ray_cast({0, 0}, {10, 0}, 0b10)->body, seen);
}

TEST(RayCast, RejectsPointsThatAreNotFinite) {
  World world;
  const Real infinite = std::numeric_limits<Real>::infinity();
  EXPECT_THROW(world.ray_cast({0, 0}, {infinite, 0}), std::invalid_argument);
}

TEST(Callback, MayDestroyEveryBodyItReceives) {
  World world;
  for (int i = 0; i < 5; ++i) world.create_body(at(i, 0), Shape::circle(1));
  int calls = 0;
  world.query_aabb({{-10, -10}, {10, 10}}, [&](BodyId id, const Part& part) {
    world.destroy_body(id);
    world.destroy_body(id);           // destroying it twice is allowed
    EXPECT_TRUE(world.contains(id));  // until the query returns
    EXPECT_EQ(part.shape.radius(), 1);
    ++calls;
    return true;
  });
  EXPECT_EQ(calls, 5);
  EXPECT_EQ(world.body_count(), 0U);
}

TEST(Callback, GetsHandlesOfNewBodiesImmediatelyButDoesNotVisitThem) {
  World world;
  world.create_body(at(0, 0), Shape::circle(1));
  std::vector<BodyId> made;
  int calls = 0;
  world.query_point({0, 0}, [&](BodyId, const Part&) {
    ++calls;
    for (int i = 0; i < 100; ++i) made.push_back(world.create_body(at(0, 0, 1, 2), Shape::circle(1)));
    EXPECT_TRUE(world.contains(made.back()));
    EXPECT_EQ(world.body(made.back()).velocity(), (Vec2{1, 2}));
    EXPECT_EQ(world.body_count(), 1U);
    return true;
  });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(world.body_count(), 101U);
}

TEST(Callback, MayRemoveAndInsert) {
  World world;
  const BodyId a = world.create_body(at(0, 0), Shape::circle(1));
  const BodyId b = world.create_body(at(0, 0), Shape::circle(1));
  world.remove_body(b);
  world.query_point({0, 0}, [&](BodyId id, const Part&) {
    world.remove_body(id);
    world.insert_body(b);
    EXPECT_THAT(world.bodies(), ElementsAre(a));
    return true;
  });
  EXPECT_THAT(world.bodies(), ElementsAre(b));
}

TEST(Callback, ThatThrowsLeavesTheWorldValid) {
  World world;
  const BodyId a = world.create_body(at(0, 0), Shape::circle(1));
  const auto fail = [&](BodyId id, const Part&) -> bool {
    world.destroy_body(id);
    throw std::runtime_error("no");
  };
  EXPECT_THROW(world.query_point({0, 0}, fail), std::runtime_error);
  EXPECT_FALSE(world.contains(a));
  world.step();
}

TEST(Callback, MayRunAnotherQuery) {
  World world;
  const BodyId a = world.create_body(at(0, 0), Shape::circle(1));
  const BodyId b = world.create_body(at(0, 0), Shape::circle(1));
  world.query_point({0, 0}, [&](BodyId id, const Part&) {
    EXPECT_THAT(found_at(world, {0, 0}), ElementsAre(a, b));
    world.destroy_body(id);
    return true;
  });
  EXPECT_EQ(world.body_count(), 0U);
}

TEST(Callback, MayNotStep) {
  World world;
  world.create_body(at(0, 0), Shape::circle(1));
  const auto step = [&world](BodyId, const Part&) {
    world.step();
    return true;
  };
  EXPECT_THROW(world.query_point({0, 0}, step), std::logic_error);
}

TEST(Contacts, GiveThePointsAndImpulsesOfTouchingBodies) {
  World world;
  const BodyId floor = add_floor(world);
  const BodyId disc = world.create_body(at(3, .5), Shape::circle(Real{0.5}));
  const Real mass = world.body(disc).mass().mass;
  run(world, 60);
  const std::span<const ContactInfo> contacts = world.contacts();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].a, floor);
  EXPECT_EQ(contacts[0].b, disc);
  EXPECT_EQ(contacts[0].normal, (Vec2{0, 1}));
  EXPECT_NEAR(contacts[0].point.x, 3, 8 * round_off);
  EXPECT_NEAR(contacts[0].point.y, 0, .01);
  // The contact carries the weight, m g dt, up to the rounding of ten iterations.
  EXPECT_NEAR(contacts[0].normal_impulse, mass * 10 * world.dt(), 32 * round_off);
  EXPECT_NEAR(contacts[0].tangent_impulse, 0, 32 * round_off);
}

TEST(Contacts, AndBodiesAreListedWithoutAllocatingAgain) {
  World world;
  add_floor(world);
  for (int i = 0; i < 5; ++i) world.create_body(at(2 * i, .5), Shape::circle(Real{0.5}));
  run(world, 60);
  const ContactInfo* contacts = world.contacts().data();
  const BodyId* bodies = world.bodies().data();
  for (int i = 0; i < 100; ++i) {
    world.step();
    EXPECT_EQ(world.contacts().data(), contacts);
    EXPECT_EQ(world.bodies().data(), bodies);
  }
}

// A disc of radius r that passes a disc of radius R at a height y touches it where the centres are r + R apart.
TEST(ShapeCast, OfADiscTouchesADiscWhereTheRadiiAddUp) {
  World world;
  const BodyId target = world.create_body(at(5, 0), Shape::circle(1));
  for (const double y : {0., .5, 1., 1.4, 1.499}) {
    const auto hit = world.shape_cast(Shape::circle(real(.5)), {{0, real(y)}, {}}, {10, 0});
    ASSERT_TRUE(hit) << y;
    const double x = 5 - std::sqrt(1.5 * 1.5 - y * y);
    EXPECT_EQ(hit->body, target);
    // The gap left is 32 round-offs of 15.5 m, and a grazing shape closes it at the rate (5 - x) / 1.5.
    const double gap = 64 * 15.5 * static_cast<double>(round_off) * 1.5 / (5 - x);
    EXPECT_NEAR(hit->fraction * 10, x, 2 * gap) << y;
    EXPECT_NEAR(hit->normal.x, (x - 5) / 1.5, 4 * gap) << y;
    EXPECT_NEAR(hit->normal.y, y / 1.5, 4 * gap) << y;
  }
  EXPECT_FALSE(world.shape_cast(Shape::circle(real(.5)), {{0, real(1.501)}, {}}, {10, 0}));
  EXPECT_FALSE(world.shape_cast(Shape::circle(real(.5)), {{0, 0}, {}}, {3, 0})) << "stops short";
  EXPECT_FALSE(world.shape_cast(Shape::circle(real(.5)), {{0, 0}, {}}, {-10, 0})) << "moves away";
}

TEST(ShapeCast, FindsTheFirstPartOfAllAndRespectsLayers) {
  World world;
  add_floor(world);
  BodyDef def = at(0, 2);
  def.layers = 2;
  const BodyId shelf = world.create_body(def, Shape::box({1, real(.5)}));
  const Shape box = Shape::box({real(.5), real(.5)});
  const auto first = world.shape_cast(box, {{0, 10}, {}}, {0, -20});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->body, shelf);
  EXPECT_NEAR(first->fraction, 7. / 20, 64 * round_off);
  EXPECT_NEAR(first->normal.y, 1, 8 * round_off);
  EXPECT_NEAR(first->point.y, 2.5, 64 * round_off);
  const auto below = world.shape_cast(box, {{0, 10}, {}}, {0, -20}, 1);
  ASSERT_TRUE(below);
  EXPECT_NE(below->body, shelf);
  EXPECT_NEAR(below->fraction, 9.5 / 20, 128 * round_off);
}

TEST(ShapeCast, HitsAtOnceWhatItOverlapsAtTheStart) {
  World world;
  world.create_body(at(0, 0), Shape::circle(1));
  const auto hit = world.shape_cast(Shape::circle(1), {{1, 0}, {}}, {5, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->fraction, 0);
  EXPECT_EQ(hit->normal, (Vec2{}));
}

TEST(ShapeCast, PassesAChainFromItsSolidSide) {
  World world;
  BodyDef def;
  def.type = BodyType::fixed;
  const std::vector<Vec2> points{{5, 0}, {0, 0}, {-5, 0}};
  std::vector<Part> parts;
  for (const Shape& shape : Shape::chain(points, false)) parts.push_back({shape, {}});
  world.create_body(def, parts);
  EXPECT_TRUE(world.shape_cast(Shape::circle(real(.5)), {{1, 3}, {}}, {0, -6}));
  EXPECT_FALSE(world.shape_cast(Shape::circle(real(.5)), {{1, -3}, {}}, {0, 6}));
}

TEST(ShapeCast, RefusesHalfSpacesAndWhatIsNotFinite) {
  const World world;
  EXPECT_THROW(world.shape_cast(Shape::half_space({0, 1}, 0), {}, {1, 0}), std::invalid_argument);
  const Real infinite = std::numeric_limits<Real>::infinity();
  EXPECT_THROW(world.shape_cast(Shape::circle(1), {}, {infinite, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace queries_test
