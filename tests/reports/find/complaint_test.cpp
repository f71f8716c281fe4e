#include "reports/find/complaint.h"

#include <gtest/gtest.h>

namespace plumb::complaint_test {
namespace {

Complaint energy(double ratio) {
  Complaint one;
  one.judge = "invariant";
  one.what = "energy";
  one.unit = "J";
  one.value = .5;
  one.ratio = ratio;
  one.time = 2;
  return one;
}

TEST(Complaint, SaysByHowMuchMoreThanIsAllowed) {
  EXPECT_EQ(energy(1.26).words(), "breaks the invariant energy by 0.5 J, 1.26 times what is allowed, at 2 s");
  EXPECT_EQ(energy(1.003).words(), "breaks the invariant energy by 0.5 J, just over what is allowed, at 2 s");
}

}  // namespace
}  // namespace plumb::complaint_test
