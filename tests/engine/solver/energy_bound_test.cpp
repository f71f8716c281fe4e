#include "solver/energy_bound.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION::energy_bound_test {
namespace {

TEST(Descent, EndsWithoutExcess) {
  Descent descent(10);
  EXPECT_TRUE(descent.goes_on(Real{1}));
  EXPECT_TRUE(descent.goes_on(Real{0.5F}));
  EXPECT_FALSE(descent.goes_on(Real{0}));
}

TEST(Descent, UsesNoMoreThanItsIterations) {
  Descent descent(2);
  EXPECT_TRUE(descent.goes_on(Real{8}));
  EXPECT_TRUE(descent.goes_on(Real{4}));
  EXPECT_FALSE(descent.goes_on(Real{2}));
}

// 1 of 8 in each iteration: seven more suffice, six do not.
TEST(Descent, ContinuesWhileTheRemainingIterationsMaySuffice) {
  for (const auto& [sweeps, hopeful] : {std::pair{8, true}, std::pair{7, false}}) {
    Descent descent(sweeps);
    EXPECT_TRUE(descent.goes_on(Real{8}));
    EXPECT_EQ(descent.goes_on(Real{7}), hopeful) << sweeps;
  }
}

TEST(Descent, EndsIfTheExcessGrows) {
  Descent descent(60);
  EXPECT_TRUE(descent.goes_on(Real{1}));
  EXPECT_FALSE(descent.goes_on(Real{2}));
}

TEST(Descent, EndsWithNan) { EXPECT_FALSE(Descent(60).goes_on(std::numeric_limits<Real>::quiet_NaN())); }

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::energy_bound_test
