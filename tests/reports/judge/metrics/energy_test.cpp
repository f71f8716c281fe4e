#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb {
namespace {

// After 2 s: v = (3, -12), y = 2 + 16 - 20.
TEST(EnergyAtTheEnd, IsSplitIntoItsKinds) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 1.0 / 60);
  const MetricContext context{.scene = scene, .trace = trace};
  EXPECT_NEAR(*measured("kinetic_energy_end", context), 9 + 144, 1e-9);
  EXPECT_NEAR(*measured("rotational_energy_end", context), 2 * (1 + 4) / 12.0 * 16 / 2, 1e-9);
  EXPECT_NEAR(*measured("potential_energy_end", context), 2 * 10 * -2, 1e-9);
}

}  // namespace
}  // namespace plumb
