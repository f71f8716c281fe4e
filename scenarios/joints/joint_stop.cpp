#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::joint_stop {
namespace {

constexpr double gravity = 10;     // m/s^2
constexpr double duration = 3;     // s, long after the stop
constexpr double half_length = 1;  // m, from the hinge to the rod's centre
constexpr double thickness = 0.1;  // m

// The rod starts level, to the right of the hinge, and falls clockwise.
Scene scene(const Parameters& p) {
  Scene scene{.name = "joint-stop",
              .about = "A hinged rod falls until its hinge stops it.",
              .gravity = {0, -gravity},
              .duration = duration};
  const Body pivot{.name = "pivot", .type = BodyType::fixed, .layers = 1};
  Body rod = box("rod", {half_length, 0}, {2 * half_length, thickness}, {});
  rod.layers = 2;
  scene.bodies = {pivot, rod};
  scene.joints.push_back(Revolute{.a = 0, .b = 1, .limits = Limits{-p.at("limit") * degree, 0}});
  return scene;
}

// It is stopped without a rebound, as a limit has no restitution, and rests against the stop from then on, wherever
// within a step it was stopped. Hinge and stop may give way by the joint's slop under its weight: slop/d in angle, and
// what the method leaves of an angle past the limit.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = -p.at("limit") * degree;
  const double d = half_length;
  const double reach = 4 * d + gravity * duration;
  const auto turn = [=](const Stepping& s) {
    return s.joint_slop / d + s.angular_slop + round_off(s, duration, reach);
  };
  const auto place = [=](const Stepping& s) { return d * turn(s) + s.joint_slop; };
  return {{.body = "rod",
           .quantity = Quantity::angle,
           .expected = angle,
           .allowed = turn,
           .source = "at rest against the stop; the joint's slop"},
          {.body = "rod",
           .quantity = Quantity::x,
           .expected = d * std::cos(angle),
           .allowed = place,
           .source = "on the circle about the hinge; the slop of hinge and stop"},
          {.body = "rod",
           .quantity = Quantity::y,
           .expected = d * std::sin(angle),
           .allowed = place,
           .source = "on the circle about the hinge; the slop of hinge and stop"}};
}

const Catalog<Scenario>::Entry entry{{.name = "joint-stop",
                                      .question = "Does a hinge stop at its limit, and hold there?",
                                      .parameters = {{.name = "limit",
                                                      .value = 60,
                                                      .min = 5,
                                                      .max = 80,
                                                      .unit = "deg",
                                                      .about = "of the hinge, from level downwards"}},
                                      .variants = {{"60deg", {}}, {"30deg", {{"limit", 30}}}},
                                      .scene = scene,
                                      .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::joint_stop
