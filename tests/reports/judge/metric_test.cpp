#include "reports/judge/metric.h"

#include <gmock/gmock.h>

#include "../fakes.h"
#include "scenarios/catalog.h"

namespace plumb::metric_test {
namespace {

TEST(Metrics, AreAllInTheCatalog) {
  std::vector<std::string> names;
  for (const Metric* metric : Catalog<Metric>::all()) {
    names.push_back(metric->name);
    EXPECT_FALSE(metric->unit.empty()) << metric->name;
    EXPECT_FALSE(metric->definition.empty()) << metric->name;
  }
  EXPECT_THAT(names, ::testing::IsSupersetOf(
                         {"angular_momentum_error", "energy_drift", "energy_rise", "kinetic_energy_end",
                          "lateral_drift", "momentum_error", "penetration_end", "penetration_max",
                          "potential_energy_end", "residual_speed", "rotational_energy_end", "time_to_rest",
                          "truth_angle_error_max", "truth_error_end", "truth_error_max", "truth_error_rms"}));
}

TEST(Measure, LeavesOutMetricsThatDoNotApply) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 0.1);
  const auto measured = measure({.scene = scene, .trace = trace});
  EXPECT_EQ(measured.count("kinetic_energy_end"), 1u);
  EXPECT_EQ(measured.count("momentum_error"), 1u);
  EXPECT_EQ(measured.count("truth_error_max"), 0u) << "no closed form was given";
  EXPECT_EQ(measured.count("time_to_rest"), 0u) << "nothing to rest on";
  EXPECT_EQ(measured.count("penetration_max"), 0u) << "nothing to overlap with";
}

}  // namespace
}  // namespace plumb::metric_test
