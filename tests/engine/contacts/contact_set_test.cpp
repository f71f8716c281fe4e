#include "contacts/contact_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "../support.h"
#include "core/method_list.h"

namespace contact_set_test {
namespace {

using namespace impulse;

struct Heap {
  BodySet bodies;
  ContactSet contacts;
  std::unique_ptr<BroadPhase> broad_phase = MethodList<BroadPhase>::make("brute");
  Settings settings;
  Margin margin;
  JointSet joints;
  PartFilter filter;
  bool persistence = false;

  std::size_t add(const BodyDef& def, std::span<const Part> parts) {
    const std::size_t i = bodies.add(def, parts).index;
    bodies.insert(i);
    return i;
  }
  std::size_t add(const BodyDef& def, const Shape& shape, const Material& material = {}) {
    const Part part{shape, material};
    return add(def, std::span(&part, 1));
  }
  std::vector<Contact>& find() {
    contacts.find({bodies, *broad_phase, settings, margin, persistence, joints, filter});
    return contacts.rows();
  }
};

TEST(ContactSet, SortsRowsByBodiesThenParts) {
  Heap heap;
  const std::array two{Part{Shape::circle(1, {-1, 0}), {}}, Part{Shape::circle(1, {1, 0}), {}}};
  heap.add(at(0, 0), two);
  heap.add(at(0, 1), two);
  heap.add(at(0, -1), two);
  const std::vector<Contact>& rows = heap.find();
  EXPECT_GT(rows.size(), 4U);
  const auto order = [](const Contact& a, const Contact& b) {
    return std::tie(a.body_a, a.body_b, a.part_a, a.part_b) < std::tie(b.body_a, b.body_b, b.part_a, b.part_b);
  };
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(), order));
  for (const Contact& row : rows) EXPECT_LT(row.body_a, row.body_b);
}

TEST(ContactSet, CountsChangesOfPointsAndMaterials) {
  Heap heap;
  heap.add(at(0, 0), Shape::circle(1));
  heap.add(at(1.5, 0), Shape::circle(1));
  heap.find();
  const std::uint64_t first = heap.contacts.changes();
  heap.find();
  EXPECT_EQ(heap.contacts.changes(), first);
  heap.settings.restitution_mixing = RestitutionMixing::min;
  heap.find();
  const std::uint64_t mixed = heap.contacts.changes();
  EXPECT_NE(mixed, first);
  heap.bodies.pose[1].p.x = 4;
  EXPECT_TRUE(heap.find().empty());
  EXPECT_NE(heap.contacts.changes(), mixed);
}

TEST(ContactSet, KeepsImpulsesWhileAContactLasts) {
  Heap heap;
  heap.add(at(0, 0), Shape::circle(1));
  heap.add(at(1.5, 0), Shape::circle(1));
  heap.add(at(3, 0), Shape::circle(1));
  ASSERT_EQ(heap.find().size(), 2U);
  for (Contact& row : heap.contacts.rows()) {
    EXPECT_EQ(row.age, 0);
    row.points[0].normal_impulse = static_cast<Real>(row.body_b);
    row.points[0].tangent_impulse = -1;
    row.points[0].total_normal_impulse = 9;
  }
  heap.bodies.pose[0].p = {-9, 0};  // the first contact ends, the second lasts
  ASSERT_EQ(heap.find().size(), 1U);
  const Contact& row = heap.contacts.rows()[0];
  EXPECT_EQ(row.age, 1);
  EXPECT_EQ(row.points[0].normal_impulse, 2);
  EXPECT_EQ(row.points[0].tangent_impulse, -1);
  EXPECT_EQ(row.points[0].total_normal_impulse, 0);
  heap.bodies.pose[0].p = {0, 0};  // and begins again
  ASSERT_EQ(heap.find().size(), 2U);
  EXPECT_EQ(heap.contacts.rows()[0].age, 0);
  EXPECT_EQ(heap.contacts.rows()[0].points[0].normal_impulse, 0);
  EXPECT_EQ(heap.contacts.rows()[1].age, 2);
}

TEST(ContactSet, NeverGivesABodyTheImpulsesOfAnEarlierOneWithItsIndex) {
  Heap heap;
  heap.add(at(0, 0), Shape::circle(1));
  const std::size_t row = heap.add(at(1.5, 0), Shape::circle(1));
  heap.find()[0].points[0].normal_impulse = 5;
  heap.contacts.forget(row);
  heap.bodies.destroy(row);
  ASSERT_EQ(heap.add(at(1.5, 0), Shape::circle(1)), row);
  EXPECT_EQ(heap.find()[0].points[0].normal_impulse, 0);
}

TEST(ContactSet, FindsOnlyContactsWithinTheMargin) {
  Heap heap;
  heap.add(at(0, 0), Shape::circle(1));
  heap.add(at(2.1, 0), Shape::circle(1));
  EXPECT_TRUE(heap.find().empty());
  heap.margin.distance = real(.05);
  EXPECT_TRUE(heap.find().empty());
  heap.margin.distance = real(.2);
  ASSERT_EQ(heap.find().size(), 1U);
  EXPECT_NEAR(heap.contacts.rows()[0].points[0].separation, .1, 8 * round_off);
}

TEST(ContactSet, LooksFartherForFasterBodies) {
  Heap heap;
  heap.margin.time = real(.1);
  heap.add(at(0, 0, 1, 0), Shape::circle(1));
  const std::size_t fast = heap.add(at(2.5, 0, -5, 0), Shape::circle(1));  // approaches .6 m in .1 s
  EXPECT_EQ(heap.find().size(), 1U);
  heap.bodies.velocity[fast].v = {1, 0};  // moves along
  EXPECT_TRUE(heap.find().empty());
  heap.bodies.velocity[fast].w = 6;  // a surface may swing over .6 m
  EXPECT_EQ(heap.find().size(), 1U);
}

// A disc that falls at 10 m/s on one that lies on the ground stops there, and the next is behind it.
TEST(ContactSet, LooksForWhatFollowsABodyThatIsStopped) {
  for (const bool lies : {false, true}) {
    Heap heap;
    heap.margin.time = real(.1);
    BodyDef floor = at(0, lies ? 0 : -9);
    floor.type = BodyType::fixed;
    const std::size_t ground = heap.add(floor, Shape::half_space({0, 1}, 0));
    const std::size_t first = heap.add(at(0, 1), Shape::circle(1));
    const std::size_t falls = heap.add(at(0, 3.1, 0, -10), Shape::circle(1));
    const std::size_t follows = heap.add(at(0, 5.8, 0, -10), Shape::circle(1));
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (const Contact& contact : heap.find()) found.emplace_back(contact.body_a, contact.body_b);
    if (lies) {
      EXPECT_EQ(found.size(), 3);
      EXPECT_TRUE(std::count(found.begin(), found.end(), std::pair{falls, follows})) << "stopped by the ground";
      EXPECT_TRUE(std::count(found.begin(), found.end(), std::pair{ground, first}));
    } else {
      EXPECT_EQ(found, (std::vector{std::pair{first, falls}})) << "two discs share their speed, so that .5 m remain";
    }
  }
}

// A disc falls on one end of a bar that a weld makes of two: the other end may come down on the ground within the step.
// A light end by all that the disc moves in the step, and more: on the short arm of a lever it would be thrown.
TEST(ContactSet, LooksForWhatIsJoinedToABodyThatIsHit) {
  struct End {
    Real density, height;  // kg/m^2, m over the ground
  };
  for (const End of : {End{1, real(.4)}, End{real(.1), real(1.5)}}) {
    for (const bool welded : {true, false}) {
      Heap heap;
      heap.margin.time = real(.1);
      BodyDef floor = at(0, -1 - of.height);
      floor.type = BodyType::fixed;
      const std::size_t ground = heap.add(floor, Shape::half_space({0, 1}, 0));
      heap.add(at(0, 0), Shape::circle(1));
      const std::size_t end = heap.add(at(3, 0), Shape::circle(1), {of.density});
      heap.add(at(0, 2.1, 0, -10), Shape::circle(1));
      ForceField forces;
      if (welded) heap.joints.add(WeldJoint{{1, 0}, {2, 0}, {real(1.5), 0}}, heap.bodies, forces);
      const std::vector<Contact>& found = heap.find();
      const bool listed = std::any_of(found.begin(), found.end(), [&](const Contact& contact) {
        return contact.body_a == ground && contact.body_b == end;
      });
      EXPECT_EQ(listed, welded) << of.density;
    }
  }
}

TEST(ContactSet, MixesStaticAndDynamicFrictionByTheSameRule) {
  Heap heap;
  heap.settings.friction_mixing = FrictionMixing::pythagorean;
  heap.settings.restitution_mixing = RestitutionMixing::max;
  heap.add(at(0, 0), Shape::circle(1), {1, real(.4), real(.3), real(.2)});
  heap.add(at(1.5, 0), Shape::circle(1), {1, real(.3), real(.0), real(.7)});
  const Contact& row = heap.find()[0];
  EXPECT_NEAR(row.static_friction, .5, 2 * round_off);  // sqrt(.4^2 + .3^2); the average would be .35
  EXPECT_NEAR(row.dynamic_friction, .3, 2 * round_off);
  EXPECT_EQ(row.restitution, real(.7));
}

TEST(ContactSet, GivesArmsFromBothCentresToOnePoint) {
  Heap heap;
  heap.add(at(0, 0), Shape::circle(1));
  heap.add(at(1.5, 0), Shape::circle(Real{0.75}));
  const Contact& row = heap.find()[0];
  EXPECT_EQ(row.normal, (Vec2{1, 0}));
  const Vec2 on_a = heap.bodies.pose[0].p + row.points[0].arm_a;
  const Vec2 on_b = heap.bodies.pose[1].p + row.points[0].arm_b;
  EXPECT_NEAR(on_a.x, .875, 4 * round_off);
  EXPECT_NEAR(on_b.x, .875, 4 * round_off);
}

TEST(ContactSet, KeepsThePointsOfBodiesThatHardlyMoved) {
  Heap heap;
  heap.persistence = true;
  heap.margin.distance = real(.02);
  heap.add(at(0, 0), Shape::box({1, 1}));
  const std::size_t above = heap.add(at(0, 2), Shape::box({1, 1}));
  const Vec2 arm = heap.find()[0].points[0].arm_b;
  heap.contacts.rows()[0].points[0].normal_impulse = 3;
  heap.bodies.pose[above].p = {real(.001), real(2.002)};
  const Contact& row = heap.find()[0];
  EXPECT_EQ(row.points[0].arm_b, arm);
  EXPECT_EQ(row.points[0].normal_impulse, 3);
  EXPECT_NEAR(row.points[0].separation, .002, 8 * round_off);
  heap.bodies.pose[above].p = {real(.1), 2};
  EXPECT_NE(heap.find()[0].points[0].arm_b, arm);
}

// Only the total motion since the points were found counts, not its speed.
TEST(ContactSet, KeepsThePointsOfBodiesThatCameBack) {
  Heap heap;
  heap.persistence = true;
  heap.margin.distance = real(.02);
  heap.add(at(0, 0), Shape::box({1, 1}));
  const std::size_t above = heap.add(at(0, 2), Shape::box({1, 1}));
  const Vec2 arm = heap.find()[0].points[0].arm_b;
  for (const Real x : {real(.008), real(-.008), real(.008)}) {
    heap.bodies.pose[above].p.x = x;
    EXPECT_EQ(heap.find()[0].points[0].arm_b, arm);
  }
  heap.bodies.pose[above].p.x = real(.02);
  const Vec2 moved = heap.find()[0].points[0].arm_b;
  EXPECT_NE(moved, arm);
  heap.bodies.pose[above].p.x = real(.008);
  EXPECT_NE(heap.find()[0].points[0].arm_b, moved);
}

TEST(ContactSet, MixesPersistentContactsByTheCurrentRule) {
  Heap heap;
  heap.persistence = true;
  heap.add(at(0, 0), Shape::box({1, 1}), {1, real(.4), real(.4), 0});
  heap.add(at(0, 2), Shape::box({1, 1}), {1, real(.3), real(.3), 0});
  heap.settings.friction_mixing = FrictionMixing::max;
  EXPECT_EQ(heap.find()[0].static_friction, real(.4));
  heap.settings.friction_mixing = FrictionMixing::min;
  const std::uint64_t changes = heap.contacts.changes();
  EXPECT_EQ(heap.find()[0].static_friction, real(.3));
  EXPECT_NE(heap.contacts.changes(), changes);
}

}  // namespace
}  // namespace contact_set_test
