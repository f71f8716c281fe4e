#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/scenario.h"

namespace plumb::conveyor_test {
namespace {

// In steps of a microsecond, by the law alone: friction of mu s g against the slip, never past it.
TEST(Conveyor, AgreesWithFrictionInSmallSteps) {
  const Scenario& scenario = *Catalog<Scenario>::find("conveyor");
  for (const Variant& variant : scenario.variants) {
    const Parameters p = complete(scenario, variant.changes);
    constexpr double h = 1e-6;
    const double most = 0.3 * p.at("scale") * 10 * h;
    double x = 0;
    double v = 0;
    const auto all = scenario.expectations(p);
    int step = 0;
    for (const std::size_t moment : {0u, 2u}) {  // vx and x at each
      for (; step < static_cast<int>(std::lround(*all[moment].time / h)); ++step) {
        const double after = v + std::clamp(p.at("speed") - v, -most, most);
        x += h * (v + after) / 2;
        v = after;
      }
      EXPECT_NEAR(*all[moment].expected, v, 1e-5) << variant.label;
      EXPECT_NEAR(*all[moment + 1].expected, x, 1e-5) << variant.label;
    }
  }
}

}  // namespace
}  // namespace plumb::conveyor_test
