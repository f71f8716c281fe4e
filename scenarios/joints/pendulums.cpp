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

// Angle and position of the rod at a quarter of the run, when a first-order method must still be good, and at the end;
// and its energy at the end. angle'' = -w^2 sin(angle), w^2 = m g d/I_p. By a time t the rod has turned by at most A
// and reached at most the angular velocity W:
//   first     x and angle are half a step ahead or behind: |drift| h W. (A step of symplectic Euler gives the exact
//             velocity of the half step before.)
//   lost      first-order methods solve a hinge at the velocity level: the centre moves along the tangent, and the part
//             of its velocity that is no longer tangential is removed. A step that turns by W h loses m d^2/I_p
//             (W h)^2/2 of the speed, and as much of the swing;
//   second    its phase is (w h)^2/24 w t ahead, and after projection back onto the circle it has turned by atan(W h):
//             (W h)^2/3 W t;
//   growth    errors grow like cosh(w t) while the rod is above the pivot; a method that keeps no spring bounded
//             multiplies the energy by at most 1 + (w h)^2 per step;
//   hinge     it may be off by the joint's slop, slop/d in angle.
// A phase error costs no energy. What does is the drift's torque times its advance, m g d |drift| h W; what is lost,
// twice its share of the kinetic energy I W^2/2; and the oscillation of the second-order terms.
struct HingedRod {
  double angle = 0;     // rad, at the start, from the downward vertical
  double distance = 0;  // m, from the pivot to the centre
  double weight = 0;    // N
  double inertia = 0;   // kg m^2, about the pivot
  double share = 0;     // the centre's part of the kinetic energy

  double w() const { return std::sqrt(weight * distance / inertia); }
  bool above() const { return std::abs(angle) > std::numbers::pi / 2; }

  // Bounds of the swing. From rest, s'' <= w^2 |sin s|: at most w^2 if it may pass the horizontal, else w^2 sin(angle);
  // and for a rod above the pivot, in terms of its lean, the growth of the linear equation.
  double fastest(double time) const {
    const double by_energy = 2 * w() * std::abs(std::sin(angle / 2));
    const double pull = above() ? 1 : std::abs(std::sin(angle));
    const double lean = std::numbers::pi - std::abs(angle);
    const double by_growth = above() ? lean * w() * std::sinh(w() * time) : by_energy;
    return std::min({by_energy, pull * w() * w() * time, by_growth});
  }
  double swept(double time) const { return std::min(2 * std::abs(angle), fastest(time) * time); }

  double second(const Stepping& s, double time) const {
    const double k = w() * s.h;
    const double turned = fastest(time) * s.h;
    return k * k / 24 + turned * turned / 3;
  }
  // Of the speed, in all steps until then.
  double lost(const Stepping& s, double time) const {
    const double turned = fastest(time) * s.h;
    return first_order(s) ? share * turned * turned / 2 * time / s.h : 0;
  }
  double grown(const Stepping& s, double time) const {
    const double k = w() * s.h;
    const bool grows = s.drift != 0 && s.spring_limit.value_or(0) == 0;
    return grows ? std::pow(1 + k * k, time / (2 * s.h)) - 1 : 0;
  }

  double turn(const Stepping& s, double time) const {
    const double unstable = above() ? std::cosh(w() * time) : 1;
    const double w_max = fastest(time);
    const double round = round_off(s, time, 4 + fastest(10) * time) * unstable;
    if (s.h == 0) return round;
    // No growth of what is lost: it is proportional to the cube of a speed that itself grew like that until then.
    return std::abs(s.drift) * s.h * w_max + lost(s, time) * swept(time) + second(s, time) * w_max * time * unstable +
           grown(s, time) * std::abs(angle) * unstable + s.joint_slop / distance * unstable + round;
  }

  double energy(const Stepping& s, double time) const {
    const double w_max = fastest(time);
    const double round = 2 * weight * distance * round_off(s, time, 4 + w_max * time);
    if (s.h == 0) return round;
    return weight * distance * std::abs(s.drift) * s.h * w_max +
           inertia * w_max * w_max * (lost(s, time) + grown(s, time) + second(s, time)) + weight * s.joint_slop + round;
  }
};

std::vector<Expectation> rod_expectations(double length, double angle, double duration) {
  const Mass mass = mass_of(rod_scene(length, angle, duration).bodies[1]);
  const double d = length / 2;
  const double inertia = mass.inertia + mass.mass * d * d;
  const HingedRod rod{angle, d, mass.mass * gravity, inertia, mass.mass * d * d / inertia};
  std::vector<Expectation> all;
  for (const double time : {std::floor(60 * duration / 4) / 60, duration}) {
    const auto turn = [=](const Stepping& s) { return rod.turn(s, time); };
    const auto place = [=](const Stepping& s) { return d * rod.turn(s, time) + s.joint_slop; };
    all.push_back({.body = "rod",
                   .quantity = Quantity::angle,
                   .time = time,
                   .allowed = turn,
                   .source = "sin(a/2) = k cd(w t); the method's phase error"});
    for (const Quantity along : {Quantity::x, Quantity::y}) {
      all.push_back({.body = "rod",
                     .quantity = along,
                     .time = time,
                     .allowed = place,
                     .source = "on the circle about the pivot; d times the angle's error"});
    }
  }
  all.push_back({.quantity = Quantity::energy,
                 .allowed = [=](const Stepping& s) { return rod.energy(s, duration); },
                 .source = "constant; what a hinge loses, and the method's own oscillation"});
  return all;
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
