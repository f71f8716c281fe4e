#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// Hinges with a motor of limited torque.
namespace plumb::scenarios::motor {
namespace {

constexpr double duration = 3;  // s

Scene scene(const Parameters& p) {
  Scene scene{.name = "motor",
              .about = "A motor spins a flywheel up to its speed, and holds it there.",
              .gravity = {0, 0},
              .duration = duration};
  Body wheel = disc("wheel", {0, 0}, 0.5, {});
  wheel.layers = 0;
  scene.bodies = {{.name = "axle", .type = BodyType::fixed, .layers = 0}, wheel};
  scene.joints.push_back(Revolute{.a = 0, .b = 1, .motor = Motor{p.at("speed"), p.at("torque")}});
  return scene;
}

// w = (tau/I) t until the motor's speed. Of a constant torque every method has the speed at a step's end; between two
// of them its reading is on their chord, which cuts the corner where the speed is reached by a h/4 at most. The angle:
//   drift     a t h while the wheel gains speed;
//   chord     a reading between two steps is off by the arc's height, a dt^2/8 at most; the step of h that reaches the
//             speed, s late, by a s (h - s)/2, no more than that.
std::vector<Expectation> expectations(const Parameters& p) {
  const double speed = p.at("speed");
  const double a = p.at("torque") / mass_of(scene(p).bodies[1]).inertia;
  const double reached = std::abs(speed) / a;
  std::vector<Expectation> all;
  for (const double t : {std::min(reached, duration) / 2, duration}) {
    const double gains = std::min(t, reached);
    const double angle = std::copysign(a * gains * (t - gains / 2), speed);
    const auto round = [=](const Stepping& s) { return round_off(s, t, a * gains * (1 + t)); };
    const auto corner = [=](const Stepping& s) { return std::abs(t - reached) < s.dt ? a * s.dt / 4 : 0; };
    all.push_back({.body = "wheel",
                   .quantity = Quantity::angular_velocity,
                   .time = t,
                   .expected = std::copysign(a * gains, speed),
                   .allowed = [=](const Stepping& s) { return round(s) + corner(s); },
                   .source = "tau t/I, then the motor's speed; round-off"});
    all.push_back({.body = "wheel",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = angle,
                   .allowed = [=](const Stepping& s) { return drifted(s, a, gains) + a * s.dt * s.dt / 8 + round(s); },
                   .source = "tau t^2/(2 I), then speed t; the method's drift, and the step that reaches the speed"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "motor",
     .question = "Does a motor of limited torque spin a wheel up with w = tau t/I, and then hold its speed?",
     .parameters =
         {{.name = "speed", .value = 2, .min = -10, .max = 10, .unit = "rad/s", .about = "of the motor"},
          {.name = "torque", .value = 0.1, .min = 0.05, .max = 2, .unit = "N m", .about = "the motor's largest"}},
     .variants = {{"slow", {}}, {"backwards", {{"speed", -6}, {"torque", 1}}}, {"too-weak", {{"speed", 8}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::motor

namespace plumb::scenarios::motor_arm {
namespace {

constexpr double gravity = 10;    // m/s^2
constexpr double half = 0.5;      // m, from the hinge to the arm's centre
constexpr double duration = 6;    // s, long after the arm has stopped
constexpr double thickness = .1;  // m

// The arm starts level, to the right of the hinge. Its motor brakes it: its speed is zero.
Scene scene(const Parameters& p) {
  Scene scene{.name = "motor-arm",
              .about = "A motor holds a level arm, or brakes its fall.",
              .gravity = {0, -gravity},
              .duration = duration};
  Body arm = box("arm", {half, 0}, {2 * half, thickness}, {});
  arm.layers = 0;
  const double strength = p.at("share") * mass_of(arm).mass * gravity * half;
  scene.bodies = {{.name = "pivot", .type = BodyType::fixed, .layers = 0}, arm};
  scene.joints.push_back(Revolute{.a = 0, .b = 1, .motor = Motor{0, strength}});
  return scene;
}

// sin x = share x, by bisection: from the level, at which sin x/x is 1, sin x/x falls up to x = pi.
double stop_of(double share) {
  double low = 0;
  double high = std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::sin(middle) > share * middle ? low : high) = middle;
  }
  return low;
}

constexpr double falling = 0.25;  // s, while the arm still falls

// rad/s^2: m g l/I, of the hinge.
double weight_of(const Scene& scene) {
  const Mass arm = mass_of(scene.bodies[1]);
  return arm.mass * gravity * half / (arm.inertia + arm.mass * half * half);
}

// rad, x'' = m g l/I (cos x - share).
double fallen(double weight, double share) {
  constexpr int steps = 1000;
  const auto rate = [=](const std::array<double, 2>& y) {
    return std::array<double, 2>{y[1], weight * (std::cos(y[0]) - share)};
  };
  return integrated(std::array<double, 2>{0, 0}, falling, steps, rate)[0];
}

// With tau = share m g l the arm stays if share >= 1. Else it falls by x, until the motor has taken all the work of the
// weight, tau x = m g l sin x, and stays there: the weight's torque m g l cos x is less than tau for share > 0.442,
// where tan x = -x. With k = W h, W the fastest turning, a method is off by
//   order    in the energy, k of the work m g l x (first order) or k^2/3 (second): by that over the torque that stops
//            the arm, tau - m g l cos x, in the angle;
//   stop     h of the deceleration a: a h^2/2, as the arm stops within a step;
//   slop     of the hinge, which moves the centre: slop/l.
// While it falls, what a step adds to its speed is not amplified (d x''/dx = -m g l/I sin x < 0), so that it is off by
//   order    drift a t h (first order), or the sum of x h^2/6 over the steps, x <= w (W^2 + w) with w = m g l/I;
//   chord    the arc's height between two steps, w dt^2/8.
std::vector<Expectation> expectations(const Parameters& p) {
  const double share = p.at("share");
  const bool holds = share >= 1;
  const double x = holds ? 0 : stop_of(share);
  const double weight = 0.75 * gravity / half;  // 1/s^2, m g l/I of a thin rod, less for a thick one
  const double falls = std::acos(std::min(share, 1.0));
  const double fastest = std::sqrt(2 * weight * (std::sin(falls) - std::min(share, 1.0) * falls));
  const double brake = share - std::cos(x);
  const auto turn = [=](const Stepping& s) {
    const double k = fastest * s.h;
    const double order = holds ? 0 : x * (first_order(s) ? k : k * k / 3) / brake + weight * brake * s.h * s.h / 2;
    return order + s.joint_slop / half + round_off(s, duration, 1 + 4 * half + fastest * duration);
  };
  std::vector<Expectation> all;
  for (const double t : {duration - 1, duration}) {
    all.push_back({.body = "arm",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = -x,
                   .allowed = turn,
                   .source = "held, or stopped where sin x = tau x/(m g l); the method's order, slop of the hinge"});
  }
  if (holds) return all;
  const double fourth = weight * (fastest * fastest + weight);
  all.push_back({.body = "arm",
                 .quantity = Quantity::angle,
                 .time = falling,
                 .expected = -fallen(weight_of(scene(p)), share),
                 .allowed =
                     [=](const Stepping& s) {
                       const double order =
                           drifted(s, weight * (1 - share), falling) + fourth * s.h * s.h / 12 * falling * falling;
                       return order + weight * s.dt * s.dt / 8 + s.joint_slop / half +
                              round_off(s, falling, 1 + 4 * half + fastest * falling);
                     },
                 .source = "x'' = (m g l cos x - tau)/I, integrated; the method's order, slop of the hinge"});
  return all;
}

const Catalog<Scenario>::Entry entry{{.name = "motor-arm",
                                      .question = "Does a motor hold an arm if tau > m g l, and else brake its fall to "
                                                  "sin x = tau x/(m g l)?",
                                      .parameters = {{.name = "share",
                                                      .value = 0.6,
                                                      .min = 0.5,
                                                      .max = 1.5,
                                                      .about = "of the arm's weight that the motor can hold"}},
                                      .variants = {{"holds", {{"share", 1.02}}}, {"falls", {}}},
                                      .scene = scene,
                                      .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::motor_arm
