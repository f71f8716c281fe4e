#include "reports/judge/pushed.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumb {
namespace {

ContactState at(double x, double normal_impulse, std::size_t b = 1) {
  return {.a = 0, .b = b, .point = {x, 0}, .normal_impulse = normal_impulse};
}

TEST(Changed, IsAgainstTheNearestContactOfItsPair) {
  const std::vector<ContactState> before{at(-1, 2), at(1, 5), at(0.9, 7, 2)};
  EXPECT_EQ(changed(before, at(0.9, 4)), 1);
  EXPECT_EQ(changed(before, at(-0.9, 4)), 2);
}

TEST(Changed, IsAllOfItWhereThePairDidNotTouch) { EXPECT_EQ(changed({}, at(0, 4)), 4); }

TEST(KnownLate, IsWhatAStepChangesOrTheLastOfManySweeps) {
  const std::vector<ContactState> before{at(0, 2)};
  const std::vector<ContactState> now{at(0, 3), at(0, 27, 2)};
  using Late = std::vector<double>;
  EXPECT_EQ(known_late(before, now, {.drift = 0}), (Late{0, 0}));
  EXPECT_EQ(known_late(before, now, {.drift = 0.5}), (Late{1, 27}));
  // (2/3)^2/3 of 27
  EXPECT_EQ(known_late(before, now, {.drift = 0.5, .iterations = 2}), (Late{4, 27}));
}

}  // namespace
}  // namespace plumb
