#include <array>
#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::motor_lift {
namespace {

constexpr double gravity = 10;      // m/s^2
constexpr double arm = 0.8;         // m, from the hinge to the weight
constexpr double duration = 3;      // s
constexpr double step = 1e-4;       // s, of the integration
constexpr double shortest = 1e-15;  // s

// A disc at the end of an arm without mass, that is one body with its hinge beside it. It starts below the hinge.
Scene scene(const Parameters& p) {
  Scene scene{.name = "motor-lift",
              .about = "A motor lifts a weight on an arm over the top of its hinge.",
              .gravity = {0, -gravity},
              .duration = duration};
  Body weight = disc("weight", {0, -arm}, 0.25, {});
  weight.layers = 0;
  const double strength = p.at("share") * mass_of(weight).mass * gravity * arm;
  scene.bodies = {{.name = "post", .type = BodyType::fixed, .layers = 0}, weight};
  scene.joints.push_back(Revolute{.a = 0, .b = 1, .motor = Motor{p.at("speed"), strength}});
  return scene;
}

// I q'' = tau - m g l sin q until the motor's speed, from then on evenly: tau > m g l holds it everywhere.
struct Lift {
  double torque, weight, speed;  // tau/I and m g l/I, 1/s^2; rad/s

  explicit Lift(const Parameters& p) : speed(p.at("speed")) {
    const Mass mass = mass_of(scene(p).bodies[1]);
    weight = mass.mass * gravity * arm / (mass.inertia + mass.mass * arm * arm);
    torque = p.at("share") * weight;
  }

  using State = std::array<double, 2>;  // angle from the lowest point, and its rate
  State at(double time) const {
    const auto rate = [this](const State& y) { return State{y[1], torque - weight * std::sin(y[0])}; };
    State now{0, 0};
    double gone = 0;
    double h = step;
    while (gone < time && h > shortest) {
      const double takes = std::min(h, time - gone);
      const State next = runge_kutta(now, takes, rate);
      if (next[1] > speed) {
        h /= 2;
        continue;
      }
      now = next;
      gone += takes;
    }
    return {now[0] + speed * (time - gone), gone < time ? speed : now[1]};
  }

  double reached() const {  // s, when it has the motor's speed
    double low = 0;
    double high = duration;
    for (int i = 0; i < 30; ++i) {
      const double middle = (low + high) / 2;
      (at(middle)[1] < speed ? low : high) = middle;
    }
    return high;
  }
};

// Until the motor's speed W is reached, at r, errors grow at most as cosh(w r), w^2 = m g l/I:
//   order   |drift| h W (first order); or a fourth derivative of the angle, w^2 (W^2 + tau/I), times h^2/12 r^2;
//   reach   the step that reaches the speed, s late, adds tau/I s (h - s)/2 at most; a reading between two steps is off
//           by the arc's height, tau/I dt^2/8;
//   slop    of the hinge, over the arm.
// Then the motor decides the speed, and a first-order method that moves along its tangent still turns evenly.
std::vector<Expectation> expectations(const Parameters& p) {
  const Lift lift(p);
  const double reached = lift.reached();
  const double w = std::sqrt(lift.weight);
  std::vector<Expectation> all;
  for (const double t : {whole_steps(reached / 2), std::floor(60 * duration / 2) / 60, duration}) {
    const Lift::State then = lift.at(t);
    const double gains = std::min(t, reached);
    const double grown = std::cosh(w * gains);
    const auto turn = [=](const Stepping& s) {
      const double fourth = lift.weight * (lift.speed * lift.speed + lift.torque);
      return (std::abs(s.drift) * s.h * lift.speed + fourth * s.h * s.h / 12 * gains * gains) * grown +
             lift.torque * (s.h * s.h + s.dt * s.dt) / 8 + s.joint_slop / arm +
             round_off(s, t, 1 + 4 * arm + lift.speed * t) * grown;
    };
    all.push_back({.body = "weight",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = then[0],
                   .allowed = turn,
                   .source = "I q'' = tau - m g l sin q up to the motor's speed, then evenly; the method's order"});
    if (t < reached) continue;  // near the lowest point the height hardly changes
    all.push_back({.body = "weight",
                   .quantity = Quantity::y,
                   .time = t,
                   .expected = -arm * std::cos(then[0]),
                   .allowed = [=](const Stepping& s) { return arm * turn(s) + s.joint_slop; },
                   .source = "on the circle about the hinge; the arm times the angle's error"});
  }
  all.push_back({.body = "weight",
                 .quantity = Quantity::angular_velocity,
                 .expected = lift.speed,
                 .allowed =
                     [=](const Stepping& s) {
                       const double kept = first_order(s) ? lift.speed * s.h * lift.speed * s.h / 2 * lift.speed : 0;
                       return kept + round_off(s, duration, 1 + lift.speed);
                     },
                 .source = "the motor holds its speed up and down, as tau > m g l"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "motor-lift",
     .question = "Does a motor with tau > m g l lift a weight on an arm over the top, and hold its speed all round?",
     .parameters = {{.name = "share",
                     .value = 1.3,
                     .min = 1.05,
                     .max = 3,
                     .about = "the motor's torque over that of the weight on a level arm"},
                    {.name = "speed", .value = 2, .min = 1, .max = 4, .unit = "rad/s", .about = "of the motor"}},
     .variants = {{"lifts", {}}, {"strong", {{"share", 3}, {"speed", 4}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::motor_lift
