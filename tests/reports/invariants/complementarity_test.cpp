#include <gtest/gtest.h>

#include "tests/reports/invariants/holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

TEST(ComplementarityInvariant, ForbidsAPushFromAfar) {
  const Scene scene = box_on_ground();
  const auto apart = [](double gap) {
    return forged(dt, {{box_at({0, 0.5})}, {box_at({0, 0.5 + gap}), {pushing(1)}}});
  };
  Stepping with_gap = exact;
  with_gap.gap = 0.01;
  // Twice the gap, and what 1 N s gives 1 kg in 0.01 s.
  EXPECT_EQ(standing("complementarity", scene, apart(0.0299), with_gap), Standing::held);
  EXPECT_EQ(standing("complementarity", scene, apart(0.0301), with_gap), Standing::broken);
}

}  // namespace
}  // namespace plumb
