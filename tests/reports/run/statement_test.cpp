#include "reports/run/statement.h"

#include <gtest/gtest.h>

#include "scenarios/scenario.h"

namespace plumb::statement_test {
namespace {

TEST(Statement, SaysInMillimetresHowFarContactsMayRestFromTouching) {
  Stepping stepping;
  stepping.impact_lag = 0;
  EXPECT_EQ(statement(stepping), "") << "what is not stated is not said";
  stepping.skin = 0.015;
  stepping.slop = 0.005;
  stepping.iterations = 8;
  stepping.position_iterations = 3;
  stepping.epsilon = 6e-8;
  EXPECT_EQ(statement(stepping),
            "bodies may rest 15 mm apart; leaves overlaps of up to 5 mm alone; 8 iterations of velocities, 3 of "
            "positions; single precision");
}

TEST(Statement, SaysThatContactsAreSpringsAndVelocitiesDifferences) {
  Stepping stepping;
  stepping.impact_lag = 0;
  stepping.contact_frequency = 30;
  stepping.fixed_contact_frequency = 60;
  stepping.differenced_velocities = true;
  EXPECT_EQ(statement(stepping),
            "contacts are springs of 30 Hz, 60 Hz on what does not move, and overlap by their load; keeps velocities "
            "as differences of positions");
}

}  // namespace
}  // namespace plumb::statement_test
