#include "solver/scalar_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::scalar_contacts_test {
namespace {

/// Bodies of 1 kg in a row that moves at 1 m/s towards a wall, which the first of them touches.
struct Row {
  static constexpr std::size_t length = 12;
  BodySet bodies;
  std::vector<std::uint32_t> members;
  std::vector<ImpactRow> rows{length};
  std::vector<Motion> motion{length + 1};
  std::vector<Pose> start{length + 1};
  JointWorkspace work;
  Island island{.bodies = members,
                .contacts = {},
                .rows = rows,
                .joints = IslandJoints({}, members, bodies, start, motion, work)};

  Row() {
    bodies.velocity.resize(length + 1);
    bodies.inverse_mass.resize(length + 1);
    island.h = real(.01);
    for (std::uint32_t i = 0; i < length; ++i) {
      members.push_back(i + 1);
      bodies.inverse_mass[i + 1] = {1, 0};
      bodies.velocity[i + 1].v.x = -1;
    }
    for (std::uint32_t i = 0; i < length; ++i) {
      ImpactRow& row = rows[i];
      row.a = i;
      row.b = i + 1;
      row.normal = {1, 0};
      row.mass_a = bodies.inverse_mass[row.a];
      row.mass_b = bodies.inverse_mass[row.b];
      row.count = 1;
      row.points[0].normal_mass = effective_mass(row, 0, 0);
    }
  }
  double fastest() const {
    Real most = 0;
    for (const Velocity& velocity : bodies.velocity) most = std::max(most, std::abs(velocity.v.x));
    return static_cast<double>(most);
  }
};

// Of what goes back and forth along n bodies a plain sweep takes about pi^2 / 4 n^2 away, an over-relaxed one three
// times as much: 1 - .98^60 of it, and 1 - .95^60.
TEST(ScalarContacts, StopARowAtAWallInAThirdOfTheSweepsWhereOverRelaxed) {
  Row pressed;
  for (int i = 0; i < 60; ++i) ScalarContacts(pressed.bodies, pressed.motion).press_rigidly(pressed.island, real(1.5));
  EXPECT_LT(pressed.fastest(), .1);
  Row relaxed;
  for (int i = 0; i < 60; ++i) ScalarContacts(relaxed.bodies, relaxed.motion).relax(relaxed.island);
  EXPECT_GT(relaxed.fastest(), .3);
  EXPECT_LT(relaxed.fastest(), .6);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::scalar_contacts_test
