#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb {
namespace {

TEST(Penetration, IsTheDeepestEverAndThatAtTheEnd) {
  const Scene scene{.bodies = {{.name = "context", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}},
                               {.name = "box", .shapes = {{.geometry = Box{}}}}}};
  Trace trace(2);
  for (const double y : {1.0, 0.4, 0.48}) {
    const BodyState states[] = {{}, {.position = {0, y}}};
    trace.record(static_cast<double>(trace.size()), states, {});
  }
  EXPECT_NEAR(*measured("penetration_max", {.scene = scene, .trace = trace}), 0.1, 1e-14);
  EXPECT_NEAR(*measured("penetration_end", {.scene = scene, .trace = trace}), 0.02, 1e-14);
}

}  // namespace
}  // namespace plumb
