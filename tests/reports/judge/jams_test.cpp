#include "reports/judge/jams.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "reports/run/run.h"
#include "reports/run/selection.h"

namespace plumb::jams_test {
namespace {

constexpr double frame = 1.0 / 60;

double most_in(const char* word) {
  const Case one = parse_cases(word).front();
  double most = 0;
  for (const auto& bodies : jams_in(*one.scene, *run(*one.scene, parse_engine("impulse"), frame).trace)) {
    for (const double jam : bodies) most = std::max(most, jam);
  }
  return most;
}

// The foot of the rod stops at once, though it never approached the ground: v = w r, w = (r x v)/(k^2 + r^2) = 3.18
// rad/s, with r = (.53, -.853) m, which is a jump of 4.26 m/s. A frame's fall, .17 m/s, is in it or not, and what may
// be a load's, as much again, is taken from it.
TEST(Jams, AreFoundWhereFrictionAndRigidityContradictEachOther) {
  constexpr double fall = 10 * frame;
  EXPECT_NEAR(most_in("painleve-rod:mu=2"), 4.26 - fall, fall);
  EXPECT_GT(most_in("painleve-rod:mu=5"), 4);
}

TEST(Jams, AreNoImpactsOfBodiesThatApproach) {
  for (const char* word : {"bounce:e=0.5", "head-on:e=0", "off-center", "dominoes:ten"})
    EXPECT_EQ(most_in(word), 0) << word;
}

TEST(Jams, AreNoLoadsThatComeAndGo) {
  for (const char* word : {"stacking:ten", "dome:slips", "step-climb:over", "stick-slip:fast"})
    EXPECT_EQ(most_in(word), 0) << word;
}

}  // namespace
}  // namespace plumb::jams_test
