#include "contacts/lanes/persistence.h"

#include <gtest/gtest.h>

#include <vector>

#include "../../random_shapes.h"

namespace impulse::inline IMPULSE_PRECISION::persistence_test {

namespace {

/// The motion of a body between two poses.
struct Moved {
  Vec2 by;
  Rotation turn;
  Moved(const Pose& now, const Pose& then) : by(now.p - then.p), turn(now.q * then.q.inverse()) {}
  Vec2 arm(Vec2 arm) const { return turn * arm - arm; }
  Real displacement(Real reach) const { return length(by) + std::abs(turn.s) * reach; }
};

TEST(PersistPoints, AgreesWithOneAtATime) {
  RandomShapes random(1);
  std::vector<Pose> poses;
  std::vector<Real> reach;
  for (int i = 0; i < 20; ++i) {
    poses.push_back(random.pose(3));
    reach.push_back(random.number(0, 2));
  }
  std::vector<Contact> contacts(100);
  for (Contact& contact : contacts) {
    contact.body_a = static_cast<std::uint32_t>(random.number(0, 19.99));
    contact.body_b = static_cast<std::uint32_t>(random.number(0, 19.99));
    contact.count = 1 + static_cast<int>(random.number(0, 1.99));
    contact.normal = random.point(1);
    contact.disc_a = random.number(0, 1) < .3;
    contact.disc_b = random.number(0, 1) < .3;
    contact.found_a = random.pose(3);
    contact.found_b = random.pose(3);
    for (std::size_t p = 0; p < 2; ++p) {
      contact.found_separation[p] = random.number(-1, 1);
      contact.points[p].arm_a = random.point(1);
      contact.points[p].arm_b = random.point(1);
    }
  }
  for (std::uint32_t count = 0; count < 20; ++count) {
    std::vector<std::uint32_t> items;
    for (std::uint32_t i = 0; i < count; ++i) items.push_back((37 * i + count) % 100);
    for (const InstructionSet set : runnable_instruction_sets()) {
      std::vector<Contact> now = contacts;
      std::vector<std::uint8_t> kept(count);
      constexpr PersistenceLimit limit{5, static_cast<Real>(0.8)};
      contact_kernels(set).persist_points(now.data(), items.data(), count, poses.data(), reach.data(), limit,
                                          kept.data());
      for (std::uint32_t i = 0; i < count; ++i) {
        const Contact& before = contacts[items[i]];
        const Contact& contact = now[items[i]];
        const Moved a(poses[contact.body_a], contact.found_a);
        const Moved b(poses[contact.body_b], contact.found_b);
        const Real moved = a.displacement(reach[contact.body_a]) + b.displacement(reach[contact.body_b]);
        const Real turned = (contact.disc_a ? 0 : std::abs(a.turn.s)) + (contact.disc_b ? 0 : std::abs(b.turn.s));
        const bool stays = moved < limit.motion && turned < limit.turn;
        EXPECT_EQ(kept[i], stays ? 1 : 0);
        EXPECT_EQ(contact.age, stays ? before.age + 1 : before.age);
        for (std::size_t p = 0; p < 2; ++p) {
          const Vec2 arms = b.arm(contact.points[p].arm_b) - a.arm(contact.points[p].arm_a);
          const Real separation = contact.found_separation[p] + dot(contact.normal, (b.by - a.by) + arms);
          const bool written = stays && static_cast<int>(p) < contact.count;
          EXPECT_EQ(contact.points[p].separation, written ? separation : before.points[p].separation);
        }
      }
    }
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::persistence_test
