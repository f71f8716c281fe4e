#include "reports/study/model/yardstick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/run/selection.h"

namespace plumb {
namespace {

constexpr double dt = 1.0 / 60;

Yardstick yardstick(const std::string& word, double tolerance = 1e-4) {
  Yardstick made(parse_case(word), parse_engine("impulse"), dt, tolerance);
  made.find();
  return made;
}

TEST(Yardstick, FindsTheFullModelNoWorseThanItself) {
  for (const char* word : {"spring:w=4", "bounce:e=0.8", "rain:count=8", "free-bodies:side=3"}) {
    const Yardstick by = yardstick(word);
    const Yardstick::Reading reading = by.read(by.full());
    EXPECT_EQ(reading.change, 0) << word;
    EXPECT_TRUE(by.within(reading)) << word;
  }
}

// A sub-step of a method of second order that is four times as long: sixteen times the error.
TEST(Yardstick, WeighsByTheTruthWhereThereIsOne) {
  const Yardstick by = yardstick("spring:w=4");
  EXPECT_EQ(by.truth(), "spring");
  EXPECT_EQ(by.compared_until(), 0);
  const double full = by.read(by.full()).error;
  const Yardstick::Reading coarse = by.read(parse_engine("impulse:substeps=1"));
  EXPECT_NEAR(coarse.error / full, 16, 0.5);
  EXPECT_DOUBLE_EQ(coarse.change, coarse.error - full);
  EXPECT_FALSE(by.within(coarse));
  EXPECT_LE(by.read(parse_engine("impulse:substeps=8")).change, 0);
}

// Half a turn of boxes and discs that turn: nothing but angles differ.
TEST(Yardstick, CountsAnglesByTheWayThatTheyMovePoints) {
  const Yardstick by = yardstick("free-bodies:side=3");
  const double change = by.read(parse_engine("impulse:rotation=off")).change;
  // 3 rad/s for 1 s: in the mean over time 3/sqrt(3) rad, at the radius of gyration of a disc of 1/4 m.
  EXPECT_NEAR(change, std::sqrt(3.0) * 0.25 / std::sqrt(2.0), 0.02);
}

TEST(Yardstick, ComparesWithTheFullModelWhereTheTruthEnds) {
  const Yardstick by = yardstick("billiard:open");
  EXPECT_GT(by.compared_until(), by.truth_until());
  const Yardstick::Reading passing = by.read(parse_engine("impulse:contacts=off"));
  EXPECT_GT(passing.change, 1e-2);
  EXPECT_FALSE(by.within(passing));
}

TEST(Yardstick, SaysWhyAModelDidNotRun) {
  const Yardstick by = yardstick("hanging-chain:still");
  const Yardstick::Reading reading = by.read(parse_engine("impulse:solver=exact"));
  EXPECT_NE(reading.status, Status::ok);
  EXPECT_NE(reading.reason, "");
  EXPECT_TRUE(std::isinf(reading.change));
  EXPECT_FALSE(by.within(reading));
}

}  // namespace
}  // namespace plumb
