#include "scenarios/joints/hinged_rod.h"

#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr double gravity = 10;     // m/s^2
constexpr double thickness = 0.1;  // m

}  // namespace

Scene hinged_rod(double length, double angle, double duration) {
  Scene scene{.gravity = {0, -gravity}, .duration = duration};
  const Body pivot{.name = "pivot", .type = BodyType::fixed, .layers = 1};
  Body rod = box("rod", {length / 2 * std::sin(angle), -length / 2 * std::cos(angle)}, {length, thickness}, {});
  rod.angle = angle - std::numbers::pi / 2;
  rod.layers = 2;
  scene.bodies = {pivot, rod};
  scene.joints.push_back(Revolute{.a = 0, .b = 1});
  return scene;
}

// angle'' = -w^2 sin(angle), w^2 = m g d/I_p. With the fastest turn W, at the lowest point:
//   first order   a method's drift makes it half a step ahead or behind, either way: 2 |drift| h W. A hinge kept by
//   speeds
//                 lets the centre go along the tangent and then takes away what of its speed no longer is tangential: a
//                 step that turns by W h loses m d^2/I_p (W h)^2/2 of the speed, and so that much of the swing;
//   second order  its phase is (w h)^2/24 w t ahead, and put back on the circle it has turned by atan(W h): (W h)^2/3 W
//   t; growth        errors grow with exp(w t) while the rod is above the pivot; explicit Euler multiplies the energy
//   by
//                 1 + (w h)^2 a step at most;
//   gap           the hinge may give by the gap, gap/d in angle.
std::vector<Expectation> hinged_rod_expectations(double length, double angle, double duration) {
  const Mass mass = mass_of(hinged_rod(length, angle, duration).bodies[1]);
  const double d = length / 2;
  const double inertia = mass.inertia + mass.mass * d * d;
  const double w = std::sqrt(mass.mass * gravity * d / inertia);
  const double fastest = 2 * w * std::abs(std::sin(angle / 2));
  const double share = mass.mass * d * d / inertia;  // of the centre's motion in the whole
  const double unstable = std::abs(angle) > std::numbers::pi / 2 ? std::exp(w * duration) : 1;

  const auto turn = [=](const Stepping& s) {
    const double round = round_off(s, duration, 4 + fastest * duration) * unstable;
    if (s.h == 0) return round;
    const double k = w * s.h;
    const double first = 2 * std::abs(s.drift) * s.h * fastest;
    const double wide = fastest * s.h;
    // Above the pivot no exp(w t): a loss goes with the cube of a speed that itself grew like that until then.
    const double lost = std::abs(angle) * share * wide * wide / 2 * duration / s.h;
    const double second = (k * k / 24 + wide * wide / 3) * fastest * duration * unstable;
    const double grown = s.drift < 0 ? std::abs(angle) * (std::pow(1 + k * k, duration / (2 * s.h)) - 1) * unstable : 0;
    return first + lost + second + grown + s.gap / d + round;
  };
  const auto place = [=](const Stepping& s) { return d * turn(s) + s.gap; };
  // Of the angle's error the kinetic and the potential part take m g d at most each.
  const auto energy = [=](const Stepping& s) { return 2 * mass.mass * gravity * d * turn(s); };
  return {{.body = "rod",
           .quantity = Quantity::angle,
           .allowed = turn,
           .source = "sin(a/2) = k cd(w t); the method's phase"},
          {.body = "rod", .quantity = Quantity::x, .allowed = place, .source = "on the circle about the pivot"},
          {.body = "rod", .quantity = Quantity::y, .allowed = place, .source = "on the circle about the pivot"},
          {.quantity = Quantity::energy, .allowed = energy, .source = "constant; m g d times the angle's error"}};
}

}  // namespace plumb
