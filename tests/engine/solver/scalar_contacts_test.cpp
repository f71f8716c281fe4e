#include "solver/scalar_contacts.h"

#include <gtest/gtest.h>

#include "column.h"
#include "solver/impacts.h"

namespace impulse::inline IMPULSE_PRECISION::scalar_contacts_test {
namespace {

/// Three bodies of 1 kg, 2 cm apart from each other and from what is below; in a sub-step of .01 s.
struct Apart : Column {
  Apart() : Column({1, 1, 1}) {
    for (ImpactRow& row : rows) row.points[0].separation = real(.02);
  }
  void leave_out_far() {
    const ScalarContacts contacts(bodies, motion);
    contacts.measure(island);
    contacts.leave_out_far(island);
  }
  bool hold_those_that_meet() {
    Impacts impacts;
    const auto stays = [](const ImpactRow&, const Motion&, const Motion&) { return false; };
    return impacts.hold_those_that_meet(rows, bodies, motion, island.h, real(1e-5), stays);
  }
};

TEST(ScalarContacts, LeaveOutWhatBearsNothingAndIsTooFarToClose) {
  Apart apart;
  apart.bodies.velocity[3].v.y = -2;
  apart.rows[0].points[0].normal_impulse = 1;
  apart.leave_out_far();
  EXPECT_TRUE(apart.rows[0].active) << "it bears something";
  EXPECT_FALSE(apart.rows[1].active);
  EXPECT_TRUE(apart.rows[2].active) << "it may close";
  apart.bodies.velocity[1].v.y = 2;
  apart.leave_out_far();
  EXPECT_TRUE(apart.rows[1].active) << "what was left out is asked again in the next sub-step";
}

TEST(ScalarContacts, TakeBackWhatWouldMeetByTheDriftThatIsFound) {
  Apart apart;
  apart.leave_out_far();
  for (const ImpactRow& row : apart.rows) EXPECT_FALSE(row.active);
  apart.bodies.velocity[2].v.y = real(-1.9);
  EXPECT_FALSE(apart.hold_those_that_meet()) << "it stops short of it";
  apart.bodies.velocity[2].v.y = -3;
  EXPECT_TRUE(apart.hold_those_that_meet());
  EXPECT_TRUE(apart.rows[1].active);
  EXPECT_FALSE(apart.rows[0].active);
}

TEST(ScalarContacts, LeaveOutNothingThatTurnsTowardsItsNeighbour) {
  Apart apart;
  apart.bodies.bounding_radius[2] = 1;
  apart.bodies.velocity[2].w = 2;
  apart.leave_out_far();
  EXPECT_TRUE(apart.rows[1].active);
  EXPECT_TRUE(apart.rows[2].active);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::scalar_contacts_test
