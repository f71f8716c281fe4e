#include "kernels/recycle.h"

#include <gtest/gtest.h>

#include <vector>

#include "../random_shapes.h"
#include "kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// How a body has moved, one at a time.
struct Moved {
  Vec2 by;
  Rotation turn;
  Moved(const Pose& now, const Pose& then) : by(now.p - then.p), turn(now.q * then.q.inverse()) {}
  Vec2 arm(Vec2 arm) const { return turn * arm - arm; }
  Real way(Real reach) const { return length(by) + std::abs(turn.s) * reach; }
};

TEST(MeasureAgain, AgreesWithOneAtATime) {
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
    contact.normal = random.point(1);
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
    for (const Kernels* version : runnable_kernels()) {
      std::vector<PointsAgain> again(count);
      version->measure_again(contacts.data(), items.data(), count, poses.data(), reach.data(), again.data());
      for (std::uint32_t i = 0; i < count; ++i) {
        const Contact& contact = contacts[items[i]];
        const Moved a(poses[contact.body_a], contact.found_a);
        const Moved b(poses[contact.body_b], contact.found_b);
        EXPECT_EQ(again[i].motion, a.way(reach[contact.body_a]) + b.way(reach[contact.body_b]));
        for (std::size_t p = 0; p < 2; ++p) {
          const Vec2 arms = b.arm(contact.points[p].arm_b) - a.arm(contact.points[p].arm_a);
          EXPECT_EQ(again[i].separation[p], contact.found_separation[p] + dot(contact.normal, (b.by - a.by) + arms));
        }
      }
    }
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
