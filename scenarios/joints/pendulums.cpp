#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// A rod hinged at one end to the world and released at rest: a pendulum or, from near upright, a toppling rod.
namespace plumb::scenarios::hinged_rod {
namespace {

constexpr double gravity = 10;     // m/s^2
constexpr double thickness = 0.1;  // m

// Length, m; angle from the downward vertical, rad; duration, s.
Scene rod_scene(double length, double angle, double duration) {
  Scene scene{.gravity = {0, -gravity}, .duration = duration};
  const Body pivot{.name = "pivot", .type = BodyType::fixed, .layers = 1};
  Body rod = box("rod", {length / 2 * std::sin(angle), -length / 2 * std::cos(angle)}, {length, thickness}, {});
  rod.angle = angle - std::numbers::pi / 2;
  rod.layers = 2;
  scene.bodies = {pivot, rod};
  scene.joints.push_back(Revolute{.a = 0, .b = 1});
  return scene;
}

// Angle, position and energy of the rod at the end. angle'' = -w^2 sin(angle), w^2 = m g d/I_p. With the largest
// angular velocity W, at the lowest point:
//   first order   a method's drift makes it half a step early or late: 2 |drift| h W. A hinge solved at the velocity
//                 level lets the centre move along the tangent and then removes the part of its velocity that is no
//                 longer tangential: a step that turns by W h loses m d^2/I_p (W h)^2/2 of the speed, and as much of
//                 the swing;
//   second order  its phase is (w h)^2/24 w t ahead, and after projection back onto the circle it has turned by atan(W
//                 h): (W h)^2/3 W t;
//   growth        errors grow like exp(w t) while the rod is above the pivot; explicit Euler multiplies the energy by
//                 at most 1 + (w h)^2 per step;
//   gap           the hinge may be off by the gap, gap/d in angle.
std::vector<Expectation> rod_expectations(double length, double angle, double duration) {
  const Mass mass = mass_of(rod_scene(length, angle, duration).bodies[1]);
  const double d = length / 2;
  const double inertia = mass.inertia + mass.mass * d * d;
  const double w = std::sqrt(mass.mass * gravity * d / inertia);
  const double fastest = 2 * w * std::abs(std::sin(angle / 2));
  const double share = mass.mass * d * d / inertia;  // the centre's part of the kinetic energy
  const double unstable = std::abs(angle) > std::numbers::pi / 2 ? std::exp(w * duration) : 1;

  const auto turn = [=](const Stepping& s) {
    const double round = round_off(s, duration, 4 + fastest * duration) * unstable;
    if (s.h == 0) return round;
    const double k = w * s.h;
    const double first = 2 * std::abs(s.drift) * s.h * fastest;
    const double step_angle = fastest * s.h;
    // No exp(w t) above the pivot: the loss is proportional to the cube of a speed that itself grew like that until
    // then.
    const double lost = std::abs(angle) * share * step_angle * step_angle / 2 * duration / s.h;
    const double second = (k * k / 24 + step_angle * step_angle / 3) * fastest * duration * unstable;
    const double grown = s.drift < 0 ? std::abs(angle) * (std::pow(1 + k * k, duration / (2 * s.h)) - 1) * unstable : 0;
    return first + lost + second + grown + s.joint_slop / d + round;
  };
  const auto place = [=](const Stepping& s) { return d * turn(s) + s.joint_slop; };
  // The angle's error causes an error of at most m g d in each of the kinetic and the potential energy.
  const auto energy = [=](const Stepping& s) { return 2 * mass.mass * gravity * d * turn(s); };
  return {{.body = "rod",
           .quantity = Quantity::angle,
           .allowed = turn,
           .source = "sin(a/2) = k cd(w t); the method's phase error"},
          {.body = "rod", .quantity = Quantity::x, .allowed = place, .source = "on the circle about the pivot"},
          {.body = "rod", .quantity = Quantity::y, .allowed = place, .source = "on the circle about the pivot"},
          {.quantity = Quantity::energy, .allowed = energy, .source = "constant; error: m g d times the angle's"}};
}

}  // namespace
}  // namespace plumb::scenarios::hinged_rod

namespace plumb::scenarios::pendulum {
namespace {

constexpr double duration = 3;  // s

Scene scene(const Parameters& p) {
  Scene scene = hinged_rod::rod_scene(p.at("length"), p.at("angle") * degree, duration);
  scene.name = "pendulum";
  scene.about = "A rod swings on a frictionless pivot.";
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return hinged_rod::rod_expectations(p.at("length"), p.at("angle") * degree, duration);
}

const Catalog<Scenario>::Entry entry{
    {.name = "pendulum",
     .question = "Does a pendulum's period grow with its amplitude as the elliptic integral says?",
     .parameters = {{.name = "length", .value = 2, .min = 0.5, .max = 10, .unit = "m", .about = "of the rod"},
                    {.name = "angle",
                     .value = 90,
                     .min = -90,
                     .max = 90,
                     .unit = "deg",
                     .about = "of release, from the downward vertical"}},
     .variants = {{"small", {{"angle", 10}}}, {"wide", {}}},
     .closed_form = "pendulum",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pendulum

namespace plumb::scenarios::rod_toppling {
namespace {

constexpr double duration = 1;  // s, after which a rod of 4 m is about horizontal

double angle_of(const Parameters& p) { return (180 - p.at("lean")) * degree; }

Scene scene(const Parameters& p) {
  Scene scene = hinged_rod::rod_scene(p.at("length"), angle_of(p), duration);
  scene.name = "rod-toppling";
  scene.about = "A rod that stands on a pivot topples over.";
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return hinged_rod::rod_expectations(p.at("length"), angle_of(p), duration);
}

const Catalog<Scenario>::Entry entry{
    {.name = "rod-toppling",
     .question = "Does a toppling rod turn with w^2 = (3 g/L)(cos b0 - cos b)?",
     .parameters =
         {{.name = "length", .value = 4, .min = 1, .max = 20, .unit = "m", .about = "of the rod"},
          {.name = "lean", .value = 15, .min = 1, .max = 80, .unit = "deg", .about = "of release, from the upright"}},
     .variants = {{"15deg", {}}},
     .closed_form = "pendulum",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rod_toppling

namespace plumb::scenarios::double_pendulum {
namespace {

constexpr double length = 1;   // m, of each rod
constexpr double thick = 0.1;  // m

// Both rods in one line, at `angle` from the downward vertical, at rest.
Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const Vec along{std::sin(angle), -std::cos(angle)};
  Scene scene{.name = "double-pendulum", .about = "One rod hangs from another.", .duration = p.at("duration")};
  scene.bodies.push_back({.name = "pivot", .type = BodyType::fixed, .layers = 0});
  for (int i = 1; i <= 2; ++i) {
    const double distance = (i - 0.5) * length;
    Body rod = box(i == 1 ? "upper" : "lower", {distance * along.x, distance * along.y}, {thick, length}, {});
    rod.angle = angle;
    rod.layers = 0;
    scene.bodies.push_back(rod);
  }
  scene.joints = {Revolute{.a = 0, .b = 1}, Revolute{.a = 1, .b = 2, .anchor = {length * along.x, length * along.y}}};
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "double-pendulum",
     .question = "Does a double pendulum keep swinging without gaining energy?",
     .parameters = {{.name = "angle",
                     .value = 120,
                     .min = 1,
                     .max = 179,
                     .unit = "deg",
                     .about = "of both rods from the downward vertical, at the start"},
                    {.name = "duration", .value = 5, .min = 0.1, .max = 100, .unit = "s", .about = "of the run"}},
     .variants = {{"small", {{"angle", 5}}}, {"wild", {}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::double_pendulum
