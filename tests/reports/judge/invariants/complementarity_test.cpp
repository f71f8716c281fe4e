#include <gtest/gtest.h>

#include "holding.h"

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
  EXPECT_EQ(status("complementarity", scene, apart(0.0299), with_gap), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, apart(0.0301), with_gap), CheckStatus::broken);
}

TEST(ComplementarityInvariant, KnowsThatAPushAtACornerTurnsItAway) {
  const Scene scene = box_on_ground();
  ContactState corner = pushing(1);
  corner.point = {0.5, 0};
  const auto apart = [&](double gap) { return forged(dt, {{box_at({0, 0.5})}, {box_at({0, 0.5 + gap}), {corner}}}); };
  // 1 m/s, and at an arm of about (.5, -.5) 1 N s x .5 m / (1/6) kg m^2 = 3 rad/s: 1 + 3 x .72 m/s.
  EXPECT_EQ(status("complementarity", scene, apart(0.031), exact), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, apart(0.033), exact), CheckStatus::broken);
}

TEST(ComplementarityInvariant, KnowsThatAThirdBodyMayStopWhatThePushSetInMotion) {
  Scene scene = box_on_ground();
  scene.bodies.push_back(scene.bodies[1]);
  scene.bodies[2].name = "box above";
  const auto boxes = [](double lower) {
    auto states = box_at({0, lower});
    states.push_back({.position = {0, lower + 1}});
    return states;
  };
  ContactState above = pushing(1);
  above.a = 1;
  above.b = 2;
  above.point = {0, 1};
  const auto apart = [&](double gap) { return forged(dt, {{boxes(0.5)}, {boxes(0.5 + gap), {pushing(1), above}}}); };
  // Each pushes the lower box by 1 m/s.
  EXPECT_EQ(status("complementarity", scene, apart(0.0199), exact), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, apart(0.0201), exact), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb
