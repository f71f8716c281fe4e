#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/scenario.h"

namespace plumb::tautochrone_test {
namespace {

// The losses at the corners of the chain are proportional to the length of its facets; on the cycloid itself all beads
// are at 0 at the same time.
TEST(Tautochrone, ExpectsAllBeadsAtTheBottomAsFacetsShrink) {
  const Scenario& scenario = *Catalog<Scenario>::find("tautochrone");
  const auto farthest = [&](double facets) {
    double far = 0;
    for (const Expectation& bead : scenario.expectations(complete(scenario, {{"facets", facets}}))) {
      far = std::max(far, std::abs(*bead.expected));
    }
    return far;
  };
  const double coarse = farthest(100);
  EXPECT_LT(coarse, 0.01);
  EXPECT_NEAR(farthest(200) / coarse, 0.5, 0.05);
  EXPECT_NEAR(farthest(1000) / coarse, 0.1, 0.01);
}

}  // namespace
}  // namespace plumb::tautochrone_test
